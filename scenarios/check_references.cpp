/// What no single value of a scenario can say of itself: names that others use, the order of the
/// steps, the two cuts of a hinge, and weights that add up. The schema knows types and ranges only.
/// Each refusal names one path and one mend; the first one found ends the reading.
#include "scenarios/check_references.h"

#include <algorithm>
#include <set>
#include <string>

#include "scenarios/check_names.h"
#include "scenarios/format_2/check_operation.h"
#include "scenarios/metric_names.h"

namespace hallux::scenarios {
namespace {

std::string points_text(std::int64_t milli) {
  return text_of_number(static_cast<double>(milli) / 1000.0);
}

/// What a part is about: where it stands in the file, and what it says.
struct Subject {
  std::string_view list;
  std::size_t index;
  std::string_view cut, hinge, zone = {}, fragment = {}, implant = {};
};

/// The key under which a part of that metric names what it is about; empty: it names nothing.
std::string_view wanted_key(const Subject& part, MetricSubject wanted) {
  switch (wanted) {
    case MetricSubject::Attempt:
      return "";
    case MetricSubject::Zone:
      return "zone";
    case MetricSubject::OneFragment:
      return "fragment";
    case MetricSubject::OneImplant:
      return "implant";
    case MetricSubject::Hinge:
    case MetricSubject::Closing:
      return "hinge";
    case MetricSubject::ClosingOrFragment:
      return part.fragment.empty() ? "hinge" : "fragment";
    case MetricSubject::CutOrImplant:
      return part.implant.empty() ? "cut" : "implant";
    case MetricSubject::CutOrHinge:
    case MetricSubject::Piece:
      return part.hinge.empty() ? "cut" : "hinge";
    default:
      return "cut";
  }
}

void refuse_others(const Subject& part, std::string_view wanted, std::string_view file) {
  for (const auto& [key, named] :
       {std::pair{"cut", part.cut}, std::pair{"hinge", part.hinge}, std::pair{"zone", part.zone},
        std::pair{"fragment", part.fragment}, std::pair{"implant", part.implant}}) {
    if (key != wanted) refuse_named(named, key, path_of(part.list, part.index, key), file);
  }
}

void check_lies_across(const Scenario& scenario, const Subject& part, std::string_view file) {
  for (const ReferenceCut& cut : scenario.cuts) {
    if (cut.name != part.cut || !lies_along_bone(cut)) continue;
    refuse(file, path_of(part.list, part.index, "cut"), is_text(part.cut),
           "name a cut across the bone, or another metric");
  }
}

/// An implant, or the alternatives of which one sets some.
void check_implant(const Scenario& scenario, std::string_view named, const std::string& path,
                   std::string_view file) {
  const bool is_group =
      !named.empty() && std::ranges::any_of(scenario.steps, [&](const OperationStep& step) {
        return step.one_of == named && !step.implants.empty();
      });
  if (!is_group) check_named(scenario.implants, named, "implant", path, file);
}

/// What the part is about is named, and nothing else. Without a zone it is about all of them.
void check_subject(const Scenario& scenario, const Subject& part, MetricSubject wanted,
                   std::string_view file) {
  const std::string_view key = wanted_key(part, wanted);
  refuse_others(part, key, file);
  const std::string path = path_of(part.list, part.index, key);
  if (key == "cut") check_named(scenario.cuts, part.cut, "cut", path, file);
  if (key == "hinge") check_named(scenario.hinges, part.hinge, "hinge", path, file);
  if (key == "fragment") check_named(scenario.fragments, part.fragment, "fragment", path, file);
  if (key == "implant") check_implant(scenario, part.implant, path, file);
  if (key == "zone" && !part.zone.empty())
    check_named(scenario.danger_zones, part.zone, "danger zone", path, file);
  if (wanted == MetricSubject::CutAcross) check_lies_across(scenario, part, file);
}

void check_step_subject(const Scenario& scenario, std::size_t index, std::string_view file) {
  const OperationStep& step = scenario.steps[index];
  const Subject subject{"steps", index, step.cut, step.hinge};
  switch (step.kind) {
    case StepKind::Cut:
      return check_subject(scenario, subject, MetricSubject::Cut, file);
    case StepKind::Close:
      return check_subject(scenario, subject, MetricSubject::Hinge, file);
    case StepKind::Remove:
      return check_subject(scenario, subject, MetricSubject::CutOrHinge, file);
    default:
      refuse_named(step.cut, "cut", path_of("steps", index, "cut"), file);
      refuse_named(step.hinge, "hinge", path_of("steps", index, "hinge"), file);
  }
}

void check_ends(const Scenario& scenario, std::string_view file) {
  const std::size_t last = scenario.steps.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const StepKind kind = scenario.steps[i].kind;
    if ((kind == StepKind::Verify) == (i == 0) && (kind == StepKind::Finish) == (i == last)) {
      continue;
    }
    refuse(file, path_of("steps", i, "kind"), "is out of order",
           "begin with the one \"verify\" and end with the one \"finish\"");
  }
}

/// What the steps before this one have done, by the names of cuts and hinges.
struct StepsDone {
  std::set<std::string_view> sawn, removed, closed;
};

void check_remove(const Scenario& scenario, const OperationStep& step, const std::string& path,
                  StepsDone& done, std::string_view file) {
  bool is_there = done.sawn.contains(step.cut);
  for (const ReferenceHinge& hinge : scenario.hinges) {
    if (hinge.name != step.hinge) continue;
    is_there = done.sawn.contains(hinge.first_cut) && done.sawn.contains(hinge.second_cut);
  }
  const std::string& subject = step.hinge.empty() ? step.cut : step.hinge;
  if (is_there && done.removed.insert(subject).second) return;
  refuse(file, path, is_text(subject) + ", whose piece is not there to be removed",
         "remove once, after the cut");
}

void check_steps(const Scenario& scenario, std::string_view file) {
  check_ends(scenario, file);
  StepsDone done;
  for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
    const OperationStep& step = scenario.steps[i];
    check_step_subject(scenario, i, file);
    const std::string path = path_of("steps", i, step.hinge.empty() ? "cut" : "hinge");
    if (step.kind == StepKind::Cut && !done.sawn.insert(step.cut).second) {
      refuse(file, path, is_text(step.cut) + ", which was cut before", "cut each face once");
    }
    if (step.kind == StepKind::Remove) check_remove(scenario, step, path, done, file);
    if (step.kind != StepKind::Close) continue;
    if (!done.removed.contains(step.hinge) || !done.closed.insert(step.hinge).second) {
      refuse(file, path, is_text(step.hinge) + ", whose wedge is not out",
             "close once, after its wedge was removed");
    }
  }
  for (std::size_t i = 0; i < scenario.cuts.size(); ++i) {
    if (done.sawn.contains(scenario.cuts[i].name)) continue;
    refuse(file, path_of("cuts", i, "name"),
           is_text(scenario.cuts[i].name) + ", which no step cuts",
           "add a step of kind \"cut\" for it");
  }
}

