#include "scenarios/foot/foot_bones.h"

#include <algorithm>
#include <array>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"
#include "scenarios/foot/make_bone.h"

namespace hallux::scenarios {
namespace {

constexpr std::array rows{
    FootBone{.name = "first_metatarsal",
             .title = "first metatarsal",
             .table = first_metatarsal_table,
             .find_landmarks = first_metatarsal_landmarks,
             .neighbour = "first_proximal_phalanx",
             .length_low_mm = 40.0,
             .length_high_mm = 90.0,
             .has_eminence = true},
    FootBone{.name = "first_proximal_phalanx",
             .title = "first proximal phalanx",
             .table = first_proximal_phalanx_table,
             .find_landmarks = first_proximal_phalanx_landmarks,
             .neighbour = "first_metatarsal",
             .length_low_mm = 18.0,
             .length_high_mm = 45.0},
};

}  // namespace

std::span<const FootBone> foot_bones() noexcept { return rows; }

const FootBone* find_foot_bone(std::string_view name, std::span<const FootBone> bones) noexcept {
  const auto found = std::ranges::find(bones, name, &FootBone::name);
  return found == bones.end() ? nullptr : &*found;
}

std::string names_of(std::span<const FootBone> bones) {
  std::string names;
  for (const FootBone& bone : bones) {
    if (!names.empty()) names += ", ";
    names += bone.name;
  }
  return names;
}

simulator::Bone make_foot_bone(const FootBone& bone, const BoneRequest& request,
                               const Progress& progress) {
  return make_bone(bone.table(), request, {bone.name, bone.find_landmarks}, progress);
}

}  // namespace hallux::scenarios
