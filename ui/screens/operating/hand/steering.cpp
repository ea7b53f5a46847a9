// Mouse and keys as motions. The pointer leads the teeth in the plane of the window at their own
// depth: what lies under it stays under it, however near the camera is. The wheel pushes the saw
// along its own blade, which is how one saws. A plain move never tilts. Which input does what
// stands in the table of gestures alone.
#include "ui/screens/operating/hand/steering.h"

#include <array>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::PointerMotion;

constexpr double turn_rad_per_pixel = 0.0045, orbit_rad_per_pixel = 0.008;
/// A notch goes as far as a key press: hints count either alike.
constexpr double push_mm_per_notch = key_step_mm, roll_rad_per_notch = key_turn_rad;
constexpr double zoom_per_notch = 1.1;

/// The way of the tip for a way of the pointer, in the view's plane.
Vec2 way_across_mm(const Sight& sight, const Vec3& tip_in_world_mm, const Point& way) {
  const EyeView eye = sight.eye();
  const Vec3 place = place_in_picture(eye, tip_in_world_mm);
  const Vec3 there(place.x + way.x / sight.display.w, place.y + way.y / sight.display.h, place.z);
  const Vec3 way_in_view =
      glm::conjugate(eye.world_from_view) * (point_at(eye, there) - point_at(eye, place));
  return {way_in_view.x, way_in_view.y};
}

void move_saw(PointerMotion& motion, Gesture gesture, const GestureAmount& amount,
              const Sight& sight, const Vec3& tip_in_world_mm) {
  switch (gesture) {
    case Gesture::Lead:
      motion.across_mm += way_across_mm(sight, tip_in_world_mm, amount.way);
      break;
    case Gesture::Push:
      motion.pushed_mm += push_mm_per_notch * amount.notches;
      break;
    case Gesture::Deepen:
      motion.deeper_mm += push_mm_per_notch * amount.notches;
      break;
    case Gesture::Roll:
      motion.rolled_rad += roll_rad_per_notch * amount.notches;
      break;
    case Gesture::Tilt:
      motion.turned_rad += turn_rad_per_pixel * Vec2(amount.way.x, -amount.way.y);
      break;
    default:
      break;
  }
}

void move_camera(Camera& camera, Gesture gesture, const GestureAmount& amount, const Sight& sight) {
  switch (gesture) {
    case Gesture::Zoom:
      camera = zoomed(camera, std::pow(zoom_per_notch, amount.notches));
      break;
    case Gesture::Orbit:
      camera =
          orbited(camera, orbit_rad_per_pixel * amount.way.x, orbit_rad_per_pixel * amount.way.y);
      break;
    case Gesture::Pan:
      camera = panned(camera, sight.viewer,
                      Vec2(amount.way.x, -amount.way.y) / static_cast<double>(sight.display.w));
      break;
    default:
      break;
  }
}

/// How often each key of a pair was heard, plain or with Shift, which makes it fine.
class HeardKeys {
 public:
  HeardKeys(Ui& ui, PointerMotion& motion) : ui_(ui), motion_(motion) {}

  double difference(Key more, Key less, Modifiers modifiers, const char* label) {
    return heard(more, modifiers, label) - heard(less, modifiers, label);
  }

 private:
  double heard(Key key, Modifiers modifiers, const char* label) {
    const std::string_view words = ui_.text(label);
    const int plain = ui_.shortcut_repeats({key, modifiers}, words);
    modifiers.shift = true;
    const int fine = ui_.shortcut_repeats({key, modifiers}, words);
    motion_.is_fine = motion_.is_fine || fine > 0;
    return static_cast<double>(plain + fine);
  }

  Ui& ui_;
  PointerMotion& motion_;
};

PointerMotion motion_by_keys(Ui& ui) {
  PointerMotion motion;
  HeardKeys keys(ui, motion);
  const Modifiers none, control{.control = true}, alt{.alt = true};
  motion.across_mm =
      key_step_mm * Vec2(keys.difference(Key::Right, Key::Left, none, "operate.key.move"),
                         keys.difference(Key::Up, Key::Down, none, "operate.key.move"));
  motion.turned_rad =
      key_turn_rad * Vec2(keys.difference(Key::Right, Key::Left, control, "operate.key.turn"),
                          keys.difference(Key::Up, Key::Down, control, "operate.key.turn"));
  motion.pushed_mm =
      key_step_mm * keys.difference(Key::PageUp, Key::PageDown, none, "operate.key.push");
  motion.rolled_rad =
      key_turn_rad * keys.difference(Key::PageUp, Key::PageDown, control, "operate.key.roll");
  motion.deeper_mm =
      key_step_mm * keys.difference(Key::PageUp, Key::PageDown, alt, "operate.key.deepen");
  return motion;
}

}  // namespace

std::optional<Point> place_on(const Sight& sight, const Vec3& point_in_world_mm) {
  const Vec3 place = place_in_picture(sight.eye(), point_in_world_mm);
  if (!(place.z > -1.0 && place.z < 1.0)) return std::nullopt;
  return Point{sight.display.x + static_cast<float>(place.x) * sight.display.w,
               sight.display.y + static_cast<float>(place.y) * sight.display.h};
}

/// Of a caught pointer its way; of a free one since the last frame in which it led.
Point Steering::pointer_way(const AreaResponse& area) {
  if (area.is_captured) {
    pointer_.reset();
    return area.way;
  }
  const std::optional<Point> before = pointer_;
  pointer_ = area.is_hovered ? std::optional(area.pointer) : std::nullopt;
  if (!before || !pointer_) return {};
  return {pointer_->x - before->x, pointer_->y - before->y};
}

void Steering::hear_lift(Ui& ui, const AreaResponse& area) {
  bool is_held = false, is_toggled = ui.shortcut({Key::L}, ui.text("operate.key.lift_stays"));
  for (const BoundGesture& bound : bound_gestures) {
    const bool is_done = amount_of(bound.input, area, ui.modifiers(), {}).is_done;
    if (bound.gesture == Gesture::Lift) is_held = is_done;
    if (bound.gesture == Gesture::StayLifted) is_toggled = is_toggled || is_done;
  }
  lift_.hear(is_held, is_toggled);
}

Steered Steering::hear(Ui& ui, const AreaResponse& area, const Sight& sight, bool may_lead,
                       const Vec3& tip_in_world_mm) {
  Steered steered;
  steered.camera = sight.camera;
  if (may_lead) hear_lift(ui, area);
  const Point way = pointer_way(area);
  steered.by_mouse.is_fine = ui.modifiers().shift;
  for (const BoundGesture& bound : bound_gestures) {
    const GestureAmount amount = amount_of(bound.input, area, ui.modifiers(), way);
    ui.note_gesture(bound.input_text, bound.gesture_text);
    if (!amount.is_done) continue;
    move_camera(steered.camera, bound.gesture, amount, sight);
    if (!may_lead || lift_.is_lifted()) continue;
    move_saw(steered.by_mouse, bound.gesture, amount, sight, tip_in_world_mm);
    if (bound.gesture == Gesture::SwitchSaw) steered.switches_saw = true;
  }
  if (may_lead) steered.by_keys = motion_by_keys(ui);
  return steered;
}

}  // namespace hallux::ui
