/// One metric of one subject, with the moment and the place that it is about.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "simulator/base/vector.h"

namespace hallux::assessment {

/// Why a metric has no value.
enum class Absence : std::uint8_t {
  /// It has one.
  None,
  /// The cut that it is about was not made; what it is worth is lost.
  NotMade,
  /// Something else that was asked for was not done; what it is worth is lost.
  NotDone,
  /// There was nothing to measure in a performance that was carried out: nothing is lost.
  Undefined,
  /// What was kept of the attempt does not tell it: nothing is lost.
  NotRecorded
};

/// "the cut was not made"; empty where there is a value.
constexpr std::string_view reason_of(Absence absence) noexcept {
  switch (absence) {
    case Absence::NotMade:
      return "the cut was not made";
    case Absence::NotDone:
      return "it was not done";
    case Absence::Undefined:
      return "there was nothing to measure it by";
    case Absence::NotRecorded:
      return "what was kept of the attempt does not tell it";
    case Absence::None:
      break;
  }
  return {};
}

struct Measurement {
  /// "angle_deg"; the unit is the last word.
  std::string metric;
  /// The reference cut's name; empty where it is about a hinge, a zone or the whole attempt.
  std::string cut;
  /// The hinge's name.
  std::string hinge;
  /// Rounded to 1e-6 of its unit.
  double value = 0.0;
  Absence absence = Absence::None;
  /// Below 1: the blade was stopped inside the bone; measured where it was.
  double done_fraction = 1.0;
  /// "dorsal", "plantar-distal"; empty where the metric has no sign.
  std::string direction;
  /// A clause with more numbers, said where points were lost; may be empty.
  std::string detail;
  /// A sentence that closes its line, whatever was lost; may be empty.
  std::string note = {};
  std::int64_t start_us = 0, end_us = 0;
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
  /// The danger zone's name; empty where all of them together are meant.
  std::string zone = {};
  /// The value is no further from the exact one, by the grids and steps that it is computed on; the
  /// rounding of what was recorded is not in it.
  double bound = 0.0;

  bool is_measured() const noexcept { return absence == Absence::None; }
  /// It has no value, and that costs nothing.
  bool is_excused() const noexcept {
    return absence == Absence::Undefined || absence == Absence::NotRecorded;
  }
};

}  // namespace hallux::assessment
