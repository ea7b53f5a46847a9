// The turned view of bones: mouse and keys move a camera, then the scene is drawn. What is drawn is
// known by a number of content, revision, ground and camera; where that is the number of the last
// picture, the picture is shown again and refined from frame to frame, until nothing is drawn. A
// size that changed before anybody turned the view fits the bone anew.
#include "ui/screens/pictures/bone_viewport.h"

#include <bit>
#include <cmath>

#include "simulator/base/check.h"

namespace hallux::ui {

namespace {

constexpr double turn_rad_per_pixel = 0.008, turn_step_rad = 0.14, zoom_step = 1.12;

/// source  Fowler, Noll, Vo: FNV-1a, 64 bits
constexpr std::uint64_t hash_start = 14695981039346656037ULL, hash_factor = 1099511628211ULL;

void mix_in(std::uint64_t& hash, std::uint64_t value) noexcept {
  for (int byte = 0; byte < 8; ++byte) {
    hash = (hash ^ (value & 0xFFU)) * hash_factor;
    value >>= 8U;
  }
}

void mix_in(std::uint64_t& hash, const Camera& camera) noexcept {
  const Quat& turn = camera.world_from_view;
  for (const double value : {camera.target_mm.x, camera.target_mm.y, camera.target_mm.z, turn.w,
                             turn.x, turn.y, turn.z, camera.magnification}) {
    mix_in(hash, std::bit_cast<std::uint64_t>(value));
  }
}

PixelSize pixels_of(const Ui& ui, const Rect& rect) {
  return {std::max(1, static_cast<int>(std::lround(rect.w * ui.scale()))),
          std::max(1, static_cast<int>(std::lround(rect.h * ui.scale())))};
}

}  // namespace

std::uint64_t picture_id(std::string_view words) noexcept {
  std::uint64_t hash = hash_start;
  for (const char letter : words) mix_in(hash, static_cast<unsigned char>(letter));
  return hash == 0 ? 1 : hash;
}

void BoneViewport::look_at(const Vec3& middle_in_world_mm, double radius_mm,
                           const Quat& world_from_view) {
  CHECK(radius_mm > 0.0);
  first_.target_mm = middle_in_world_mm;
  first_.world_from_view = world_from_view;
  radius_mm_ = radius_mm;
  is_fitted_ = false;
}

void BoneViewport::look_at(const Vec3& middle_in_world_mm, double radius_mm, StandardView view) {
  look_at(middle_in_world_mm, radius_mm, standard_view(Camera{}, view).world_from_view);
}

void BoneViewport::turn_to(StandardView view) noexcept {
  if (view != StandardView::AlongBlade) {
    camera_ = standard_view(camera_, view);
    return;
  }
  CHECK(has_blade());
  camera_ = seen_along_blade(camera_, *world_from_blade_);
}

EyeView BoneViewport::eye_view() const noexcept {
  return view_of(camera_, Viewer{}, Eye::Middle,
                 static_cast<double>(rect_.w) / static_cast<double>(rect_.h));
}

bool BoneViewport::hear_pointer(const AreaResponse& area) {
  const Camera before = camera_;
  const auto turn = [&](Point by) {
    camera_ = orbited(camera_, turn_rad_per_pixel * static_cast<double>(by.x),
                      -turn_rad_per_pixel * static_cast<double>(by.y));
  };
  if (area.is_down[0]) turn(area.dragged[0]);
  if (area.is_down[2]) turn(area.dragged[2]);
  if (area.is_down[1]) {
    const double width = static_cast<double>(rect_.w);
    camera_ = panned(camera_, Viewer{},
                     Vec2(static_cast<double>(area.dragged[1].x) / width,
                          -static_cast<double>(area.dragged[1].y) / width));
  }
  if (area.wheel != 0.0F)
    camera_ = zoomed(camera_, std::pow(zoom_step, static_cast<double>(area.wheel)));
  return camera_ != before;
}

bool BoneViewport::hear_keys(Ui& ui) {
  bool was_turned = false;
  const int views = has_blade() ? standard_view_count : standard_view_count - 1;
  for (int view = 0; view < views; ++view) {
    const Key key = static_cast<Key>(static_cast<int>(Key::Digit1) + view);
    if (!ui.shortcut({key}, ui.text(standard_view_texts[static_cast<std::size_t>(view)]))) continue;
    turn_to(static_cast<StandardView>(view));
    was_turned = true;
  }
  const auto turn = [&](Key key, std::string_view label, double right, double up) {
    if (!ui.shortcut({key, {.alt = true}}, label)) return;
    camera_ = orbited(camera_, turn_step_rad * right, turn_step_rad * up);
    was_turned = true;
  };
  turn(Key::Left, ui.text("stage.turn_left"), -1.0, 0.0);
  turn(Key::Right, ui.text("stage.turn_right"), 1.0, 0.0);
  turn(Key::Up, ui.text("stage.turn_up"), 0.0, 1.0);
  turn(Key::Down, ui.text("stage.turn_down"), 0.0, -1.0);
  const auto zoom = [&](Key key, std::string_view label, double factor) {
    if (!ui.shortcut({key, {.alt = zooms_with_alt_}}, label)) return;
    camera_ = zoomed(camera_, factor);
    was_turned = true;
  };
  zoom(Key::Plus, ui.text("stage.nearer"), zoom_step);
  zoom(Key::Minus, ui.text("stage.farther"), 1.0 / zoom_step);
  return was_turned;
}

StageResponse BoneViewport::draw(Ui& ui, Shell& shell, const Rect& rect, const Scene& scene,
                                 const StagePicture& picture, bool hears_keys) {
  CHECK(has_view());
  StageResponse response;
  response.rect = rect_ = {rect.x, rect.y, std::max(rect.w, 1.0F), std::max(rect.h, 1.0F)};
  const double aspect = static_cast<double>(rect_.w) / static_cast<double>(rect_.h);
  const AreaResponse area = ui.area(picture.id, picture.label, rect_);
  if (!is_fitted_) {
    camera_ = fitted(first_, Viewer{}, radius_mm_, aspect);
    is_fitted_ = true;
  }
  response.was_turned = hear_pointer(area);
  if (hears_keys && hear_keys(ui)) response.was_turned = true;
  if (hears_keys && ui.shortcut({Key::R}, ui.text("stage.back"))) {
    turn_back();
    response.was_turned_back = true;
  }
  if (!is_fitted_) {
    camera_ = fitted(first_, Viewer{}, radius_mm_, aspect);
    is_fitted_ = true;
  }
  std::uint64_t wanted = picture_id(picture.id);
  mix_in(wanted, picture.revision);
  mix_in(wanted, static_cast<std::uint64_t>(scene.ground));
  mix_in(wanted, camera_);
  const PixelSize size = pixels_of(ui, rect_);
  ScenePainter& scenes = shell.scenes();
  std::uint64_t texture = wanted == drawn_ ? scenes.refine(picture.id, scene, camera_, size) : 0;
  if (texture == 0) texture = scenes.draw(picture.id, scene, camera_, size);
  if (!scenes.is_refined(picture.id)) ui.want_frame_in_s(0.0);
  drawn_ = wanted;
  if (texture != 0) ui.canvas().picture({texture}, rect_, picture.radius);
  if (area.clicked[0]) {
    response.pointed = ray_through(Vec2(static_cast<double>((area.pointer.x - rect_.x) / rect_.w),
                                        static_cast<double>((area.pointer.y - rect_.y) / rect_.h)));
  }
  return response;
}

SightRay BoneViewport::ray_through(const Vec2& shares) const noexcept {
  const EyeView view = eye_view();
  const Vec3 through = point_at(view, Vec3(shares, 0.0));
  return {view.eye_in_world_mm, glm::normalize(through - view.eye_in_world_mm)};
}

std::optional<Point> BoneViewport::seen_at(const Vec3& point_in_world_mm) const noexcept {
  const Vec3 place = place_in_picture(eye_view(), point_in_world_mm);
  if (place.x < 0.0 || place.x > 1.0 || place.y < 0.0 || place.y > 1.0 || place.z > 1.0 ||
      place.z < -1.0)
    return std::nullopt;
  return Point{rect_.x + rect_.w * static_cast<float>(place.x),
               rect_.y + rect_.h * static_cast<float>(place.y)};
}

}  // namespace hallux::ui
