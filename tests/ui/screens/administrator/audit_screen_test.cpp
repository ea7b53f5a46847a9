// Records, as an administrator uses them: the audit log, backups, retention.
#include "ui/screens/administrator/audit_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "database/audit/audit.h"
#include "database/exchange/origins.h"
#include "database/recording/erased_recordings.h"
#include "tests/support/time_zone.h"
#include "tests/ui/screens/administrator/some_desk.h"
#include "ui/screens/administrator/audit_text.h"

namespace hallux::ui {
namespace {

using testing::Contains;
using testing::IsEmpty;

TEST(AuditScreen, SaysWhatWasDoneInWords) {
  database::SomeCourse course;
  Desk<AuditScreen> desk(course);
  for (const char* words :
       {"Signed in", "Published a scenario", "silver version 1", "Refused only"})
    EXPECT_TRUE(desk.driver().sees(words)) << words;
  EXPECT_THAT(desk.driver().faults(), IsEmpty());
}

TEST(AuditScreen, ShowsRefusalsAloneAndTheWholeOfALine) {
  database::SomeCourse course;
  try {
    course.instructor("kim", course.autumn()).attempts_of(course.id_of("eve"));
  } catch (const database::DatabaseError&) {  // refused, as it should be
  }
  const std::int64_t number = database::read_audit(course.database()).back().number;
  Desk<AuditScreen> desk(course);
  desk.press("records.filter.1");
  EXPECT_TRUE(desk.driver().sees("List attempts"));
  EXPECT_FALSE(desk.driver().sees("Signed in"));
  desk.press("records.row." + std::to_string(number));
  EXPECT_TRUE(desk.driver().sees("Entry " + std::to_string(number)));
}

TEST(AuditScreen, IsSearchedForAPersonAndCopied) {
  database::SomeCourse course;
  for (const char* login : {"ada", "bob"})
    database::append_audit(course.database(), {course.id_of(login), "note_written", "note", "1"});
  course.administrator().correct_name("ada", "Ada Čapek");
  Desk<AuditScreen> desk(course);
  desk.driver().press(Key::Slash);
  desk.type("čapek");  // capitals beyond a-z differ
  desk.driver().wait(0.5);
  desk.visitor.finish_work();
  EXPECT_TRUE(desk.driver().sees("No such entries"));
  desk.driver().press(Key::A, {.control = true});
  desk.type("ADA");
  desk.driver().wait(0.5);
  desk.visitor.finish_work();
  EXPECT_TRUE(desk.driver().sees("Wrote a note"));
  EXPECT_TRUE(desk.driver().sees("ada, called ada before"));
  EXPECT_FALSE(shows_word(desk.driver(), "bob"));
  desk.press("records.copy");
  desk.driver().frame();
  const std::string csv = desk.driver().clipboard().read();
  EXPECT_TRUE(csv.starts_with("entry,at_utc,by,code,did,outcome,to\n")) << csv;
  EXPECT_NE(csv.find(",ada,note_written,Wrote a note,done,Note 1\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",name_corrected,Corrected a name,done,\"ada, called ada before\"\n"),
            std::string::npos)
      << csv;
  EXPECT_EQ(csv.find("bob"), std::string::npos);
}

TEST(AuditScreen, TurnsPages) {
  database::SomeCourse course;
  for (int count = 0; count < 60; ++count)
    database::append_audit(course.database(),
                           {course.id_of("ada"), "signed_in", "session", "1", false, {}, ""});
  Desk<AuditScreen> desk(course);
  const auto all = static_cast<long>(database::read_audit(course.database()).size());
  EXPECT_TRUE(desk.driver().sees("1 to 50 of " + grouped(all)));
  expect_reason_by_keyboard(desk.driver(), "records.newer");
  desk.press("records.older");
  EXPECT_TRUE(desk.driver().sees("51 to " + grouped(std::min(all, 100L)) + " of"));
  press_by_keyboard(desk.visitor, "records.newer");
  EXPECT_TRUE(desk.driver().sees("1 to 50 of"));
}

TEST(AuditScreen, ABackupIsWrittenAndItsPlaceIsSaid) {
  database::SomeCourse course;
  Desk<AuditScreen> desk(course);
  EXPECT_TRUE(desk.driver().sees("There is no backup"));
  desk.driver().press(Key::Enter);  // the primary button
  desk.visitor.finish_work();
  desk.visitor.finish_work();
  EXPECT_TRUE(desk.driver().sees("The backup was written"));
  EXPECT_TRUE(desk.driver().sees("Last backup:"));
  EXPECT_TRUE(desk.driver().sees("Made a backup"));
  desk.press("records.backup.copy");
  const std::filesystem::path file = desk.driver().clipboard().read();
  EXPECT_EQ(file.parent_path(), course.database().directory() / "backups");
  EXPECT_TRUE(std::filesystem::is_regular_file(file));
}

TEST(AuditScreen, ABackupThatCannotBeWrittenSaysWhy) {
  database::SomeCourse course;
  std::ofstream(course.database().directory() / "backups") << "a file stands in its place";
  Desk<AuditScreen> desk(course);
  desk.press("records.backup");
  EXPECT_TRUE(desk.driver().sees("No backup was made"));
}

TEST(AuditScreen, WhatWouldGoIsListedBeforeItGoes) {
  const TimeZone zone("UTC0");
  database::SomeCourse course;
  course.database().pretend_it_is("2020-01-10T10:00:00.000Z");
  const database::AttemptId old = course.recorded_by("ada");
  course.database().pretend_it_is("");
  Desk<AuditScreen> desk(course);
  desk.press("records.retention");
  EXPECT_TRUE(desk.driver().sees("kept for ever unless"));
  desk.type("30");
  desk.press("records.retention.days.act");
  EXPECT_TRUE(desk.driver().sees("This would go now"));
  EXPECT_TRUE(desk.driver().sees("Practice: ada, 10 Jan 2020"));
  EXPECT_FALSE(database::erased_recording(course.database(), old));
  desk.press("records.retention.plan.act");
  EXPECT_TRUE(database::erased_recording(course.database(), old));
  desk.visitor.finish_work();  // the audit is read anew
  EXPECT_TRUE(desk.driver().sees("Let go of what need not be kept"));
  EXPECT_THAT(desk.driver().faults(), IsEmpty());
}

TEST(AuditScreen, AnOriginIsAcceptedAndNoLonger) {
  database::SomeCourse course;
  const database::DirectoryId elsewhere{std::string(32, 'e')};
  {
    Desk<AuditScreen> desk(course);
    EXPECT_FALSE(desk.driver().sees("Imported from elsewhere")) << "nothing was";
  }
  database::note_origin(course.database(), elsewhere);
  Desk<AuditScreen> desk(course);
  EXPECT_TRUE(desk.driver().sees("eeeeeeee: 0 attempts"));
  desk.press("records.origins.eeeeeeee");
  desk.visitor.finish_work();
  EXPECT_TRUE(course.administrator().origins().front().is_accepted);
  EXPECT_TRUE(desk.driver().sees("No longer accept"));
  desk.press("records.origins.eeeeeeee");
  desk.visitor.finish_work();
  EXPECT_FALSE(course.administrator().origins().front().is_accepted);
  EXPECT_THAT(desk.driver().faults(), IsEmpty());
}

TEST(AuditScreen, WhatIsKeptForEverIsSaidAndWhatIsNoNumberIsNotTaken) {
  database::SomeCourse course;
  course.recorded_by("ada");
  Desk<AuditScreen> desk(course);
  desk.press("records.retention");
  desk.type("soon");
  EXPECT_FALSE(desk.driver().widget("records.retention.days.act").is_enabled);
  for (int i = 0; i < 4; ++i) desk.driver().press(Key::Backspace);
  desk.press("records.retention.days.act");
  EXPECT_TRUE(desk.driver().sees("Nothing would go now"));
}

TEST(AuditScreen, NothingIsCutOffAnywhere) {
  database::SomeCourse course;
  const auto make = [&] { return std::make_unique<AuditScreen>(visit_of(course, "root")); };
  const auto choose_newest = [&](SomeVisitor& visitor) {
    const std::int64_t number = database::read_audit(course.database()).back().number;
    visitor.driver().click("records.row." + std::to_string(number));
  };
  EXPECT_THAT(faults_at_every_size(make), IsEmpty());
  EXPECT_THAT(faults_at_every_size(make, choose_newest), IsEmpty());
}

TEST(AuditScreen, ABackupsNameTellsItsMoment) {
  EXPECT_EQ(backup_moment("hallux-20260303-140210.db"), "2026-03-03T14:02");
  EXPECT_EQ(backup_moment("hallux-20260303-140210-2.db"), "2026-03-03T14:02");
  EXPECT_EQ(backup_moment("hallux.db"), "");
  EXPECT_EQ(bytes_text(12'345'678), "12.3 MB");
}

/// What the sources of the database write to the audit.
std::set<std::string> written_codes() {
  std::set<std::string> codes;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALLUX_SOURCE_DATABASE)) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    const std::string source((std::istreambuf_iterator<char>(stream)),
                             std::istreambuf_iterator<char>());
    for (const char* pattern :
         {R"re(\baudit\((?:[^;"]*\?)?\s*"([a-z_]+)"(?:\s*:\s*"([a-z_]+)")?)re",
          R"re(append_audit\([^;"]*\{[^;"]*,\s*"([a-z_]+)"\s*,\s*"[a-z_]+")re",
          R"re(action = [^;"]*\?\s*"([a-z_]+)"[^;"]*\?\s*"([a-z_]+)"[^;"]*:\s*"([a-z_]+)")re"}) {
      const std::regex wanted(pattern);
      for (std::sregex_iterator found(source.begin(), source.end(), wanted), end; found != end;
           ++found)
        for (std::size_t group = 1; group < found->size(); ++group)
          if ((*found)[group].matched) codes.insert((*found)[group].str());
    }
    const std::size_t names = source.find("action_names{");
    if (names == std::string::npos) continue;
    const std::string list = source.substr(names, source.find("};", names) - names);
    const std::regex quoted(R"re("([a-z_]+)")re");
    for (std::sregex_iterator found(list.begin(), list.end(), quoted), end; found != end; ++found)
      codes.insert((*found)[1].str());
  }
  codes.erase("result_");  // the beginning of three
  return codes;
}

