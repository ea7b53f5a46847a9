#include "simulator/bone/close_bridge.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

struct KerfGap {
  HingeGap gap;
  std::int32_t place = 0;
};

/// The gaps that opened kerfs leave at the bridge, each in the bone as if it were the only kerf;
/// thinnest first.
std::vector<KerfGap> gaps_of_kerfs(CutBone& bone, const HingeLine& line) {
  std::vector<KerfGap> gaps;
  const SolidWithTree whole = bone.before(0);
  for (std::int32_t place = 0; place < bone.kerf_count(); ++place) {
    const OpenedKerf& kerf = bone.kerf(place);
    const Section section = slice_section(whole.solid, whole.bvh, kerf.plane);
    const std::optional<HingeGap> gap = measure_hinge_gap(section, kerf.region, line);
    if (gap && gap->is_opened) gaps.push_back({*gap, place});
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const KerfGap& a, const KerfGap& b) {
    return a.gap.thickness_mm < b.gap.thickness_mm;
  });
  return gaps;
}

}  // namespace

ClosedHinge close_bridge(CutBone& bone, const PlannedBridge& bridge) {
  return close_bridge(bone, bone.pieces().gathered(), bridge);
}

ClosedHinge close_bridge(CutBone& bone, const CutSolid& solid, const PlannedBridge& bridge) {
  ClosedHinge missing;
  missing.outcome = HingeOutcome::FacesMissing;
  const std::vector<KerfGap> gaps = gaps_of_kerfs(bone, bridge.line);
  if (gaps.size() < 2) return missing;
  const HingeRequest request{bone.kerf(gaps[0].place).plane, bone.kerf(gaps[1].place).plane,
                             gaps[0].gap, gaps[1].gap, bridge};
  return close_hinge(solid, Bvh(solid.mesh), request);
}

}  // namespace hallux::simulator
