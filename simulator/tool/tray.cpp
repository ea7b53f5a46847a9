#include "simulator/tool/tray.h"

namespace hallux::simulator {

namespace {

struct BoredRadius {
  double operator()(const Saw&) const noexcept { return 0.0; }
  double operator()(const WireDriver& driver) const noexcept {
    return 0.5 * driver.wire.diameter_mm;
  }
  double operator()(const Drill& drill) const noexcept { return 0.5 * drill.bit.diameter_mm; }
  double operator()(const Screwdriver& driver) const noexcept {
    return 0.5 * driver.screw.shaft_diameter_mm;
  }
};

struct ShaftLength {
  double operator()(const Saw&) const noexcept { return 0.0; }
  double operator()(const WireDriver& driver) const noexcept { return driver.wire.length_mm; }
  double operator()(const Drill& drill) const noexcept { return drill.bit.length_mm; }
  double operator()(const Screwdriver& driver) const noexcept { return driver.screw.length_mm; }
};

}  // namespace

double bored_radius_mm(const Tool& tool) noexcept { return std::visit(BoredRadius{}, tool); }

double shaft_length_mm(const Tool& tool) noexcept { return std::visit(ShaftLength{}, tool); }

std::optional<ImplantSize> implant_of(const Tool& tool) noexcept {
  if (const auto* driver = std::get_if<WireDriver>(&tool))
    return ImplantSize{0.5 * driver->wire.diameter_mm, driver->wire.length_mm, false};
  if (const auto* driver = std::get_if<Screwdriver>(&tool))
    return ImplantSize{0.5 * driver->screw.thread_diameter_mm, driver->screw.length_mm, true};
  return std::nullopt;
}

Tray::Tray(const Saw& first, std::span<const Tool> further) {
  tools_.reserve(1 + further.size());
  tools_.emplace_back(first);
  tools_.insert(tools_.end(), further.begin(), further.end());
}

}  // namespace hallux::simulator
