/// A text is read in three steps: the row of its name, the subject that the scenario has, the size
/// within the row's range. Each refusal lists what there is at that step.
#include "scenarios/hands/hand_fault.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "scenarios/json_node.h"
#include "scenarios/scenario.h"

namespace hallux::scenarios {

namespace {

constexpr std::array<FaultRow, 20> rows{{
    {FaultKind::Tilt, "tilt", FaultSubject::MayBeCut, "degrees", 4.0, -45.0, 45.0, false,
     "turns the aimed plane about the direction that the planned one contains"},
    {FaultKind::Roll, "roll", FaultSubject::MayBeCut, "degrees", 4.0, -45.0, 45.0, false,
     "turns the aimed plane out of that direction"},
    {FaultKind::Offset, "offset", FaultSubject::MayBeCut, "mm", 1.0, -10.0, 10.0, false,
     "shifts the aimed plane along the plan's normal, towards the waste"},
    {FaultKind::OverCut, "over_cut", FaultSubject::MayBeCut, "mm", 2.0, 0.0, 20.0, false,
     "goes so much farther than it would: beyond the hinge's line, or the last bone"},
    {FaultKind::StopShort, "stop_short", FaultSubject::MayBeCut, "mm", 2.0, 0.0, 20.0, false,
     "stops so long before the hinge's line, or the last bone under the teeth"},
    {FaultKind::Skip, "skip", FaultSubject::Step, "", 0.0, 0.0, 0.0, false,
     "neither does nor declares the step"},
    {FaultKind::Swap, "swap", FaultSubject::None, "", 0.0, 0.0, 0.0, false,
     "does and declares the second cut before the first"},
    {FaultKind::Dry, "dry", FaultSubject::None, "", 0.0, 0.0, 0.0, false, "saws without water"},
    {FaultKind::Slow, "slow", FaultSubject::None, "times", 2.0, 1.0, 10.0, false,
     "waits between strokes until the attempt takes so many times as long"},
    {FaultKind::Press, "press", FaultSubject::None, "N", 8.0, 0.0, 20.0, false,
     "pushes so much harder in bone, before the far side, too"},
    {FaultKind::Restarts, "restarts", FaultSubject::None, "times", 3.0, 1.0, 20.0, true,
     "draws the blade wholly out of its first kerf so often, and enters it again"},
    {FaultKind::TouchZone, "touch_zone", FaultSubject::Zone, "s", 1.0, 0.1, 10.0, false,
     "leads the running saw through the air into the zone for so long, before its first cut"},
    {FaultKind::ShiftBy, "shift_by", FaultSubject::Fragment, "mm", 3.0, -20.0, 20.0, false,
     "leads the fragment so much farther along the planned way"},
    {FaultKind::TurnBy, "turn_by", FaultSubject::Fragment, "degrees", 8.0, -45.0, 45.0, false,
     "turns the fragment so much about the foot's dorsal"},
    {FaultKind::WrongWay, "wrong_way", FaultSubject::Fragment, "", 0.0, 0.0, 0.0, false,
     "leads the fragment the opposite way"},
    {FaultKind::Direction, "direction", FaultSubject::Implant, "degrees", 15.0, -45.0, 45.0, false,
     "sets the wire or screw so much off its direction"},
    {FaultKind::Entry, "entry", FaultSubject::Implant, "mm", 4.0, -15.0, 15.0, false,
     "sets it in so far beside its entry"},
    {FaultKind::Length, "length", FaultSubject::Implant, "mm", 6.0, -15.0, 15.0, false,
     "sets it so much deeper, or a screw so much longer"},
    {FaultKind::Unicortical, "unicortical", FaultSubject::Implant, "", 0.0, 0.0, 0.0, false,
     "stops with it before the far cortex"},
    {FaultKind::WrongBlade, "wrong_blade", FaultSubject::MayBeCut, "", 0.0, 0.0, 0.0, false,
     "saws with the next blade on the tray"},
}};

const FaultRow& row_of(FaultKind kind) noexcept { return rows[static_cast<std::size_t>(kind)]; }

/// "a", "a or b", "a, b or c".
std::string any_of_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

/// How a fault of the row is written.
std::string pattern_of(const FaultRow& row) {
  std::string text(row.name);
  if (row.subject == FaultSubject::MayBeCut) text += "[:CUT]";
  if (row.subject == FaultSubject::Step) text += ":STEP";
  if (row.subject == FaultSubject::Zone) text += ":ZONE";
  if (row.subject == FaultSubject::Fragment) text += ":FRAGMENT";
  if (row.subject == FaultSubject::Implant) text += ":IMPLANT";
  if (!row.unit.empty()) {
    text += "[=" + text_of_number(row.usual_size) + " " + std::string(row.unit) + "]";
  }
  return text;
}

[[noreturn]] void refuse_fault(std::string_view text, const std::string& what) {
  throw ScenarioError("fault \"" + std::string(text) + "\": " + what);
}

const FaultRow& row_named(std::string_view name) {
  for (const FaultRow& row : rows) {
    if (row.name == name) return row;
  }
  std::vector<std::string> patterns;
  patterns.reserve(rows.size());
  for (const FaultRow& row : rows) patterns.push_back(pattern_of(row));
  throw ScenarioError("there is no fault \"" + std::string(name) + "\"; use " +
                      any_of_words(patterns));
}

/// What a fault of this row may be of.
std::vector<std::string> subjects_in(const Scenario& scenario, FaultSubject subject) {
  std::vector<std::string> names;
  if (subject == FaultSubject::MayBeCut) {
    for (const ReferenceCut& cut : scenario.cuts) names.push_back(cut.name);
  }
  if (subject == FaultSubject::Zone) {
    for (const DangerZone& zone : scenario.danger_zones) names.push_back(zone.name);
  }
  if (subject == FaultSubject::Fragment) {
    for (const Fragment& fragment : scenario.fragments) names.push_back(fragment.name);
  }
  if (subject == FaultSubject::Implant) {
    for (const Implant& implant : scenario.implants) names.push_back(implant.name);
  }
  if (subject == FaultSubject::Step) {
    for (const OperationStep& step : scenario.steps) {
      const std::string name(fault_name_of(step));
      const bool is_known = std::find(names.begin(), names.end(), name) != names.end();
      if (!name.empty() && !is_known) names.push_back(name);
    }
  }
  return names;
}

std::string subject_in(std::string_view text, const FaultRow& row,
                       const std::optional<std::string_view>& subject, const Scenario& scenario) {
  const std::string pattern = "write " + pattern_of(row);
  if (row.subject == FaultSubject::None) {
    if (subject) refuse_fault(text, "it is of the whole attempt; " + pattern);
    return {};
  }
  if (!subject && row.subject == FaultSubject::MayBeCut) return {};
  const std::vector<std::string> known = subjects_in(scenario, row.subject);
  std::string name(subject.value_or(""));
  if (std::find(known.begin(), known.end(), name) != known.end()) return name;
  if (known.empty()) refuse_fault(text, scenario.name + " has none that it could be of");
  refuse_fault(text, (subject ? scenario.name + " has no \"" + name + "\" that it could be of"
                              : "it does not say what it is of") +
                         "; " + pattern + " with " + any_of_words(known));
}

double size_in(std::string_view text, const FaultRow& row,
               const std::optional<std::string_view>& digits) {
  if (row.unit.empty()) {
    if (digits) refuse_fault(text, "it has no size; write " + pattern_of(row));
    return 0.0;
  }
  if (!digits) return row.usual_size;
  double size = 0.0;
  const char* const end = digits->data() + digits->size();
  const auto read = std::from_chars(digits->data(), end, size);
  const bool is_number = read.ec == std::errc() && read.ptr == end;
  const bool is_in_range = size >= row.least && size <= row.greatest;
  if (is_number && is_in_range && (!row.is_whole || size == std::ceil(size))) {
    return size == 0.0 ? 0.0 : size;
  }
  refuse_fault(text, "give " + std::string(row.is_whole ? "a whole number" : "a number") +
                         " from " + text_of_number(row.least) + " to " +
                         text_of_number(row.greatest) + ", " + std::string(row.unit) + "; " +
                         pattern_of(row));
}

/// Up to a mark, and what comes after it, where it is there.
struct Split {
  std::string_view before;
  std::optional<std::string_view> after;
};

Split split_at(std::string_view text, char mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return {text, std::nullopt};
  return {text.substr(0, at), text.substr(at + 1)};
}

HandFault parse_hand_fault(std::string_view text, const Scenario& scenario) {
  const Split sized = split_at(text, '=');
  const Split named = split_at(sized.before, ':');
  const FaultRow& row = row_named(named.before);
  if (row.kind == FaultKind::Swap && scenario.cuts.size() < 2) {
    refuse_fault(text, scenario.name + " has one cut, and two are swapped");
  }
  return {row.kind, subject_in(text, row, named.after, scenario), size_in(text, row, sized.after)};
}

bool is_same(const HandFault& a, const HandFault& b) noexcept {
  return a.kind == b.kind && a.subject == b.subject;
}

}  // namespace

std::span<const FaultRow> fault_table() noexcept { return rows; }

std::vector<HandFault> parse_hand_faults(std::span<const std::string> texts,
                                         const Scenario& scenario) {
  std::vector<HandFault> faults;
  for (const std::string& text : texts) {
    HandFault fault = parse_hand_fault(text, scenario);
    const auto same = [&](const HandFault& known) { return is_same(known, fault); };
    if (std::any_of(faults.begin(), faults.end(), same)) {
      refuse_fault(text, "it is given twice; give one of the two");
    }
    faults.push_back(std::move(fault));
  }
  // The longest name of a hand that feels goes in front.
  if (hand_with_faults("perfect", faults).size() > hand_name_bytes_max) {
    throw ScenarioError("a record names faults in " + std::to_string(hand_name_bytes_max) +
                        " letters with their hand, and these take more; give fewer");
  }
  return faults;
}

std::string text_of(const HandFault& fault) {
  const FaultRow& row = row_of(fault.kind);
  std::string text(row.name);
  if (!fault.subject.empty()) text += ":" + fault.subject;
  if (!row.unit.empty()) text += "=" + text_of_number(fault.size);
  return text;
}

std::string hand_with_faults(std::string_view hand, std::span<const HandFault> faults) {
  std::string name(hand);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    name += (i == 0 ? " with " : ", ") + text_of(faults[i]);
  }
  return name;
}

