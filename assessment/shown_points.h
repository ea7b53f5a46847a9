/// Points as people read them: always of 100, in tenths that add up as printed.
///
///     ledger    17.6 + 0.9 + ... lost   +   score 81.5   =   100
///     groups    72.9 / 86.2  and  8.6 / 13.8             =   81.5 / 100  (before gates)
///
/// A rubric's own points add up to 100 only where all of it is measured. The score, the pass mark,
/// the caps of gates and what an instructor sets are of 100 in every attempt, so all that is
/// printed beside them is too: one point means the same everywhere, and what is lost is what the
/// score lacks. How much of the rubric was measured is a share and said in per cent, never in
/// points. The rubric's points stay in the stored card and in the answers for programs.
///
/// Units: thousandths of a point of 100, in whole tenths.
/// source  docs/metrics.md, "From points to a score"
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/records/score.h"
#include "scenarios/scenario.h"

namespace hallux::assessment {

struct ShownLine {
  /// 0 for a gate: it has no points of its own.
  std::int64_t possible_milli = 0;
  std::int64_t lost_milli = 0;
};

struct ShownGroup {
  /// 0: not measured.
  std::int64_t possible_milli = 0;
  /// Before gates.
  std::int64_t earned_milli = 0;
};

struct ShownPoints {
  std::int64_t score_milli = 0;
  /// As the card's ledger.
  std::vector<ShownLine> lines;
  /// As the card's groups.
  std::vector<ShownGroup> groups;
};

/// needs   the card is one that `balance` made
/// ensures where something was measured: losses + score = 100, what is possible in the groups adds
///         up to 100, a group's possible = its earned + what its lines lost; what lost or earned
///         nothing shows 0; no number is further than 0.3 from the exact one
ShownPoints shown_points(const database::ScoreCard& card);

/// What there is to earn, before anything was measured.
struct ShownWeights {
  /// As the rubric's groups; 0: not measured yet.
  std::vector<std::int64_t> groups_milli;
  /// As the rubric's items.
  std::vector<std::int64_t> items_milli;
};

/// ensures the same numbers as `shown_points` of an attempt in which every item could be measured,
///         but for a tenth where something was lost or kept as a whole
ShownWeights shown_weights(const scenarios::Rubric& rubric);

/// "17.6"; "less than 0.1" where too little was lost to show; "0" where nothing was.
std::string lost_points_text(const database::LedgerLine& line, const ShownLine& shown);

/// The share of the rubric that was measured, rounded down: "58 %".
std::string measured_share_text(const database::ScoreCard& card);

}  // namespace hallux::assessment
