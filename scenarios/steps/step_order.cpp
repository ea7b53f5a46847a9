// What a step comes after is ids of steps and names of groups, in any number: each step is worked
// out once, whatever leads to it. Checking refuses cycles first, and all walks after that end.
#include "scenarios/steps/step_order.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <string>

#include "scenarios/json_node.h"

namespace hallux::scenarios {
namespace {

using Steps = std::vector<OperationStep>;

std::string path_of_step(std::size_t index, std::string_view key) {
  return "steps[" + std::to_string(index) + "]." + std::string(key);
}

/// Indices of the step of that id, or of the group's alternatives.
std::vector<std::size_t> named_by(const Steps& steps, std::string_view name) {
  std::vector<std::size_t> named;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].id == name || steps[i].one_of == name) named.push_back(i);
  }
  return named;
}

/// Of each step what it comes after: one list of alternatives for each name. In format 1 none has a
/// name, and each comes after the one before.
using Before = std::vector<std::vector<std::vector<std::size_t>>>;

Before before_each(const Scenario& scenario) {
  Before before(scenario.steps.size());
  for (std::size_t step = 0; step < before.size(); ++step) {
    if (scenario.format == 1) {
      if (step > 0) before[step].push_back({step - 1});
      continue;
    }
    for (const std::string& name : scenario.steps[step].after)
      before[step].push_back(named_by(scenario.steps, name));
  }
  return before;
}

/// Of each step all that it cannot be done without, optional steps among them: of a group what all
/// of its alternatives need.
/// needs   no cycle
class Needs {
 public:
  explicit Needs(const Before& before) : before_(before), known_(before.size()) {}

  const std::set<std::size_t>& of(std::size_t step) {
    if (!known_[step]) known_[step] = worked_out(step);
    return *known_[step];
  }

 private:
  std::set<std::size_t> worked_out(std::size_t step) {
    std::set<std::size_t> needed;
    for (const std::vector<std::size_t>& alternatives : before_[step])
      needed.merge(common_of(alternatives));
    return needed;
  }

  std::set<std::size_t> common_of(const std::vector<std::size_t>& alternatives) {
    std::set<std::size_t> common;
    for (const std::size_t each : alternatives) {
      std::set<std::size_t> with = of(each);
      with.insert(each);
      if (each == alternatives.front()) common = with;
      std::erase_if(common, [&](std::size_t step) { return !with.contains(step); });
    }
    return common;
  }

  const Before& before_;
  std::vector<std::optional<std::set<std::size_t>>> known_;
};

bool is_group_done(const Scenario& scenario, std::size_t step, const std::vector<bool>& is_done) {
  return std::ranges::any_of(alternatives_of(scenario, step),
                             [&](std::size_t each) { return is_done[each]; });
}

/// Which steps have all behind them that they come after.
class Following {
 public:
  Following(const Scenario& scenario, const Before& before, const std::vector<bool>& is_done)
      : scenario_(scenario), before_(before), is_done_(is_done), known_(before.size()) {}

  /// Of each name one alternative is past.
  bool may_follow(std::size_t step) {
    if (known_[step]) return *known_[step];
    const bool may = std::ranges::all_of(before_[step], [&](const auto& alternatives) {
      return std::ranges::any_of(alternatives, [&](std::size_t before) { return is_past(before); });
    });
    known_[step] = may;
    return may;
  }

 private:
  /// Done, or passed over: optional, and it could have been done.
  bool is_past(std::size_t step) {
    return is_done_[step] || (scenario_.steps[step].is_optional && may_follow(step));
  }

  const Scenario& scenario_;
  const Before& before_;
  const std::vector<bool>& is_done_;
  std::vector<std::optional<bool>> known_;
};

void check_ids(const Steps& steps, std::string_view file) {
  std::set<std::string_view> ids;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!ids.insert(steps[i].id).second)
      refuse(file, path_of_step(i, "id"), "is \"" + steps[i].id + "\", which is already taken",
             "give each its own");
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (ids.contains(steps[i].one_of))
      refuse(file, path_of_step(i, "one_of"), "is \"" + steps[i].one_of + "\", which is a step",
             "give the group a name of its own");
  }
}

void check_names_of_after(const Steps& steps, std::string_view file) {
  std::string known;
  for (const OperationStep& step : steps) known += (known.empty() ? "" : ", ") + step.id;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = 0; j < steps[i].after.size(); ++j) {
      const std::string& name = steps[i].after[j];
      if (!named_by(steps, name).empty()) continue;
      refuse(file, path_of_step(i, "after[" + std::to_string(j) + "]"),
             "is \"" + name + "\", which is no step and no group",
             "name a group, or one of: " + known);
    }
  }
}

/// Walks against the arrows; `on_way` holds the steps between the first and this one.
void check_cycle(const Scenario& scenario, const Before& before, std::size_t step,
                 std::set<std::size_t>& on_way, std::set<std::size_t>& sound,
                 std::string_view file) {
  if (sound.contains(step)) return;
  if (!on_way.insert(step).second) {
    refuse(file, path_of_step(step, "after"),
           "leads round about to \"" + scenario.steps[step].id + "\" itself",
           "let no step come after itself");
  }
  for (const auto& alternatives : before[step]) {
    for (const std::size_t each : alternatives)
      check_cycle(scenario, before, each, on_way, sound, file);
  }
  on_way.erase(step);
  sound.insert(step);
}

