/// Implants among fragments that part and move: where their metal lies, which fragment each goes
/// along with, and what they leave a gripped fragment free to do. Inside this corner only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "simulator/contact/gripped_body.h"
#include "simulator/contact/wound.h"
#include "simulator/cutting/hole/implant_set.h"
#include "simulator/step/step_output.h"

namespace hallux::simulator {

/// Whether it is there, and what it goes along with stands.
bool stands(const Implant& implant, const Wound& wound) noexcept;
/// needs   it stands
RigidTransform wound_from_implant(const Implant& implant, const Wound& wound) noexcept;

/// How much of an implant's axis lies within the fragment's outer surface, to a quarter of a
/// millimetre [mm].
/// needs   the fragment stands
double engaged_mm(const Implant& implant, std::int32_t fragment, const Wound& wound) noexcept;

/// All implants of an attempt in the wound's frame, by their numbers; one that is not there is as
/// thick as nothing.
class StandingMetal {
 public:
  void update(const ImplantSet& implants, const Wound& wound) noexcept;
  std::span<const Capsule> capsules() const noexcept { return {capsules_.data(), count_}; }

 private:
  std::array<Capsule, static_cast<std::size_t>(implant_limit)> capsules_{};
  std::size_t count_ = 0;
};

/// A fragment that parts takes along the implants that are more in it than in what is left.
class CarriedImplants {
 public:
  /// The implants of a fragment are asked about, one in each step: a way through two surfaces.
  void part(std::int32_t parent, std::int32_t fragment, const ImplantSet& implants) noexcept;
  /// Says it of the next that goes along.
  void carry_next(const Wound& wound, StepWriter& out) noexcept;

 private:
  struct Asked {
    std::int32_t parent = -1, fragment = -1;
  };
  /// By implant.
  std::array<Asked, static_cast<std::size_t>(implant_limit)> asked_{};
};

/// What implants leave a fragment free to do that they join to another.
struct ImplantHold {
  /// A screw, or wires that are not parallel.
  bool is_fixed = false;
  /// One wire: turns about it; parallel ones: slides along them.
  std::optional<WoundJoint> joint;
};

/// needs   the fragment stands
ImplantHold hold_of(std::int32_t fragment, const ImplantSet& implants, const Wound& wound) noexcept;

}  // namespace hallux::simulator
