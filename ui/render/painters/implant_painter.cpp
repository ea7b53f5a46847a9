// What is planned is seen through bone, but not through itself, and fainter where bone lies before
// it. In four steps: the stencil learns where it lies before the bones; its depths are laid into
// the nearest sliver of the depth range, before everything; its nearest surface is drawn there with
// the one opacity and with the other; at last the depths are the bones' again, from the shapes'
// buffer.
#include "ui/render/painters/implant_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "simulator/base/check.h"
#include "ui/render/painters/pixel_box.h"
#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/screw_model.h"

namespace hallux::ui {

namespace {

constexpr float before_bone_opacity = 0.86F, in_bone_opacity = 0.55F;
/// Of the depth range.
constexpr double sliver = 1.0e-3;
/// Models kept for implants that the scene has no more.
constexpr std::size_t models_kept = 16;

ToolMesh mesh_of(const simulator::Tool& tool) {
  if (const auto* driver = std::get_if<simulator::WireDriver>(&tool))
    return wire_mesh(driver->wire);
  const auto* screwdriver = std::get_if<simulator::Screwdriver>(&tool);
  CHECK(screwdriver != nullptr);
  return screw_mesh(screwdriver->screw);
}

void let_colours_pass(bool do_they) {
  const GLboolean pass = do_they ? GL_TRUE : GL_FALSE;
  glColorMask(pass, pass, pass, pass);
}

/// The bones' depths in that part of the picture.
void restore_depth(const Frame& frame, const PixelBox& part) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.shapes);
  glBlitFramebuffer(part.left, part.bottom, part.right, part.top, part.left, part.bottom,
                    part.right, part.top, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame.target.framebuffer);
}

}  // namespace

Box box_of(const simulator::Tool& implant) noexcept {
  const double radius_mm = held_radius_mm(implant);
  double back_mm = 0.0;
  if (const auto* driver = std::get_if<simulator::WireDriver>(&implant))
    back_mm = driver->wire.length_mm;
  if (const auto* screwdriver = std::get_if<simulator::Screwdriver>(&implant))
    back_mm = screwdriver->screw.length_mm + screwdriver->screw.head_height_mm;
  Box box;
  box.add(Vec3(-back_mm, -radius_mm, -radius_mm));
  box.add(Vec3(0.0, radius_mm, radius_mm));
  return box;
}

ImplantPainter::ImplantPainter(PartPainter& parts)
    : parts_(parts), planned_("tool.vert", "planned.frag") {}

const ToolView& ImplantPainter::view_of(const Scene& scene, const simulator::Tool& tool) {
  const auto is_of = [](const simulator::Tool& wanted) {
    return [&wanted](const auto& has) { return has.tool == wanted; };
  };
  if (const auto found = std::ranges::find_if(models_, is_of(tool)); found != models_.end())
    return found->view;
  if (models_.size() >= models_kept) {
    std::erase_if(models_, [&](const Model& model) {
      return std::ranges::none_of(scene.implants, is_of(model.tool));
    });
  }
  return models_.emplace_back(Model{tool, ToolView(mesh_of(tool))}).view;
}

void ImplantPainter::draw_planned(const Frame& frame, const ImplantInScene& implant) {
  const ToolView& view = view_of(frame.scene, implant.tool);
  const PixelBox part = common(
      pixels_of(box_of(implant.tool), implant.world_from_tool, frame.view, frame.target.size),
      all_of(frame.target.size));
  if (part.is_empty()) return;
  set_scissor(part);
  planned_.use();
  set_part(planned_, frame, implant.world_from_tool);
  glClear(GL_STENCIL_BUFFER_BIT);
  let_colours_pass(false);
  glDepthMask(GL_FALSE);
  glStencilFunc(GL_ALWAYS, 1, 0xff);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  view.draw();
  glDepthMask(GL_TRUE);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDepthRange(0.0, sliver);
  view.draw();
  let_colours_pass(true);
  glEnable(GL_BLEND);
  for (const bool is_before_bone : {false, true}) {
    glStencilFunc(GL_EQUAL, is_before_bone ? 1 : 0, 0xff);
    planned_.set("ink", Float4(colour_of(frame.palette, Ink::Reference),
                               is_before_bone ? before_bone_opacity : in_bone_opacity));
    view.draw();
  }
  glDisable(GL_BLEND);
  glDepthRange(0.0, 1.0);
  restore_depth(frame, part);
}

void ImplantPainter::draw_planned(const Frame& frame) {
  const auto is_planned = [](const ImplantInScene& implant) { return implant.is_planned; };
  if (std::ranges::none_of(frame.scene.implants, is_planned)) return;
  glEnable(GL_STENCIL_TEST);
  for (const ImplantInScene& implant : frame.scene.implants) {
    if (implant.is_planned) draw_planned(frame, implant);
  }
  glDisable(GL_STENCIL_TEST);
  set_scissor(all_of(frame.target.size));
}

void ImplantPainter::draw_standing(const Frame& frame) {
  for (const ImplantInScene& implant : frame.scene.implants) {
    if (implant.is_planned) continue;
    parts_.draw(frame, {view_of(frame.scene, implant.tool), implant.world_from_tool});
  }
}

std::size_t ImplantPainter::triangle_count(const Scene& scene) const noexcept {
  std::size_t count = 0;
  for (const ImplantInScene& implant : scene.implants) {
    const auto found = std::ranges::find_if(
        models_, [&](const Model& model) { return model.tool == implant.tool; });
    if (found != models_.end()) count += found->view.triangle_count();
  }
  return count;
}

}  // namespace hallux::ui
