/// What was on the screen, beside the recording: kept with it, gone with it, and wherever it goes.
#include "database/recording/display_facts.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <fstream>

#include "database/course/begin_attempt.h"
#include "database/exchange/view_table.h"
#include "database/maintenance/backup.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/recording_file.h"
#include "database/maintenance/restore.h"
#include "database/maintenance/verify.h"
#include "database/recording/erased_recordings.h"
#include "database/recording/recordings.h"
#include "tests/database/some_exchange.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;
using simulator::DisplayFact;

constexpr std::int64_t ticks = 1700;

/// Ada's, with a view that turns.
AttemptId seen_by_ada(SomeCourse& course) {
  return record(course.database(), course.attempt_of("ada"), some_recording(ticks),
                some_display_facts(ticks));
}

TEST(DisplayFacts, AreKeptAsTheyWereShown) {
  SomeCourse course;
  const AttemptId id = seen_by_ada(course);
  EXPECT_EQ(load_display_facts(course.database(), id), some_display_facts(ticks));
  EXPECT_EQ(course.trainee("ada").display_facts(id), some_display_facts(ticks));
  EXPECT_TRUE(load_display_facts(course.database(), course.recorded_by("bob")).empty());
}

TEST(DisplayFacts, ChangeNeitherChainNorSeal) {
  SomeCourse course;
  const AttemptId id = seen_by_ada(course);
  EXPECT_TRUE(is_same(load_recording(course.database(), id), some_recording(ticks)));
  tamper(course.database(), "DELETE FROM display_fact");
  const Verification found = verify(course.database());
  EXPECT_TRUE(found.is_whole()) << *found.first_damage;
}

TEST(DisplayFacts, ThatComeLateAreKeptWithTheNextWindow) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  simulator::AttemptChannels channels;
  Recorder recorder{database, create_attempt(database, some_attempt(database)), channels};
  produce(some_recording(600), channels);
  const auto facts = some_display_facts(600);
  // The window's thread is behind: of a tick long gone, and after the last one.
  channels.closed.store(false);
  for (const DisplayFact& fact : facts) ASSERT_TRUE(channels.display_facts.push(fact));
  channels.closed.store(true);
  EXPECT_EQ(recorder.finish("{}").display_facts, static_cast<std::int64_t>(facts.size()));
  EXPECT_EQ(load_display_facts(database, recorder.attempt()), facts);
}

TEST(DisplayFacts, GoWithTheRecording) {
  SomeCourse course;
  const AttemptId id = seen_by_ada(course);
  EXPECT_GT(erase_recording(course.database(), id, std::nullopt), 0);
  EXPECT_TRUE(load_display_facts(course.database(), id).empty());
}

TEST(DisplayFacts, GoWithThePersonWhereTheRecordingsDo) {
  SomeCourse course;
  const AttemptId id = seen_by_ada(course);
  erase_person(course.database(), {course.id_of("ada"), true, "asked for"}, std::nullopt);
  EXPECT_TRUE(load_display_facts(course.database(), id).empty());
}

TEST(DisplayFacts, AreExportedBesideTheRecordAndComeInAgain) {
  TwoDirectories two;
  const AttemptId id = seen_by_ada(two.course());
  const fs::path folder = two.exported(id);
  const auto as_it_left = bytes_below(folder);
  EXPECT_TRUE(as_it_left.at(view_table_name).starts_with("tick_ms,target_x_um,"));
  ASSERT_TRUE(two.import(folder));
  EXPECT_EQ(load_display_facts(two.there(), id), some_display_facts(ticks));
  const fs::path again = two.out() / "again";
  fs::create_directory(again);
  export_attempt(two.there(), id, again, some_derived);
  EXPECT_EQ(bytes_below(again / id.text), as_it_left);
}

TEST(DisplayFacts, OfAnExportWithoutThemAreNone) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("ada");
  const fs::path folder = two.exported(id);
  EXPECT_FALSE(bytes_below(folder).contains(view_table_name));
  ASSERT_TRUE(two.import(folder));
  EXPECT_TRUE(load_display_facts(two.there(), id).empty());
}

TEST(DisplayFacts, ThatAnotherToolWroteAreNotExported) {
  TwoDirectories two;
  const AttemptId id = seen_by_ada(two.course());
  tamper(two.course().database(),
         "PRAGMA ignore_check_constraints = ON; UPDATE display_fact SET magnification_milli = 0 "
         "WHERE tick = 100; UPDATE display_fact SET rotation_w_micro = 0, rotation_y_micro = 0 "
         "WHERE tick = 200");
  ASSERT_TRUE(two.import(two.exported(id)));
  EXPECT_EQ(load_display_facts(two.there(), id).size(), some_display_facts(ticks).size() - 2);
}

