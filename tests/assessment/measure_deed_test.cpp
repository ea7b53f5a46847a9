#include "assessment/measure_deed.h"

#include <gtest/gtest.h>

#include "assessment/assess.h"
#include "assessment/ledger.h"
#include "tests/assessment/akin_attempt.h"
#include "tests/assessment/block_attempt.h"

namespace hallux::assessment {
namespace {

using simulator::Bone;
using simulator::CutEventKind;
using simulator::Recording;
using testing::add_removal;
using testing::add_stroke;
using testing::akin_recording;
using testing::Stroke;

/// In the middle of the block's eminence.
constexpr Vec3 in_eminence_mm{30.0, 0.0, -10.0};

double piece_out_of(const Recording& recording) {
  const Examination examination =
      assess_fully(testing::block_scenario(), testing::block_bone(), recording, "scripted");
  const Measurement* made = find_measurement(examination.measurements, "piece_out", "eminence");
  EXPECT_TRUE(made->is_measured());
  return made->value;
}

Recording sawn(const std::vector<Stroke>& strokes) {
  Recording recording;
  for (const Stroke& stroke : strokes) add_stroke(recording, testing::block_bone(), stroke);
  return recording;
}

TEST(PieceOut, IsOneWhereTheFreePieceWasTakenOut) {
  Recording recording = sawn({Stroke{}});
  EXPECT_EQ(piece_out_of(recording), 0.0) << "free, and left lying there";
  add_removal(recording, in_eminence_mm);
  EXPECT_EQ(piece_out_of(recording), 1.0);
}

TEST(PieceOut, IsNoneWithoutACutOrWhereOnlyTheBoneItselfWasAskedFor) {
  EXPECT_EQ(piece_out_of({}), 0.0);
  Recording recording = sawn({Stroke{.last_y_mm = 5.0}});
  add_removal(recording, in_eminence_mm);
  EXPECT_EQ(piece_out_of(recording), 0.0) << "it holds: the piece in which that point lies is all";
}

TEST(PieceOut, OfACornerAloneIsNotTheEminence) {
  // A slice of 2 of 4 mm, beyond a face that was sawn afterwards and is the one that counts.
  Recording recording = sawn({Stroke{.face_z_mm = -11.3}});
  add_removal(recording, {30.0, 0.0, -11.8});
  add_stroke(recording, testing::block_bone(), Stroke{});
  EXPECT_EQ(piece_out_of(recording), 0.0);
  add_removal(recording, in_eminence_mm);
  EXPECT_EQ(piece_out_of(recording), 1.0);
}

TEST(PieceOut, IsKnownByItsPlaceThoughTheBladeWentOnWhereItHadBeen) {
  Recording recording = sawn({Stroke{}});
  add_removal(recording, in_eminence_mm);
  // Right through the piece that is gone: what is left of it would be two.
  add_stroke(recording, testing::block_bone(), Stroke{.face_z_mm = -10.0});
  EXPECT_EQ(piece_out_of(recording), 1.0);
}

TEST(PieceOut, IsKnownByItsVolumeInRecordingsThatTellNoPlace) {
  Recording recording = sawn({Stroke{}});
  recording.engine = 6;
  simulator::CutEvent freed;
  freed.tick = recording.samples.back().tick;
  freed.kind = CutEventKind::PieceFreed;
  freed.subject = 1;
  freed.value = 4'200'000;
  recording.events.push_back(freed);
  add_removal(recording, {0.0, 0.0, 0.0});
  EXPECT_EQ(piece_out_of(recording), 1.0);
}

TEST(PieceOut, AnswersAtTheMomentOfTheRemovalOrAtTheEnd) {
  Recording recording = sawn({Stroke{}});
  const auto moment_us = [&] {
    const Examination examination =
        assess_fully(testing::block_scenario(), testing::block_bone(), recording, "scripted");
    return find_measurement(examination.measurements, "piece_out", "eminence")->start_us;
  };
  const std::int64_t last_us = 1000 * recording.samples.back().tick;
  EXPECT_EQ(moment_us(), last_us);
  add_removal(recording, in_eminence_mm);
  EXPECT_EQ(moment_us(), last_us + 1000);
}

/// The worked example's wedge, and what of it was done besides the cuts.
struct Deeds {
  double out = 0.0, closed = 0.0;
};

Deeds deeds_of(const Recording& recording) {
  scenarios::Scenario scenario = testing::akin_scenario();
  scenario.steps = {{scenarios::StepKind::Remove, "", "", "", "lateral"},
                    {scenarios::StepKind::Close, "", "", "", "lateral"}};
  const Examination examination =
      assess_fully(scenario, testing::oval_bone(), recording, "scripted");
  const auto value = [&](const char* metric) {
    return find_measurement(examination.measurements, metric, "", "lateral")->value;
  };
  return {value("piece_out"), value("wedge_closed")};
}

TEST(WedgeOut, IsTheThinWedgeBetweenTheTwoFacesAsTheyWereSawn) {
  const Bone bone = testing::oval_bone();
  // 2 mm beside the plan: the planned wedge lies half in the bone that stays.
  for (const double entry_x_mm : {6.0, 8.0}) {
    Recording recording = akin_recording({.entry_x_mm = entry_x_mm}, bone);
    EXPECT_EQ(deeds_of(recording).out, 0.0);
    // Between the faces, near the entry.
    testing::add_removal(recording, {entry_x_mm + 1.3, 0.0, -6.5});
    EXPECT_EQ(deeds_of(recording).out, 1.0) << entry_x_mm;
  }
}

TEST(WedgeClosed, IsWhatTheKernelSaid) {
  Recording recording = akin_recording({}, testing::oval_bone());
  EXPECT_EQ(deeds_of(recording).closed, 0.0);
  simulator::CutEvent closed;
  closed.tick = recording.samples.back().tick;
  closed.kind = CutEventKind::HingeRefused;
  recording.events.push_back(closed);
  EXPECT_EQ(deeds_of(recording).closed, 0.0);
  recording.events.back().kind = CutEventKind::HingeClosed;
  EXPECT_EQ(deeds_of(recording).closed, 1.0);
}

}  // namespace
}  // namespace hallux::assessment
