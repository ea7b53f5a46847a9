// A step names what it is about by the key of its kind and by no other. What must be done before
// is asked of the order alone: whichever way through the alternatives is taken, a piece is sawn
// free before it is taken out.
#include "scenarios/format_2/check_ordered_steps.h"

#include "scenarios/check_names.h"
#include "scenarios/steps/step_order.h"

namespace hallux::scenarios {
namespace {

class StepCheck {
 public:
  StepCheck(const Scenario& scenario, std::string_view file) : scenario_(scenario), file_(file) {}

  void run() {
    check_step_order(scenario_, file_);
    needs_ = needs_of_steps(scenario_);
    for (std::size_t i = 0; i < scenario_.steps.size(); ++i) {
      check_subject_of(i);
      check_deeds_before(i);
    }
    check_done_once();
    check_all_used();
  }

 private:
  const OperationStep& step(std::size_t index) const { return scenario_.steps[index]; }

  static std::string path(std::size_t index, std::string_view key) {
    return path_of("steps", index, key);
  }

  /// Keys that a kind does not have are refused.
  void refuse_others(std::size_t index, std::string_view own, std::string_view also = {}) const {
    const OperationStep& each = step(index);
    const auto refuse_key = [&](std::string_view key, const std::string& named) {
      if (key != own && key != also) refuse_named(named, key, path(index, key), file_);
    };
    refuse_key("cut", each.cut);
    refuse_key("hinge", each.hinge);
    refuse_key("point", each.point);
    refuse_key("shift", each.shift);
    if (!each.implants.empty()) refuse_key("implants", each.implants.front());
  }

  void check_subject_of(std::size_t index) const {
    const OperationStep& each = step(index);
    switch (each.kind) {
      case StepKind::Verify:
      case StepKind::Finish:
      case StepKind::Retract:
        return refuse_others(index, {});
      case StepKind::Mark:
        if (each.point.empty())
          refuse(file_, path(index, "point"), "is missing", "name a point or a landmark");
        return refuse_others(index, "point");
      case StepKind::Cut:
      case StepKind::Trim:
        check_named(scenario_.cuts, each.cut, "cut", path(index, "cut"), file_);
        return refuse_others(index, "cut");
      case StepKind::Complete:
      case StepKind::Close:
        check_named(scenario_.hinges, each.hinge, "hinge", path(index, "hinge"), file_);
        return refuse_others(index, "hinge");
      case StepKind::Remove:
        return check_removed(index);
      case StepKind::Shift:
        check_named(scenario_.shifts, each.shift, "shift", path(index, "shift"), file_);
        return refuse_others(index, "shift");
      case StepKind::GuideWire:
      case StepKind::TemporaryWire:
      case StepKind::Fix:
        return check_implants(index);
    }
  }

  void check_removed(std::size_t index) const {
    const OperationStep& each = step(index);
    if (!each.hinge.empty()) {
      check_named(scenario_.hinges, each.hinge, "hinge", path(index, "hinge"), file_);
      return refuse_others(index, "hinge");
    }
    check_named(scenario_.cuts, each.cut, "cut", path(index, "cut"), file_);
    refuse_others(index, "cut");
  }

  void check_implants(std::size_t index) const {
    const OperationStep& each = step(index);
    if (each.implants.empty())
      refuse(file_, path(index, "implants"), "is missing", "name the wires or screws that are set");
    for (std::size_t i = 0; i < each.implants.size(); ++i) {
      const std::string place = path(index, "implants[" + std::to_string(i) + "]");
      check_named(scenario_.implants, each.implants[i], "implant", place, file_);
      const auto found = std::ranges::find(scenario_.implants, each.implants[i], &Implant::name);
      if (each.kind != StepKind::Fix && found->kind != ImplantKind::Wire)
        refuse(file_, place, is_text(each.implants[i]) + ", which is no wire", "name a wire");
    }
    refuse_others(index, "implants");
  }

  /// Whether a step of these words must be done before this one.
  template <typename Claim>
  bool needs(std::size_t index, Claim claim) const {
    return std::ranges::any_of(needs_[index],
                               [&](std::size_t before) { return claim(step(before)); });
  }

