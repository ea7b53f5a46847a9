#include "assessment/fixation/measure_implants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "assessment/make_measurement.h"
#include "scenarios/metric_names.h"
#include "scenarios/site/bone_words.h"
#include "scenarios/site/plan_in_first.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::OperationStep;
using scenarios::PlannedImplant;

constexpr std::array of_implants{Metric::EntryMm,      Metric::DirectionDeg,  Metric::TipToJointMm,
                                 Metric::ProtrusionMm, Metric::LengthErrorMm, Metric::Cortices,
                                 Metric::Insertions,   Metric::RightTool};

/// 0 within the range.
double outside_mm(double value_mm, const scenarios::Range& range) noexcept {
  return std::max({0.0, range.low_mm - value_mm, value_mm - range.high_mm});
}

std::vector<Measurement> measure_one(const PlacedImplant& placed, const PlannedImplant& planned) {
  const Moment left{placed.left_tick, placed.left_tick};
  const Vec3 &entry_mm = placed.entry_in_bone_mm, &tip_mm = placed.tip_in_bone_mm;
  const Vec3 way_mm = tip_mm - entry_mm;
  const double in_bone_mm = length_of(way_mm);
  const double off_rad = angle_between_rad(way_mm, planned.direction_in_bone);
  // Along the axis the bone decides where it begins.
  const auto aside = [&](const Vec3& way) {
    return way - glm::dot(way, planned.direction_in_bone) * planned.direction_in_bone;
  };
  const Vec3 entry_off_mm = aside(entry_mm - planned.entry_in_bone_mm);
  // What a diameter is off beyond what is recorded of it.
  constexpr double same_mm = 1.0e-6;
  const bool is_right = outside_mm(placed.diameter_mm, planned.diameters) < same_mm;
  std::vector<Measurement> made{
      measured(Metric::EntryMm, length_of(entry_off_mm), left, entry_mm),
      measured(Metric::DirectionDeg, degree_from_radian(off_rad), left, tip_mm),
      placed.tip_to_joint_mm ? measured(Metric::TipToJointMm, *placed.tip_to_joint_mm, left, tip_mm)
                             : absent(Metric::TipToJointMm, Absence::Undefined, tip_mm),
      measured(Metric::ProtrusionMm, placed.protrusion_mm, left, tip_mm),
      measured(Metric::LengthErrorMm, outside_mm(in_bone_mm, planned.lengths), left, tip_mm),
      measured(Metric::Cortices, placed.cortices, left, entry_mm),
      measured(Metric::Insertions, placed.insertions, left, entry_mm),
      measured(Metric::RightTool, is_right ? 1.0 : 0.0, left, entry_mm)};
  made[0].direction = scenarios::direction_text(entry_off_mm);
  made[1].direction = scenarios::direction_text(aside(way_mm));
  made[4].direction = in_bone_mm < planned.lengths.low_mm ? "short" : "long";
  return made;
}

std::vector<Measurement> all_absent(Absence why, const Vec3& place_mm) {
  std::vector<Measurement> made;
  made.reserve(of_implants.size());
  for (const Metric metric : of_implants) made.push_back(absent(metric, why, place_mm));
  return made;
}

/// The one that stands for it; null where none does, or it was to stay and was taken out.
const PlacedImplant* placed_for(std::size_t planned, const WhatIsLeft& left,
                                const scenarios::PlannedFixation& plan) {
  for (const std::vector<PlacedImplant>* list : {&left.fixation.implants, &left.fixation.taken}) {
    for (const PlacedImplant& placed : *list) {
      const bool counts = !placed.is_taken || plan.implants[planned].is_temporary;
      if (placed.planned == planned && counts) return &placed;
    }
  }
  return nullptr;
}

/// A step with alternatives, or the one that sets the implant.
struct Setting {
  const OperationStep* step = nullptr;
  /// How many of its implants are there.
  std::size_t set_count = 0;

  bool is_done() const { return set_count == step->implants.size(); }
};

class ImplantMetrics {
 public:
  ImplantMetrics(const WhatIsLeft& left, const Evidence& evidence)
      : left_(left), plan_(plan_in_first(evidence.plan, evidence.bones).fixation) {
    for (const OperationStep& step : evidence.scenario.steps) {
      if (step.implants.empty()) continue;
      Setting setting{&step, 0};
      for (const std::string& name : step.implants) setting.set_count += is_set(name) ? 1 : 0;
      settings_.push_back(setting);
    }
  }

