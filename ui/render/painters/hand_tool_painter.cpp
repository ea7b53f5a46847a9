// Chuck and what it holds turn, the body does not. The arms of the forceps are one mesh and its
// mirror image, each turned about the joint to its side.
#include "ui/render/painters/hand_tool_painter.h"

#include "simulator/base/check.h"
#include "ui/render/scene/driver_model.h"
#include "ui/render/scene/forceps_model.h"

namespace hallux::ui {

namespace {

RigidTransform world_from_turned(const DriverInScene& driver) {
  if (!driver.is_running) return driver.world_from_tool;
  return driver.world_from_tool *
         RigidTransform{rotation_about(Vec3(1.0, 0.0, 0.0), driver.turned_rad), Vec3(0.0)};
}

/// Of both arms: the second one's frame is the first one's in the mirror y = 0.
std::array<RigidTransform, 2> world_from_arms(const ForcepsInScene& forceps) {
  const RigidTransform first = tool_from_arm(forceps.opening_mm);
  const RigidTransform second{glm::conjugate(first.rotation), first.translation_mm};
  return {forceps.world_from_tool * first, forceps.world_from_tool * second};
}

std::array<ToolView, 2> both_arms(const ToolMesh& mesh) {
  return {ToolView(mesh), ToolView(mirrored_in_y(mesh))};
}

}  // namespace

HandToolPainter::Driver& HandToolPainter::model_of(const simulator::Tool& tool) {
  CHECK(!std::holds_alternative<simulator::Saw>(tool));
  if (!driver_ || driver_->tool != tool) {
    driver_.emplace(Driver{tool, ToolView(held_mesh(tool)), ToolView(blur_mesh(tool)),
                           ToolView(chuck_mesh(tool)), ToolView(driver_body_mesh(tool))});
  }
  return *driver_;
}

HandToolPainter::Forceps& HandToolPainter::forceps() {
  if (!forceps_) forceps_.emplace(Forceps{both_arms(jaw_mesh()), both_arms(forceps_handle_mesh())});
  return *forceps_;
}

std::array<PlacedPart, 1> HandToolPainter::held_part(const DriverInScene& driver) {
  return {PlacedPart{model_of(driver.tool).held, world_from_turned(driver)}};
}

std::array<PlacedPart, 2> HandToolPainter::handle_parts(const DriverInScene& driver) {
  const Driver& model = model_of(driver.tool);
  return {PlacedPart{model.chuck, world_from_turned(driver)},
          PlacedPart{model.body, driver.world_from_tool}};
}

std::array<PlacedPart, 2> HandToolPainter::handle_parts(const ForcepsInScene& forceps) {
  const auto world_from_arm = world_from_arms(forceps);
  const Forceps& model = this->forceps();
  return {PlacedPart{model.handles[0], world_from_arm[0]},
          PlacedPart{model.handles[1], world_from_arm[1]}};
}

void HandToolPainter::draw_tips(const Frame& frame, HandlePart which) {
  if (const auto& driver = frame.scene.driver)
    parts_.draw_handle(frame, held_of(*driver), held_part(*driver), which);
  if (!frame.scene.forceps) return;
  const auto world_from_arm = world_from_arms(*frame.scene.forceps);
  for (std::size_t arm = 0; arm < world_from_arm.size(); ++arm)
    parts_.draw(frame, {forceps().jaws[arm], world_from_arm[arm]});
}

void HandToolPainter::draw_handles(const Frame& frame, HandlePart which) {
  if (const auto& driver = frame.scene.driver)
    parts_.draw_handle(frame, handle_of(*driver), handle_parts(*driver), which);
  if (const auto& forceps = frame.scene.forceps)
    parts_.draw_handle(frame, handle_of(*forceps), handle_parts(*forceps), which);
}

void HandToolPainter::draw(const Frame& frame) {
  draw_handles(frame, HandlePart::Whole);
  draw_tips(frame, HandlePart::Whole);
}

void HandToolPainter::draw_blur(const Frame& frame) {
  const auto& driver = frame.scene.driver;
  if (!driver || !driver->is_running) return;
  const ToolView& blur = model_of(driver->tool).blur;
  if (blur.triangle_count() == 0) return;
  parts_.draw_ghost(frame, {blur, driver->world_from_tool}, Float4(0.46F, 0.48F, 0.51F, 0.52F));
}

void HandToolPainter::draw_seen_through(const Frame& frame) {
  if (const auto& driver = frame.scene.driver) {
    parts_.draw_seen_through(frame, held_of(*driver), held_part(*driver));
    parts_.draw_seen_through(frame, handle_of(*driver), handle_parts(*driver));
  }
  if (const auto& forceps = frame.scene.forceps)
    parts_.draw_seen_through(frame, handle_of(*forceps), handle_parts(*forceps));
}

std::size_t HandToolPainter::triangle_count(const Scene& scene) const noexcept {
  std::size_t count = 0;
  if (scene.driver && driver_) {
    count += driver_->held.triangle_count() + driver_->chuck.triangle_count() +
             driver_->body.triangle_count();
  }
  if (scene.forceps && forceps_)
    count += 2 * (forceps_->jaws[0].triangle_count() + forceps_->handles[0].triangle_count());
  return count;
}

}  // namespace hallux::ui
