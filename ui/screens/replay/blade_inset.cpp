// The section of a moment follows from the stretch's solid, which stands still: its tree is built
// once, beside the window, when somebody first looks. In the kerf's plane a section is made anew
// where the kerf grew; in the blade's own, where the blade moved out of it.
#include "ui/screens/replay/blade_inset.h"

#include <cmath>
#include <utility>

#include "scenarios/site/kerf_of_cut.h"
#include "ui/screens/pictures/blade_section_view.h"
#include "ui/screens/pictures/way_ahead.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

/// Out of its own plane.
constexpr double same_section_mm = 0.1, same_section_rad = 0.0035;
/// Of a blade that saws a planned face: further off it is on its way.
constexpr double same_cut_misfit = 12.0;

bool is_moved(const RigidTransform& bone_from_plane, const RigidTransform& bone_from_tool) {
  const RigidTransform moved = inverse(bone_from_plane) * bone_from_tool;
  const Vec3 normal = moved.rotation * Vec3(0.0, 0.0, 1.0);
  return std::abs(moved.translation_mm.z) > same_section_mm ||
         glm::length(Vec2(normal.x, normal.y)) > same_section_rad;
}

/// The hinge of the planned cut that the blade lies in.
const scenarios::PlannedHinge* hinge_at(const scenarios::Plan& plan,
                                        const RigidTransform& bone_from_tool, double kerf_mm) {
  if (plan.cuts.empty()) return nullptr;
  const simulator::KerfPlane plane{bone_from_tool, kerf_mm};
  const scenarios::PlannedCut& cut = plan.cuts[nearest_cut(plane, plan)];
  return misfit(plane, cut) < same_cut_misfit ? find_hinge(plan, cut.hinge) : nullptr;
}

/// As far as the section tells; nothing beside the bone.
std::optional<WayAhead> way_in(const BladeSection& section, const scenarios::Plan* plan,
                               const RigidTransform& bone_from_tool, double kerf_mm) {
  const simulator::BladeAhead ahead = ahead_in(section);
  if (!ahead.to_bone_mm) return std::nullopt;
  const scenarios::PlannedHinge* const hinge =
      plan == nullptr ? nullptr : hinge_at(*plan, bone_from_tool, kerf_mm);
  std::optional<double> to_hinge_mm;
  if (hinge != nullptr) to_hinge_mm = way_to_hinge_mm(*hinge, bone_from_tool);
  return way_ahead(ahead, to_hinge_mm);
}

}  // namespace

const simulator::Bvh* BladeInset::tree_of(Shell& shell,
                                          const std::shared_ptr<const ReplayMaterial>& material,
                                          std::size_t stretch) {
  const auto known = trees_->find(stretch);
  if (known != trees_->end()) return known->second.get();
  trees_->emplace(stretch, nullptr);
  auto built = std::make_shared<std::shared_ptr<const simulator::Bvh>>();
  // Without a label, since nobody waits for it.
  shell.background().start(
      {},
      [built, material, stretch](WorkReport&) {
        *built =
            std::make_shared<const simulator::Bvh>(material->bone->stretches[stretch].solid.mesh);
      },
      [built, trees = trees_, stretch](WorkEnd end, const std::string&) {
        if (end == WorkEnd::Done) (*trees)[stretch] = std::move(*built);
      });
  return nullptr;
}

void BladeInset::renew(const ReplayMaterial& material, simulator::BoneMoment& bone,
                       const RigidTransform& bone_from_tool, const simulator::Bvh& tree) {
  const std::optional<simulator::KerfOpening> kerf = bone.kerf_at_hand();
  const bool is_in_kerf = kerf && is_in_plane(kerf->plane.bone_from_kerf, bone_from_tool);
  const bool is_same = is_made_ && revision_ == bone.revision() && is_in_kerf == is_in_kerf_ &&
                       (is_in_kerf || !is_moved(section_.bone_from_plane, bone_from_tool));
  if (is_same) return;
  const simulator::CutSolid& solid = material.bone->stretches[bone.stretch()].solid;
  const simulator::KerfPlane own{bone_from_tool, material.scenario.saw.blade.kerf_mm};
  section_ = kerf_section(solid, tree, is_in_kerf ? *kerf : simulator::KerfOpening{own, {}});
  revision_ = bone.revision();
  is_in_kerf_ = is_in_kerf;
  is_made_ = true;
}

void BladeInset::draw(Ui& ui, Shell& shell, const Rect& rect,
                      const std::shared_ptr<const ReplayMaterial>& material,
                      simulator::BoneMoment& bone, const HandAtMoment& hand, bool shows_plan) {
  if (bone.is_closed()) return;
  const simulator::Bvh* tree = tree_of(shell, material, bone.stretch());
  if (tree == nullptr) return;
  const RigidTransform bone_from_tool = inverse(material->world_from_bone) * hand.world_from_tool;
  renew(*material, bone, bone_from_tool, *tree);
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  const scenarios::Plan* const plan = shows_plan ? &material->plan : nullptr;
  BladeSection shown = blade_section(section_, bone_from_tool, material->scenario.saw.blade, plan);
  shown.way = way_in(shown, plan, bone_from_tool, material->scenario.saw.blade.kerf_mm);
  draw_blade_section(ui, inset(rect, 8.0F), shown);
}

}  // namespace hallux::ui