  std::vector<Measurement> all() const {
    std::vector<Measurement> made;
    for (std::size_t i = 0; i < plan_.implants.size(); ++i)
      add(made, of_planned(i), plan_.implants[i].name);
    for (const Setting& setting : settings_) {
      const std::string& group = setting.step->one_of;
      if (!group.empty() && &setting == first_of(group)) add(made, of_group(group), group);
    }
    return made;
  }

 private:
  static void add(std::vector<Measurement>& all, std::vector<Measurement> made,
                  const std::string& name) {
    for (Measurement& each : made) {
      each.implant = name;
      all.push_back(std::move(each));
    }
  }

  std::size_t index_of(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(plan_.implants, name, &PlannedImplant::name) -
                                    plan_.implants.begin());
  }
  bool is_set(const std::string& name) const {
    return placed_for(index_of(name), left_, plan_) != nullptr;
  }

  const Setting* first_of(const std::string& group) const {
    const auto found = std::ranges::find_if(
        settings_, [&](const Setting& setting) { return setting.step->one_of == group; });
    return &*found;
  }

  /// The alternative that was carried out: of which most was set, of all of it before of some.
  const Setting& carried_out(const std::string& group) const {
    const Setting* best = first_of(group);
    for (const Setting& setting : settings_) {
      if (setting.step->one_of != group) continue;
      const bool is_better = setting.is_done() == best->is_done()
                                 ? setting.set_count > best->set_count
                                 : setting.is_done();
      if (is_better) best = &setting;
    }
    return *best;
  }

  /// It is set by a step in whose place another one was carried out.
  bool is_passed_over(const std::string& name) const {
    for (const Setting& setting : settings_) {
      const std::vector<std::string>& names = setting.step->implants;
      if (setting.step->one_of.empty() || std::ranges::find(names, name) == names.end()) continue;
      const Setting& done = carried_out(setting.step->one_of);
      if (done.step != setting.step && done.set_count > 0) return true;
    }
    return false;
  }

  std::vector<Measurement> of_planned(std::size_t index) const {
    const PlannedImplant& planned = plan_.implants[index];
    const PlacedImplant* const placed = placed_for(index, left_, plan_);
    if (placed != nullptr) return measure_one(*placed, planned);
    const Absence why = is_passed_over(planned.name) ? Absence::Undefined : Absence::NotDone;
    return all_absent(why, planned.entry_in_bone_mm);
  }

  /// Of each metric the worst of what the step sets; what is not set is the worst of all.
  std::vector<Measurement> of_group(const std::string& group) const {
    std::vector<Measurement> worst;
    for (const std::string& name : carried_out(group).step->implants) {
      const std::size_t index = index_of(name);
      const PlacedImplant* const placed = placed_for(index, left_, plan_);
      const PlannedImplant& planned = plan_.implants[index];
      std::vector<Measurement> made = placed == nullptr
                                          ? all_absent(Absence::NotDone, planned.entry_in_bone_mm)
                                          : measure_one(*placed, planned);
      if (worst.empty()) worst = made;
      for (std::size_t i = 0; i < made.size(); ++i) {
        if (is_worse(made[i], worst[i])) worst[i] = made[i];
      }
    }
    return worst;
  }

  static bool is_worse(const Measurement& one, const Measurement& other) {
    if (one.absence == Absence::NotDone || other.absence == Absence::NotDone)
      return other.absence != Absence::NotDone;
    if (!one.is_measured() || !other.is_measured()) return one.is_measured();
    const bool is_higher_better =
        scenarios::find_metric(one.metric)->sense == scenarios::MetricSense::Higher;
    return is_higher_better ? one.value < other.value : one.value > other.value;
  }

  const WhatIsLeft& left_;
  const scenarios::PlannedFixation plan_;
  std::vector<Setting> settings_;
};

}  // namespace

std::vector<Measurement> measure_implants(const WhatIsLeft& left, const Evidence& evidence) {
  return ImplantMetrics(left, evidence).all();
}

}  // namespace hallux::assessment
