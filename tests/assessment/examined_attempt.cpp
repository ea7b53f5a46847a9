#include "tests/assessment/examined_attempt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace hallux::assessment::testing {

const Measurement& ExaminedAttempt::found(const std::string& metric,
                                          const std::string& subject) const {
  const auto& all = examination.measurements;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& each) {
    const bool is_of_it = each.cut == subject || each.hinge == subject || each.zone == subject;
    const bool is_of_all = each.cut.empty() && each.hinge.empty() && each.zone.empty();
    return each.metric == metric && (subject.empty() ? is_of_all : is_of_it);
  });
  if (found == all.end()) throw std::runtime_error("nothing measures " + metric + " " + subject);
  return *found;
}

double ExaminedAttempt::value(const std::string& metric, const std::string& subject) const {
  const Measurement& measurement = found(metric, subject);
  EXPECT_TRUE(measurement.is_measured()) << metric << " " << reason_of(measurement.absence);
  return measurement.value;
}

ExaminedAttempt examined(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const simulator::Recording& recording) {
  return {scenario, bone, recording, assess_fully(scenario, bone, recording, "scripted")};
}

ExaminedAttempt examined(const scenarios::Scenario& scenario, const std::vector<Stroke>& strokes) {
  const simulator::Bone bone = block_bone();
  simulator::Recording recording;
  for (const Stroke& stroke : strokes) add_stroke(recording, bone, stroke);
  return examined(scenario, bone, recording);
}

ExaminedAttempt examined(const scenarios::Scenario& scenario, const AkinAttempt& attempt) {
  const simulator::Bone bone = oval_bone();
  return examined(scenario, bone, akin_recording(attempt, bone, scenario.saw.blade.kerf_mm));
}

scenarios::Scenario akin_with_deeds() {
  scenarios::Scenario scenario = akin_scenario();
  scenario.steps = {{scenarios::StepKind::Remove, "", "", "", "lateral"},
                    {scenarios::StepKind::Close, "", "", "", "lateral"}};
  return scenario;
}

}  // namespace hallux::assessment::testing
