#include "ui/screens/operating/hand/rail_of_step.h"

#include "scenarios/planned_guide.h"
#include "scenarios/tray/laid_out_tools.h"

namespace hallux::ui {

namespace {

using simulator::Rail;

/// A plane of the bone in the world.
Rail rail_in_world(const RigidTransform& world_from_bone, const Vec3& normal_in_bone,
                   double offset_mm) {
  const Vec3 normal = world_from_bone.rotation * normal_in_bone;
  return {normal, offset_mm + glm::dot(normal, world_from_bone.translation_mm)};
}

Rail planned_rail(const PreparedCase& prepared_case, const scenarios::PlannedCut& cut) {
  // A face is finished bone: the middle of the blade lies half a kerf further into the waste.
  const double half_kerf_mm = 0.5 * blade_of(prepared_case.scenario, cut).kerf_mm;
  return rail_in_world(prepared_case.bone().world_from_bone, cut.face.normal,
                       cut.face.offset_mm + half_kerf_mm);
}

}  // namespace

std::optional<Rail> rail_of_step(const PreparedCase& prepared_case, std::size_t step,
                                 const std::vector<scenarios::HeldCut>* held,
                                 std::int32_t in_kerf) {
  const scenarios::PlannedCut* const cut =
      cut_at_step(prepared_case.scenario, prepared_case.plan_in_first, step);
  if (cut == nullptr) return std::nullopt;
  const std::size_t index = index_of_cut(prepared_case.plan_in_first, cut->name);
  const bool is_begun = held != nullptr && index < held->size() && (*held)[index].is_begun();
  if (in_kerf >= 0 && (!is_begun || (*held)[index].kerf != in_kerf)) return std::nullopt;
  if (!is_begun) return planned_rail(prepared_case, *cut);
  const RigidTransform bone_from_kerf = (*held)[index].bone_from_kerf_now();
  const Vec3 normal = axis_z(bone_from_kerf);
  return rail_in_world(prepared_case.bone().world_from_bone, normal,
                       glm::dot(normal, bone_from_kerf.translation_mm));
}

}  // namespace hallux::ui
