/// Folders that nobody vouches for: each is refused with a sentence that names the place, and
/// nothing is stored.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>
#include <memory>

#include "database/exchange/origins.h"
#include "simulator/base/json_depth.h"
#include "tests/database/some_exchange.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

struct Attack {
  std::string name;
  std::function<void(const fs::path& folder)> make;
};

Attack in_manifest(const std::string& name, const std::string& old_text,
                   const std::string& new_text) {
  return {name,
          [=](const fs::path& folder) { alter_alone(folder / manifest_name, old_text, new_text); }};
}

Attack in_tape(const std::string& name, const std::string& old_text, const std::string& new_text) {
  return {name, [=](const fs::path& folder) { alter(folder, "tape.csv", old_text, new_text); }};
}

std::vector<Attack> on_the_manifest() {
  return {in_manifest("AnotherFormat", "hallux-attempt", "hallux-bone"),
          in_manifest("AnotherSeal", "\"seal\": \"", "\"seal\": \"0"),
          in_manifest("NoSeal", "\"seal\": \"", "\"sael\": \""),
          in_manifest("AnotherHand", "\"hand\": \"\"", "\"hand\": \"expert\""),
          in_manifest("AControlCharacter", "\"hand\": \"\"", "\"hand\": \"\\u001b[2J\""),
          in_manifest("AnotherDuration", "\"duration_ticks\": ", "\"duration_ticks\": 1"),
          in_manifest("AFractionOfATick", "\"duration_ticks\": 5", "\"duration_ticks\": 5.5"),
          in_manifest("AHugeDuration", "\"duration_ticks\": 5", "\"duration_ticks\": 1e308"),
          in_manifest("APathAsAUuid", "\"uuid\": \"", "\"uuid\": \"../../"),
          in_manifest("APathAsAFile", "\"name\": \"tape.csv\"", "\"name\": \"../tape.csv\""),
          in_manifest("AnAbsoluteFile", "\"name\": \"tape.csv\"", "\"name\": \"/etc/passwd\""),
          in_manifest("AFileTwice", "\"name\": \"bone.ply\"", "\"name\": \"bone.bin\""),
          in_manifest("ThreeGigabytes", "\"bytes\": ", "\"bytes\": 3000000000"),
          in_manifest("ANegativeSize", "\"bytes\": ", "\"bytes\": -"),
          in_manifest("AnotherDigest", "\"blake2b_256\": \"", "\"blake2b_256\": \"f0"),
          in_manifest("AScenarioAltered", "{\\\"name\\\": \\\"silver\\\"}",
                      "{\\\"name\\\": \\\"akin\\\"}"),
          in_manifest("AStateOfItsOwn", "\"state\": \"closed\"", "\"state\": \"void\""),
          in_manifest("AKindOfItsOwn", "\"kind\": \"practice\"", "\"kind\": \"exam\""),
          in_manifest("AnotherPurpose", "\"kind\": \"practice\"", "\"kind\": \"assessment\""),
          in_manifest("SimulatedSuddenly", "\"is_simulated\": false", "\"is_simulated\": true"),
          in_manifest("AnotherPerson", "\"person\": \"person-", "\"person\": \"person-7"),
          in_manifest("AnotherAct", "\"number\": ", "\"number\": 1"),
          in_manifest("NoAct", "\"audit\": ", "\"adieu\": "),
          in_manifest("APersonByName", "\"person\": \"person-", "\"person\": \"ada-"),
          in_manifest("ATimeThatIsNone", "\"started_utc\": \"2", "\"started_utc\": \"x")};
}

