#include "database/maintenance/erasures.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <iterator>

#include "database/audit/audit.h"
#include "database/content/cached_bytes.h"
#include "database/course/begin_attempt.h"
#include "database/course/help_requests.h"
#include "database/maintenance/verify.h"
#include "database/recording/erased_recordings.h"
#include "database/recording/recordings.h"
#include "database/store/own_directory.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"
#include "tests/support/faulty_vfs.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// In everything that somebody called "zelda" left behind, and nowhere else.
constexpr const char* canary = "zelda";

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The files below `directory` in which somebody who reads bytes finds the canary.
std::vector<std::string> files_with_canary(const fs::path& directory) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator{directory}) {
    if (entry.is_regular_file() && content_of(entry.path()).find(canary) != std::string::npos) {
      found.push_back(entry.path().filename().string());
    }
  }
  return found;
}

void expect_no_canary(Database& database) {
  for (const std::string& file : files_with_canary(database.directory())) {
    ADD_FAILURE() << "the name is still in " << file;
  }
}

/// A course with a trainee whose name is in every place that a name can get to.
class CourseWithZelda : public SomeCourse {
 public:
  CourseWithZelda() {
    AdministratorDesk desk = administrator();
    id_ = desk.add_person({canary, "Zelda zelda", false}, secret(good_password), cheap);
    desk.enrol(autumn(), canary, CohortRole::Trainee);
    attempt_ = scored_by(canary, 50'000);
    talk();
    EXPECT_THROW(sign_in(database(), canary, secret("wrong wrong wrong"), cheap), DatabaseError);
    EXPECT_THROW(trainee("ada").recording(attempt_), DatabaseError);
    instructor("kim", autumn()).decide({attempt_, DecisionKind::Overridden, 60'000, "zelda knows"});
    desk.reset(canary, cheap);
    store_cached(database().directory(), attempt_.text + ".fields", Digest{},
                 std::as_bytes(std::span{"of a hand", 9}));
  }

  PersonId id() const noexcept { return id_; }
  const AttemptId& attempt() const noexcept { return attempt_; }

 private:
  void talk() {
    const PersonId kim = id_of("kim");
    const NoteId note = add_note(database(), {attempt_, {}, false, "well done zelda"}, kim);
    add_note(database(), {attempt_, {}, true, "zelda seems tired"}, kim);
    add_reply(database(), note, "thanks, zelda", id_);
    const auto question = add_help_request(database(), {attempt_, {}, "why, asks zelda"}, id_);
    answer_help_request(database(), question, "because, zelda", kim);
    for (int i = 0; i < 40; ++i) {
      add_note(database(), {attempt_, {}, false, "zelda " + std::string(1800, 'x')}, kim);
    }
  }

  PersonId id_;
  AttemptId attempt_;
};

ErasureOrder order_for(const CourseWithZelda& course, bool with_recordings) {
  return {course.id(), with_recordings, "asked for it in writing"};
}

TEST(Erasure, LeavesTheNameInNoByteOfNoFile) {
  CourseWithZelda course;
  EXPECT_FALSE(files_with_canary(course.database().directory()).empty());
  const ErasedPieces erased =
      erase_person(course.database(), order_for(course, false), course.id_of("root"));
  EXPECT_GT(erased.texts, 40);
  EXPECT_TRUE(erased.is_log_cleared);
  expect_no_canary(course.database());
  const Verification found = verify(course.database());
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
}

TEST(Erasure, TakesTheNamesFromBeforeACorrectionToo) {
  CourseWithZelda course;
  AdministratorDesk desk = course.administrator();
  desk.add_person({"twin", "Zed zelda", false}, secret(good_password), cheap);
  desk.correct_name("twin", "Somebody");
  EXPECT_THROW(course.trainee("ada").recording({"zed zelda knows"}), DatabaseError);
  const PersonId twin = course.id_of("twin");
  EXPECT_THROW(
      erase_person(course.database(), {twin, true, "Zed zelda asked"}, course.id_of("root")),
      DatabaseError);
  erase_person(course.database(), {twin, true, "asked in writing"}, course.id_of("root"));
  erase_person(course.database(), order_for(course, true), course.id_of("root"));
  expect_no_canary(course.database());
}

TEST(Erasure, KeepsTheStatisticAndTheOthers) {
  CourseWithZelda course;
  const AttemptId other = course.scored_by("ada", 70'000);
  add_note(course.database(), {other, {}, false, "mind the hinge"}, course.id_of("kim"));
  erase_person(course.database(), order_for(course, false), course.id_of("root"));
  const AttemptHeader header = load_header(course.database(), course.attempt());
  EXPECT_EQ(header.begun.person, course.id());
  EXPECT_EQ(header.decided_milli, 60'000);
  EXPECT_EQ(header.login, "");
  EXPECT_EQ(load_recording(course.database(), header.id).tape.size(), 5U);
  EXPECT_EQ(course.instructor("kim", course.autumn()).trainees().size(), 4U);
  EXPECT_EQ(list_notes(course.database(), other, true).front().text, "mind the hinge");
}

TEST(Erasure, LetsNobodySignInAsThem) {
  CourseWithZelda course;
  TraineeDesk held = course.trainee("ada");
  Session session = course.sign_in_as("bob");
  erase_person(course.database(), {course.id_of("bob"), false, "asked"}, course.id_of("root"));
  EXPECT_FALSE(session.trainee());
  EXPECT_EQ(kind_thrown([&] { course.sign_in_as("bob"); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(kind_thrown([&] { course.administrator().set_disabled("bob", false); }),
            DatabaseErrorKind::NotFound);
  EXPECT_NO_THROW(held.attempts());
  // Somebody else may be called so later, and is somebody else.
  const PersonId next =
      course.administrator().add_person({"bob", "", false}, secret(good_password), cheap);
  EXPECT_TRUE(course.trainee("bob").attempts().empty());
  EXPECT_FALSE(is_erased(course.database(), next));
}

TEST(Erasure, TakesTheRecordingsWhereThatWasOrdered) {
  CourseWithZelda course;
  const ErasedPieces erased =
      erase_person(course.database(), order_for(course, true), course.id_of("root"));
  EXPECT_EQ(erased.recordings, 1);
  EXPECT_GT(erased.recording_bytes, 0);
  EXPECT_EQ(kind_thrown([&] { load_recording(course.database(), course.attempt()); }),
            DatabaseErrorKind::NotFound);
  EXPECT_FALSE(
      fs::exists(course.database().directory() / "cache" / (course.attempt().text + ".fields")));
  EXPECT_EQ(load_score(course.database(), course.attempt())->card.score_milli, 50'000);
  const Verification found = verify(course.database());
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
}

TEST(Erasure, OfARecordingStillHoldsTheSeal) {
  CourseWithZelda course;
  erase_recording(course.database(), course.attempt(), std::nullopt);
  EXPECT_EQ(erase_recording(course.database(), course.attempt(), std::nullopt), 0);
  EXPECT_TRUE(verify(course.database()).is_whole());
  tamper(course.database(),
         "UPDATE attempt SET duration_ticks = 4 WHERE uuid = '" + course.attempt().text + "'");
  const Verification found = verify(course.database());
  ASSERT_FALSE(found.is_whole());
  EXPECT_NE(found.first_damage->find(course.attempt().text), std::string::npos);
}

TEST(Erasure, OfARecordingWaitsUntilItHasEnded) {
  SomeCourse course;
  const WriterLease lease = create_attempt(course.database(), course.attempt_of("ada"));
  EXPECT_EQ(kind_thrown([&] { erase_recording(course.database(), lease.attempt(), {}); }),
            DatabaseErrorKind::Refused);
  EXPECT_EQ(kind_thrown([&] {
              erase_person(course.database(), {course.id_of("ada"), false, "asked"}, {});
            }),
            DatabaseErrorKind::Refused);
}

TEST(Erasure, RefusesTheLastAdministratorAReasonWithTheNameAndASecondTime) {
  CourseWithZelda course;
  Database& database = course.database();
  EXPECT_EQ(kind_thrown([&] {
              erase_person(database, {course.id(), false, "so Zelda wanted"}, {});
            }),
            DatabaseErrorKind::BadInput);
  erase_person(database, {course.id_of("max"), false, "left"}, course.id_of("root"));
  EXPECT_EQ(kind_thrown([&] {
              erase_person(database, {course.id_of("root"), false, "left"}, {});
            }),
            DatabaseErrorKind::Refused);
  erase_person(database, order_for(course, false), {});
  EXPECT_EQ(kind_thrown([&] { erase_person(database, order_for(course, false), {}); }),
            DatabaseErrorKind::Refused);
}

TEST(Erasure, AsksTheAdministratorForTheirPasswordOnceMore) {
  CourseWithZelda course;
  Session root = course.sign_in_as("root");
  AdministratorDesk desk = *root.administrator();
  const PasswordProof of_another = course.sign_in_as("max").prove(secret(good_password), cheap);
  EXPECT_EQ(kind_thrown([&] {
              desk.erase_person({canary, "asked"}, of_another);
            }),
            DatabaseErrorKind::Refused);
  EXPECT_FALSE(is_erased(course.database(), course.id()));
  desk.erase_person({canary, "asked"}, root.prove(secret(good_password), cheap));
  EXPECT_EQ(course.last_audit().action, "person_erased");
  EXPECT_EQ(course.last_audit().text, "asked");
  expect_no_canary(course.database());
}

TEST(Erasure, ShortLoginsDoNotTakeOtherTextsAway) {
  SomeCourse course;
  course.administrator().add_person({"ed", "", false}, secret(good_password), cheap);
  append_audit(course.database(), {{}, "signed_in", "login", "", true, {}, "edgar was edited"});
  append_audit(course.database(), {{}, "signed_in", "login", "", true, {}, "by ED, said"});
  erase_person(course.database(), {course.id_of("ed"), false, "asked"}, course.id_of("root"));
  std::vector<std::string> texts;
  for (const AuditRow& row : read_audit(course.database())) texts.push_back(row.entry.text);
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "edgar was edited"), 1);
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "by ED, said"), 0);
}

TEST(Erasure, ByAFullDiskIsWholeOrNotAtAll) {
  const TemporaryDirectory temporary;
  tests::FaultyVfs vfs{"full_while_erasing"};
  Database database = Database::open(temporary.data(), {Access::ReadWrite, 200, vfs.name()});
  create_person(database, {"root", "", true}, secret(good_password), cheap);
  const PersonId person =
      create_person(database, {canary, "", false}, secret(good_password), cheap);
  vfs.fail_after(1, SQLITE_FULL);
  EXPECT_EQ(kind_thrown([&] {
              erase_person(database, {person, true, "asked"}, {});
            }),
            DatabaseErrorKind::Full);
  vfs.heal();
  EXPECT_EQ(load_person(database, person).login, canary);
  erase_person(database, {person, true, "asked"}, {});
  expect_no_canary(database);
}

TEST(Erasure, StoppedBetweenTwoRecordingsGoesOnLater) {
  CourseWithZelda course;
  course.recorded_by("ada");
  int asked = 0;
  const ErasureOrder order = order_for(course, true);
  EXPECT_THROW(erase_person(course.database(), order, {}, [&](double) { return ++asked > 1; }),
               Cancelled);
  EXPECT_FALSE(is_erased(course.database(), course.id()));
  erase_person(course.database(), order, {});
  expect_no_canary(course.database());
}

TEST(ErasureJournal, IsWrittenBesideTheBackupsWithoutAName) {
  CourseWithZelda course;
  erase_person(course.database(), order_for(course, true), course.id_of("root"));
  const auto lines = read_journal(journal_in(course.database().directory() / "backups"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].person, course.id());
  EXPECT_EQ(lines[0].directory, own_directory(course.database()).text);
  EXPECT_TRUE(lines[0].with_recordings);
  EXPECT_TRUE(list_erasures(course.database()).front().with_recordings);
}

TEST(ErasureJournal, ErasesOnceMoreWhoCameBack) {
  CourseWithZelda course;
  const JournalLine line{own_directory(course.database()).text, course.id(), true, "2026-03-01"};
  const JournalLine foreign{std::string(32, 'f'), course.id_of("ada"), true, "2026-03-01"};
  const JournalLine later{line.directory, {4711}, true, "2026-03-01"};
  const std::array lines{foreign, line, line, later};
  EXPECT_EQ(apply_journal(course.database(), lines), 1);
  expect_no_canary(course.database());
  EXPECT_FALSE(is_erased(course.database(), course.id_of("ada")));
  EXPECT_EQ(apply_journal(course.database(), std::span{&foreign, 1}, true), 1);
  EXPECT_FALSE(known_person(course.database(), "ada"));
}

TEST(ErasureJournal, PassesOverALineCutByAPowerCutAndNamesADamagedOne) {
  const TemporaryDirectory temporary;
  const fs::path file = journal_in(temporary.data());
  const JournalLine first{std::string(32, 'a'), {1}, false, "2026-03-01"};
  const JournalLine second{std::string(32, 'a'), {2}, true, "2026-03-02"};
  add_to_journal(file, std::array{first, second});
  add_to_journal(file, std::array{second});
  EXPECT_EQ(read_journal(file), (std::vector{first, second}));
  fs::resize_file(file, fs::file_size(file) - 3);
  EXPECT_EQ(read_journal(file), std::vector{first});
  add_to_journal(file, std::array{second});
  EXPECT_EQ(read_journal(file), (std::vector{first, second}));
  std::string content = content_of(file);
  content[content.find("\"person\":1") + 9] = '3';
  std::ofstream{file, std::ios::binary} << content;
  EXPECT_EQ(kind_thrown([&] { read_journal(file); }), DatabaseErrorKind::Damaged);
}

TEST(ErasureJournal, FollowsNoLink) {
  const TemporaryDirectory temporary;
  fs::create_directories(temporary.data());
  std::ofstream{temporary.data() / "elsewhere"} << "not a journal\n";
  fs::create_symlink(temporary.data() / "elsewhere", journal_in(temporary.data()));
  EXPECT_EQ(kind_thrown([&] { read_journal(journal_in(temporary.data())); }),
            DatabaseErrorKind::BadInput);
}

}  // namespace

}  // namespace hallux::database
