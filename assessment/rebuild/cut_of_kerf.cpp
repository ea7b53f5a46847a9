#include "assessment/rebuild/cut_of_kerf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "assessment/rebuild/face_samples.h"
#include "scenarios/site/kerf_of_cut.h"
#include "scenarios/site/planned_window.h"

namespace hallux::assessment {

namespace {

using scenarios::misfit;
using scenarios::Plan;
using scenarios::PlannedHinge;
using simulator::KerfPlane;

/// What is not open is not done, however little is missing.
constexpr double almost_done = 0.999;
/// Less than this of a cut is a false start.
constexpr double least_cut = 0.5;

/// Moves one of several kerfs of `from` to `to`, which has none.
void share_out(std::vector<std::size_t>& cuts, const std::vector<std::int32_t>& sawn,
               const RebuiltBone& rebuilt, const Plan& plan, std::size_t from, std::size_t to) {
  std::optional<std::int32_t> chosen;
  double least = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for (const std::int32_t kerf : sawn) {
    const std::size_t cut = cuts[static_cast<std::size_t>(kerf)];
    if (cut == to) return;
    if (cut != from) continue;
    ++count;
    const KerfPlane& plane = rebuilt.fields.plane(kerf);
    const double loss = misfit(plane, plan.cuts[to]) - misfit(plane, plan.cuts[from]);
    if (loss >= least) continue;
    least = loss;
    chosen = kerf;
  }
  if (count > 1 && chosen) cuts[static_cast<std::size_t>(*chosen)] = to;
}

}  // namespace

double done_fraction_of(const RebuiltBone& rebuilt, std::int32_t kerf, const PlannedHinge* hinge) {
  if (hinge == nullptr) return rebuilt.kerfs[static_cast<std::size_t>(kerf)].done_fraction();
  const double kerf_mm = rebuilt.fields.plane(kerf).thickness_mm;
  const double share = opened_share(rebuilt, kerf, window_before(*hinge, kerf_mm));
  return share == 1.0 ? share : std::min(share, almost_done);
}

std::vector<std::size_t> cuts_of_kerfs(const RebuiltBone& rebuilt, const Plan& plan) {
  std::vector<std::size_t> cuts;
  cuts.reserve(rebuilt.kerfs.size());
  for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
    cuts.push_back(scenarios::nearest_cut(rebuilt.fields.plane(kerf), plan));
  }
  for (const PlannedHinge& hinge : plan.hinges) {
    std::vector<std::int32_t> sawn;
    for (std::int32_t kerf = 0; kerf < rebuilt.fields.count(); ++kerf) {
      if (done_fraction_of(rebuilt, kerf, &hinge) >= least_cut) sawn.push_back(kerf);
    }
    const std::size_t first = index_of_cut(plan, hinge.first_cut);
    const std::size_t second = index_of_cut(plan, hinge.second_cut);
    share_out(cuts, sawn, rebuilt, plan, first, second);
    share_out(cuts, sawn, rebuilt, plan, second, first);
  }
  return cuts;
}

}  // namespace hallux::assessment
