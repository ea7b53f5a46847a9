#include "tests/assessment/any_card.h"

#include <rapidcheck.h>

namespace hallux::assessment {

scenarios::RubricItem item(const std::string& id, const std::string& group,
                           std::int64_t weight_milli) {
  scenarios::RubricItem made;
  made.id = id;
  made.group = group;
  made.metric = id + "_mm";
  made.cut = "cut";
  made.unit = "mm";
  made.weight_milli = weight_milli;
  made.zero = 1.0;
  return made;
}

scenarios::Gate gate(const std::string& metric, double limit, std::int64_t cap_milli) {
  scenarios::Gate made;
  made.name = "gate " + metric;
  made.metric = metric;
  made.cut = "cut";
  made.limit = limit;
  made.cap_milli = cap_milli;
  return made;
}

Measurement measured(const std::string& metric, double value) {
  Measurement made;
  made.metric = metric;
  made.cut = "cut";
  made.value = value;
  return made;
}

namespace {

double any_value() { return static_cast<double>(*rc::gen::inRange(0, 1500)) / 1000.0; }

}  // namespace

database::ScoreCard any_card() {
  scenarios::Rubric rubric;
  std::vector<Measurement> measurements;
  for (const std::string group : {"accuracy", "safety", "efficiency"}) {
    rubric.groups.push_back({group, group, *rc::gen::inRange(0, 50000), ""});
    for (int count = *rc::gen::inRange(0, 4); count > 0; --count) {
      const std::string id = group + std::to_string(count);
      rubric.items.push_back(item(id, group, *rc::gen::inRange(0, 20000)));
      if (*rc::gen::inRange(0, 4) == 0) continue;
      measurements.push_back(measured(id + "_mm", any_value()));
      measurements.back().done_fraction = *rc::gen::inRange(0, 2) == 0 ? 1.0 : any_value() / 1.5;
      if (*rc::gen::inRange(0, 4) == 0) {
        measurements.back().absence =
            *rc::gen::element(Absence::NotMade, Absence::NotDone, Absence::Undefined);
      }
    }
  }
  for (int count = *rc::gen::inRange(0, 3); count > 0; --count) {
    const std::string metric = "gate" + std::to_string(count);
    rubric.gates.push_back(gate(metric, any_value(), *rc::gen::inRange(0, 100001)));
    measurements.push_back(measured(metric, any_value()));
  }
  return score_rubric(rubric, measurements);
}

}  // namespace hallux::assessment
