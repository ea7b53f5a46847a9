#include "ui/report/effects_text.h"

#include "assessment/number_text.h"

namespace hallux::ui {

using assessment::number_text;

bool was_hot(const simulator::HeatSummary& heat) noexcept {
  return heat.hottest_celsius > simulator::hot_celsius;
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
