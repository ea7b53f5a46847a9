// Pointer, wheel and keys as motions, without a state beyond where the pointer was. The pointer
// leads the teeth in the plane of the window at their own depth: what lies under it stays under it,
// however near the camera is. The right button turns the blade, so that a plain move never tilts
// it. The saw begins square to the bone's axes, because the plan would else be found for the
// trainee.
#include "ui/screens/operating/steering.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::PointerMotion;

constexpr double stand_off_mm = 30.0;
constexpr double turn_rad_per_pixel = 0.0045, orbit_rad_per_pixel = 0.008;
constexpr double depth_mm_per_notch = 1.0, zoom_per_notch = 1.1;
constexpr double key_step_mm = 1.0, key_turn_rad = 0.0175;
/// What one wants to see around the site: most of a phalanx, the head and half the shaft of a
/// metatarsal.
constexpr double usual_aspect = 1.6;
constexpr double site_share_of_bone = 0.5, site_least_mm = 20.0, site_most_mm = 30.0;

bool is_down(const AreaResponse& area, MouseButton button) {
  return area.is_down[static_cast<std::size_t>(button)];
}
Point dragged(const AreaResponse& area, MouseButton button) {
  return area.dragged[static_cast<std::size_t>(button)];
}

/// Bone frame: y dorsal, z lateral.
Vec3 feed_of(std::string_view approach) {
  if (approach == "dorsal") return {0.0, -1.0, 0.0};
  if (approach == "plantar") return {0.0, 1.0, 0.0};
  return approach == "lateral" ? Vec3(0.0, 0.0, -1.0) : Vec3(0.0, 0.0, 1.0);
}

/// The axis of the bone, square to the feed, that a planned normal lies nearest to.
Vec3 nearest_axis(const Vec3& normal, const Vec3& feed) {
  Vec3 best(1.0, 0.0, 0.0);
  double most = -1.0;
  for (const Vec3& axis :
       std::array{Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)}) {
    const double along = std::abs(glm::dot(axis, normal));
    if (std::abs(glm::dot(axis, feed)) > 0.5 || along <= most) continue;
    most = along;
    best = glm::dot(axis, normal) < 0.0 ? -axis : axis;
  }
  return best;
}

const scenarios::PlannedCut& first_cut(const PreparedCase& prepared_case) {
  for (const scenarios::OperationStep& step : prepared_case.scenario.steps) {
    const scenarios::PlannedCut* cut = find_cut(prepared_case.plan, step.cut);
    if (step.kind == scenarios::StepKind::Cut && cut != nullptr) return *cut;
  }
  return prepared_case.plan.cuts.front();
}

/// The view frame of an eye in that direction, dorsal up; of one that looks straight down, distal
/// up.
Quat facing(const Vec3& eye_in_world) {
  constexpr double straight = 0.999;
  const bool is_straight = std::abs(eye_in_world.y) > straight;
  const Vec3 up = is_straight ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const Vec3 right = unit(glm::cross(up, eye_in_world));
  return rotation_from_axes(right, glm::cross(eye_in_world, right));
}

Vec3 site_in_bone_mm(const scenarios::PlannedCut& cut) {
  return 0.5 * (cut.entry_point_in_bone_mm + cut.exit_point_in_bone_mm);
}

}  // namespace

RigidTransform start_pose(const PreparedCase& prepared_case) {
  const scenarios::PlannedCut& cut = first_cut(prepared_case);
  if (const auto& start = prepared_case.scenario.start) {
    const Vec3 across = glm::cross(start->normal_in_bone, start->feed_in_bone);
    return prepared_case.bone.world_from_bone *
           RigidTransform{rotation_from_axes(start->feed_in_bone, across),
                          cut.entry_point_in_bone_mm + start->tip_from_entry_mm};
  }
  const auto reference =
      std::find_if(prepared_case.scenario.cuts.begin(), prepared_case.scenario.cuts.end(),
                   [&](const scenarios::ReferenceCut& each) { return each.name == cut.name; });
  const Vec3 feed = feed_of(reference->approach);
  const Vec3 normal = nearest_axis(cut.face.normal, feed);
  const RigidTransform bone_from_tool{rotation_from_axes(feed, glm::cross(normal, feed)),
                                      cut.entry_point_in_bone_mm - stand_off_mm * feed};
  return prepared_case.bone.world_from_bone * bone_from_tool;
}

