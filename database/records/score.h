/// Score card of an attempt: points in integer thousandths, a ledger that adds up, and what its
/// sentences are made from. The words are made when a card is shown (assessment/sentences.h); a
/// card of an older program brings its own.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "database/records/measurement.h"
#include "database/records/names.h"

namespace hallux::database {

enum class LedgerKind { Metric, Damping, Gate };

template <>
inline constexpr std::array<std::string_view, 3> stored_names<LedgerKind>{"metric", "damping",
                                                                          "gate"};

/// Where full points are.
enum class TargetKind { AtMost, AtLeast, Between };

template <>
inline constexpr std::array<std::string_view, 3> stored_names<TargetKind>{"at_most", "at_least",
                                                                          "between"};

/// What the sentence of a line is made from, beside the line's own numbers.
struct LineFacts {
  /// Of the rubric's item.
  std::string title;
  /// Of the cut, hinge or zone; empty where the sentence needs no name.
  std::string subject;
  TargetKind target = TargetKind::AtMost;
  /// Of a target between two values both; else one.
  double target_low = 0.0, target_high = 0.0;
  /// As measured.
  Absence absence = Absence::None;
  double done_fraction = 1.0;
  std::string direction;
  Detail detail;
  Remark remark = Remark::None;
};

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
  /// Of a line that is no item's: nothing.
  LineFacts facts;
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
  /// What its sentence is made from.
  std::string title = {}, metric = {};
  bool is_measured = false, is_at_least = false;
};

/// What matters most, as a message names it.
enum class MessageKind {
  /// A line of the ledger.
  Line,
  /// All that one cut has cost, because it was left out or unfinished.
  CutNotMade,
  CutUnfinished,
  NothingMeasured
};

template <>
inline constexpr std::array<std::string_view, 4> stored_names<MessageKind>{
    "line", "cut_not_made", "cut_unfinished", "nothing_measured"};

struct Message {
  MessageKind kind = MessageKind::Line;
  /// Of the ledger.
  std::int64_t line = 0;
  /// The cut's title; empty where the operation has but one.
  std::string subject;
  double done_fraction = 0.0;
  /// Of 100, as shown.
  std::int64_t lost_milli = 0;
};

/// How a stored card tells what it has to say.
enum class CardForm {
  /// In the words of the program that made it.
  Words,
  /// By what the words are made from.
  Facts
};

template <>
inline constexpr std::array<std::string_view, 2> stored_names<CardForm>{"words", "facts"};

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
  /// The three that matter most, most urgent first.
  std::vector<Message> messages;
  /// The same in words.
  std::vector<std::string> sentences;
  std::string scenario;
  std::int32_t scenario_version = 0, rubric_version = 0, engine = 0;
  /// A surgeon signed the scenario's version.
  bool is_reviewed = false;
  /// What of facts and words is stored.
  CardForm form = CardForm::Words;
};

PassFacts pass_facts_of(const ScoreCard& card) noexcept;

}  // namespace hallux::database
