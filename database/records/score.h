/// Score card of an attempt: points in integer thousandths, a ledger that adds up, sentences.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "database/records/names.h"

namespace hallux::database {

enum class LedgerKind { Metric, Damping, Gate };

template <>
inline constexpr std::array<std::string_view, 3> stored_names<LedgerKind>{"metric", "damping",
                                                                          "gate"};

/// One place where points were won or lost. A line with points_lost_milli 0 is kept: it says what
/// was right.
struct LedgerLine {
  LedgerKind kind = LedgerKind::Metric;
  /// Rubric item or gate: "A1".
  std::string item;
  /// "angle_deg".
  std::string metric;
  /// "accuracy".
  std::string group;
  /// "deg", "mm".
  std::string unit;
  /// Rounded to 1e-6 of its unit.
  double value = 0.0;
  /// False: nothing to measure (no cut was made); value then means nothing.
  bool is_measured = true;
  /// Where full points begin to be lost, or the gate's limit.
  double target = 0.0;
  /// Rubric points x 1000 that this line could have earned.
  std::int64_t weight_milli = 0;
  /// Rubric points x 1000.
  std::int64_t points_lost_milli = 0;
  /// The moment of the attempt it is about.
  std::int64_t start_us = 0, end_us = 0;
  /// The patch of bone it is about.
  std::array<double, 3> place_in_bone_mm{};
  /// One sentence with the number, the target and the loss.
  std::string text;
};

/// What decides whether a result passes (assessment/pass_mark.h), without the rest of the card.
struct PassFacts {
  std::int64_t measured_milli = 0, rubric_milli = 0;
  std::int64_t safety_measured_milli = 0, safety_earned_milli = 0;
  /// A gate is triggered.
  bool is_gated = false;
};

struct GroupScore {
  std::string name;
  /// In the whole rubric.
  std::int64_t weight_milli = 0;
  /// Of which could be measured; 0: not measured yet.
  std::int64_t measured_milli = 0;
  /// Before gates.
  std::int64_t earned_milli = 0;
};

struct GateResult {
  std::string name;
  /// Highest score (of 100 000) once the gate is triggered.
  std::int64_t cap_milli = 0;
  bool is_triggered = false;
  double value = 0.0, limit = 0.0;
  std::string unit;
  std::string text;
};

/// earned_milli + the sum of all points_lost_milli = measured_milli, exactly.
struct ScoreCard {
  /// 0 to 100 000: 100 x earned / measured, rounded to the nearest thousandth.
  std::int64_t score_milli = 0;
  /// Rubric points x 1000, after damping and gates.
  std::int64_t earned_milli = 0;
  /// Rubric points x 1000 that could be measured.
  std::int64_t measured_milli = 0;
  /// Rubric points x 1000 in all (100 000).
  std::int64_t rubric_milli = 0;
  std::vector<GroupScore> groups;
  std::vector<GateResult> gates;
  std::vector<LedgerLine> ledger;
  /// The losses of the ledger scaled to 100: they add up to 100 000 - score_milli exactly (largest
  /// remainders).
  std::vector<std::int64_t> shown_losses_milli;
  /// The three that matter most, greatest loss first.
  std::vector<std::string> sentences;
  std::string scenario;
  std::int32_t scenario_version = 0, rubric_version = 0, engine = 0;
  /// A surgeon signed the scenario's version.
  bool is_reviewed = false;
};

PassFacts pass_facts_of(const ScoreCard& card) noexcept;

}  // namespace hallux::database
