#include "simulator/record/record.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>

#include "simulator/base/random.h"
#include "simulator/base/units.h"

namespace hallux::simulator {
namespace {

std::int32_t any_int(Random& random) { return static_cast<std::int32_t>(random.bits() >> 32U); }

QuantisedPose any_pose(Random& random) {
  QuantisedPose pose;
  for (std::int32_t& part : pose.translation_um) part = any_int(random);
  for (std::int32_t& part : pose.rotation_micro) part = any_int(random);
  return pose;
}

TapeLine any_line(Random& random) {
  TapeLine line;
  line.tick = static_cast<std::int64_t>(random.bits());
  line.device = {any_pose(random), static_cast<std::uint32_t>(random.bits()),
                 static_cast<std::uint32_t>(random.bits() >> 32U)};
  line.ticks = static_cast<std::uint8_t>(random.bits());
  line.command_count = static_cast<std::uint8_t>(random.bits());
  for (Command& command : line.commands) {
    command = {static_cast<CommandKind>(any_int(random)), any_int(random),
               static_cast<std::int64_t>(random.bits())};
  }
  return line;
}

ToolSample any_sample(Random& random) {
  ToolSample sample;
  sample.tick = static_cast<std::int64_t>(random.bits());
  sample.world_from_tool = any_pose(random);
  for (std::int32_t& part : sample.force_mn) part = any_int(random);
  sample.status = static_cast<std::uint32_t>(random.bits());
  sample.kerf = any_int(random);
  return sample;
}

CutEvent any_event(Random& random) {
  return {static_cast<std::int64_t>(random.bits()), static_cast<CutEventKind>(any_int(random)),
          any_int(random), static_cast<std::int64_t>(random.bits()), any_pose(random)};
}

RC_GTEST_PROP(Record, RowsComeBackFromTheirColumns, (std::uint64_t seed)) {
  Random random{seed};
  const TapeLine line = any_line(random);
  const ToolSample sample = any_sample(random);
  const CutEvent event = any_event(random);
  RC_ASSERT(tape_line_from(columns_of(line)) == line);
  RC_ASSERT(tool_sample_from(columns_of(sample)) == sample);
  RC_ASSERT(cut_event_from(columns_of(event)) == event);
}

/// Each column of a row carries something: a change of any of them changes the row.
template <typename Columns, typename FromColumns>
void expect_every_column_counts(const Columns& columns, const FromColumns& from_columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    Columns changed = columns;
    changed[i] ^= 1;
    EXPECT_NE(from_columns(changed), from_columns(columns)) << "column " << i;
  }
}

TEST(Record, NoColumnIsIdle) {
  Random random{9};
  expect_every_column_counts(columns_of(any_line(random)), tape_line_from);
  expect_every_column_counts(columns_of(any_sample(random)), tool_sample_from);
  expect_every_column_counts(columns_of(any_event(random)), cut_event_from);
}

RC_GTEST_PROP(Record, AQuantisedPoseStaysWhatItIs, (std::uint64_t seed)) {
  Random random{seed};
  const RigidTransform pose{
      normalised(Quat{random.normal(), random.normal(), random.normal(), random.normal()}),
      Vec3{random.uniform(-500.0, 500.0), random.uniform(-500.0, 500.0),
           random.uniform(-1.0, 1.0)}};
  const QuantisedPose once = quantise(pose);
  const QuantisedPose twice = quantise(transform_from(once));
  RC_ASSERT(once.translation_um == twice.translation_um);
  // Rounding leaves the length off by up to four half quanta, which normalising spreads over the
  // parts.
  for (std::size_t i = 0; i < 4; ++i) {
    RC_ASSERT(std::abs(once.rotation_micro[i] - twice.rotation_micro[i]) <= 1);
  }
}

TEST(Record, QuantisingKeepsHalfAQuantum) {
  const RigidTransform pose{Quat{1.0, 0.0, 0.0, 0.0}, Vec3{1.23456, -0.0004, 100.0}};
  const Vec3 kept = transform_from(quantise(pose)).translation_mm;
  EXPECT_NEAR(kept.x, 1.23456, 0.0005 + 1.0e-12);
  EXPECT_NEAR(kept.y, -0.0004, 0.0005 + 1.0e-12);
  EXPECT_DOUBLE_EQ(kept.z, 100.0);
}

TEST(Record, BothQuaternionsOfARotationGiveOnePose) {
  const Quat rotation = normalised(Quat{-0.5, 0.1, 0.7, -0.3});
  const RigidTransform pose{rotation, Vec3{0.0}};
  const RigidTransform negative{-rotation, Vec3{0.0}};
  EXPECT_EQ(quantise(pose), quantise(negative));
  EXPECT_GT(quantise(pose).rotation_micro[0], 0);
}

Recording small_recording() {
  Random random{11};
  Recording recording;
  for (int i = 0; i < 3; ++i) {
    recording.tape.push_back(any_line(random));
    recording.samples.push_back(any_sample(random));
    recording.events.push_back(any_event(random));
  }
  return recording;
}

TEST(Record, TheHashOfTheOutputsSeesEveryField) {
  const Recording recording = small_recording();
  const Digest digest = digest_outputs(recording);
  EXPECT_EQ(digest_outputs(recording), digest);
  for (std::size_t i = 0; i < sample_columns; ++i) {
    Recording changed = recording;
    auto columns = columns_of(changed.samples[1]);
    columns[i] ^= 1;
    changed.samples[1] = tool_sample_from(columns);
    EXPECT_NE(digest_outputs(changed), digest) << "sample column " << i;
  }
  for (std::size_t i = 0; i < event_columns; ++i) {
    Recording changed = recording;
    auto columns = columns_of(changed.events[2]);
    columns[i] ^= 1;
    changed.events[2] = cut_event_from(columns);
    EXPECT_NE(digest_outputs(changed), digest) << "event column " << i;
  }
  Recording other_engine = recording;
  ++other_engine.engine;
  EXPECT_NE(digest_outputs(other_engine), digest);
  Recording shorter = recording;
  shorter.samples.pop_back();
  EXPECT_NE(digest_outputs(shorter), digest);
}

TEST(Record, TheHashOfTheOutputsLeavesOutTheInputs) {
  Recording recording = small_recording();
  const Digest digest = digest_outputs(recording);
  recording.tape.clear();
  EXPECT_EQ(digest_outputs(recording), digest);
}

}  // namespace
}  // namespace hallux::simulator