TEST(DisplayFacts, OfAnImportThatAreNoViewsAreRefusedByTheirLine) {
  TwoDirectories two;
  const AttemptId id = seen_by_ada(two.course());
  const fs::path folder = two.exported(id);
  const std::string header_end = "lost_before\r\n";
  for (const std::string& row : std::initializer_list<std::string>{
           "0,0,0,0,0,0,0,0,8000,6000,1600,0,0,0\r\n",         // no rotation: not a number
           "0,0,0,0,1000000,0,0,0,0,6000,1600,0,0,0\r\n",      // nothing magnified
           "0,0,0,0,1000000,0,0,0,8000,6000,0,0,0,0\r\n",      // no picture
           "-1,0,0,0,1000000,0,0,0,8000,6000,1600,0,0,0\r\n",  // before the beginning
           "0,9000000000000000000,0,0,1000000,0,0,0,8000,6000,1600,0,0,0\r\n",
           "0,0,0,0,1000000,0,0,0,8000,6000,1600,-1,0,0\r\n",  // a stereo mode of nobody
           "0,0,0,0,1000000,0,0,0,8e3,6000,1600,0,0,0\r\n", "0,0,0\r\n"}) {
    alter(folder, view_table_name, header_end, header_end + row);
    try {
      two.import(folder);
      ADD_FAILURE() << row;
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput);
      EXPECT_NE(std::string{error.what()}.find("views.csv, line 2"), std::string::npos)
          << error.what();
    }
    alter(folder, view_table_name, header_end + row, header_end);
  }
  EXPECT_TRUE(two.import(folder));
}

TEST(DisplayFacts, OfANewerProgramComeInAsTheyAre) {
  TwoDirectories two;
  const AttemptId id = seen_by_ada(two.course());
  const fs::path folder = two.exported(id);
  alter(folder, view_table_name, ",0,0,0\r\n", ",0,7,0\r\n");
  ASSERT_TRUE(two.import(folder));
  const auto facts = load_display_facts(two.there(), id);
  EXPECT_FALSE(is_known(facts.front()));
  EXPECT_TRUE(is_view(facts.front()));
}

TEST(DisplayFacts, LieInABackupBesideTheTablesAndComeBack) {
  SomeCourse course;
  const AttemptId id = seen_by_ada(course);
  const TemporaryDirectory place;
  fs::create_directories(place.data());
  const Backup backup = back_up(course.database(), place.data() / "kept");
  {
    SQLite::Database tables{fs::path{backup.file}.replace_extension(".tables").string()};
    EXPECT_EQ(tables.execAndGet("SELECT count(*) FROM display_fact").getInt(), 0);
  }
  restore({backup.file, place.data() / "again", {}});
  Database again = Database::open(place.data() / "again");
  EXPECT_EQ(load_display_facts(again, id), some_display_facts(ticks));
}

/// As a program wrote it that kept nothing of what was on the screen.
BackedUpRecording made_older(const fs::path& file, const AttemptId& id) {
  std::ifstream in{file, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{in}, {}};
  bytes.resize(bytes.size() - 32 - 8);  // without digest and the number of facts
  bytes.replace(0, 8, "HALLUXR1");
  const Digest digest = digest_of(std::as_bytes(std::span{bytes.data(), bytes.size()}));
  bytes.append(reinterpret_cast<const char*>(digest.bytes.data()), digest.bytes.size());
  std::ofstream{file, std::ios::binary} << bytes;
  return {id, static_cast<std::int64_t>(bytes.size()), digest};
}

TEST(DisplayFacts, AreMissingInABackupOfAnOlderProgramWithoutHarm) {
  SomeCourse course;
  Database& database = course.database();
  const AttemptId id = course.recorded_by("ada");
  const TemporaryDirectory place;
  fs::create_directories(place.data());
  back_up(database, place.data());
  const BackedUpRecording older = made_older(recording_file(place.data(), id), id);
  EXPECT_EQ(NewRecordingFiles{place.data()}.add(database, id), older) << "named, not written anew";
  tamper(database, "DELETE FROM chunk");
  put_recording_back(database, older, place.data());
  EXPECT_TRUE(is_same(load_recording(database, id), some_recording(5)));
}

}  // namespace

}  // namespace hallux::database
