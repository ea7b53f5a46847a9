// A hole is laid on what is seen of the skin, a pass over the pixels around its rim: inside of the
// rim, seen along the hole, the pixel shows what the line of sight meets in a cylinder that goes
// into the bone. So it lies on the skin however that curves, and nothing fights for the depth;
// through a polygon across the rim a convex bone would stand out.
#include "ui/render/painters/hole_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/render/painters/bone_pass.h"

namespace hallux::ui {

namespace {

/// Around the rim, what is lighter; and so many pixels at the least.
constexpr double rim_mm = 0.16, rim_pixels = 1.4;
/// How far the skin inside of the rim may lie out of the rim's own range along the hole.
constexpr double bulge_mm = 0.4;

/// A frame whose z axis that is.
Quat rotation_to(const Vec3& z) {
  const Vec3 beside = std::abs(z.x) < 0.8 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const Vec3 x = glm::normalize(glm::cross(beside, z));
  return rotation_from_axes(x, glm::cross(z, x));
}

Box box_of(const HoleShape& hole) noexcept {
  Box box;
  for (const Vec3& point_mm : hole.rim_mm) box.add(point_mm);
  const double bulge = bulge_mm + 0.5 * hole.radius_mm;
  box.low_mm -= Vec3(rim_mm, rim_mm, bulge);
  box.high_mm += Vec3(rim_mm, rim_mm, bulge);
  return box;
}

void set_hole(ShaderProgram& program, const HoleShape& hole) {
  std::array<Float4, rim_points_most> rim{};
  Box box;
  for (std::size_t i = 0; i < hole.rim_mm.size(); ++i) {
    rim[i] = Float4(to_float(hole.rim_mm[i]), 0.0F);
    box.add(hole.rim_mm[i]);
  }
  const double bulge = bulge_mm + 0.5 * hole.radius_mm;
  program.set("hole_from_world", to_float(matrix_of(inverse(hole.world_from_hole))));
  program.set("world_from_hole", to_float(matrix_of(hole.world_from_hole)));
  program.set("rim_points", std::span<const Float4>(rim));
  program.set("rim_count", static_cast<int>(hole.rim_mm.size()));
  program.set("radius_mm", static_cast<float>(hole.radius_mm));
  program.set("skin_range_mm", Float2(box.low_mm.z - bulge, box.high_mm.z + bulge));
}

}  // namespace

HoleShape shape_of(const HoleInScene& hole) {
  const std::size_t step = (hole.rim_mm.size() + rim_points_most - 1) / rim_points_most;
  Vec3 middle_mm(0.0);
  for (const Vec3& point_mm : hole.rim_mm) middle_mm += point_mm;
  middle_mm /= static_cast<double>(hole.rim_mm.size());
  HoleShape shape{{rotation_to(glm::normalize(hole.outward)), middle_mm}, {}, 0.0};
  const RigidTransform hole_from_world = inverse(shape.world_from_hole);
  for (std::size_t i = 0; i < hole.rim_mm.size(); i += step)
    shape.rim_mm.push_back(transform_point(hole_from_world, hole.rim_mm[i]));
  for (const Vec3& point_mm : shape.rim_mm) shape.radius_mm += glm::length(Vec2(point_mm));
  shape.radius_mm /= static_cast<double>(shape.rim_mm.size());
  return shape;
}

PixelBox hole_pixels(const HoleShape& hole, const EyeView& view, PixelSize size) noexcept {
  constexpr int margin_pixels = 4;
  return widened(pixels_of(box_of(hole), hole.world_from_hole, view, size), margin_pixels, size);
}

HolePainter::HolePainter() : hole_("part.vert", "hole.frag") {}

void HolePainter::draw(const Frame& frame) {
  if (frame.scene.holes.empty()) return;
  hole_.use();
  set_light(hole_, frame);
  set_seen_bone(hole_, frame);
  hole_.set("rim_size", Float2(rim_mm, rim_pixels * frame.pixel_scale));
  const BonePass pass(frame, no_attributes_);
  const BlendOver blend;
  for (const HoleInScene& each : frame.scene.holes) {
    if (each.rim_mm.size() < 3) continue;
    const HoleShape hole = shape_of(each);
    const std::array boxes{hole_pixels(hole, frame.view, frame.target.size)};
    if (boxes.front().is_empty()) continue;
    set_hole(hole_, hole);
    set_boxes(hole_, boxes, frame.target.size);
    for (std::size_t i = 0; i < frame.scene.bones.size(); ++i) {
      pass.take_only(skin_of(i));
      place_bone(hole_, frame, frame.scene.bones[i]);
      draw_boxes(boxes);
    }
  }
}

}  // namespace hallux::ui
