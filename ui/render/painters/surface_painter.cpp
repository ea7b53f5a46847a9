// Lines and rings on bones, a pass each over the pixels where they can be: what a pixel shows of
// which bone stands in the shapes' textures, so that nothing has to be projected on anything.
#include "ui/render/painters/surface_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "simulator/base/check.h"
#include "ui/render/painters/bone_pass.h"
#include "ui/render/scene/plane_fade.h"

namespace hallux::ui {

namespace {

constexpr Vec3 x_axis(1.0, 0.0, 0.0), y_axis(0.0, 1.0, 0.0), z_axis(0.0, 0.0, 1.0);

/// Half a line and its soft edge.
constexpr int beside_lines_pixels = 4;
/// A dash and the gap behind it.
constexpr double dash_pixels = 11.0;
/// Where there is no end.
constexpr double endless_mm = 1.0e6;

/// Width of a pixel at a place of the world.
double pixel_mm(const Frame& frame, const Vec3& place_mm) {
  const double away_mm = glm::length(place_mm - frame.view.eye_in_world_mm);
  return 2.0 * away_mm / (frame.view.clip_from_view[1][1] * frame.target.size.height);
}

Float4 plane_through(const RigidTransform& world_from_plane, const Vec3& axis) {
  const Vec3 direction = world_from_plane.rotation * axis;
  return Float4(to_float(direction), glm::dot(direction, world_from_plane.translation_mm));
}

Vec2 reach_of(const CuttingLine& line) {
  return Vec2(line.half_mm.x > 0.0 ? line.half_mm.x : endless_mm,
              line.half_mm.y > 0.0 ? line.half_mm.y : endless_mm);
}

struct LineUniforms {
  std::array<Float4, lines_at_most> normal{}, along{}, across{}, style{}, reach{}, more{};
};

void set_lines(ShaderProgram& program, const Frame& frame, std::span<const CuttingLine> lines) {
  LineUniforms uniforms;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const CuttingLine& line = lines[i];
    const RigidTransform& plane = line.world_from_plane;
    const double dash_mm =
        line.is_dashed ? dash_pixels * frame.pixel_scale * pixel_mm(frame, plane.translation_mm)
                       : 0.0;
    const Vec2 reach_mm = reach_of(line);
    uniforms.normal[i] = plane_through(plane, z_axis);
    uniforms.along[i] = plane_through(plane, x_axis);
    uniforms.across[i] = plane_through(plane, y_axis);
    uniforms.style[i] =
        Float4(colour_of(frame.palette, line.ink), 0.5 * line.width_pixels * frame.pixel_scale);
    uniforms.reach[i] = Float4(reach_mm.x, reach_mm.y, line.faint_mm, dash_mm);
    uniforms.more[i] = Float4(line.presence, line.tick_mm, 0.0, 0.0);
  }
  program.set("line_normal", uniforms.normal);
  program.set("line_along", uniforms.along);
  program.set("line_across", uniforms.across);
  program.set("line_style", uniforms.style);
  program.set("line_reach", uniforms.reach);
  program.set("line_more", uniforms.more);
}

/// Where lines can be on that bone.
std::vector<PixelBox> lined_pixels(const Frame& frame, const BoneInScene& bone,
                                   std::span<const CuttingLine> lines) {
  PixelTiles tiles{frame.target.size};
  const Vec3 eye_in_bone_mm =
      transform_point(inverse(bone.world_from_bone), frame.view.eye_in_world_mm);
  const int margin = static_cast<int>(std::ceil(beside_lines_pixels * frame.pixel_scale));
  for (const CuttingLine& line : lines) {
    const RigidTransform plane_from_bone = inverse(line.world_from_plane) * bone.world_from_bone;
    const Vec2 reach_mm = reach_of(line) + Vec2(line.faint_mm);
    const auto is_met = [&](const Vec3& middle_mm, double radius_mm) {
      const Vec3 place_mm = transform_point(plane_from_bone, middle_mm);
      return std::abs(place_mm.z) <= radius_mm + line.tick_mm &&
             std::abs(place_mm.x) <= reach_mm.x + radius_mm &&
             std::abs(place_mm.y) <= reach_mm.y + radius_mm;
    };
    for (const TriangleCluster& cluster : bone.mesh->skin_clusters) {
      if (!bone.cut_away && faces_away(cluster, eye_in_bone_mm)) continue;
      const SeenBox seen{cluster.box, bone.world_from_bone, frame.view, frame.target.size, margin};
      add_parts(tiles, seen, is_met);
    }
  }
  return tiles.boxes();
}

constexpr double halo_least_mm = 0.6, halo_growth = 0.12, halo_most_mm = 3.0;
/// From here on it grows fainter with the distance.
constexpr double halo_whole_mm = 8.0, halo_faint_mm = 30.0, halo_faint = 0.35;
/// How far behind its nearest place the bone is still drawn on.
constexpr double halo_depth_mm = 6.0;

double halo_radius_mm(const ContactHalo& halo) {
  if (halo.kind == HaloKind::Behind) return 1.4;
  return std::min(halo_least_mm + halo_growth * std::max(halo.distance_mm, 0.0), halo_most_mm);
}

double halo_presence(const ContactHalo& halo) {
  const double share = (halo.distance_mm - halo_whole_mm) / (halo_faint_mm - halo_whole_mm);
  return 1.0 - (1.0 - halo_faint) * std::clamp(share, 0.0, 1.0);
}

/// The pixels on which the ring can lie.
PixelBox halo_pixels(const Frame& frame, const ContactHalo& halo) {
  const double radius_mm = halo_radius_mm(halo) + 0.5;
  const double side_mm = halo.half_width_mm + radius_mm;
  Box box;
  if (halo.kind == HaloKind::Behind) {
    box.add(Vec3(-radius_mm, -side_mm, -side_mm));
    box.add(Vec3(side_mm, side_mm, side_mm));
  } else {
    box.add(Vec3(-1.0, -side_mm, -radius_mm));
    box.add(Vec3(halo.distance_mm + halo_depth_mm, side_mm, radius_mm));
  }
  return widened(pixels_of(box, halo.world_from_tool, frame.view, frame.target.size),
                 beside_lines_pixels, frame.target.size);
}

/// The frame in which the ring is drawn: y along the teeth, z across them, x away from the viewer
/// or along the feed; and half of the ring's straight sides.
struct HaloFrame {
  RigidTransform world_from_ring;
  double half_mm = 0.0;
};
HaloFrame halo_frame(const ContactHalo& halo, const Vec3& eye_mm) {
  if (halo.kind != HaloKind::Behind) return {halo.world_from_tool, halo.half_width_mm};
  const Vec3 tip_mm = halo.world_from_tool.translation_mm;
  const Vec3 away = glm::normalize(tip_mm - eye_mm);
  const Vec3 teeth = halo.world_from_tool.rotation * y_axis;
  Vec3 along = teeth - glm::dot(teeth, away) * away;
  const double share = glm::length(along);
  along = share > 1.0e-3 ? along / share : halo.world_from_tool.rotation * z_axis;
  return {{rotation_from_axes(away, along), tip_mm}, share * halo.half_width_mm};
}

void set_halo(ShaderProgram& program, const Frame& frame, const ContactHalo& halo) {
  const HaloFrame ring = halo_frame(halo, frame.view.eye_in_world_mm);
  const double dash_mm =
      dash_pixels * frame.pixel_scale * pixel_mm(frame, halo.world_from_tool.translation_mm);
  const bool is_behind = halo.kind == HaloKind::Behind;
  program.set("ring_from_world", to_float(matrix_of(inverse(ring.world_from_ring))));
  program.set("ring_along", to_float(ring.world_from_ring.rotation * y_axis));
  program.set("ring_across", to_float(ring.world_from_ring.rotation * z_axis));
  program.set("ring", Float4(ring.half_mm, halo_radius_mm(halo),
                             is_behind ? endless_mm : halo.distance_mm + halo_depth_mm,
                             is_behind ? dash_mm : 0.0));
  program.set("half_pixels", static_cast<float>(1.4 * frame.pixel_scale));
  program.set("fill", halo.kind == HaloKind::On ? 0.55F : is_behind ? 0.0F : 0.18F);
  program.set("halo_presence", static_cast<float>(halo_presence(halo)));
  program.set("is_behind", is_behind ? 1.0F : 0.0F);
  program.set("ink", colour_of(frame.palette, Ink::Accent));
}

}  // namespace

