/// When a score passes: the total, the share of safety and the gates are asked for separately.
#pragma once

#include <cstdint>

#include "database/records/score.h"

namespace hallux::assessment {

/// Provisional, until judges or two groups of people have set another.
/// Of 100 000.
/// source  reference/domain 5.3: to be replaced by a modified Angoff, then by contrasting groups
inline constexpr std::int64_t pass_milli = 60'000;
/// Never averaged away: the least share of the safety points.
inline constexpr double safety_pass_share = 0.6;

enum class PassAnswer { Reached, NotReached, NotDecided };

/// `standing_milli` is the score that stands, the machine's or an instructor's.
/// ensures a partial card is never reached: what was not measured may hold a gate or a loss of
///         safety. It is not reached where what was measured says so already
PassAnswer pass_answer(const database::PassFacts& facts, std::int64_t standing_milli) noexcept;
PassAnswer pass_answer(const database::ScoreCard& card, std::int64_t standing_milli) noexcept;

}  // namespace hallux::assessment