std::vector<Attack> on_the_files() {
  return {
      {"NoManifest", [](const fs::path& f) { fs::remove(f / manifest_name); }},
      {"EmptyManifest", [](const fs::path& f) { std::ofstream(f / manifest_name).flush(); }},
      {"DeepManifest",
       [](const fs::path& f) { std::ofstream(f / manifest_name) << std::string(100'000, '['); }},
      {"DeepCard",
       [](const fs::path& f) {
         alter_alone(f / manifest_name, "\"groups\": []",
                     "\"groups\": " + std::string(50'000, '[') + std::string(50'000, ']'));
       }},
      {"ACutTable",
       [](const fs::path& f) {
         fs::resize_file(f / "tape.csv", fs::file_size(f / "tape.csv") / 2);
       }},
      {"AMissingTable", [](const fs::path& f) { fs::remove(f / "samples.csv"); }},
      {"AMissingBone", [](const fs::path& f) { fs::remove(f / "bone.bin"); }},
      {"AnotherBone",
       [](const fs::path& f) {
         alter(f, "bone.bin", "a bone of no shape", "a bone of bad shape");
       }},
      {"AnAlteredPiece", [](const fs::path& f) { alter_alone(f / "piece-1.ply", "rows", "cows"); }},
      {"ALinkForATable",
       [](const fs::path& f) {
         fs::rename(f / "tape.csv", f / "real.csv");
         fs::create_symlink("real.csv", f / "tape.csv");
       }},
      {"ALinkForTheManifest",
       [](const fs::path& f) {
         fs::rename(f / manifest_name, f / "real.json");
         fs::create_symlink("real.json", f / manifest_name);
       }},
      {"APipeForATable",
       [](const fs::path& f) {
         fs::remove(f / "tape.csv");
         ASSERT_EQ(::mkfifo((f / "tape.csv").c_str(), 0600), 0);
       }},
      {"AFolderForATable",
       [](const fs::path& f) {
         fs::remove(f / "tape.csv");
         fs::create_directory(f / "tape.csv");
       }},
      {"NoEnd",
       [](const fs::path& f) { alter(f, "events.csv", "pose_qz_micro\r\n", "pose_qz_micro"); }}};
}

std::vector<Attack> on_a_table() {
  return {in_tape("AnAlteredRow", "\r\n0,1,", "\r\n0,1,1"),
          in_tape("AFormula", "\r\n0,1,", "\r\n0,=1,"),
          in_tape("NotANumber", "\r\n0,1,", "\r\n0,NaN,"),
          in_tape("AHugeNumber", "\r\n0,1,", "\r\n0,1e308,"),
          in_tape("TooLongANumber", "\r\n0,1,", "\r\n0,99999999999999999999,"),
          in_tape("ALeadingZero", "\r\n0,1,", "\r\n0,01,"),
          in_tape("APlus", "\r\n0,1,", "\r\n0,+1,"),
          in_tape("AMinusZero", "\r\n0,1,", "\r\n0,-0,"),
          in_tape("AnEmptyCell", "\r\n0,1,", "\r\n0,,"),
          in_tape("AQuotedLine", "\r\n0,1,", "\r\n0,\"1\r\n\","),
          in_tape("ALineOfUnix", "\r\n0,1,", "\n0,1,"),
          in_tape("OneColumnMore", "\r\n0,1,", "\r\n0,1,1,"),
          in_tape("OneRowTwice", "\r\n0,1,", "\r\n0,0,"),
          in_tape("ATickBefore", "\r\n0,2,", "\r\n0,0,"),
          in_tape("AWindowBefore", "\r\n0,2,", "\r\n-1,2,"),
          in_tape("AWindowOfItsOwn", "\r\n0,2,", "\r\n1,2,"),
          in_tape("AnotherHeader", "handle_x_um", "handle_x_mm"),
          in_tape("ALongLine", "\r\n0,1,", "\r\n" + std::string(2000, '0') + ",1,")};
}

const std::vector<Attack>& attacks() {
  static const std::vector<Attack> all = [] {
    std::vector<Attack> gathered = on_the_manifest();
    for (const auto& more : {on_the_files(), on_a_table()}) {
      gathered.insert(gathered.end(), more.begin(), more.end());
    }
    return gathered;
  }();
  return all;
}

/// One world for all: each attack is on a copy of the same folder, and none may leave a trace.
class Hostile : public testing::TestWithParam<std::size_t> {
 protected:
  static void SetUpTestSuite() {
    two = std::make_unique<TwoDirectories>();
    exported = two->exported(two->course().scored_by("ada", 50'000));
  }
  static void TearDownTestSuite() { two.reset(); }

  static std::unique_ptr<TwoDirectories> two;
  static fs::path exported;
};

std::unique_ptr<TwoDirectories> Hostile::two;
fs::path Hostile::exported;

TEST_P(Hostile, FolderIsRefusedAndNothingIsStored) {
  const TemporaryDirectory temporary;
  const fs::path folder = temporary.data();
  fs::copy(exported, folder);
  ASSERT_NO_FATAL_FAILURE(attacks()[GetParam()].make(folder));
  try {
    two->import(folder);
    ADD_FAILURE() << "it was taken in";
  } catch (const DatabaseError& error) {
    EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput) << error.what();
    EXPECT_NE(std::string{error.what()}.find(folder.string()), std::string::npos) << error.what();
  }
  EXPECT_TRUE(list_attempts(two->there()).empty());
  EXPECT_TRUE(list_origins(two->there()).empty());
}

INSTANTIATE_TEST_SUITE_P(Import, Hostile, testing::Range(std::size_t{0}, attacks().size()),
                         [](const auto& each) { return attacks()[each.param].name; });

TEST(HostileImport, TheTablesOfAnotherAttemptDoNotFit) {
  TwoDirectories two;
  NewAttempt attempt = two.course().attempt_of("ada");
  const AttemptId mine = record(two.course().database(), attempt, some_recording(20));
  const AttemptId better = record(two.course().database(), attempt, some_recording(20));
  const fs::path folder = two.exported(mine), other = two.exported(better);
  for (const char* name : {"tape.csv", "samples.csv", "events.csv"}) {
    fs::copy_file(other / name, folder / name, fs::copy_options::overwrite_existing);
  }
  two.import(
      folder);  // The same rows: only the uuid in the chain tells them apart, and that is kept.
  EXPECT_EQ(list_attempts(two.there()).size(), 1U);
  alter_alone(other / manifest_name, better.text, mine.text);
  EXPECT_EQ(kind_thrown([&] { two.import(other); }), DatabaseErrorKind::BadInput);
}

TEST(HostileImport, ANewerFormatIsSaid) {
  TwoDirectories two;
  const fs::path folder = two.exported(two.course().recorded_by("ada"));
  alter_alone(folder / manifest_name, "\"format_version\": 3", "\"format_version\": 4");
  EXPECT_EQ(kind_thrown([&] { two.import(folder); }), DatabaseErrorKind::Newer);
}

TEST(HostileImport, DepthIsKnownWithoutAParser) {
  EXPECT_EQ(json_depth(""), 0);
  EXPECT_EQ(json_depth("[{\"a\": [1, 2]}, {}]"), 3);
  EXPECT_EQ(json_depth("[\"[[[[\", \"\\\"[[[[\"]"), 1);
  EXPECT_EQ(json_depth(std::string(1000, '{')), 1000);
  EXPECT_EQ(json_depth("]]]]["), 1);
}

TEST(HostileImport, FoldersAreFoundOneLevelDeepAndNoLinkIsFollowed) {
  TwoDirectories two;
  const fs::path folder = two.exported(two.course().recorded_by("ada"));
  EXPECT_EQ(find_exported(folder), std::vector{folder});
  EXPECT_EQ(find_exported(two.out()), std::vector{folder});
  const TemporaryDirectory elsewhere;
  const fs::path links = elsewhere.data();
  fs::create_directory(links);
  fs::create_directory_symlink(folder, links / "a");
  EXPECT_EQ(kind_thrown([&] { find_exported(links); }), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_thrown([&] { find_exported(links / "nowhere"); }), DatabaseErrorKind::BadInput);
}

}  // namespace

}  // namespace hallux::database
