/// Lines are made in the order of the score: items, damping, gates. A gate can take no more than
/// what is left above its cap, so the lowest cap goes first and the others may find nothing.
/// Integers throughout: shares are rounded by the largest remainder, so that what is shown adds up
/// to what was lost.
#include "assessment/ledger.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "assessment/number_text.h"
#include "assessment/points.h"

namespace hallux::assessment {

namespace {

using database::GateResult;
using database::GroupScore;
using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;
using scenarios::Gate;
using scenarios::Rubric;
using scenarios::RubricItem;

constexpr std::int64_t full_score_milli = 100000;
constexpr const char* accuracy_group = "accuracy";
constexpr const char* efficiency_group = "efficiency";

/// Below three fifths of the accuracy points efficiency is damped.
constexpr std::int64_t damping_numerator = 3, damping_denominator = 5;

/// value x numerator / denominator to the nearest integer, halves up.
std::int64_t scaled(std::int64_t value, std::int64_t numerator, std::int64_t denominator) noexcept {
  return (2 * value * numerator + denominator) / (2 * denominator);
}

GroupScore* find_group(ScoreCard& card, const std::string& name) noexcept {
  for (GroupScore& group : card.groups) {
    if (group.name == name) return &group;
  }
  return nullptr;
}

void place_line(LedgerLine& line, const Measurement& measurement) {
  line.value = measurement.value;
  line.is_measured = measurement.is_measured();
  line.start_us = measurement.start_us;
  line.end_us = measurement.end_us;
  const Vec3& place = measurement.place_in_bone_mm;
  line.place_in_bone_mm = {place.x, place.y, place.z};
}

/// What was not done earns nothing; what there was nothing of to measure, all that the work is
/// worth.
std::int64_t earned_milli(const RubricItem& item, const Measurement& measurement) {
  if (!measurement.is_measured() && !measurement.is_excused()) return 0;
  const std::int64_t points =
      measurement.is_measured() ? points_milli(item, measurement.value) : item.weight_milli;
  return std::llround(measurement.done_fraction * static_cast<double>(points));
}

LedgerLine item_line(const RubricItem& item, const Measurement& measurement) {
  LedgerLine line;
  line.item = item.id;
  line.metric = item.metric;
  line.group = item.group;
  line.unit = item.unit;
  line.weight_milli = item.weight_milli;
  place_line(line, measurement);
  line.target = item.full;
  if (item.is_band) line.target = line.value < item.full_low ? item.full_low : item.full_high;
  line.points_lost_milli = item.weight_milli - earned_milli(item, measurement);
  return line;
}

void add_items(ScoreCard& card, const Rubric& rubric, std::span<const Measurement> measurements) {
  for (const RubricItem& item : rubric.items) {
    const Measurement* measurement = find_measurement(measurements, item);
    GroupScore* group = find_group(card, item.group);
    if (measurement == nullptr || group == nullptr) continue;
    card.ledger.push_back(item_line(item, *measurement));
    group->measured_milli += item.weight_milli;
    group->earned_milli += item.weight_milli - card.ledger.back().points_lost_milli;
  }
}

void add_damping(ScoreCard& card) {
  const GroupScore* accuracy = find_group(card, accuracy_group);
  GroupScore* efficiency = find_group(card, efficiency_group);
  if (accuracy == nullptr || efficiency == nullptr) return;
  if (accuracy->measured_milli == 0 || efficiency->measured_milli == 0) return;
  const std::int64_t reached = accuracy->earned_milli * damping_denominator;
  const std::int64_t needed = accuracy->measured_milli * damping_numerator;
  const std::int64_t kept_milli = reached >= needed
                                      ? efficiency->earned_milli
                                      : scaled(efficiency->earned_milli, reached, needed);
  LedgerLine line;
  line.kind = LedgerKind::Damping;
  line.item = "damping";
  line.metric = "accuracy_fraction";
  line.group = efficiency_group;
  line.value = rounded_to_micro(static_cast<double>(accuracy->earned_milli) /
                                static_cast<double>(accuracy->measured_milli));
  line.target = static_cast<double>(damping_numerator) / static_cast<double>(damping_denominator);
  line.weight_milli = efficiency->earned_milli;
  line.points_lost_milli = efficiency->earned_milli - kept_milli;
  card.ledger.push_back(line);
  efficiency->earned_milli = kept_milli;
}

GateResult gate_result(const Gate& gate, const Measurement* measurement) {
  GateResult result;
  result.name = gate.name;
  result.cap_milli = gate.cap_milli;
  result.limit = gate.limit;
  result.unit = gate.unit;
  if (measurement == nullptr || !measurement->is_measured()) return result;
  result.value = measurement->value;
  result.is_triggered =
      gate.is_at_least ? measurement->value < gate.limit : measurement->value > gate.limit;
  return result;
}

/// What stands above the cap is lost; rounding down keeps the score from ending above it.
void add_gate_line(ScoreCard& card, const Gate& gate, const Measurement& measurement) {
  const std::int64_t capped_milli = card.measured_milli * gate.cap_milli / full_score_milli;
  LedgerLine line;
  line.kind = LedgerKind::Gate;
  line.item = gate.name;
  line.metric = gate.metric;
  line.group = "gate";
  line.unit = gate.unit;
  place_line(line, measurement);
  line.target = gate.limit;
  line.weight_milli = 0;
  line.points_lost_milli = std::max<std::int64_t>(0, card.earned_milli - capped_milli);
  card.earned_milli -= line.points_lost_milli;
  card.ledger.push_back(line);
}

void add_gates(ScoreCard& card, const Rubric& rubric, std::span<const Measurement> measurements) {
  std::vector<std::size_t> triggered;
  for (const Gate& gate : rubric.gates) {
    card.gates.push_back(gate_result(gate, find_measurement(measurements, gate)));
    if (card.gates.back().is_triggered) triggered.push_back(card.gates.size() - 1);
  }
  std::stable_sort(triggered.begin(), triggered.end(), [&](std::size_t a, std::size_t b) {
    return rubric.gates[a].cap_milli < rubric.gates[b].cap_milli;
  });
  for (const std::size_t index : triggered) {
    const Gate& gate = rubric.gates[index];
    add_gate_line(card, gate, *find_measurement(measurements, gate));
  }
}

void add_shown_losses(ScoreCard& card) {
  std::vector<std::int64_t> losses_milli;
  for (const LedgerLine& line : card.ledger) losses_milli.push_back(line.points_lost_milli);
  if (card.measured_milli == 0) {
    card.shown_losses_milli.assign(losses_milli.size(), 0);
    return;
  }
  card.shown_losses_milli = scale_to_total(losses_milli, full_score_milli, card.measured_milli,
                                           full_score_milli - card.score_milli);
}

template <typename Part>
const Measurement* first_of_same(std::span<const Measurement> measurements,
                                 const Part& part) noexcept {
  const auto found = std::ranges::find_if(
      measurements, [&](const Measurement& each) { return is_of_same(each, part); });
  return found == measurements.end() ? nullptr : &*found;
}

}  // namespace

const Measurement* find_measurement(std::span<const Measurement> measurements,
                                    const std::string& metric, const std::string& cut,
                                    const std::string& hinge, const std::string& zone) noexcept {
  for (const Measurement& measurement : measurements) {
    const bool is_wanted = measurement.metric == metric && measurement.cut == cut &&
                           measurement.fragment.empty() && measurement.implant.empty();
    if (is_wanted && measurement.hinge == hinge && measurement.zone == zone) return &measurement;
  }
  return nullptr;
}

const Measurement* find_measurement(std::span<const Measurement> measurements,
                                    const RubricItem& item) noexcept {
  return first_of_same(measurements, item);
}

const Measurement* find_measurement(std::span<const Measurement> measurements,
                                    const Gate& gate) noexcept {
  return first_of_same(measurements, gate);
}

std::vector<std::int64_t> scale_to_total(std::span<const std::int64_t> parts, std::int64_t scale,
                                         std::int64_t whole, std::int64_t total) {
  std::vector<std::int64_t> scaled_parts;
  for (const std::int64_t part : parts) scaled_parts.push_back(part * scale / whole);
  std::int64_t missing =
      total - std::accumulate(scaled_parts.begin(), scaled_parts.end(), std::int64_t{0});
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts[a] * scale % whole > parts[b] * scale % whole;
  });
  for (const std::size_t index : order) {
    if (missing <= 0) break;
    ++scaled_parts[index];
    --missing;
  }
  return scaled_parts;
}

ScoreCard score_rubric(const Rubric& rubric, std::span<const Measurement> measurements) {
  ScoreCard card;
  card.rubric_version = rubric.version;
  for (const scenarios::RubricGroup& group : rubric.groups) {
    card.groups.push_back({group.name, group.weight_milli, 0, 0});
    card.rubric_milli += group.weight_milli;
  }
  add_items(card, rubric, measurements);
  add_damping(card);
  for (const GroupScore& group : card.groups) {
    card.measured_milli += group.measured_milli;
    card.earned_milli += group.earned_milli;
  }
  add_gates(card, rubric, measurements);
  if (card.measured_milli > 0) {
    card.score_milli = scaled(full_score_milli, card.earned_milli, card.measured_milli);
  }
  add_shown_losses(card);
  return card;
}

}  // namespace hallux::assessment
