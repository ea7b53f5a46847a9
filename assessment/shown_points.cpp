/// Rounding each number by itself gives columns that do not add up. So the losses are shared out
/// among groups first and then among a group's lines, each time by the largest remainder, and what
/// is possible likewise. Last, a group that earned nothing gives the tenth that rounding left it to
/// one that earned most.
#include "assessment/shown_points.h"

#include <algorithm>
#include <numeric>

#include "assessment/ledger.h"
#include "assessment/number_text.h"

namespace hallux::assessment {

namespace {

using database::GroupScore;
using database::LedgerKind;
using database::LedgerLine;
using database::ScoreCard;

constexpr std::int64_t tenth_milli = 100, full_tenths = 1000;

/// Everything below is in tenths of a point of 100 until it is returned.
using Tenths = std::vector<std::int64_t>;

std::int64_t nearest_tenth(std::int64_t part, std::int64_t whole) noexcept {
  return (2 * part * full_tenths + whole) / (2 * whole);
}

/// The items' weights scaled to 100 points: first among the groups, then within each.
struct Possible {
  Tenths groups, items;
};

/// `group_of[i]` is the group of item i, below `group_count`.
Possible possible_of(const Tenths& item_weights, const std::vector<std::size_t>& group_of,
                     std::size_t group_count) {
  Possible possible{Tenths(group_count, 0), Tenths(item_weights.size(), 0)};
  Tenths group_weights(group_count, 0);
  for (std::size_t item = 0; item < item_weights.size(); ++item)
    group_weights[group_of[item]] += item_weights[item];
  const std::int64_t whole =
      std::accumulate(group_weights.begin(), group_weights.end(), std::int64_t{0});
  if (whole == 0) return possible;
  possible.groups = scale_to_total(group_weights, full_tenths, whole, full_tenths);
  for (std::size_t group = 0; group < group_count; ++group) {
    Tenths own = item_weights;
    for (std::size_t item = 0; item < own.size(); ++item)
      if (group_of[item] != group) own[item] = 0;
    const Tenths scaled = scale_to_total(own, full_tenths, whole, possible.groups[group]);
    for (std::size_t item = 0; item < own.size(); ++item) possible.items[item] += scaled[item];
  }
  return possible;
}

std::size_t group_index(const ScoreCard& card, const std::string& name) noexcept {
  const auto found = std::find_if(card.groups.begin(), card.groups.end(),
                                  [&](const GroupScore& group) { return group.name == name; });
  return static_cast<std::size_t>(found - card.groups.begin());
}

/// What a loss belongs to: its group, or, after the groups, what is of no group (gates).
std::size_t owner_of(const ScoreCard& card, const LedgerLine& line) noexcept {
  return line.kind == LedgerKind::Gate ? card.groups.size() : group_index(card, line.group);
}

/// The losses of the lines, first among their owners, so that a group's lines add up to what the
/// group lost.
Tenths losses_of(const ScoreCard& card, std::int64_t total) {
  const std::size_t owners = card.groups.size() + 1;
  std::vector<Tenths> of_owner(owners, Tenths(card.ledger.size(), 0));
  Tenths sums(owners, 0);
  for (std::size_t line = 0; line < card.ledger.size(); ++line) {
    const std::size_t owner = owner_of(card, card.ledger[line]);
    of_owner[owner][line] = card.ledger[line].points_lost_milli;
    sums[owner] += card.ledger[line].points_lost_milli;
  }
  const Tenths totals = scale_to_total(sums, full_tenths, card.measured_milli, total);
  Tenths losses(card.ledger.size(), 0);
  for (std::size_t owner = 0; owner < owners; ++owner) {
    const Tenths own =
        scale_to_total(of_owner[owner], full_tenths, card.measured_milli, totals[owner]);
    for (std::size_t line = 0; line < own.size(); ++line) losses[line] += own[line];
  }
  return losses;
}

/// Gives or takes `spare` tenths, one after the other, where most was earned.
void spread(Tenths& possible, const Tenths& lost, const std::vector<bool>& is_fixed,
            std::int64_t spare) {
  while (spare != 0) {
    std::size_t most = possible.size();
    for (std::size_t group = 0; group < possible.size(); ++group) {
      const bool is_more =
          most == possible.size() || possible[group] - lost[group] > possible[most] - lost[most];
      if (!is_fixed[group] && is_more) most = group;
    }
    if (most == possible.size()) return;
    possible[most] += spare > 0 ? 1 : -1;
    spare += spare > 0 ? -1 : 1;
  }
}

/// A group that earned nothing must not show a tenth that rounding left, nor one less than none:
/// what is possible there is what was lost, and the tenth goes to another group.
void keep_noughts(const ScoreCard& card, Tenths& possible, const Tenths& lost) {
  std::vector<bool> is_fixed(possible.size(), false);
  std::int64_t spare = 0;
  for (std::size_t group = 0; group < possible.size(); ++group) {
    const bool is_nought = card.groups[group].earned_milli == 0;
    if (!is_nought && possible[group] >= lost[group]) continue;
    is_fixed[group] = true;
    spare += possible[group] - lost[group];
    possible[group] = lost[group];
  }
  spread(possible, lost, is_fixed, spare);
}

Possible possible_of(const ScoreCard& card) {
  Tenths weights;
  std::vector<std::size_t> group_of;
  for (const LedgerLine& line : card.ledger) {
    weights.push_back(line.kind == LedgerKind::Metric ? line.weight_milli : 0);
    group_of.push_back(owner_of(card, line));
  }
  return possible_of(weights, group_of, card.groups.size() + 1);
}

ShownLine shown_line(const ScoreCard& card, const LedgerLine& line, std::int64_t possible,
                     std::int64_t lost) {
  if (line.kind == LedgerKind::Gate) return {0, lost * tenth_milli};
  if (line.kind == LedgerKind::Damping)
    possible = nearest_tenth(line.weight_milli, card.measured_milli);
  const bool is_all_lost = line.points_lost_milli == line.weight_milli;
  const std::int64_t shown = is_all_lost ? lost : std::max(possible, lost);
  return {shown * tenth_milli, lost * tenth_milli};
}

}  // namespace

ShownPoints shown_points(const ScoreCard& card) {
  ShownPoints shown;
  shown.lines.resize(card.ledger.size());
  shown.groups.resize(card.groups.size());
  if (card.measured_milli == 0) return shown;
  const std::int64_t score = (card.score_milli + tenth_milli / 2) / tenth_milli;
  shown.score_milli = score * tenth_milli;
  const Tenths losses = losses_of(card, full_tenths - score);
  Possible possible = possible_of(card);
  Tenths lost(card.groups.size() + 1, 0);
  for (std::size_t line = 0; line < losses.size(); ++line) {
    lost[owner_of(card, card.ledger[line])] += losses[line];
    shown.lines[line] = shown_line(card, card.ledger[line], possible.items[line], losses[line]);
  }
  lost.pop_back();
  possible.groups.pop_back();
  keep_noughts(card, possible.groups, lost);
  for (std::size_t group = 0; group < lost.size(); ++group) {
    shown.groups[group] = {possible.groups[group] * tenth_milli,
                           (possible.groups[group] - lost[group]) * tenth_milli};
  }
  return shown;
}

ShownWeights shown_weights(const scenarios::Rubric& rubric) {
  Tenths weights;
  std::vector<std::size_t> group_of;
  for (const scenarios::RubricItem& item : rubric.items) {
    const auto found = std::find_if(rubric.groups.begin(), rubric.groups.end(),
                                    [&](const auto& group) { return group.name == item.group; });
    weights.push_back(item.weight_milli);
    group_of.push_back(static_cast<std::size_t>(found - rubric.groups.begin()));
  }
  Possible possible = possible_of(weights, group_of, rubric.groups.size() + 1);
  possible.groups.pop_back();
  ShownWeights shown;
  for (const std::int64_t each : possible.groups) shown.groups_milli.push_back(each * tenth_milli);
  for (const std::int64_t each : possible.items) shown.items_milli.push_back(each * tenth_milli);
  return shown;
}

std::string lost_points_text(const LedgerLine& line, const ShownLine& shown) {
  const bool is_too_little = line.points_lost_milli > 0 && shown.lost_milli == 0;
  return is_too_little ? "less than 0.1" : points_text(shown.lost_milli);
}

std::string measured_share_text(const ScoreCard& card) {
  const std::int64_t whole = std::max<std::int64_t>(1, card.rubric_milli);
  return std::to_string(100 * card.measured_milli / whole) + " %";
}

}  // namespace hallux::assessment
