#include "simulator/contact/bore/bore_tool.h"

namespace hallux::simulator {

namespace {

double law_cycles(double revolutions_per_minute, double sharpness) noexcept {
  return law_cycles_per_minute * (revolutions_per_minute / rated_revolutions_per_minute) *
         sharpness;
}

}  // namespace

BoreTool bore_tool(const WireDriver& driver) noexcept {
  return {.radius_mm = bored_radius_mm(driver),
          .shaft_mm = shaft_length_mm(driver),
          .shoulder_radius_mm = chuck_radius_mm,
          .law_cycles_per_minute = law_cycles(driver.revolutions_per_minute, driver.sharpness),
          .turns_per_s = driver.revolutions_per_minute / 60.0};
}

BoreTool bore_tool(const Drill& drill) noexcept {
  return {.radius_mm = bored_radius_mm(drill),
          .shaft_mm = shaft_length_mm(drill),
          .shoulder_radius_mm = chuck_radius_mm,
          .law_cycles_per_minute = law_cycles(drill.revolutions_per_minute, drill.sharpness),
          .turns_per_s = drill.revolutions_per_minute / 60.0};
}

BoreTool bore_tool(const Screwdriver& driver) noexcept {
  return {.radius_mm = bored_radius_mm(driver),
          .shaft_mm = shaft_length_mm(driver),
          .shoulder_radius_mm = 0.5 * driver.screw.head_diameter_mm,
          .law_cycles_per_minute = law_cycles(rated_revolutions_per_minute, 1.0),
          .turns_per_s = driver.revolutions_per_minute / 60.0,
          .pitch_mm = driver.screw.pitch_mm,
          .bores = driver.screw.is_self_drilling};
}

std::optional<BoreTool> bore_tool(const Tool& tool) noexcept {
  if (const auto* driver = std::get_if<WireDriver>(&tool)) return bore_tool(*driver);
  if (const auto* drill = std::get_if<Drill>(&tool)) return bore_tool(*drill);
  if (const auto* driver = std::get_if<Screwdriver>(&tool)) return bore_tool(*driver);
  return std::nullopt;
}

}  // namespace hallux::simulator