std::string_view opposite_of(std::string_view side) {
  return side == "lateral" ? "medial" : "lateral";
}

void check_hinge_cuts(const Scenario& scenario, std::size_t index, std::string_view file) {
  const ReferenceHinge& hinge = scenario.hinges[index];
  const std::string first_path = path_of("hinges", index, "first_cut");
  const std::string second_path = path_of("hinges", index, "second_cut");
  check_named(scenario.cuts, hinge.first_cut, "cut", first_path, file);
  check_named(scenario.cuts, hinge.second_cut, "cut", second_path, file);
  for (const ReferenceCut& cut : scenario.cuts) {
    if (cut.name == hinge.first_cut && cut.face.kind != FaceKind::Transverse) {
      refuse(file, first_path, is_text(cut.name) + ", which does not lie across the bone",
             "name a cut whose face is \"transverse\"");
    }
    const bool is_through =
        cut.face.kind == FaceKind::ThroughHinge && cut.face.through == hinge.name;
    if (cut.name == hinge.second_cut && !is_through) {
      refuse(file, second_path, is_text(cut.name) + ", which does not run through this hinge",
             "name the cut whose face is \"through_hinge\" " + hinge.name);
    }
  }
}

/// The two faces keep the bone on their outer sides, and the blade comes from where the gap is
/// open.
void check_hinge_sides(const Scenario& scenario, std::size_t index, std::string_view file) {
  const ReferenceHinge& hinge = scenario.hinges[index];
  for (std::size_t i = 0; i < scenario.cuts.size(); ++i) {
    const ReferenceCut& cut = scenario.cuts[i];
    if (cut.name != hinge.first_cut && cut.name != hinge.second_cut) continue;
    const std::string_view waste = cut.name == hinge.first_cut ? "distal" : "proximal";
    if (cut.waste_side != waste) {
      refuse(file, path_of("cuts", i, "waste_side"), is_text(cut.waste_side),
             "give \"" + std::string(waste) +
                 "\": the waste is the wedge between the two cuts of \"" + hinge.name + "\"");
    }
    if (cut.approach != opposite_of(hinge.side)) {
      refuse(file, path_of("cuts", i, "approach"), is_text(cut.approach),
             "give \"" + std::string(opposite_of(hinge.side)) + "\": the hinge \"" + hinge.name +
                 "\" stays on the other side");
    }
  }
}