Camera start_camera(const PreparedCase& prepared_case) {
  Camera camera;
  camera.target_mm = transform_point(prepared_case.bone.world_from_bone,
                                     site_in_bone_mm(first_cut(prepared_case)));
  if (const auto& start = prepared_case.scenario.start) {
    camera = fitted(camera, Viewer{}, start->radius_mm, usual_aspect);
    camera.world_from_view =
        facing(transform_direction(prepared_case.bone.world_from_bone, start->eye_in_bone));
    return camera;
  }
  const double length_mm = prepared_case.scenario.patient.length_mm;
  const double radius_mm = std::clamp(site_share_of_bone * length_mm, site_least_mm, site_most_mm);
  return standard_view(fitted(camera, Viewer{}, radius_mm, usual_aspect), StandardView::Operator);
}

std::optional<Point> place_on(const Sight& sight, const Vec3& point_in_world_mm) {
  const Vec3 place = place_in_picture(sight.eye(), point_in_world_mm);
  if (!(place.z > -1.0 && place.z < 1.0)) return std::nullopt;
  return Point{sight.display.x + static_cast<float>(place.x) * sight.display.w,
               sight.display.y + static_cast<float>(place.y) * sight.display.h};
}

PointerMotion Steering::motion(const AreaResponse& area, const Modifiers& modifiers,
                               const Sight& sight, const Vec3& tip_in_world_mm) {
  PointerMotion motion;
  motion.is_fine = modifiers.shift;
  if (!modifiers.control) motion.deeper_mm = depth_mm_per_notch * static_cast<double>(area.wheel);
  if (is_down(area, MouseButton::Right)) {
    const Point turn = dragged(area, MouseButton::Right);
    motion.turned_rad = turn_rad_per_pixel * Vec2(turn.x, -turn.y);
  }
  const bool leads =
      area.is_hovered && !is_down(area, MouseButton::Right) && !is_down(area, MouseButton::Middle);
  if (leads && pointer_) {
    const EyeView eye = sight.eye();
    const Vec3 place = place_in_picture(eye, tip_in_world_mm);
    const Vec3 there(place.x + (area.pointer.x - pointer_->x) / sight.display.w,
                     place.y + (area.pointer.y - pointer_->y) / sight.display.h, place.z);
    const Vec3 way_in_view =
        glm::conjugate(eye.world_from_view) * (point_at(eye, there) - point_at(eye, place));
    motion.across_mm = Vec2(way_in_view.x, way_in_view.y);
  }
  pointer_ = leads ? std::optional(area.pointer) : std::nullopt;
  return motion;
}

PointerMotion Steering::motion_by_keys(Ui& ui) const {
  struct Arrow {
    Key key;
    Vec2 way;
  };
  constexpr int arrow_count = 4;
  const std::array<Arrow, arrow_count> arrows{{{Key::Left, Vec2(-1.0, 0.0)},
                                               {Key::Right, Vec2(1.0, 0.0)},
                                               {Key::Up, Vec2(0.0, 1.0)},
                                               {Key::Down, Vec2(0.0, -1.0)}}};
  PointerMotion motion;
  const auto heard = [&](Key key, bool is_turn) {
    const std::string_view label = ui.text(is_turn ? "operate.key.turn" : "operate.key.move");
    const int fine = ui.shortcut_repeats({key, {.shift = true, .control = is_turn}}, label);
    motion.is_fine = motion.is_fine || fine > 0;
    return static_cast<double>(fine + ui.shortcut_repeats({key, {.control = is_turn}}, label));
  };
  for (const Arrow& arrow : arrows) {
    motion.across_mm += heard(arrow.key, false) * key_step_mm * arrow.way;
    motion.turned_rad += heard(arrow.key, true) * key_turn_rad * arrow.way;
  }
  motion.deeper_mm += key_step_mm * (heard(Key::PageUp, false) - heard(Key::PageDown, false));
  motion.rolled_rad += key_turn_rad * (heard(Key::PageUp, true) - heard(Key::PageDown, true));
  return motion;
}

Camera Steering::looked(const AreaResponse& area, const Modifiers& modifiers,
                        const Sight& sight) const {
  Camera camera = sight.camera;
  if (modifiers.control && area.wheel != 0.0F) {
    camera = zoomed(camera, std::pow(zoom_per_notch, static_cast<double>(area.wheel)));
  }
  if (!is_down(area, MouseButton::Middle)) return camera;
  const Point way = dragged(area, MouseButton::Middle);
  if (modifiers.shift) {
    return panned(camera, sight.viewer, Vec2(way.x, -way.y) / static_cast<double>(sight.display.w));
  }
  return orbited(camera, orbit_rad_per_pixel * way.x, orbit_rad_per_pixel * way.y);
}

}  // namespace hallux::ui
