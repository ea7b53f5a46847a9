/// The kinds of steps as scenario files and listings say them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// "guide_wire".
std::string_view step_word(StepKind kind) noexcept;
/// Nothing where no kind has that word.
std::optional<StepKind> find_step_kind(std::string_view word) noexcept;
/// All of them, with commas between.
std::string step_words();

}  // namespace hallux::scenarios