double fault_size(std::span<const HandFault> faults, FaultKind kind,
                  std::string_view subject) noexcept {
  double size = 0.0;
  for (const HandFault& fault : faults) {
    if (fault.kind == kind && (fault.subject.empty() || fault.subject == subject))
      size += fault.size;
  }
  return size;
}

bool has_fault(std::span<const HandFault> faults, FaultKind kind) noexcept {
  return std::any_of(faults.begin(), faults.end(),
                     [kind](const HandFault& fault) { return fault.kind == kind; });
}

bool is_faulty(std::span<const HandFault> faults, FaultKind kind,
               std::string_view subject) noexcept {
  return std::any_of(faults.begin(), faults.end(), [&](const HandFault& fault) {
    return fault.kind == kind && (fault.subject.empty() || fault.subject == subject);
  });
}

std::string_view fault_name_of(const OperationStep& step) noexcept {
  if (!step.id.empty() && step.kind != StepKind::Finish) return step.id;
  switch (step.kind) {
    case StepKind::Verify:
      return "verify";
    case StepKind::Cut:
      return step.cut;
    case StepKind::Remove:
      return "remove";
    case StepKind::Close:
      return "close";
    default:
      return {};
  }
}

bool is_skipped(std::span<const HandFault> faults, const OperationStep& step) noexcept {
  const std::string_view name = fault_name_of(step);
  return !name.empty() && std::any_of(faults.begin(), faults.end(), [&](const HandFault& fault) {
    return fault.kind == FaultKind::Skip && fault.subject == name;
  });
}

}  // namespace hallux::scenarios
