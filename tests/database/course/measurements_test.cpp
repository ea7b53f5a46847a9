#include "database/course/measurements.h"

#include <gtest/gtest.h>

#include <limits>

#include "database/course/begin_attempt.h"
#include "database/maintenance/verify.h"
#include "database/store/sql.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

class Measurements : public testing::Test {
 protected:
  std::optional<std::vector<Measurement>> kept(const MeasuredBy& by) {
    return load_measurements(database_, id_, by);
  }
  void store(std::span<const Measurement> measurements) {
    store_measurements(database_, id_, by_, measurements, std::nullopt);
  }
  std::int64_t sets() {
    return single<std::int64_t>(database_, "SELECT count(*) FROM measurement_set");
  }

  const TemporaryDirectory temporary_;
  Database database_ = Database::open(temporary_.data());
  const AttemptId id_ = record(database_, some_attempt(database_), some_recording(10));
  const MeasuredBy by_{Digest{{1}}, 3};
};

TEST_F(Measurements, ComeBackAsTheyWere) {
  const std::vector<Measurement> before = some_measurements();
  store(before);
  const auto after = kept(by_);
  ASSERT_TRUE(after);
  ASSERT_EQ(after->size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ((*after)[i].metric, before[i].metric);
  EXPECT_EQ(after->front().value, before.front().value);
  EXPECT_EQ(after->front().detail, before.front().detail);
  EXPECT_EQ(after->front().remark, before.front().remark);
  EXPECT_EQ(after->front().place_in_bone_mm, before.front().place_in_bone_mm);
  EXPECT_EQ((*after)[1].absence, Absence::NotMade);
  EXPECT_EQ((*after)[2].zone, "nerve");
  EXPECT_TRUE(verify(database_).is_whole());
}

TEST_F(Measurements, AreOfOnePlanAndOneVersion) {
  store(some_measurements());
  EXPECT_FALSE(kept({Digest{{2}}, by_.metrics_version}));
  EXPECT_FALSE(kept({by_.plan, by_.metrics_version + 1}));
}

TEST_F(Measurements, ThatAreThereAreNotStoredTwice) {
  store(some_measurements());
  store(some_measurements());
  EXPECT_EQ(sets(), 1);
}

TEST_F(Measurements, OfAnAttemptWithoutASealAreNotKept) {
  const AttemptId open = create_attempt(database_, some_attempt(database_)).attempt();
  store_measurements(database_, open, by_, some_measurements(), std::nullopt);
  EXPECT_EQ(sets(), 0);
  EXPECT_FALSE(load_measurements(database_, open, by_));
}

class AlteredMeasurements : public Measurements, public testing::WithParamInterface<const char*> {};

TEST_P(AlteredMeasurements, AreNotReadAndKeptAnewBesideThem) {
  store(some_measurements());
  tamper(database_, std::string("DROP TRIGGER measurement_is_never_altered; "
                                "DROP TRIGGER measurement_is_never_deleted; ") +
                        GetParam());
  EXPECT_FALSE(kept(by_));
  store(some_measurements());
  EXPECT_TRUE(kept(by_));
  EXPECT_EQ(sets(), 2);
}

INSTANTIATE_TEST_SUITE_P(ByRow, AlteredMeasurements,
                         testing::Values("UPDATE measurement SET value = 0.5 WHERE line = 0",
                                         "UPDATE measurement SET value = 0.5 WHERE line = 1",
                                         "UPDATE measurement SET absence = 'gone' WHERE line = 0",
                                         "UPDATE measurement SET remark = 'mine' WHERE line = 2",
                                         "UPDATE measurement SET detail_json = detail_json || ' ' "
                                         "WHERE line = 0",
                                         "UPDATE measurement SET detail_json = '{}' WHERE line = 1",
                                         "DELETE FROM measurement WHERE line = 2",
                                         "DROP TRIGGER measurement_set_is_never_altered; UPDATE "
                                         "measurement_set SET digest = zeroblob(32)"));

TEST_F(Measurements, ThatWereMovedToAnotherAttemptAreNotItsOwn) {
  store(some_measurements());
  const AttemptId other = record(database_, some_attempt(database_), some_recording(10));
  tamper(database_,
         "DROP TRIGGER measurement_set_is_never_altered; UPDATE measurement_set SET (attempt_id, "
         "seal) = (SELECT attempt_id, seal FROM attempt WHERE uuid = '" +
             other.text + "')");
  EXPECT_FALSE(load_measurements(database_, other, by_));
}

TEST_F(Measurements, WithAMinusZeroAreKeptAndWithNoNumberAreNot) {
  std::vector<Measurement> odd = some_measurements();
  odd[0].place_in_bone_mm.x = -0.0;
  odd[0].value = -0.0;
  store(odd);
  EXPECT_TRUE(kept(by_));
  EXPECT_TRUE(verify(database_).is_whole());
  odd[0].bound = std::numeric_limits<double>::quiet_NaN();
  store(odd);
  EXPECT_EQ(sets(), 1);
}

TEST_F(Measurements, AreOnlyAddedTo) {
  store(some_measurements());
  for (const char* sql :
       {"UPDATE measurement SET value = 0.5", "DELETE FROM measurement",
        "UPDATE measurement_set SET metrics_version = 9", "DELETE FROM measurement_set"})
    EXPECT_ANY_THROW(tamper(database_, sql)) << sql;
}

}  // namespace

}  // namespace hallux::database
