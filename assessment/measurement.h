/// What this room measures; see database/records/measurement.h.
#pragma once

#include <string_view>

#include "database/records/measurement.h"

namespace hallux::assessment {

using database::Absence;
using database::Detail;
using database::DetailKind;
using database::Measurement;
using database::Remark;

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

}  // namespace hallux::assessment
