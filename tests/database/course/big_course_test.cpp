/// What is asked in another way where there is much of it says the same as where there is little.
#include "tests/database/big_course.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "database/course/standings.h"
#include "database/desks/session.h"
#include "database/maintenance/backup.h"
#include "database/maintenance/verify.h"
#include "tests/database/whole_course.h"

namespace hallux::database {

namespace {

constexpr const char* password = "a long enough phrase";

class ManyAttempts : public testing::Test {
 protected:
  ManyAttempts() : database_(Database::open(temporary_.data())) {
    make_big_course(database_, {60, 100}, password);
  }
  Session sign_in_as(const std::string& login) {
    return sign_in(database_, login, secret(password), cheap);
  }

  TemporaryDirectory temporary_;
  Database database_;
};

TEST_F(ManyAttempts, AreListedFromTheNewestOn) {
  Session kim = sign_in_as("kim");
  InstructorDesk desk = *kim.instructor_of({1});
  const auto all = desk.attempts();
  ASSERT_EQ(all.size(), 6000U);
  for (const std::int32_t count : {1, 6, 500}) {
    const auto newest = desk.newest_attempts(count);
    ASSERT_EQ(newest.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(std::equal(newest.begin(), newest.end(), all.begin(),
                           [](const auto& a, const auto& b) { return a.id == b.id; }));
    const auto listed = kim.attempts(count);
    ASSERT_EQ(listed.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(std::equal(listed.begin(), listed.end(), newest.begin(),
                           [](const auto& a, const auto& b) { return a.id == b.id; }));
  }
  Session lee = sign_in_as("lee");
  EXPECT_TRUE(lee.instructor_of({2})->newest_attempts(6).empty());
}

TEST_F(ManyAttempts, StandAsTheyAreCounted) {
  EXPECT_NO_THROW(check_standings(database_));
  Session kim = sign_in_as("kim");
  const auto trainees = kim.instructor_of({1})->trainees();
  ASSERT_EQ(trainees.size(), 60U);
  std::int32_t attempts = 0, open = 0;
  std::size_t runs = 0;
  for (const TraineeStanding& trainee : trainees) {
    open += trainee.open_help_requests;
    for (const OperationStanding& operation : trainee.operations) {
      attempts += operation.attempts;
      for (const DeviceRuns& device : operation.by_device) runs += device.runs.size();
    }
  }
  EXPECT_EQ(attempts, 6000);
  EXPECT_EQ(runs, 3000U);
  EXPECT_EQ(open, 60);
}

TEST_F(ManyAttempts, LeaveAnInboxWithTheOpenOnesAndTheNewestAnswered) {
  Session kim = sign_in_as("kim");
  InstructorDesk desk = *kim.instructor_of({1});
  EXPECT_EQ(desk.help_requests(true).size(), 60U);
  const auto inbox = desk.help_requests();
  ASSERT_EQ(inbox.size(), 500U);
  EXPECT_FALSE(inbox[59].answer);
  EXPECT_TRUE(inbox[60].answer);
  EXPECT_GT(inbox[60].id.number, inbox[499].id.number);
}

TEST_F(ManyAttempts, AreCountedInPagesOfTheAudit) {
  Session root = sign_in_as("root");
  AdministratorDesk desk = *root.administrator();
  AuditRequest request;
  request.lines = 10;
  const AuditPage page = desk.audit_page(request);
  ASSERT_EQ(page.lines.size(), 10U);
  EXPECT_EQ(page.total, page.lines.front().number);
  request.refused_only = true;
  request.before = page.lines.back().number;
  const AuditPage refused = desk.audit_page(request);
  EXPECT_EQ(refused.total, 3 * 6000 / 50);
  for (const AuditLine& line : refused.lines) EXPECT_LT(line.number, *request.before);
}

/// What a table of speeds goes through is what the program makes.
TEST(WholeCourse, IsFoundWhole) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  make_whole_course(database, {7, 20, 1200}, password);
  const Verification found = verify(database);
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
  EXPECT_EQ(found.attempts, 20);
  EXPECT_EQ(found.scores, 20);
  EXPECT_EQ(back_up(database, temporary.data() / "backups").recordings, 20);
}

}  // namespace

}  // namespace hallux::database
