#include "scenarios/hands/stroke_timing.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/check.h"
#include "simulator/contact/feed.h"
#include "simulator/contact/tool_motion.h"

namespace hallux::scenarios {

namespace {

using simulator::Engagement;
using simulator::Tissue;

constexpr double stride_mm = 0.1;
/// Through air and open slots a hand does not rush.
constexpr double free_mm_s = 3.0;

/// The blade on its way: where it is, what it goes through.
struct BladeWay {
  const simulator::KerfPlane& plane;
  const simulator::TissueMap& tissue;
  double width_mm;
};

bool is_open(std::span<const Stroke> earlier, double feed_mm, double along_mm, double width_mm) {
  return std::any_of(earlier.begin(), earlier.end(), [&](const Stroke& stroke) {
    return std::abs(along_mm - stroke.along_mm) <= 0.5 * width_mm && feed_mm <= stroke.last_mm;
  });
}

/// The hardest tissue over a tooth's thickness, summed over the tooth line where earlier strokes left bone.
Engagement expected_engagement(double feed_mm, const Stroke& stroke,
                               std::span<const Stroke> earlier, const BladeWay& blade,
                               simulator::TeethMemory& memory) {
  const double share_mm = blade.width_mm / static_cast<double>(simulator::tooth_count);
  Engagement engaged;
  for (std::size_t tooth = 0; tooth < simulator::tooth_count; ++tooth) {
    const double along_mm =
        stroke.along_mm - 0.5 * blade.width_mm + (static_cast<double>(tooth) + 0.5) * share_mm;
    if (is_open(earlier, feed_mm, along_mm, blade.width_mm)) continue;
    Tissue hardest = Tissue::None;
    for (std::size_t layer = 0; layer < simulator::tooth_layers; ++layer) {
      const double aside_mm = simulator::tooth_layer_share * blade.plane.thickness_mm *
                              (static_cast<double>(layer) - 1.0);
      const Vec3 point =
          transform_point(blade.plane.bone_from_kerf, Vec3{feed_mm, along_mm, aside_mm});
      hardest =
          std::max(hardest, blade.tissue.at(point, memory[layer * simulator::tooth_count + tooth]));
    }
    if (hardest == Tissue::Cortical) engaged.cortical_mm += share_mm;
    if (hardest == Tissue::Cancellous) engaged.cancellous_mm += share_mm;
  }
  return engaged;
}

}  // namespace

std::vector<FeedMoment> predict_feed(const Stroke& stroke, std::span<const Stroke> earlier,
                                     const simulator::KerfPlane& plane,
                                     const simulator::TissueMap& tissue, double blade_width_mm,
                                     double cycles_per_minute, const Push& push) {
  CHECK(push.steady_newton > simulator::cortical_threshold_newton &&
        push.exit_newton > simulator::cortical_threshold_newton);
  const BladeWay blade{plane, tissue, blade_width_mm};
  simulator::TeethMemory memory{};
  std::vector<FeedMoment> moments;
  FeedMoment now{0.0, stroke.first_mm, 0.0};
  bool has_met_bone = false;
  for (; now.feed_mm < stroke.last_mm; now.feed_mm += stride_mm) {
    const Engagement engaged = expected_engagement(now.feed_mm, stroke, earlier, blade, memory);
    has_met_bone = has_met_bone || engaged.width_mm() > 0.0;
    const double wanted_newton =
        now.feed_mm > stroke.last_mm - push.exit_mm ? push.exit_newton : push.steady_newton;
    now.push_newton = has_met_bone ? wanted_newton : 0.0;
    moments.push_back(now);
    const double rate_mm_s =
        engaged.width_mm() > 0.0
            ? simulator::feed_rate_mm_s(engaged, now.push_newton, cycles_per_minute)
            : free_mm_s;
    now.time_s += stride_mm / std::min(rate_mm_s, free_mm_s);
  }
  moments.push_back(now);
  return moments;
}

}  // namespace hallux::scenarios
