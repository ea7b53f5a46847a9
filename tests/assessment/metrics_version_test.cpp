/// What two recordings measure, beside what they measured when the version of the metrics was
/// raised last.
#include "assessment/metrics_version.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {

namespace {

using testing::examined;
using testing::ExaminedAttempt;

/// Values are rounded to it; another machine's last bit may round the other way.
constexpr double slack = 2.0e-6;

struct ListedValue {
  std::string subject;
  double value = 0.0;
};

/// "angle_deg/first//" and its value; what is absent is told by its reason.
std::vector<ListedValue> values_of(const ExaminedAttempt& attempt) {
  std::vector<ListedValue> values;
  for (const Measurement& each : attempt.examination.measurements) {
    const std::string absence(database::name_of(each.absence));
    values.push_back({each.metric + "/" + each.cut + "/" + each.hinge + "/" + each.zone +
                          (absence.empty() ? "" : "=" + absence),
                      each.value});
  }
  return values;
}

std::vector<ListedValue> measured_now() {
  std::vector<ListedValue> values = values_of(examined(
      testing::akin_with_deeds(), testing::AkinAttempt{6.9, -2.4, 3.1, 12.3, 1.4, 6.9, 6.9, 6.9}));
  const std::vector<ListedValue> block =
      values_of(examined(testing::block_scenario(), {testing::Stroke{}}));
  values.insert(values.end(), block.begin(), block.end());
  return values;
}

const std::string file = HALLUX_METRICS_OF_VERSION;

void write(const std::vector<ListedValue>& values) {
  std::ofstream out(file);
  out.precision(12);
  out << "version " << metrics_version << "\n";
  for (const ListedValue& each : values) out << each.subject << " " << each.value << "\n";
}

TEST(MetricsVersion, IsRaisedWhenARecordingMeasuresOtherwise) {
  const std::vector<ListedValue> now = measured_now();
  if (std::getenv("HALLUX_WRITE_METRICS") != nullptr) write(now);
  std::ifstream in(file);
  std::string word;
  std::int32_t version = 0;
  in >> word >> version;
  ASSERT_EQ(version, metrics_version)
      << "run this test with HALLUX_WRITE_METRICS=1 after raising the version";
  std::size_t listed = 0;
  for (ListedValue then; in >> then.subject >> then.value; ++listed) {
    ASSERT_LT(listed, now.size());
    EXPECT_EQ(then.subject, now[listed].subject);
    EXPECT_NEAR(then.value, now[listed].value, slack) << then.subject;
  }
  EXPECT_EQ(listed, now.size());
  EXPECT_FALSE(HasFailure())
      << "what is kept of attempts was measured otherwise: raise assessment/metrics_version.h";
}

}  // namespace

}  // namespace hallux::assessment