  bool needs_cut(std::size_t index, const std::string& cut) const {
    return needs(index, [&](const OperationStep& before) {
      return before.kind == StepKind::Cut && before.cut == cut;
    });
  }

  void check_deeds_before(std::size_t index) const {
    const OperationStep& each = step(index);
    if (each.kind == StepKind::Remove) return check_sawn_free(index);
    if (each.kind == StepKind::Close) {
      const bool is_out = needs(index, [&](const OperationStep& before) {
        return before.kind == StepKind::Remove && before.hinge == each.hinge;
      });
      if (!is_out)
        refuse(file_, path(index, "hinge"), is_text(each.hinge) + ", whose wedge is not out",
               "let it come after the step that removes its wedge");
    }
    if (each.kind == StepKind::Shift) {
      const bool is_any =
          needs(index, [](const OperationStep& before) { return before.kind == StepKind::Cut; });
      if (!is_any)
        refuse(file_, path(index, "shift"), is_text(each.shift) + ", and nothing is cut before it",
               "let it come after the cuts that free its fragment");
    }
  }

  void check_sawn_free(std::size_t index) const {
    const OperationStep& each = step(index);
    bool is_free = needs_cut(index, each.cut);
    for (const ReferenceHinge& hinge : scenario_.hinges) {
      if (hinge.name != each.hinge) continue;
      is_free = needs_cut(index, hinge.first_cut) && needs_cut(index, hinge.second_cut);
    }
    if (!is_free)
      refuse(file_, path(index, each.hinge.empty() ? "cut" : "hinge"),
             is_text(subject_of(each)) + ", whose piece is not there to be removed",
             "let it come after its cuts");
  }

  /// What two steps do is done by one of two alternatives.
  void check_done_once() const {
    for (std::size_t i = 0; i < scenario_.steps.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!does_the_same(step(j), step(i))) continue;
        if (!step(i).one_of.empty() && step(i).one_of == step(j).one_of) continue;
        refuse(file_, path(i, "kind"), "does again what \"" + step(j).id + "\" has done",
               "do each thing once");
      }
    }
  }

  static bool does_the_same(const OperationStep& one, const OperationStep& other) {
    const auto is_sawing = [](const OperationStep& each) { return is_sawn(each); };
    if (is_sawing(one) && is_sawing(other)) return one.cut == other.cut;
    if (one.kind != other.kind) return false;
    switch (one.kind) {
      case StepKind::Remove:
        return one.cut == other.cut && one.hinge == other.hinge;
      case StepKind::Close:
      case StepKind::Complete:
        return one.hinge == other.hinge;
      case StepKind::Shift:
        return one.shift == other.shift;
      default:
        return false;
    }
  }

  /// errors  ScenarioError naming the part that no step is about
  template <typename Part, typename Claim>
  void check_used(const std::vector<Part>& parts, std::string_view list, std::string_view mend,
                  Claim claim) const {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool is_used = std::ranges::any_of(
          scenario_.steps, [&](const OperationStep& each) { return claim(each, parts[i].name); });
      if (!is_used)
        refuse(file_, std::string(list), "have \"" + parts[i].name + "\", which no step is about",
               mend);
    }
  }

  void check_all_used() const {
    check_used(scenario_.cuts, "cuts", "add a step of kind \"cut\" or \"trim\" for it",
               [](const OperationStep& each, const std::string& name) {
                 return each.cut == name && is_sawn(each);
               });
    check_used(
        scenario_.shifts, "shifts", "add a step of kind \"shift\" for it",
        [](const OperationStep& each, const std::string& name) { return each.shift == name; });
    check_used(scenario_.implants, "wires and screws", "add a step that sets it",
               [](const OperationStep& each, const std::string& name) {
                 return std::ranges::find(each.implants, name) != each.implants.end();
               });
  }

  const Scenario& scenario_;
  std::string_view file_;
  std::vector<std::set<std::size_t>> needs_;
};

}  // namespace

void check_ordered_steps(const Scenario& scenario, std::string_view file) {
  StepCheck(scenario, file).run();
}

}  // namespace hallux::scenarios
