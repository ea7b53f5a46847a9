#include "database/course/begin_attempt.h"
#include "database/exchange/export_attempt.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "database/exchange/read_manifest.h"
#include "database/exchange/write_manifest.h"
#include "database/store/fresh_directory.h"
#include "database/text/csv_text.h"
#include "tests/database/some_exchange.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

unsigned mode_of(const fs::path& file) {
  struct stat facts {};
  EXPECT_EQ(::stat(file.c_str(), &facts), 0);
  return facts.st_mode & 0777U;
}

TEST(Export, WritesAFolderThatNobodyElseMayRead) {
  TwoDirectories two;
  const AttemptId id = two.course().scored_by("ada", 50'000);
  const fs::path folder = two.exported(id);
  std::vector<std::string> names;
  for (const auto& [name, bytes] : bytes_below(folder)) {
    names.push_back(name);
    EXPECT_EQ(mode_of(folder / name), 0600U) << name;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"bone.bin", "bone.ply", "events.csv", "manifest.json",
                                      "piece-1.ply", "samples.csv", "score.csv", "tape.csv"}));
  EXPECT_EQ(mode_of(folder), 0700U);
}

TEST(Export, TablesAreTheRecordsIntegersWithUnitsAbove) {
  TwoDirectories two;
  const simulator::Recording recording = some_recording(600);
  const AttemptId id = record(two.course().database(), two.course().attempt_of("ada"), recording);
  const auto bytes = bytes_below(two.exported(id));
  const std::string& tape = bytes.at("tape.csv");
  EXPECT_TRUE(tape.starts_with("window,tick_ms,handle_x_um,"));
  std::string first = "\r\n0,0";
  const auto columns = columns_of(recording.tape.front());
  for (std::size_t i = 1; i < columns.size(); ++i) first += "," + std::to_string(columns[i]);
  EXPECT_NE(tape.find(first + "\r\n"), std::string::npos);
  EXPECT_NE(tape.find("\r\n1,500,"), std::string::npos) << "the second window begins at tick 500";
  for (const char* name : {"tape.csv", "samples.csv", "events.csv", "score.csv"}) {
    const auto found = bytes.find(name);
    if (found == bytes.end()) continue;
    for (std::size_t at = 0; (at = found->second.find('\n', at)) != std::string::npos; ++at) {
      ASSERT_EQ(found->second[at - 1], '\r') << name;
    }
  }
}

