/// The tray: the tools that an operation lays out, in its order.
///
/// The first is a saw, which is in the hand when the operation begins; which one is in it later
/// says the record by the place on the tray. Forceps are always at hand, and lie on no tray.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "simulator/tool/drill.h"
#include "simulator/tool/saw.h"
#include "simulator/tool/screw.h"
#include "simulator/tool/wire.h"

namespace hallux::simulator {

using Tool = std::variant<Saw, WireDriver, Drill, Screwdriver>;

/// What may stay in the bone: a wire or a screw.
struct ImplantSize {
  double radius_mm = 0.5;
  /// From the tip back.
  double length_mm = 10.0;
  /// It holds by itself what it goes through.
  bool is_screw = false;
};

/// Of what a tool bores; 0: it bores nothing.
double bored_radius_mm(const Tool& tool) noexcept;
/// Of what bores, from the tip back to its chuck or head; 0 of a saw.
double shaft_length_mm(const Tool& tool) noexcept;
/// Nothing of a tool that leaves nothing in the bone.
std::optional<ImplantSize> implant_of(const Tool& tool) noexcept;

class Tray {
 public:
  /// A saw alone, where nothing else is laid out.
  Tray(const Saw& first = {}, std::span<const Tool> further = {});
  Tray(const Blade& blade) : Tray(Saw{.blade = blade}) {}

  bool has(std::int32_t place) const noexcept {
    return place >= 0 && static_cast<std::size_t>(place) < tools_.size();
  }
  std::int32_t count() const noexcept { return static_cast<std::int32_t>(tools_.size()); }
  /// needs   has(place)
  const Tool& operator[](std::int32_t place) const noexcept {
    return tools_[static_cast<std::size_t>(place)];
  }
  /// Null where there lies something else, or nothing.
  const Saw* saw(std::int32_t place) const noexcept {
    return has(place) ? std::get_if<Saw>(&(*this)[place]) : nullptr;
  }
  const Saw& first_saw() const noexcept { return *saw(0); }

 private:
  std::vector<Tool> tools_;
};

}  // namespace hallux::simulator
