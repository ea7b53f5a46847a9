#include "assessment/make_measurement.h"

#include "assessment/number_text.h"
#include "assessment/rebuild/bound.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

Measurement measured(scenarios::Metric metric, double value, const Moment& moment,
                     const Vec3& place_in_bone_mm) {
  Measurement made;
  made.metric = name_of(metric);
  made.value = rounded_to_micro(value);
  made.bound = scenarios::is_counted(*scenarios::find_metric(made.metric)) ? 0.0 : rounding_bound;
  made.start_us = time_us_from_tick(moment.first_tick);
  made.end_us = time_us_from_tick(moment.last_tick + 1);
  made.place_in_bone_mm = place_in_bone_mm;
  return made;
}

Measurement measured(scenarios::Metric metric, const Finding& finding,
                     const Vec3& place_in_bone_mm) {
  Measurement made =
      measured(metric, finding.value, {finding.first_tick, finding.last_tick}, place_in_bone_mm);
  made.bound += finding.bound;
  return made;
}

Measurement absent(scenarios::Metric metric, Absence why, const Vec3& place_in_bone_mm) {
  Measurement made;
  made.metric = name_of(metric);
  made.absence = why;
  made.place_in_bone_mm = place_in_bone_mm;
  return made;
}

}  // namespace hallux::assessment
