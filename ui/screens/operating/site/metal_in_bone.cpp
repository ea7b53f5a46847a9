#include "ui/screens/operating/site/metal_in_bone.h"

#include <cmath>

#include "simulator/cutting/hole/hole_rim.h"

namespace hallux::ui {

namespace {

using simulator::Bore;

/// The rim at the far side comes with the depth: so coarse is seen by nobody.
constexpr double depth_step_mm = 0.5;

std::vector<HoleInScene> rims_on(const Bore& bore, const FragmentSkin& skin) {
  std::vector<HoleInScene> rims;
  const Vec3 along = axis_x(bore.body_from_bore);
  for (simulator::HoleRim& rim : hole_rims(*skin.mesh, *skin.tree, capsule_of(bore))) {
    const bool is_entry = rim.way_mm < 0.5 * bore.depth_mm;
    rims.push_back({std::move(rim.points_mm), is_entry ? -along : along});
  }
  return rims;
}

}  // namespace

const std::vector<HoleInScene>& MetalInBone::rims_of(std::size_t place, const Bore& bore,
                                                     const FragmentSkin& skin) {
  if (known_.size() <= place) known_.resize(place + 1);
  KnownHole& known = known_[place];
  const double depth_mm = depth_step_mm * std::floor(bore.depth_mm / depth_step_mm);
  if (known.skin != skin.id || known.depth_mm != depth_mm)
    known = {skin.id, depth_mm, rims_on(bore, skin)};
  return known.rims;
}

MetalShown MetalInBone::renew(const simulator::LiveCut& cut,
                              const std::vector<FragmentSkin>& skins) {
  MetalShown shown;
  const auto is_shown = [&](std::int32_t fragment) {
    const auto number = static_cast<std::size_t>(fragment);
    return number < skins.size() && skins[number].tree != nullptr;
  };
  for (const simulator::Implant& implant : cut.implants().all()) {
    if (implant.is_taken || !is_shown(implant.fragment)) continue;
    shown.implants.push_back(
        {implant.fragment, {implant.fragment_from_tool, cut.kerfs().tray()[implant.tool]}});
  }
  const std::span<const simulator::BorePlace> places = cut.bores().places();
  for (std::size_t place = 0; place < places.size(); ++place) {
    const std::int32_t fragment = places[place].fragment;
    if (places[place].bore.depth_mm <= 0.0 || !is_shown(fragment)) continue;
    const FragmentSkin& skin = skins[static_cast<std::size_t>(fragment)];
    for (const HoleInScene& rim : rims_of(place, places[place].bore, skin))
      shown.holes.push_back({fragment, rim});
  }
  return shown;
}

void add_metal(Scene& scene, const MetalShown& metal,
               const std::function<RigidTransform(std::int32_t)>& world_from_fragment) {
  for (const MetalShown::Standing& standing : metal.implants) {
    ImplantInScene implant = standing.implant;
    implant.world_from_tool = world_from_fragment(standing.fragment) * implant.world_from_tool;
    scene.implants.push_back(implant);
  }
  for (const MetalShown::Hole& each : metal.holes) {
    const RigidTransform world_from_hole = world_from_fragment(each.fragment);
    HoleInScene hole = each.hole;
    for (Vec3& point_mm : hole.rim_mm) point_mm = transform_point(world_from_hole, point_mm);
    hole.outward = transform_direction(world_from_hole, hole.outward);
    scene.holes.push_back(std::move(hole));
  }
}

}  // namespace hallux::ui
