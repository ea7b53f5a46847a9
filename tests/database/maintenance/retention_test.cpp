#include "database/maintenance/retention.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"
#include "database/course/help_requests.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "database/store/settings.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const std::vector<RetentionPiece>& pieces) {
  std::vector<std::string> names;
  names.reserve(pieces.size());
  for (const RetentionPiece& piece : pieces) names.push_back(piece.name);
  return names;
}

/// In January a practice and an assessment of ada's; it is June now.
class OldCourse : public SomeCourse {
 public:
  OldCourse() {
    at("2026-01-10");
    practice_ = recorded_by("ada");
    NewAttempt assessment = attempt_of("ada");
    assessment.kind = AttemptKind::Assessment;
    assessment_ = record(database(), assessment, some_recording(5));
    store_score(database(), assessment_, card_worth(80'000), id_of("ada"));
    at("2026-06-01");
  }

  void at(const std::string& day) { database().pretend_it_is(day + "T10:00:00.000Z"); }
  std::vector<std::string> due() { return names_in(plan_retention(database())); }
  bool has_recording(const AttemptId& id) {
    try {
      return !load_recording(database(), id).tape.empty();
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::NotFound) << error.what();
      return false;
    }
  }

  const AttemptId& practice() const noexcept { return practice_; }
  const AttemptId& assessment() const noexcept { return assessment_; }

 private:
  AttemptId practice_, assessment_;
};

TEST(Retention, LetsNothingGoUnlessATimeWasSet) {
  OldCourse course;
  course.at("2099-01-01");
  EXPECT_EQ(load_retention(course.database()), RetentionRules{});
  EXPECT_TRUE(course.due().empty());
  EXPECT_EQ(apply_retention(course.database(), {}).recordings, 0);
  store_setting(course.database(), "retain_practice_days", "0");
  store_setting(course.database(), "retain_assessment_days", "many");
  EXPECT_EQ(load_retention(course.database()), RetentionRules{});
}

TEST(Retention, IsSetWithinItsBounds) {
  SomeCourse course;
  const RetentionRules rules{30, 365, {}, 7};
  store_retention(course.database(), rules);
  EXPECT_EQ(load_retention(course.database()), rules);
  EXPECT_EQ(kind_thrown([&] {
              store_retention(course.database(), {0, {}, {}, {}});
            }),
            DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_thrown([&] {
              store_retention(course.database(), {{}, 36'501, {}, {}});
            }),
            DatabaseErrorKind::BadInput);
  EXPECT_EQ(load_retention(course.database()), rules);
}

TEST(Retention, SaysExactlyWhatWouldGoAndThenLetsThatGo) {
  OldCourse course;
  store_retention(course.database(), {90, 365, {}, {}});
  const std::vector<RetentionPiece> plan = plan_retention(course.database());
  ASSERT_EQ(plan.size(), 1U);
  EXPECT_EQ(plan[0].name, course.practice().text);
  EXPECT_EQ(plan[0].login, "ada");
  EXPECT_EQ(plan[0].since_utc, "2026-01-10T10:00:00.000Z");
  EXPECT_GT(plan[0].bytes, 0);
  EXPECT_TRUE(course.has_recording(course.practice())) << "a plan takes nothing";
  const RetentionDone done = apply_retention(course.database(), course.id_of("root"));
  EXPECT_EQ(done.recordings, 1);
  EXPECT_EQ(done.bytes, plan[0].bytes);
  EXPECT_FALSE(course.has_recording(course.practice()));
  EXPECT_TRUE(course.has_recording(course.assessment()));
  EXPECT_EQ(course.last_audit().action, "retention_applied");
  EXPECT_TRUE(course.due().empty());
  const Verification found = verify(course.database());
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
}

TEST(Retention, CountsAnAssessmentFromItsLastDecision) {
  OldCourse course;
  store_retention(course.database(), {{}, 90, {}, {}});
  EXPECT_EQ(course.due(), std::vector{course.assessment().text});
  course.at("2026-05-20");
  course.instructor("kim", course.autumn())
      .decide({course.assessment(), DecisionKind::Confirmed, 0, "seen"});
  course.at("2026-06-01");
  EXPECT_TRUE(course.due().empty());
  course.at("2026-09-01");
  EXPECT_EQ(course.due(), std::vector{course.assessment().text});
}

TEST(Retention, KeepsWhatIsAskedAboutAndWhatIsBeingRecorded) {
  OldCourse course;
  store_retention(course.database(), {90, 90, {}, {}});
  const auto question =
      add_help_request(course.database(), {course.practice(), {}, "why?"}, course.id_of("ada"));
  EXPECT_EQ(course.due(), std::vector{course.assessment().text});
  answer_help_request(course.database(), question, "so", course.id_of("kim"));
  EXPECT_EQ(course.due().size(), 2U);
  course.at("2026-01-01");
  const WriterLease running = create_attempt(course.database(), course.attempt_of("bob"));
  course.at("2026-06-01");
  EXPECT_EQ(course.due().size(), 2U);
}

TEST(Retention, AsksOnceMoreBeforeEachPiece) {
  OldCourse course;
  store_retention(course.database(), {90, 90, {}, {}});
  // Somebody asks while the first piece goes.
  apply_retention(course.database(), {}, [&](double) {
    if (course.due().size() == 2) {
      add_help_request(course.database(), {course.practice(), {}, "why?"}, course.id_of("ada"));
      add_help_request(course.database(), {course.assessment(), {}, "why?"}, course.id_of("ada"));
    }
    return true;
  });
  EXPECT_TRUE(course.has_recording(course.practice()));
  EXPECT_TRUE(course.has_recording(course.assessment()));
}

TEST(Retention, ErasesAccountsThatWereClosedForLong) {
  OldCourse course;
  course.at("2026-02-01");
  course.administrator().set_disabled("bob", true);
  course.administrator().set_disabled("eve", true);
  course.at("2026-05-30");
  course.administrator().set_disabled("eve", false);
  course.administrator().set_disabled("eve", true);
  course.at("2026-06-01");
  store_retention(course.database(), {{}, {}, 60, {}});
  const PersonId bob = course.id_of("bob");
  EXPECT_EQ(course.due(), std::vector{std::to_string(bob.number)});
  EXPECT_EQ(apply_retention(course.database(), course.id_of("root")).accounts, 1);
  EXPECT_TRUE(is_erased(course.database(), bob));
  EXPECT_TRUE(known_person(course.database(), "eve"));
}

TEST(Retention, LetsOldCachedFilesGo) {
  SomeCourse course;
  const fs::path cache = course.database().directory() / "cache";
  fs::create_directories(cache);
  std::ofstream{cache / "old.fields"} << "12345";
  std::ofstream{cache / "new.fields"} << "1";
  fs::last_write_time(cache / "old.fields",
                      fs::file_time_type::clock::now() - std::chrono::hours{24 * 8});
  store_retention(course.database(), {{}, {}, {}, 7});
  const RetentionDone done = apply_retention(course.database(), {});
  EXPECT_EQ(done.cached, 1);
  EXPECT_EQ(done.bytes, 5);
  EXPECT_TRUE(fs::exists(cache / "new.fields"));
}

TEST(Retention, StoppedSaysWhatWentAndGoesOnLater) {
  OldCourse course;
  store_retention(course.database(), {90, 90, {}, {}});
  int asked = 0;
  EXPECT_THROW(apply_retention(course.database(), {}, [&](double) { return ++asked < 2; }),
               Cancelled);
  EXPECT_EQ(course.due().size(), 1U);
  EXPECT_EQ(course.last_audit().action, "retention_applied");
  EXPECT_EQ(apply_retention(course.database(), {}).recordings, 1);
}

}  // namespace

}  // namespace hallux::database
