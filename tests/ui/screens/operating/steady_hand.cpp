#include "tests/ui/screens/operating/steady_hand.h"

#include <chrono>
#include <cmath>

#include "simulator/device/mouse.h"
#include "ui/screens/operating/hand/steering.h"

namespace hallux::ui {

namespace {

/// Of the screen: a left drag's turn, a notch's depth.
constexpr double turn_rad_per_pixel = 0.0045, depth_mm_per_notch = 1.0;
constexpr double near_mm = 1.5, near_rad = 0.06;  ///< from where Shift is held
constexpr double good_mm = 0.12, good_rad = 0.005;
constexpr int rounds_at_most = 16;
constexpr double settling_s = 0.35;
constexpr float wide_pixels = 20.0F;

/// The way from one attitude to another as axis times angle.
Vec3 turn_between(const Quat& from, const Quat& to) {
  const Quat way = normalised(to * glm::conjugate(from));
  const Vec3 axis(way.x, way.y, way.z);
  return (way.w < 0.0 ? -2.0 : 2.0) * axis;
}

}  // namespace

SteadyHand::SteadyHand(Operator& person)
    : person_(person), pointer_(person.driver().ui().display().centre()) {
  point();
}

const RigidTransform& SteadyHand::world_from_tool() const {
  return person_.scenes.saw->world_from_tool;
}

EyeView SteadyHand::eye() const {
  return Sight{person_.scenes.camera, Viewer{}, person_.driver().ui().display()}.eye();
}

void SteadyHand::point() { send(person_.driver().moved_to(pointer_)); }

void SteadyHand::send(InputEvent event) {
  event.modifiers = modifiers_;
  person_.driver().send({event});
  person_.make_frames(2);
}

void SteadyHand::wait(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  person_.until([&] { return std::chrono::steady_clock::now() > end; });
}

void SteadyHand::toggle_saw() { person_.press(Key::Space, modifiers_); }

bool SteadyHand::lead_to(const RigidTransform& world_from_wanted) {
  for (int round = 0; round < rounds_at_most; ++round) {
    wait(settling_s);
    const RigidTransform now = world_from_tool();
    const Vec3 way_mm = world_from_wanted.translation_mm - now.translation_mm;
    const Vec3 turn_rad = turn_between(now.rotation, world_from_wanted.rotation);
    if (glm::length(way_mm) < good_mm && glm::length(turn_rad) < good_rad) return true;
    modifiers_.shift = glm::length(way_mm) < near_mm && glm::length(turn_rad) < near_rad;
    owed_in_view_mm_ = {0.0, 0.0, 0.0};
    if (glm::length(turn_rad) >= good_rad) turn(glm::conjugate(eye().world_from_view) * turn_rad);
    nudge(way_mm);
    modifiers_.shift = false;
  }
  return false;
}

/// About the view's y and x by a left drag, about its z by keys.
void SteadyHand::turn(const Vec3& turn_in_view_rad) {
  const double share = modifiers_.shift ? simulator::fine_share : 1.0;
  InputEvent event;
  event.button = MouseButton::Left;
  event.kind = EventKind::ButtonPressed;
  send(event);
  // Out and back again: a press that hardly moves is a click.
  pointer_.x += wide_pixels;
  point();
  const double pixel_rad = share * turn_rad_per_pixel;
  pointer_.x += static_cast<float>(std::round(turn_in_view_rad.y / pixel_rad)) - wide_pixels;
  pointer_.y += static_cast<float>(std::round(turn_in_view_rad.x / pixel_rad));
  point();
  event.kind = EventKind::ButtonReleased;
  send(event);
  const auto presses = std::lround(std::abs(turn_in_view_rad.z) / (share * key_turn_rad));
  for (long press = 0; press < presses; ++press) {
    person_.press(turn_in_view_rad.z > 0.0 ? Key::PageUp : Key::PageDown,
                  {.shift = modifiers_.shift, .control = true});
  }
  // What was held with the keys is held no more.
  point();
}

void SteadyHand::nudge(const Vec3& way_in_world_mm) {
  const EyeView seen = eye();
  owed_in_view_mm_ += glm::conjugate(seen.world_from_view) * way_in_world_mm;
  const double share = modifiers_.shift ? simulator::fine_share : 1.0;
  const Rect display = person_.driver().ui().display();
  const Vec3& tip_mm = world_from_tool().translation_mm;
  const Vec3 place = place_in_picture(seen, tip_mm);
  const Vec3 aside_mm(1.0, 1.0, 0.0);
  const Vec3 there = place_in_picture(seen, tip_mm + seen.world_from_view * aside_mm);
  const Vec2 pixels_per_mm(display.w * (there.x - place.x), display.h * (place.y - there.y));
  const Vec2 pixels(std::round(owed_in_view_mm_.x * pixels_per_mm.x / share),
                    std::round(owed_in_view_mm_.y * pixels_per_mm.y / share));
  const double notches = std::round(-owed_in_view_mm_.z / (share * depth_mm_per_notch));
  owed_in_view_mm_ -= share * Vec3(pixels.x / pixels_per_mm.x, pixels.y / pixels_per_mm.y,
                                   -notches * depth_mm_per_notch);
  InputEvent event;
  if (pixels != Vec2(0.0, 0.0)) {
    pointer_.x += static_cast<float>(pixels.x);
    pointer_.y -= static_cast<float>(pixels.y);
    point();
  }
  if (notches == 0.0) return;
  event.kind = EventKind::Wheel;
  event.wheel = static_cast<float>(notches);
  modifiers_.alt = true;
  send(event);
  modifiers_.alt = false;
}

}  // namespace hallux::ui
