#include "ui/jobs/cached_fields.h"

#include <gtest/gtest.h>

#include <fstream>

#include "assessment/assess.h"
#include "database/content/cached_bytes.h"
#include "database/course/score_json.h"
#include "simulator/base/progress.h"
#include "tests/database/some_database.h"
#include "tests/ui/screens/some_operation.h"

namespace hallux::ui {
namespace {

namespace fs = std::filesystem;

struct World {
  World() {
    const SomeOperation operation = some_operation();
    material.header.id = database::AttemptId{"0f5c2a7e-9a44-4a55-b8a5-2f1f1f6d1d11"};
    material.header.begun.engine = operation.recording.engine;
    material.scenario = operation.scenario;
    material.bones = {operation.bone};
    material.recording = operation.recording;
  }

  fs::path kept() const {
    return temporary.data() / "cache" / cached_fields_name(material.header.id);
  }

  database::TemporaryDirectory temporary;
  AttemptMaterial material;
};

void expect_same(const assessment::OpenedFields& a, const assessment::OpenedFields& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].inside_mm, b[i].inside_mm);
    EXPECT_EQ(a[i].opened_tick, b[i].opened_tick);
  }
}

TEST(CachedFields, AreMadeOnceAndReadAgainBitForBit) {
  const World world;
  const assessment::OpenedFields made = fields_of(world.material, world.temporary.data());
  ASSERT_EQ(made.size(), 2U);
  ASSERT_TRUE(fs::exists(world.kept()));
  const auto written = fs::last_write_time(world.kept());
  expect_same(fields_of(world.material, world.temporary.data()), made);
  EXPECT_EQ(fs::last_write_time(world.kept()), written);
  EXPECT_LT(fs::file_size(world.kept()), 400000U);
}

TEST(CachedFields, AnotherRecordingIsNotShownFromThem) {
  World world;
  const assessment::OpenedFields made = fields_of(world.material, world.temporary.data());
  world.material.recording.samples.resize(world.material.recording.samples.size() / 2);
  const assessment::OpenedFields half = fields_of(world.material, world.temporary.data());
  EXPECT_LT(half.front().inside_mm.size() + half.back().inside_mm.size(),
            made.front().inside_mm.size() + made.back().inside_mm.size());
  expect_same(half, assessment::opened_fields(world.material.scenario.saw.blade,
                                              world.material.bones, world.material.recording));
}

TEST(CachedFields, ADeletedOrDamagedFileIsMadeAgain) {
  const World world;
  const assessment::OpenedFields made = fields_of(world.material, world.temporary.data());
  fs::resize_file(world.kept(), fs::file_size(world.kept()) / 2);
  expect_same(fields_of(world.material, world.temporary.data()), made);
  fs::remove_all(world.temporary.data() / "cache");
  expect_same(fields_of(world.material, world.temporary.data()), made);
  EXPECT_TRUE(fs::exists(world.kept()));
}

TEST(CachedFields, WhereTheyCannotBeKeptTheAttemptIsShownAllTheSame) {
  const World world;
  fs::create_directories(world.temporary.data());
  std::ofstream(world.temporary.data() / "cache") << "a file";
  EXPECT_EQ(fields_of(world.material, world.temporary.data()).size(), 2U);
}

TEST(CachedFields, GiveTheScoreThatTheRecordingGives) {
  const World world;
  fields_of(world.material, world.temporary.data());
  const auto no_progress = [](const std::string&) { return Progress(); };
  const assessment::Examination fresh = score_attempt(world.material, no_progress);
  const assessment::Examination kept =
      examine_kept(world.material, world.temporary.data(), fresh.measurements, no_progress);
  EXPECT_EQ(database::json_from_card(kept.card), database::json_from_card(fresh.card));
  EXPECT_EQ(kept.card.score_milli, fresh.card.score_milli);
  EXPECT_EQ(kept.rebuilt.removed_mm3, fresh.rebuilt.removed_mm3);
  EXPECT_EQ(kept.rebuilt.piece_volumes_mm3, fresh.rebuilt.piece_volumes_mm3);
}

TEST(CachedFields, StopWhereThatIsAsked) {
  const World world;
  EXPECT_THROW(fields_of(world.material, world.temporary.data(), [](double) { return false; }),
               Cancelled);
  EXPECT_FALSE(fs::exists(world.kept()));
}

TEST(CachedFields, BytesThatAreNoFieldsAreRefused) {
  const World world;
  const assessment::OpenedFields made = fields_of(world.material, world.temporary.data());
  const std::vector<std::byte> whole = bytes_of(made);
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 50)
    EXPECT_FALSE(fields_from(std::span(whole).first(size))) << size;
  std::vector<std::byte> longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(fields_from(longer));
  assessment::OpenedFields beyond = made;
  beyond.front().window.u_last = beyond.front().grid.u_count + 1;
  EXPECT_FALSE(fields_from(bytes_of(beyond)));
  beyond = made;
  beyond.front().window.v_first = -1;
  EXPECT_FALSE(fields_from(bytes_of(beyond)));
  EXPECT_FALSE(fields_from(bytes_of(assessment::OpenedFields(simulator::kerf_limit + 1))));
}

}  // namespace
}  // namespace hallux::ui