TEST(Export, IsTheSameTwice) {
  TwoDirectories two;
  const AttemptId id = two.course().scored_by("ada", 50'000);
  const fs::path folder = two.exported(id);
  const auto first = bytes_below(folder);
  fs::remove_all(folder);
  EXPECT_EQ(bytes_below(two.exported(id)), first);
}

TEST(Export, NamesNobody) {
  TwoDirectories two;
  const AttemptId id = two.course().scored_by("bob", 50'000);
  two.course()
      .instructor("kim", two.course().autumn())
      .decide({id, DecisionKind::Voided, 0, "a canary sang"});
  for (const auto& [name, bytes] : bytes_below(two.exported(id))) {
    for (const char* word : {"\"bob\"", "kim", "canary"}) {
      EXPECT_EQ(bytes.find(word), std::string::npos) << word << " in " << name;
    }
  }
}

TEST(Export, RefusesWhatIsStillBeingRecorded) {
  TwoDirectories two;
  const WriterLease lease = create_attempt(two.course().database(), two.course().attempt_of("ada"));
  EXPECT_EQ(kind_thrown([&] { two.exported(lease.attempt()); }), DatabaseErrorKind::BadInput);
  EXPECT_TRUE(bytes_below(two.out()).empty());
}

TEST(Export, IsNotedForEverybodyWhoSignedIn) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("ada");
  two.course().trainee("ada").export_attempt(id, two.out(), some_derived);
  EXPECT_EQ(two.course().last_audit().action, "attempt_exported");
  EXPECT_EQ(two.course().last_audit().subject_id, id.text);
}

TEST(Export, GivesATraineeNothingOfAnother) {
  TwoDirectories two;
  const AttemptId id = two.course().recorded_by("eve");
  EXPECT_EQ(
      kind_thrown([&] { two.course().trainee("ada").export_attempt(id, two.out(), some_derived); }),
      DatabaseErrorKind::NotFound);
  EXPECT_TRUE(fs::is_empty(two.out()));
}

TEST(Export, AFreshDirectoryIsCompleteOrNotThere) {
  const TemporaryDirectory out;
  const fs::path parent = out.data().parent_path(), target = parent / "exported";
  {
    const FreshDirectory stopped(target);
    ExchangeWriter(stopped.path(), "a.csv").finish();
    EXPECT_FALSE(fs::exists(target));
  }
  EXPECT_TRUE(fs::is_empty(parent));
  {
    const FreshDirectory kept(target);
    ExchangeWriter(kept.path(), "a.csv").finish();
    kept.finish();
  }
  EXPECT_TRUE(fs::exists(target / "a.csv"));
  EXPECT_EQ(mode_of(target), 0700U);
  EXPECT_EQ(kind_thrown([&] { FreshDirectory again(target); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(kind_thrown([&] { FreshDirectory nowhere(target / "a.csv" / "such"); }),
            DatabaseErrorKind::BadInput);
}

TEST(Export, AFullDiskIsSaidAndLeavesNothing) {
  const TemporaryDirectory out;
  const fs::path target = out.data().parent_path() / "exported";
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &usual), 0);
  const rlimit small{10'000, usual.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const DatabaseErrorKind kind = kind_thrown([&] {
    const FreshDirectory folder(target);
    write_record_tables(folder.path(), some_recording(500), {{Stream::Tape, 0, 0, 500}});
  });
  ::setrlimit(RLIMIT_FSIZE, &usual);
  EXPECT_EQ(kind, DatabaseErrorKind::Full);
  EXPECT_TRUE(fs::is_empty(out.data().parent_path()));
}

TEST(Export, ACellIsNeverAFormula) {
  EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_cell("+1"), "'+1");
  EXPECT_EQ(csv_cell("-1"), "'-1");
  EXPECT_EQ(csv_cell("@sum"), "'@sum");
  EXPECT_EQ(csv_cell("\tx"), "'\tx");
  EXPECT_EQ(csv_cell("'quoted'"), "''quoted'");
  EXPECT_EQ(csv_cell("a, \"b\"\nc"), "\"a, \"\"b\"\"\nc\"");
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("\r=x"), "\"'\r=x\"");
  EXPECT_EQ(csv_number(-0.125), "-0.125");
  EXPECT_EQ(csv_number(0.0 / (mode_of("/") == 0U ? 1.0 : 0.0)), "");
}

TEST(Export, AManifestIsReadBackAsItWasWritten) {
  TwoDirectories two;
  const AttemptId id = two.course().scored_by("ada", 50'000);
  two.course()
      .instructor("kim", two.course().autumn())
      .decide({id, DecisionKind::Overridden, 60'000, "seen"});
  const std::string text = bytes_below(two.exported(id)).at(manifest_name);
  const Manifest manifest = manifest_from_json(text);
  EXPECT_EQ(manifest.header.id, id);
  EXPECT_EQ(manifest.header.begun.person, two.course().id_of("ada"));
  EXPECT_EQ(manifest.decisions.at(0).decided_by, two.course().id_of("kim"));
  EXPECT_EQ(manifest.decisions.at(0).score_milli, 60'000);
  EXPECT_EQ(manifest.scores.size(), 1U);
  EXPECT_EQ(nlohmann::json::parse(json_from_manifest(manifest)), nlohmann::json::parse(text));
}

}  // namespace

}  // namespace hallux::database