SurfacePainter::SurfacePainter() : halo_("part.vert", "bone_halo.frag") {}

ShaderProgram& SurfacePainter::lines_program(std::size_t count) {
  auto at = lines_.find(count);
  if (at == lines_.end()) {
    const std::string settings = "#define LINES " + std::to_string(count) + "\n";
    at = lines_.emplace(count, ShaderProgram("part.vert", "bone_lines.frag", settings)).first;
  }
  return at->second;
}

void SurfacePainter::draw_lines(const Frame& frame) {
  const std::vector<CuttingLine> lines = all_lines(frame.scene, frame.view.eye_in_world_mm);
  CHECK(lines.size() <= lines_at_most);
  if (lines.empty()) return;
  ShaderProgram& program = lines_program(lines.size());
  program.use();
  program.set("eye_mm", to_float(frame.view.eye_in_world_mm));
  set_seen_bone(program, frame);
  set_lines(program, frame, lines);
  const BonePass pass(frame, no_attributes_);
  const BlendOver blend;
  for (std::size_t i = 0; i < frame.scene.bones.size(); ++i) {
    const BoneInScene& bone = frame.scene.bones[i];
    if (bone.presence < 1.0) continue;
    const std::vector<PixelBox> boxes = lined_pixels(frame, bone, lines);
    pass.take_only(skin_of(i));
    place_bone(program, frame, bone);
    set_boxes(program, boxes, frame.target.size);
    draw_boxes(boxes);
  }
}

void SurfacePainter::draw_halo(const Frame& frame) {
  if (!frame.scene.halo) return;
  const std::array boxes{halo_pixels(frame, *frame.scene.halo)};
  if (boxes.front().is_empty()) return;
  halo_.use();
  halo_.set("eye_mm", to_float(frame.view.eye_in_world_mm));
  set_seen_bone(halo_, frame);
  set_halo(halo_, frame, *frame.scene.halo);
  set_boxes(halo_, boxes, frame.target.size);
  const BonePass pass(frame, no_attributes_);
  const BlendOver blend;
  for (std::size_t i = 0; i < frame.scene.bones.size(); ++i) {
    if (frame.scene.bones[i].presence < 1.0) continue;
    place_bone(halo_, frame, frame.scene.bones[i]);
    for (const int stencil : {skin_of(i), cut_faces_of(i)}) {
      pass.take_only(stencil);
      draw_boxes(boxes);
    }
  }
}

}  // namespace hallux::ui
