#include "ui/screens/operating/hud/cut_bands.h"

#include <algorithm>
#include <cmath>

#include "scenarios/metric_names.h"

namespace hallux::ui {

namespace {

std::optional<LiveBand> band_of(const scenarios::Rubric& rubric, std::string_view cut,
                                scenarios::Metric metric) {
  const auto item = std::find_if(rubric.items.begin(), rubric.items.end(), [&](const auto& each) {
    return each.cut == cut && each.metric == name_of(metric) && !each.is_band;
  });
  if (item == rubric.items.end()) return std::nullopt;
  return LiveBand{item->full, item->zero};
}

}  // namespace

BandState state_in(const LiveBand& band, double value) noexcept {
  const double size = std::abs(value);
  if (size <= band.full) return BandState::Full;
  return size < band.zero ? BandState::Partial : BandState::None;
}

CutBands bands_of(const scenarios::Rubric& rubric, std::string_view cut) {
  return {band_of(rubric, cut, scenarios::Metric::AngleDeg),
          band_of(rubric, cut, scenarios::Metric::LocationMm)};
}

}  // namespace hallux::ui