void check_groups(const Steps& steps, std::string_view file) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].one_of.empty()) continue;
    const std::vector<std::size_t> group = named_by(steps, steps[i].one_of);
    if (group.size() == 1)
      refuse(file, path_of_step(i, "one_of"),
             "is \"" + steps[i].one_of + "\", which has no other alternative",
             "name the same group in another step, or remove it");
    if (steps[i].is_optional != steps[group.front()].is_optional)
      refuse(file, path_of_step(i, "optional"), "differs between the alternatives of a group",
             "let all of \"" + steps[i].one_of + "\" be optional, or none");
  }
}

/// A step, or what it needs, must not hold two alternatives of which only one is done.
void check_satisfiable(const Scenario& scenario, std::size_t step, std::set<std::size_t> needed,
                       std::string_view file) {
  needed.insert(step);
  for (const std::size_t one : needed) {
    for (const std::size_t other : needed) {
      const std::string& group = scenario.steps[one].one_of;
      if (one == other || group.empty() || scenario.steps[other].one_of != group) continue;
      refuse(file, path_of_step(step, "after"),
             "asks for \"" + scenario.steps[one].id + "\" and \"" + scenario.steps[other].id +
                 "\", of which one excludes the other",
             "name the group \"" + group + "\" instead");
    }
  }
}

/// Exactly one step of that kind.
std::size_t only_step(const Steps& steps, StepKind kind, std::string_view word,
                      std::string_view file) {
  const auto found = std::ranges::find(steps, kind, &OperationStep::kind);
  if (std::ranges::count(steps, kind, &OperationStep::kind) != 1)
    refuse(file, "steps", "have not exactly one \"" + std::string(word) + "\"",
           "begin with the one \"verify\" and end with the one \"finish\"");
  return static_cast<std::size_t>(found - steps.begin());
}

/// All that leads to the step, by whichever alternative, itself included.
std::set<std::size_t> leading_to(const Before& before, std::size_t step) {
  std::set<std::size_t> reached{step};
  std::vector<std::size_t> border{step};
  while (!border.empty()) {
    const std::size_t next = border.back();
    border.pop_back();
    for (const auto& alternatives : before[next]) {
      for (const std::size_t each : alternatives) {
        if (reached.insert(each).second) border.push_back(each);
      }
    }
  }
  return reached;
}

void check_ends_of_order(const Scenario& scenario, const Before& before, Needs& needs,
                         std::string_view file) {
  const Steps& steps = scenario.steps;
  const std::size_t verify = only_step(steps, StepKind::Verify, "verify", file);
  const std::size_t finish = only_step(steps, StepKind::Finish, "finish", file);
  const std::set<std::size_t> awaited = leading_to(before, finish);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i != verify && !needs.of(i).contains(verify))
      refuse(file, path_of_step(i, "after"), "does not lead back to \"" + steps[verify].id + "\"",
             "let every step come after the one \"verify\"");
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!awaited.contains(i))
      refuse(file, path_of_step(finish, "after"), "does not wait for \"" + steps[i].id + "\"",
             "let the one \"finish\" come after every step");
  }
}

}  // namespace

std::vector<std::size_t> alternatives_of(const Scenario& scenario, std::size_t step) {
  const std::string& group = scenario.steps[step].one_of;
  return group.empty() ? std::vector{step} : named_by(scenario.steps, group);
}

std::vector<std::size_t> steps_at_hand(const Scenario& scenario, const std::vector<bool>& is_done) {
  const Before before = before_each(scenario);
  Needs needs(before);
  Following following(scenario, before, is_done);
  std::vector<std::size_t> at_hand;
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    if (is_group_done(scenario, step, is_done) || !following.may_follow(step)) continue;
    bool is_passed = false;
    for (std::size_t later = 0; later < scenario.steps.size(); ++later)
      is_passed = is_passed || (is_done[later] && needs.of(later).contains(step));
    if (!is_passed) at_hand.push_back(step);
  }
  return at_hand;
}

bool is_all_done(const Scenario& scenario, const std::vector<bool>& is_done) {
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    if (!scenario.steps[step].is_optional && !is_group_done(scenario, step, is_done)) return false;
  }
  return true;
}

std::vector<std::size_t> steps_in_order(const Scenario& scenario) {
  const Before before = before_each(scenario);
  // More leads to a step than to any that leads to it.
  std::vector<std::size_t> led_to_by;
  for (std::size_t step = 0; step < before.size(); ++step)
    led_to_by.push_back(leading_to(before, step).size());
  std::vector<std::size_t> ordered(before.size());
  std::iota(ordered.begin(), ordered.end(), 0);
  std::ranges::stable_sort(ordered, {}, [&](std::size_t step) { return led_to_by[step]; });
  return ordered;
}

std::vector<std::set<std::size_t>> needs_of_steps(const Scenario& scenario) {
  const Before before = before_each(scenario);
  Needs needs(before);
  std::vector<std::set<std::size_t>> needed;
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) needed.push_back(needs.of(step));
  return needed;
}

void check_step_order(const Scenario& scenario, std::string_view file) {
  check_ids(scenario.steps, file);
  check_names_of_after(scenario.steps, file);
  const Before before = before_each(scenario);
  std::set<std::size_t> on_way, sound;
  for (std::size_t step = 0; step < scenario.steps.size(); ++step)
    check_cycle(scenario, before, step, on_way, sound, file);
  check_groups(scenario.steps, file);
  Needs needs(before);
  for (std::size_t step = 0; step < scenario.steps.size(); ++step)
    check_satisfiable(scenario, step, needs.of(step), file);
  check_ends_of_order(scenario, before, needs, file);
}

}  // namespace hallux::scenarios
