// The section of a moment follows from the stretch's solid, which stands still: its tree is built
// once, beside the window, when somebody first looks. In the kerf's plane a section is made anew
// where the kerf grew; in the blade's own, where the blade moved out of it.
#include "ui/screens/replay/blade_inset.h"

#include <algorithm>
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

/// Of the cuts on that bone, the hinge of the planned one that the blade lies in.
const scenarios::PlannedHinge* hinge_at(const scenarios::Plan& plan, std::size_t bone,
                                        const RigidTransform& first_from_tool, double kerf_mm) {
  const simulator::KerfPlane plane{first_from_tool, kerf_mm};
  const std::size_t nearest = nearest_cut(plane, plan, bone);
  if (nearest == plan.cuts.size()) return nullptr;
  const scenarios::PlannedCut& cut = plan.cuts[nearest];
  return misfit(plane, cut) < same_cut_misfit ? find_hinge(plan, cut.hinge) : nullptr;
}

/// The bone of the planned cut that begins nearest to the blade.
std::int32_t bone_at(const scenarios::Plan& plan, const Vec3& tip_in_first_mm) {
  const auto nearest =
      std::ranges::min_element(plan.cuts, {}, [&](const scenarios::PlannedCut& cut) {
        return squared_length(cut.entry_point_in_bone_mm - tip_in_first_mm);
      });
  return static_cast<std::int32_t>(nearest->bone);
}

/// As far as the section tells; nothing beside the bone.
/// hinge  of the planned cut that the blade lies in, or null
std::optional<WayAhead> way_in(const BladeSection& section, const scenarios::PlannedHinge* hinge,
                               const RigidTransform& first_from_tool) {
  const simulator::BladeAhead ahead = ahead_in(section);
  if (!ahead.to_bone_mm) return std::nullopt;
  std::optional<double> to_hinge_mm;
  if (hinge != nullptr) to_hinge_mm = way_to_hinge_mm(*hinge, first_from_tool);
  return way_ahead(ahead, to_hinge_mm);
}

}  // namespace

const simulator::Bvh* BladeInset::tree_of(Shell& shell,
                                          const std::shared_ptr<const ReplayMaterial>& material,
                                          const Solid& solid) {
  const auto known = trees_->find(solid);
  if (known != trees_->end()) return known->second.get();
  trees_->emplace(solid, nullptr);
  auto built = std::make_shared<std::shared_ptr<const simulator::Bvh>>();
  // Without a label, since nobody waits for it.
  shell.background().start(
      {},
      [built, material, solid](WorkReport&) {
        const auto fragment = static_cast<std::size_t>(solid.fragment);
        const BoneMesh& mesh = material->bone->stretches[fragment][solid.stretch];
        *built = std::make_shared<const simulator::Bvh>(mesh.solid.mesh);
      },
      [built, trees = trees_, solid](WorkEnd end, const std::string&) {
        if (end == WorkEnd::Done) (*trees)[solid] = std::move(*built);
      });
  return nullptr;
}

void BladeInset::renew(const simulator::BoneMoment& bone, std::int32_t fragment,
                       const std::optional<simulator::KerfAtHand>& kerf,
                       const simulator::KerfPlane& own, const simulator::Bvh& tree) {
  const bool is_in_kerf =
      kerf && is_in_plane(kerf->opening.plane.bone_from_kerf, own.bone_from_kerf);
  const bool is_same = is_made_ && fragment_ == fragment &&
                       revision_ == bone.revision_of(fragment) && is_in_kerf == is_in_kerf_ &&
                       (is_in_kerf || !is_moved(fragment_from_plane_, own.bone_from_kerf));
  if (is_same) return;
  section_ = kerf_section(bone.fragment(fragment).solid(), tree,
                          is_in_kerf ? kerf->opening : simulator::KerfOpening{own, {}});
  fragment_from_plane_ = section_.bone_from_plane;
  fragment_ = fragment;
  revision_ = bone.revision_of(fragment);
  is_in_kerf_ = is_in_kerf;
  is_made_ = true;
}

void BladeInset::draw(Ui& ui, Shell& shell, const Rect& rect,
                      const std::shared_ptr<const ReplayMaterial>& material,
                      simulator::BoneMoment& bone, const HandAtMoment& hand, bool shows_plan) {
  const std::optional<simulator::KerfAtHand> kerf = bone.kerf_at_hand();
  const RigidTransform first_from_world = inverse(material->world_from_bone);
  const RigidTransform first_from_tool = first_from_world * hand.world_from_tool;
  const std::int32_t fragment =
      kerf ? kerf->fragment : bone_at(material->plan, first_from_tool.translation_mm);
  if (!bone.fragment(fragment).is_there()) return;
  const simulator::Bvh* tree =
      tree_of(shell, material, {fragment, bone.fragment(fragment).stretch()});
  if (tree == nullptr) return;
  const simulator::Blade& blade = std::get<simulator::Saw>(*hand.tool.tool).blade;
  const RigidTransform world_from_fragment = bone.world_from_fragment(fragment);
  renew(bone, fragment, kerf, {inverse(world_from_fragment) * hand.world_from_tool, blade.kerf_mm},
        *tree);
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  // The plan is said in the frame of the first bone, and of bones that are whole.
  section_.bone_from_plane = first_from_world * world_from_fragment * fragment_from_plane_;
  const auto of_bone = static_cast<std::size_t>(fragment);
  const bool is_bone = of_bone < material->bone->history->world_from_bones.size();
  const scenarios::Plan* const plan = shows_plan && is_bone ? &material->plan : nullptr;
  BladeSection shown = blade_section(section_, first_from_tool, blade, plan);
  const scenarios::PlannedHinge* const hinge =
      plan == nullptr ? nullptr : hinge_at(*plan, of_bone, first_from_tool, blade.kerf_mm);
  shown.way = way_in(shown, hinge, first_from_tool);
  draw_blade_section(ui, inset(rect, 8.0F), shown);
}

}  // namespace hallux::ui
