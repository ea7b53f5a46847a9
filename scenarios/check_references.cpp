#include "scenarios/check_references.h"

#include <algorithm>
#include <set>
#include <string>

#include "scenarios/json_node.h"
#include "scenarios/metric_names.h"

namespace hallux::scenarios {
namespace {

std::string path_of(std::string_view list, std::size_t index, std::string_view key) {
  return std::string(list) + "[" + std::to_string(index) + "]." + std::string(key);
}

std::string is_text(std::string_view text) { return "is \"" + std::string(text) + "\""; }

std::string points_text(std::int64_t milli) {
  return text_of_number(static_cast<double>(milli) / 1000.0);
}

template <typename Part>
void check_names(const std::vector<Part>& parts, std::string Part::*name, std::string_view list,
                 std::string_view key, std::string_view file) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (seen.insert(parts[i].*name).second) continue;
    refuse(file, path_of(list, i, key), is_text(parts[i].*name) + ", which is already taken",
           "give each its own");
  }
}

bool has_cut(const Scenario& scenario, std::string_view name) {
  return std::any_of(scenario.cuts.begin(), scenario.cuts.end(),
                     [&](const ReferenceCut& cut) { return cut.name == name; });
}

/// A cut is named exactly where the part is about one.
void check_cut(const Scenario& scenario, std::string_view cut, bool is_of_a_cut,
               const std::string& path, std::string_view file) {
  if (!is_of_a_cut && !cut.empty()) {
    refuse(file, path, is_text(cut), "remove it: this is not about one cut");
  }
  if (is_of_a_cut && !has_cut(scenario, cut)) {
    std::string mend = "name one of the cuts:";
    for (const ReferenceCut& known : scenario.cuts) mend += " " + known.name;
    refuse(file, path, cut.empty() ? "is missing" : is_text(cut) + ", which is no cut", mend);
  }
}

void check_steps(const Scenario& scenario, std::string_view file) {
  std::set<std::string_view> sawn, removed;
  const std::size_t last = scenario.steps.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const OperationStep& step = scenario.steps[i];
    if ((step.kind == StepKind::Verify) != (i == 0) ||
        (step.kind == StepKind::Finish) != (i == last)) {
      refuse(file, path_of("steps", i, "kind"), "is out of order",
             "begin with the one \"verify\" and end with the one \"finish\"");
    }
    const bool is_of_a_cut = step.kind == StepKind::Cut || step.kind == StepKind::Remove;
    const std::string path = path_of("steps", i, "cut");
    check_cut(scenario, step.cut, is_of_a_cut, path, file);
    if (step.kind == StepKind::Cut && !sawn.insert(step.cut).second) {
      refuse(file, path, is_text(step.cut) + ", which was cut before", "cut each face once");
    }
    if (step.kind != StepKind::Remove) continue;
    if (!sawn.contains(step.cut) || !removed.insert(step.cut).second) {
      refuse(file, path, is_text(step.cut) + ", whose piece is not there to be removed",
             "remove once, after the cut");
    }
  }
  for (std::size_t i = 0; i < scenario.cuts.size(); ++i) {
    if (sawn.contains(scenario.cuts[i].name)) continue;
    refuse(file, path_of("cuts", i, "name"),
           is_text(scenario.cuts[i].name) + ", which no step cuts",
           "add a step of kind \"cut\" for it");
  }
}

void check_group_weights(const Rubric& rubric, std::string_view file) {
  std::int64_t total_milli = 0;
  for (const RubricGroup& group : rubric.groups) total_milli += group.weight_milli;
  if (total_milli != 100'000) {
    refuse(file, "rubric.groups", "the weights add up to " + points_text(total_milli),
           "make them add up to 100");
  }
  for (std::size_t i = 0; i < rubric.groups.size(); ++i) {
    const RubricGroup& group = rubric.groups[i];
    std::int64_t items_milli = 0;
    bool has_items = false;
    for (const RubricItem& item : rubric.items) {
      if (item.group != group.name) continue;
      has_items = true;
      items_milli += item.weight_milli;
    }
    if (!has_items || items_milli == group.weight_milli) continue;
    refuse(file, path_of("rubric.groups", i, "weight"),
           "is " + points_text(group.weight_milli) + " but its items add up to " +
               points_text(items_milli),
           "make them equal");
  }
}

void check_rubric(const Scenario& scenario, std::string_view file) {
  const Rubric& rubric = scenario.rubric;
  for (std::size_t i = 0; i < rubric.items.size(); ++i) {
    const RubricItem& item = rubric.items[i];
    const bool has_group =
        std::any_of(rubric.groups.begin(), rubric.groups.end(),
                    [&](const RubricGroup& group) { return group.name == item.group; });
    if (!has_group) {
      refuse(file, path_of("rubric.items", i, "group"), is_text(item.group) + ", which is no group",
             "name one of rubric.groups");
    }
    check_cut(scenario, item.cut, find_metric(item.metric)->is_of_a_cut,
              path_of("rubric.items", i, "cut"), file);
  }
  for (std::size_t i = 0; i < rubric.gates.size(); ++i) {
    const Gate& gate = rubric.gates[i];
    check_cut(scenario, gate.cut, find_metric(gate.metric)->is_of_a_cut,
              path_of("rubric.gates", i, "cut"), file);
  }
  check_group_weights(rubric, file);
}

}  // namespace

void check_references(const Scenario& scenario, std::string_view file) {
  check_names(scenario.sources, &SourceNote::key, "sources", "key", file);
  check_names(scenario.cuts, &ReferenceCut::name, "cuts", "name", file);
  check_names(scenario.danger_zones, &DangerZone::name, "danger_zones", "name", file);
  check_names(scenario.rubric.groups, &RubricGroup::name, "rubric.groups", "name", file);
  check_names(scenario.rubric.items, &RubricItem::id, "rubric.items", "id", file);
  check_names(scenario.rubric.gates, &Gate::name, "rubric.gates", "name", file);
  check_steps(scenario, file);
  check_rubric(scenario, file);
}

}  // namespace hallux::scenarios
