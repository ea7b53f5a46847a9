#include "ui/report/effects_text.h"

#include <algorithm>
#include <array>

#include "assessment/number_text.h"
#include "scenarios/metric_names.h"

namespace hallux::ui {

using assessment::number_text;

bool was_hot(const simulator::HeatSummary& heat) noexcept {
  return heat.hottest_celsius > simulator::hot_celsius;
}

bool are_effects_scored(const database::ScoreCard& card) noexcept {
  using enum scenarios::Metric;
  constexpr std::array effects{HotS, NecroticMm3, DangerContactsCount, DangerS, DangerDepthMm};
  return std::ranges::any_of(card.ledger, [&](const database::LedgerLine& line) {
    return line.kind == database::LedgerKind::Metric &&
           std::ranges::any_of(effects, [&](scenarios::Metric metric) {
             return scenarios::name_of(metric) == line.metric;
           });
  });
}

std::string hottest_text(const simulator::HeatSummary& heat) {
  return number_text(heat.hottest_celsius, 0) + " °C";
}

std::string hot_time_text(const simulator::HeatSummary& heat) {
  return number_text(heat.hot_s, 1) + " s";
}

std::string dead_bone_text(const simulator::HeatSummary& heat) {
  return number_text(heat.necrotic_mm3, 0) + " mm³";
}

std::string bend_text(double deflection_mm) { return number_text(deflection_mm, 2) + " mm"; }

std::string contact_time_text(double duration_s) { return number_text(duration_s, 1) + " s"; }

}  // namespace hallux::ui
