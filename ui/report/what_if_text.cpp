/// A change of geometry is said as what is to be done otherwise, seen from where its turn shows,
/// and then which edge lay too far: a person who saws thinks of an edge, not of an axis. A value of
/// the work is said with the rubric's title and the advice of its metric.
#include "ui/report/what_if_text.h"

#include <algorithm>
#include <cmath>

#include "assessment/number_text.h"
#include "scenarios/metric_advice.h"
#include "scenarios/metric_names.h"
#include "scenarios/site/bone_words.h"
#include "ui/report/measured_text.h"

namespace hallux::ui {

namespace {

using assessment::Proposals;
using assessment::ProposedChange;
using database::ScoreCard;
using scenarios::PlannedCut;
using scenarios::RubricItem;
using scenarios::Scenario;

constexpr std::int64_t tenth_milli = 100;

/// "tilt:proximal_face" is of a kind and about a subject.
struct ChangeName {
  std::string kind, subject;

  explicit ChangeName(const std::string& name)
      : kind(name.substr(0, name.find(':'))),
        subject(kind.size() < name.size() ? name.substr(kind.size() + 1) : "") {}
};

template <typename Part>
std::string title_in(const std::vector<Part>& parts, const std::string& name) {
  const auto found = std::ranges::find(parts, name, &Part::name);
  return found == parts.end() || found->title.empty() ? name : found->title;
}

/// Both scores as they are shown, so that a reader's subtraction is right.
std::int64_t in_tenths(std::int64_t milli) noexcept {
  return (milli + tenth_milli / 2) / tenth_milli;
}

std::string tenths_text(std::int64_t tenths) {
  return assessment::number_text(static_cast<double>(tenths) / 10.0, 1);
}

std::string gain_text(std::int64_t tenths) {
  return tenths > 0 ? "+" + tenths_text(tenths) + " points" : "less than +0.1";
}

/// "A", "A and B", "A, B and C".
std::string list_text(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

/// Empty where no item would lose less.
std::string items_text(const ProposedChange& proposed, const Scenario& scenario) {
  std::vector<std::string> titles;
  for (const RubricItem& item : scenario.rubric.items) {
    if (std::ranges::find(proposed.items, item.id) != proposed.items.end())
      titles.push_back(item.title);
  }
  return titles.empty() ? "" : " More points for: " + list_text(titles) + ".";
}

/// Empty where no gate would be lifted.
std::string gates_text(const ProposedChange& proposed, const Scenario& scenario) {
  std::vector<std::string> titles;
  for (const std::string& gate : proposed.lifted_gates)
    titles.push_back(title_in(scenario.rubric.gates, gate));
  return titles.empty() ? "" : " No longer capped for: " + list_text(titles) + ".";
}

/// From where the turn shows.
const char* seen_from(const PlannedCut& cut, bool is_tilt) noexcept {
  const bool is_along = cut.is_along_bone;
  if (is_along == is_tilt) return is_along ? "along the bone" : "from the side";
  return "from dorsal";
}

/// The edge that lies further towards the plan's normal. A tilt is about the axis in the planned
/// face, a roll takes the normal towards it (see assessment/what_if).
Vec3 raised_edge(const PlannedCut& cut, bool is_tilt, double turn_deg) {
  const Vec3 edge = is_tilt ? glm::cross(cut.face.normal, cut.axis) : -cut.axis;
  return turn_deg < 0.0 ? -edge : edge;
}

SaidChange said_turn(const ProposedChange& proposed, const PlannedCut& cut, bool is_tilt) {
  const double turn_deg = proposed.change.from - proposed.to;
  SaidChange said;
  said.head = "turned back by " + measured_text(std::abs(turn_deg), proposed.change.unit) +
              ", seen " + seen_from(cut, is_tilt);
  said.body = "Its " + scenarios::direction_text(raised_edge(cut, is_tilt, turn_deg)) +
              " edge lay too far " + scenarios::direction_text(cut.face.normal) + ".";
  return said;
}

SaidChange said_shift(const ProposedChange& proposed, const PlannedCut& cut) {
  const double shift_mm = proposed.change.from - proposed.to;
  const auto side = [&](double sign) { return scenarios::direction_text(sign * cut.face.normal); };
  const std::string amount = measured_text(std::abs(shift_mm), proposed.change.unit);
  SaidChange said;
  said.head = amount + " further " + side(shift_mm > 0.0 ? -1.0 : 1.0);
  said.body = "Its middle lay too far " + side(shift_mm > 0.0 ? 1.0 : -1.0) + ".";
  return said;
}

/// Below 0 the blade went beyond the cortex.
SaidChange said_stop(const ProposedChange& proposed) {
  const double was_mm = proposed.change.from;
  const std::string left = measured_text(proposed.to, "mm") + " of bone left";
  if (was_mm < 0.0)
    return {
        left, "The blade went " + measured_text(-was_mm, "mm") + " beyond the far cortex.", {}, {}};
  return {left + " instead of " + measured_text(was_mm, "mm"),
          was_mm > proposed.to ? "The cuts ended too early." : "The cuts went too deep.",
          {},
          {}};
}

std::string value_of_work(double value, const RubricItem& item) {
  if (scenarios::is_claim(item.metric)) return value > 0.5 ? "yes" : "no";
  return measured_text(value, item.unit);
}

SaidChange said_work(const ProposedChange& proposed, const Scenario& scenario,
                     const ChangeName& name) {
  const auto item = std::ranges::find_if(scenario.rubric.items, [&](const RubricItem& each) {
    return each.metric == name.kind && scenarios::subject_of(each) == name.subject;
  });
  if (item == scenario.rubric.items.end()) return {proposed.change.name, "", {}, {}};
  return {item->title + ": " + value_of_work(proposed.to, *item) + " instead of " +
              value_of_work(proposed.change.from, *item),
          scenarios::advice_text(item->metric),
          {},
          {}};
}

SaidChange said_geometry(const ProposedChange& proposed, const Scenario& scenario,
                         const scenarios::Plan& plan, const ChangeName& name) {
  const PlannedCut* cut = find_cut(plan, name.subject);
  SaidChange said = cut == nullptr          ? said_stop(proposed)
                    : name.kind == "offset" ? said_shift(proposed, *cut)
                                            : said_turn(proposed, *cut, name.kind == "tilt");
  const std::string title = cut == nullptr ? title_in(scenario.hinges, name.subject)
                                           : title_in(scenario.cuts, name.subject);
  said.head = title + ": " + said.head;
  said.body += items_text(proposed, scenario);
  return said;
}

void add_together(SaidWhatIf& said, const Proposals& proposals, const ScoreCard& card) {
  const std::int64_t now = in_tenths(card.score_milli), then = in_tenths(proposals.score_milli);
  said.together = proposals.changes.size() == 2 ? "Both together" : "All three together";
  said.together_score = "The machine\xE2\x80\x99s score would have been " + tenths_text(then) +
                        " instead of " + tenths_text(now) + ".";
  // They may touch the same points, move the bone that another was measured on, or meet a gate.
  if (proposals.gain_milli <= proposals.changes.front().gain_milli)
    said.together_score += " That is no more than the first alone: they do not simply add up.";
  said.together_gain = gain_text(then - now);
}

std::string nothing_text(const ScoreCard& card) {
  constexpr std::int64_t all_milli = 100'000;
  if (card.score_milli >= all_milli)
    return "Every point was earned: nothing would have earned more.";
  if (card.measured_milli == 0)
    return "Nothing of this attempt could be measured, so there is nothing to change.";
  if (std::ranges::any_of(card.gates, &database::GateResult::is_triggered))
    return "A gate caps this score, and no single change of what was measured lifts it.";
  return "No single change of what was measured would have earned more by itself.";
}

}  // namespace

SaidWhatIf said_what_if(const Proposals& proposals, const Scenario& scenario,
                        const scenarios::Plan& plan, const ScoreCard& card) {
  SaidWhatIf said;
  for (const ProposedChange& proposed : proposals.changes) {
    const ChangeName name(proposed.change.name);
    SaidChange change = proposed.change.is_replaced ? said_work(proposed, scenario, name)
                                                    : said_geometry(proposed, scenario, plan, name);
    change.body += gates_text(proposed, scenario);
    change.gain = gain_text(in_tenths(proposed.gain_milli));
    change.items = proposed.items;
    said.changes.push_back(std::move(change));
  }
  if (said.changes.empty()) said.nothing = nothing_text(card);
  if (said.changes.size() > 1) add_together(said, proposals, card);
  return said;
}

std::string_view what_if_note() noexcept {
  return "Worked out by the scorer itself: a cut is moved and measured again, or one value of the "
         "work is replaced; all else stays as it was.";
}

}  // namespace hallux::ui
