/// From measurements to a score: every point that could be earned is either earned or has a line
/// that says why not. Inside this corner only.
///
///     items        points of each rubric item that has a measurement; an item whose cut was never
///                  made loses all, and one whose cut was left unfinished earns the share of the
///                  section that was opened: else a scratch in the right plane would be perfect
///     damping      efficiency counts min(1, accuracy fraction / 0.6): speed alone earns nothing
///     gates        each triggered cap takes what stands above it; the lowest cap first
///     score        100 x earned / measured; measured: the weight of the items with a measurement
///
/// All in integer thousandths, so earned + lost = measured holds exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assessment/measurement.h"
#include "database/records/score.h"
#include "scenarios/scenario.h"

namespace hallux::assessment {

/// The score without its sentences.
/// shape   ledger: items in the rubric's order, then damping (where efficiency was measured), then
///         triggered gates
/// needs   the rubric's weights are not negative; measurements are rounded (see rounded_to_micro)
/// ensures earned + sum of losses = measured; the shown losses add up to 100 000 - score, except
///         where nothing was measured: then score and losses are 0
database::ScoreCard score_rubric(const scenarios::Rubric& rubric,
                                 std::span<const Measurement> measurements);

/// Whether two measurements, items or gates have the same metric of the same subject.
template <typename One, typename Other>
bool is_of_same(const One& one, const Other& other) noexcept {
  return one.metric == other.metric && one.cut == other.cut && one.hinge == other.hinge &&
         one.zone == other.zone && one.fragment == other.fragment && one.implant == other.implant;
}

/// The measurement that an item or gate asks for; nothing (null) where that metric is not measured
/// yet.
const Measurement* find_measurement(std::span<const Measurement> measurements,
                                    const scenarios::RubricItem& item) noexcept;
const Measurement* find_measurement(std::span<const Measurement> measurements,
                                    const scenarios::Gate& gate) noexcept;
/// The same by names, of a cut, a hinge, a zone or the whole attempt; of the three at most one is
/// not empty.
const Measurement* find_measurement(std::span<const Measurement> measurements,
                                    const std::string& metric, const std::string& cut,
                                    const std::string& hinge = {},
                                    const std::string& zone = {}) noexcept;

/// `parts` scaled so that they add up to `total`, by largest remainders; ties go to the earlier
/// part.
/// needs   parts are not negative; total differs from sum(parts) x scale / whole by less than 1
/// ensures a part of 0 stays 0
std::vector<std::int64_t> scale_to_total(std::span<const std::int64_t> parts, std::int64_t scale,
                                         std::int64_t whole, std::int64_t total);

}  // namespace hallux::assessment
