/// What two whole performances measure, beside what they measured when the version of the metrics
/// was raised last: a novice's Silver that touches a zone, dry and with a restart, and an expert's
/// Akin with its wedge closed and a screw set.
#include "assessment/metrics_version.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "assessment/assess.h"
#include "scenarios/hands/hand_fault.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::assessment {

namespace {

/// Values are rounded to 1e-6; another machine's last bit may round the other way.
constexpr double slack = 2.0e-6;
constexpr double coarse_mm = 1.5;

struct Performance {
  const char *operation, *hand;
  std::vector<std::string> faults;
};

/// The names of a line, and its numbers beside them.
struct Listed {
  std::string names;
  std::vector<double> numbers;
};

std::string names_of(const Measurement& each) {
  std::string names = each.metric;
  for (const std::string& name : {each.cut, each.hinge, each.zone, each.fragment, each.implant,
                                  std::string(database::name_of(each.absence)), each.direction,
                                  std::string(database::name_of(each.detail.kind)),
                                  std::string(database::name_of(each.remark))})
    names += "/" + name;
  for (const std::string& word : each.detail.words) names += "/" + word;
  std::ranges::replace(names, ' ', '_');
  return names;
}

Listed listed(const Measurement& each) {
  const Vec3& place = each.place_in_bone_mm;
  Listed line{names_of(each),
              {each.value, each.done_fraction, each.bound, static_cast<double>(each.start_us),
               static_cast<double>(each.end_us), place.x, place.y, place.z}};
  line.numbers.insert(line.numbers.end(), each.detail.values.begin(), each.detail.values.end());
  return line;
}

std::vector<Measurement> measured(const Performance& performance) {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario(performance.operation);
  scenario.patient.edge_mm = coarse_mm;
  const simulator::Bone bone = make_patient_bones(scenario).front();
  const scenarios::Plan plan = plan_on(scenario, bone);
  scenarios::FeelingHand hand(
      scenario, bone, plan,
      with_faults(scenarios::hand_skill(performance.hand),
                  scenarios::parse_hand_faults(performance.faults, scenario)),
      7);
  const simulator::Recording recording = tests::run_hand(scenario, bone, plan, hand).recording;
  return assess_fully(scenario, bone, recording, "scripted").measurements;
}

std::vector<Measurement> measured_now() {
  std::vector<Measurement> all =
      measured({"silver", "novice", {"touch_zone:plantar_medial_nerve", "dry", "restarts=2"}});
  const std::vector<Measurement> akin = measured({"akin", "expert", {}});
  all.insert(all.end(), akin.begin(), akin.end());
  return all;
}

const std::string file = HALLUX_METRICS_OF_VERSION;

void write(const std::vector<Measurement>& all) {
  std::ofstream out(file);
  out.precision(12);
  out << "version " << metrics_version << "\n";
  for (const Measurement& each : all) {
    const Listed line = listed(each);
    out << line.names;
    for (const double number : line.numbers) out << " " << number;
    out << "\n";
  }
}

std::vector<Listed> kept_lines(std::istream& in) {
  std::vector<Listed> lines;
  for (std::string text; std::getline(in, text);) {
    std::istringstream words(text);
    Listed& line = lines.emplace_back();
    words >> line.names;
    for (double number = 0.0; words >> number;) line.numbers.push_back(number);
  }
  return lines;
}

/// The metrics that have a value other than 0 in any line.
std::set<std::string> told_by(const std::vector<Measurement>& all) {
  std::set<std::string> told;
  for (const Measurement& each : all)
    if (each.is_measured() && each.value != 0.0) told.insert(each.metric);
  return told;
}

TEST(MetricsVersion, IsRaisedWhenARecordingMeasuresOtherwise) {
  const std::vector<Measurement> now = measured_now();
  if (std::getenv("HALLUX_WRITE_METRICS") != nullptr) write(now);
  std::ifstream in(file);
  std::string word, rest;
  std::int32_t version = 0;
  in >> word >> version;
  std::getline(in, rest);
  ASSERT_EQ(version, metrics_version)
      << "run this test with HALLUX_WRITE_METRICS=1 after raising the version";
  const std::vector<Listed> then = kept_lines(in);
  ASSERT_EQ(then.size(), now.size());
  for (std::size_t i = 0; i < then.size(); ++i) {
    const Listed line = listed(now[i]);
    EXPECT_EQ(line.names, then[i].names);
    ASSERT_EQ(line.numbers.size(), then[i].numbers.size()) << line.names;
    for (std::size_t n = 0; n < line.numbers.size(); ++n)
      EXPECT_NEAR(line.numbers[n], then[i].numbers[n], slack * (1.0 + std::abs(line.numbers[n])))
          << line.names << ", number " << n;
  }
  EXPECT_FALSE(HasFailure())
      << "what is kept of attempts was measured otherwise: raise assessment/metrics_version.h";
  // A change that these performances do not show goes unseen.
  EXPECT_GE(told_by(now).size(), 45U);
}

}  // namespace

}  // namespace hallux::assessment
