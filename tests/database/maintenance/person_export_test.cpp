#include "database/maintenance/person_export.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "database/course/help_requests.h"
#include "database/maintenance/erasures.h"
#include "database/text/csv_text.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// What ada did, what others said about it, and what is none of hers.
class TalkativeCourse : public SomeCourse {
 public:
  TalkativeCourse() : SomeCourse(long_name), attempt_(scored_by("ada", 50'000)) {
    const AttemptId other = scored_by("bob", 40'000);
    const PersonId kim = id_of("kim");
    const NoteId note = add_note(database(), {attempt_, {}, false, "=look, \"here\""}, kim);
    add_note(database(), {attempt_, {}, true, "canary of instructors"}, kim);
    add_note(database(), {other, {}, false, "canary of bob"}, kim);
    add_reply(database(), note, "thanks", id_of("ada"));
    const auto question = add_help_request(database(), {attempt_, {}, "why?"}, id_of("ada"));
    answer_help_request(database(), question, "so", kim);
    trainee("ada").choose_hand({true, 1500, std::nullopt});
    trainee("bob").choose_hand({false, 700, 300});
    instructor("kim", autumn()).recording(attempt_);
    instructor("kim", autumn()).decide({attempt_, DecisionKind::Overridden, 60'000, "a hard bone"});
  }

  fs::path target() const { return place_.data() / "ada"; }
  nlohmann::json exported(const std::string& login) {
    export_person(database(), id_of(login), target());
    return nlohmann::json::parse(content_of(target() / "person.json"));
  }
  std::string all_bytes() const {
    std::string bytes;
    for (const auto& entry : fs::directory_iterator{target()}) bytes += content_of(entry.path());
    return bytes;
  }
  const AttemptId& attempt() const noexcept { return attempt_; }

 private:
  TemporaryDirectory place_;
  AttemptId attempt_;
};

TEST(PersonExport, HoldsAllThatIsKeptOfThem) {
  TalkativeCourse course;
  const nlohmann::json all = course.exported("ada");
  EXPECT_EQ(all["person"][0]["login"], "ada");
  EXPECT_EQ(all["cohorts"][0]["cohort"], "autumn");
  ASSERT_EQ(all["attempts"].size(), 1U);
  EXPECT_EQ(all["attempts"][0]["attempt"], course.attempt().text);
  EXPECT_GT(all["attempts"][0]["recording_bytes"], 0);
  EXPECT_EQ(all["scores"][0]["score_milli"], 50'000);
  EXPECT_EQ(all["decisions"][0]["reason"], "a hard bone");
  EXPECT_EQ(all["notes"][0]["text"], "=look, \"here\"");
  EXPECT_EQ(all["private_notes"][0]["notes"], 1);
  ASSERT_EQ(all["hand_settings"].size(), 1U);
  EXPECT_EQ(all["hand_settings"][0]["motion_scale_milli"], 1500);
  EXPECT_TRUE(all["hand_settings"][0]["force_share_milli"].is_null());
  EXPECT_EQ(all["replies"][0]["text"], "thanks");
  EXPECT_EQ(all["questions"][0]["answered_by"], "kim");
  const auto is_view = [](const nlohmann::json& line) {
    return line["action"] == "attempt_viewed" && line["by_whom"] == "kim";
  };
  EXPECT_EQ(std::count_if(all["log"].begin(), all["log"].end(), is_view), 1);
}

TEST(PersonExport, HoldsNothingOfOthersAndNoPassword) {
  TalkativeCourse course;
  course.exported("ada");
  const std::string bytes = course.all_bytes();
  EXPECT_EQ(bytes.find("canary"), std::string::npos);
  EXPECT_EQ(bytes.find("argon2id"), std::string::npos);
  EXPECT_EQ(bytes.find(long_name), std::string::npos);
}

TEST(PersonExport, ExplainsEveryFile) {
  TalkativeCourse course;
  course.exported("ada");
  const std::string explanation = content_of(course.target() / "explanation.txt");
  for (const auto& entry : fs::directory_iterator{course.target()}) {
    if (entry.path().extension() != ".csv") continue;
    EXPECT_NE(explanation.find(entry.path().filename().string()), std::string::npos);
    struct stat facts {};
    ASSERT_EQ(::stat(entry.path().c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0600U);
  }
}

TEST(PersonExport, RunsNoFormulaInASpreadsheet) {
  EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_cell("@x"), "'@x");
  EXPECT_EQ(csv_cell("-12", true), "-12");
  EXPECT_EQ(csv_cell("a \"b\", c"), "\"a \"\"b\"\", c\"");
  EXPECT_EQ(csv_cell("\tline\r\n"), "\"'\tline\r\n\"");
  TalkativeCourse course;
  course.exported("ada");
  EXPECT_NE(content_of(course.target() / "notes.csv").find("\"'=look, \"\"here\"\"\""),
            std::string::npos);
}

TEST(PersonExport, IsThereWholeOrNotAtAll) {
  TalkativeCourse course;
  const PersonId ada = course.id_of("ada");
  EXPECT_THROW(export_person(course.database(), ada, course.target(),
                             [](double part) { return part < 0.5; }),
               Cancelled);
  EXPECT_TRUE(fs::is_empty(course.target().parent_path()));
  fs::create_directories(course.target());
  std::ofstream{course.target() / "mine"} << "of value";
  EXPECT_EQ(kind_thrown([&] { export_person(course.database(), ada, course.target()); }),
            DatabaseErrorKind::Refused);
  EXPECT_EQ(content_of(course.target() / "mine"), "of value");
}

TEST(PersonExport, IsDoneAtADeskAndWrittenToTheAudit) {
  TalkativeCourse course;
  course.trainee("ada").export_own(course.target());
  EXPECT_EQ(course.last_audit().action, "person_exported");
  EXPECT_EQ(course.last_audit().subject_id, std::to_string(course.id_of("ada").number));
  fs::remove_all(course.target());
  course.administrator().export_person("ada", course.target());
  EXPECT_EQ(course.last_audit().actor, course.id_of("root"));
  EXPECT_TRUE(fs::exists(course.target() / "explanation.txt"));
}

}  // namespace

}  // namespace hallux::database