void check_hinges(const Scenario& scenario, std::string_view file) {
  for (std::size_t i = 0; i < scenario.hinges.size(); ++i) {
    check_hinge_cuts(scenario, i, file);
    check_hinge_sides(scenario, i, file);
  }
  for (std::size_t i = 0; i < scenario.cuts.size(); ++i) {
    const ReferenceCut& cut = scenario.cuts[i];
    if (cut.face.kind != FaceKind::ThroughHinge) continue;
    const std::string path = path_of("cuts", i, "face.through");
    check_named(scenario.hinges, cut.face.through, "hinge", path, file);
    for (const ReferenceHinge& hinge : scenario.hinges) {
      if (hinge.name != cut.face.through || hinge.second_cut == cut.name) continue;
      refuse(file, path, is_text(cut.face.through) + ", whose second cut is another",
             "name the hinge of this cut");
    }
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
    if (!has_items && group.not_measured_milli == 0) continue;
    if (!has_items) {
      refuse(file, path_of("rubric.groups", i, "not_measured"), "is there but no items are",
             "remove it: a group without items is not measured");
    }
    if (items_milli + group.not_measured_milli == group.weight_milli) continue;
    refuse(file, path_of("rubric.groups", i, "weight"),
           "is " + points_text(group.weight_milli) + " but its items add up to " +
               points_text(items_milli) +
               (group.not_measured_milli == 0
                    ? ""
                    : " with " + points_text(group.not_measured_milli) + " not measured"),
           "make them equal");
  }
}

/// What is to be out is removed by a step, what is to be closed closed by one.
void check_deed(const Scenario& scenario, const Subject& part, MetricSubject wanted,
                std::string_view file) {
  const bool is_closing = wanted == MetricSubject::Closing ||
                          (wanted == MetricSubject::ClosingOrFragment && part.fragment.empty());
  if (wanted != MetricSubject::Piece && !is_closing) return;
  const StepKind kind = is_closing ? StepKind::Close : StepKind::Remove;
  for (const OperationStep& step : scenario.steps) {
    if (step.kind == kind && step.cut == part.cut && step.hinge == part.hinge) return;
  }
  const std::string_view key = part.hinge.empty() ? "cut" : "hinge";
  refuse(file, path_of(part.list, part.index, key),
         is_text(part.hinge.empty() ? part.cut : part.hinge) + ", which no step " +
             (kind == StepKind::Remove ? "removes" : "closes"),
         "add that step, or remove this");
}

void check_rubric(const Scenario& scenario, std::string_view file) {
  const Rubric& rubric = scenario.rubric;
  for (std::size_t i = 0; i < rubric.items.size(); ++i) {
    const RubricItem& item = rubric.items[i];
    if (!has_name(rubric.groups, item.group)) {
      refuse(file, path_of("rubric.items", i, "group"), is_text(item.group) + ", which is no group",
             "name one of rubric.groups");
    }
    const Subject subject{"rubric.items", i,           item.cut, item.hinge, item.zone,
                          item.fragment,  item.implant};
    check_subject(scenario, subject, find_metric(item.metric)->subject, file);
    check_deed(scenario, subject, find_metric(item.metric)->subject, file);
  }
  for (std::size_t i = 0; i < rubric.gates.size(); ++i) {
    const Gate& gate = rubric.gates[i];
    const Subject subject{"rubric.gates", i,           gate.cut, gate.hinge, gate.zone,
                          gate.fragment,  gate.implant};
    check_subject(scenario, subject, find_metric(gate.metric)->subject, file);
    check_deed(scenario, subject, find_metric(gate.metric)->subject, file);
  }
  check_group_weights(rubric, file);
}

/// What a fault must cost is in the rubric, and it costs something.
void check_proof(const Scenario& scenario, std::string_view file) {
  for (std::size_t i = 0; i < scenario.proof.size(); ++i) {
    const ProofFault& proof = scenario.proof[i];
    for (const std::string& id : proof.items) {
      const bool is_known = std::ranges::any_of(
          scenario.rubric.items, [&](const RubricItem& item) { return item.id == id; });
      if (!is_known)
        refuse(file, path_of("proof", i, "items"), is_text(id) + ", which is no item",
               "name ids of rubric.items");
    }
    for (const std::string& name : proof.gates)
      check_named(scenario.rubric.gates, name, "gate", path_of("proof", i, "gates"), file);
    if (proof.items.empty() && proof.gates.empty())
      refuse(file, path_of("proof", i, "items"), "is empty", "say what the fault must cost");
  }
}

}  // namespace

void check_references(const Scenario& scenario, std::string_view file) {
  check_names(scenario.sources, &SourceNote::key, "sources", "key", file);
  check_names(scenario.cuts, &ReferenceCut::name, "cuts", "name", file);
  check_names(scenario.hinges, &ReferenceHinge::name, "hinges", "name", file);
  check_names(scenario.danger_zones, &DangerZone::name, "danger_zones", "name", file);
  check_names(scenario.joint_surfaces, &JointSurface::name, "joint_surfaces", "name", file);
  check_names(scenario.rubric.groups, &RubricGroup::name, "rubric.groups", "name", file);
  check_names(scenario.rubric.items, &RubricItem::id, "rubric.items", "id", file);
  check_names(scenario.rubric.gates, &Gate::name, "rubric.gates", "name", file);
  if (scenario.format == 1) {
    check_hinges(scenario, file);
    check_steps(scenario, file);
  } else {
    check_operation(scenario, file);
  }
  check_rubric(scenario, file);
  check_proof(scenario, file);
}

}  // namespace hallux::scenarios
