// Bone that holds is the bone's section without what is open: both outlines are drawn into the
// stencil, each into a bit of its own that every triangle turns over, and the rectangle around them
// is filled where the first bit is set and the second is not. So no polygons have to be subtracted.
// A capsule is one mesh for all zones, which the shader stretches.
#include "ui/render/painters/site_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "ui/render/painters/pixel_box.h"

namespace hallux::ui {

namespace {

constexpr unsigned bone_bit = 1, opened_bit = 2;
constexpr double stripe_pixels = 17.0, dash_pixels = 12.0, outline_pixels = 2.0;
/// Of a near zone that bone or saw hides.
constexpr double hidden_share = 0.35;

/// Runs of one buffer.
struct Loops {
  std::vector<Float2> points;
  std::vector<GLint> bone_starts, opened_starts, counts;
  Box box;
};

void add_loops(Loops& loops, const std::vector<PlaneLoop>& added, std::vector<GLint>& starts) {
  for (const PlaneLoop& loop : added) {
    if (loop.size() < 3) continue;
    starts.push_back(static_cast<GLint>(loops.points.size()));
    loops.counts.push_back(static_cast<GLint>(loop.size()));
    for (const Vec2& corner : loop) {
      loops.points.push_back(to_float(corner));
      loops.box.add(Vec3(corner, 0.0));
    }
  }
}

Loops loops_of(const HeldBone& held) {
  Loops loops;
  add_loops(loops, held.bone_mm, loops.bone_starts);
  add_loops(loops, held.opened_mm, loops.opened_starts);
  return loops;
}

/// Turns the bit over under each triangle of the loops' fans: what lies in an odd number of loops
/// keeps it set.
void turn_over(unsigned bit, std::span<const GLint> starts, const GLint* counts) {
  glStencilMask(bit);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    glDrawArrays(GL_TRIANGLE_FAN, starts[i], counts[i]);
  }
}

double pixel_at_one_mm(const Frame& frame) {
  return 2.0 / (frame.view.clip_from_view[1][1] * frame.target.size.height);
}

RigidTransform world_from(const ZoneInScene& zone) {
  const Vec3 axis = zone.to_mm - zone.from_mm;
  const double length_mm = glm::length(axis);
  const Vec3 z = length_mm > 0.0 ? axis / length_mm : Vec3(0.0, 0.0, 1.0);
  const Vec3 beside = std::abs(z.x) < 0.8 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const Vec3 x = glm::normalize(glm::cross(beside, z));
  return {rotation_from_axes(x, glm::cross(z, x)), zone.from_mm};
}

}  // namespace

SitePainter::SitePainter() : held_("held.vert", "held.frag"), zone_("zone.vert", "zone.frag") {
  const CapsuleMesh capsule = capsule_mesh();
  capsule_points_.assign(capsule.vertices);
  capsule_points_.upload();
  capsule_triangles_.assign(capsule.triangles);
  capsule_triangles_.upload();
  glBindVertexArray(capsule_array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, capsule_points_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(CapsuleVertex), nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, capsule_triangles_.name());
  glBindVertexArray(0);
}

void SitePainter::draw_held(const Frame& frame) {
  if (frame.scene.held.empty()) return;
  held_.use();
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_STENCIL_TEST);
  for (const HeldBone& held : frame.scene.held) draw_held(frame, held);
  glStencilMask(0xff);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  set_scissor(all_of(frame.target.size));
  glBindVertexArray(0);
}

void SitePainter::draw_held(const Frame& frame, const HeldBone& held) {
  Loops loops = loops_of(held);
  if (loops.bone_starts.empty()) return;
  const auto cover = static_cast<GLint>(loops.points.size());
  for (const double y : {loops.box.low_mm.y, loops.box.high_mm.y}) {
    for (const double x : {loops.box.low_mm.x, loops.box.high_mm.x}) {
      loops.points.push_back(to_float(Vec2(x, y)));
    }
  }
  plane_points_.assign(loops.points);
  plane_points_.upload();
  glBindVertexArray(plane_array_.name());
  if (pointed_at_ != plane_points_.name()) {
    pointed_at_ = plane_points_.name();
    glBindBuffer(GL_ARRAY_BUFFER, pointed_at_);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Float2), nullptr);
  }
  set_scissor(pixels_of(loops.box, held.world_from_kerf, frame.view, frame.target.size));
  held_.set("clip_from_kerf", to_float(frame.clip_from_world * matrix_of(held.world_from_kerf)));
  const double away_mm =
      glm::length(held.world_from_kerf.translation_mm - frame.view.eye_in_world_mm);
  held_.set("stripe_mm", static_cast<float>(stripe_pixels * frame.pixel_scale * away_mm *
                                            pixel_at_one_mm(frame)));
  held_.set("ink", colour_of(frame.palette, Ink::Warn));
  glStencilMask(0xff);
  glClear(GL_STENCIL_BUFFER_BIT);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glStencilFunc(GL_ALWAYS, 0, 0xff);
  glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
  turn_over(bone_bit, loops.bone_starts, loops.counts.data());
  turn_over(opened_bit, loops.opened_starts, loops.counts.data() + loops.bone_starts.size());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilFunc(GL_EQUAL, bone_bit, bone_bit | opened_bit);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glEnable(GL_BLEND);
  glDrawArrays(GL_TRIANGLE_STRIP, cover, 4);
  glDisable(GL_BLEND);
}

void SitePainter::draw_zones(const Frame& frame) {
  if (frame.scene.zones.empty()) return;
  zone_.use();
  zone_.set("clip_from_world", to_float(frame.clip_from_world));
  zone_.set("eye_mm", to_float(frame.view.eye_in_world_mm));
  zone_.set("pixel_and_half",
            Float2(pixel_at_one_mm(frame), 0.5 * outline_pixels * frame.pixel_scale));
  zone_.set("ink", colour_of(frame.palette, Ink::Harm));
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(capsule_array_.name());
  for (const ZoneInScene& zone : frame.scene.zones) draw_zone(frame, zone);
  glBindVertexArray(0);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void SitePainter::draw_zone(const Frame& frame, const ZoneInScene& zone) {
  const double length_mm = glm::length(zone.to_mm - zone.from_mm);
  const double away_mm =
      glm::length(0.5 * (zone.from_mm + zone.to_mm) - frame.view.eye_in_world_mm);
  zone_.set("world_from_zone", to_float(matrix_of(world_from(zone))));
  zone_.set("radius_and_length_mm", Float2(zone.radius_mm, length_mm));
  zone_.set("radius_mm", static_cast<float>(zone.radius_mm));
  zone_.set("is_near", zone.is_near ? 1.0F : 0.0F);
  zone_.set("dash_mm",
            static_cast<float>(dash_pixels * frame.pixel_scale * away_mm * pixel_at_one_mm(frame)));
  const auto draw = [&](double share) {
    zone_.set("presence", static_cast<float>(share * zone.presence));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * capsule_triangles_.size()),
                   GL_UNSIGNED_INT, nullptr);
  };
  draw(1.0);
  if (!zone.is_near) return;
  glDepthFunc(GL_GREATER);
  draw(hidden_share);
  glDepthFunc(GL_LEQUAL);
}

}  // namespace hallux::ui