TEST(AuditWords, EveryCodeThatIsWrittenHasWords) {
  const std::set<std::string> codes = written_codes();
  for (const char* known : {"signed_in", "person_disabled", "person_enabled", "scenario_retired",
                            "help_answered", "publish_scenario", "backup_made"})
    EXPECT_TRUE(codes.contains(known)) << known << ": the sources were not understood";
  const std::vector<std::string_view> deeds = known_deeds();
  for (const std::string& code : codes)
    EXPECT_THAT(deeds, Contains(std::string_view(code))) << code << " is shown as a code";
  const Texts texts = english_texts();
  for (const std::string_view deed : deeds) {
    database::AuditLine line;
    line.action = deed;
    EXPECT_EQ(deed_text(texts, line).find('_'), std::string::npos);
    EXPECT_NE(deed_text(texts, line), "[missing text]") << deed;
  }
}

TEST(AuditWords, SubjectsAreNamedWhereTheyCan) {
  const Texts texts = english_texts();
  database::AuditLine line;
  line.subject_kind = "attempt";
  line.subject_id = "81cd8c77-1111-4222-8333-444455556666";
  EXPECT_EQ(subject_text(texts, line), "Attempt 81cd8c77");
  line.text = "the guide slipped";
  EXPECT_EQ(subject_text(texts, line), "Attempt 81cd8c77: the guide slipped");
  line.subject = "trainee-2";
  line.text.clear();
  EXPECT_EQ(subject_text(texts, line), "trainee-2");
}

}  // namespace
}  // namespace hallux::ui
