#include "scenarios/metric_names.h"

#include <algorithm>
#include <array>

namespace hallux::scenarios {
namespace {

using enum MetricSubject;

constexpr std::array<MetricName, 14> metrics{{
    {Metric::AngleDeg,
     "angle_deg",
     "deg",
     Cut,
     {"The face is tilted ", "", ", deepest at its ", " edge"}},
    {Metric::LocationMm,
     "location_mm",
     "mm",
     Cut,
     {"The face lies up to ", " from the plan", ", there too far "}},
    {Metric::DepthMm,
     "depth_mm",
     "mm",
     CutAlong,
     {"At the depth landmark the face is ", " from the planned depth", ", too far "}},
    {Metric::StepMm,
     "step_mm",
     "mm",
     CutAlong,
     {"At the exit the face is ", " off the planned one", ", too far "}},
    {Metric::FlatnessMm,
     "flatness_mm",
     "mm",
     CutOrHinge,
     {"The blade wandered ", " out of its plane, by its poses in the kerf"}},
    {Metric::PastLandmarkMm,
     "past_landmark_mm",
     "mm",
     CutAlong,
     {"The face passes ", " beyond the landmark"}},
    {Metric::NotchMm,
     "notch_mm",
     "mm",
     CutAlong,
     {"At the exit the face runs ", " into the bone that is kept"}},
    {Metric::WedgeErrorDeg,
     "wedge_error_deg",
     "deg",
     Hinge,
     {"The wedge is ", " off the planned angle", ", too "}},
    {Metric::WedgeSagittalDeg,
     "wedge_sagittal_deg",
     "deg",
     Hinge,
     {"The wedge leans ", " in the sagittal plane", ", wider "}},
    {Metric::HingeMm,
     "hinge_mm",
     "mm",
     Hinge,
     {"The hinge is ", " thick", "", "", "The hinge is gone"}},
    {Metric::OverCutMm,
     "over_cut_mm",
     "mm",
     Hinge,
     {"The blade went ", " past the far cortex", "", "", "The blade stayed inside the far cortex"}},
    {Metric::HingeLost, "hinge_lost", "", Hinge, {}, true},
    {Metric::PieceOut, "piece_out", "", Piece, {}, true},
    {Metric::WedgeClosed, "wedge_closed", "", Closing, {}, true},
}};

/// Each metric has its row, at its place, and every one that is no claim has words.
constexpr bool is_whole() {
  if (metrics.size() != static_cast<std::size_t>(Metric::Count)) return false;
  for (std::size_t place = 0; place < metrics.size(); ++place) {
    const MetricName& row = metrics[place];
    if (static_cast<std::size_t>(row.metric) != place || row.name.empty()) return false;
    if (row.is_claim == (row.wording.subject[0] != '\0')) return false;
  }
  return true;
}
static_assert(is_whole(), "a metric lacks its row or its words");

}  // namespace

std::span<const MetricName> known_metrics() noexcept { return metrics; }

const MetricName* find_metric(std::string_view name) noexcept {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const MetricName& metric) { return metric.name == name; });
  return found == metrics.end() ? nullptr : &*found;
}

bool is_claim(std::string_view name) noexcept {
  const MetricName* metric = find_metric(name);
  return metric != nullptr && metric->is_claim;
}

std::string_view name_of(Metric metric) noexcept {
  return metrics[static_cast<std::size_t>(metric)].name;
}

}  // namespace hallux::scenarios
