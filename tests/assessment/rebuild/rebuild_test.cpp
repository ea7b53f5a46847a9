#include "assessment/rebuild/rebuild.h"

#include <gtest/gtest.h>

#include "assessment/rebuild/cut_face.h"
#include "scenarios/plan.h"
#include "simulator/base/progress.h"
#include "tests/assessment/block_attempt.h"

namespace hallux::assessment {
namespace {

using simulator::Bone;
using simulator::Recording;
using testing::Stroke;

/// Poses are recorded to 1 um: over the block's 1200 mm2 the wall may lie 0.5 um off, twice that
/// with its rotation.
constexpr double volume_tolerance_mm3 = 1200.0 * 0.001;

/// Of a recording in which nobody said that a step is done.
const Recording nothing_said;
const StepEvidence no_steps{{}, nothing_said};

RebuiltBone rebuilt_from(const std::vector<Stroke>& strokes) {
  const Bone bone = testing::block_bone();
  Recording recording;
  for (const Stroke& stroke : strokes) add_stroke(recording, bone, stroke);
  return rebuild(bone, testing::block_scenario().saw.blade, recording);
}

TEST(Rebuild, ACutThroughTheBlockLeavesTwoPiecesAndTakesItsKerf) {
  const RebuiltBone rebuilt = rebuilt_from({Stroke{}});
  EXPECT_DOUBLE_EQ(rebuilt.input_mm3(), testing::block_mm3);
  ASSERT_EQ(rebuilt.pieces.size(), 2U);
  EXPECT_NEAR(rebuilt.piece_volumes_mm3[0], 1200.0 * 16.0, volume_tolerance_mm3);
  EXPECT_NEAR(rebuilt.piece_volumes_mm3[1], 1200.0 * 3.5, volume_tolerance_mm3);
  EXPECT_NEAR(rebuilt.removed_mm3, 1200.0 * testing::kerf_mm, volume_tolerance_mm3);
  const double sum_mm3 = rebuilt.piece_volumes_mm3[0] + rebuilt.piece_volumes_mm3[1] +
                         rebuilt.removed_mm3 + rebuilt.debris_mm3;
  EXPECT_NEAR(sum_mm3, rebuilt.input_mm3(), 1e-6 * rebuilt.input_mm3());
  EXPECT_TRUE(rebuilt.kerfs.at(0).is_finished());
  EXPECT_EQ(rebuilt.kerfs[0].frozen_tick, 10);
  EXPECT_EQ(rebuilt.kerfs[0].first_cutting_tick, 10);
}

TEST(Rebuild, AStrokeThatStopsInsideTakesWhatItOpenedAndSaysHowFarItCame) {
  const RebuiltBone rebuilt = rebuilt_from({Stroke{.last_y_mm = 0.0}});
  EXPECT_EQ(rebuilt.pieces.size(), 1U);
  // The last pose lies one feed of 0.05 mm above the middle; its tip is off by 1 um and its line by
  // as much.
  EXPECT_NEAR(rebuilt.removed_mm3, 60.0 * 9.95 * testing::kerf_mm, 60.0 * 0.002 * testing::kerf_mm);
  EXPECT_NEAR(rebuilt.piece_volumes_mm3[0] + rebuilt.removed_mm3, rebuilt.input_mm3(), 1e-6);
  ASSERT_EQ(rebuilt.kerfs.size(), 1U);
  EXPECT_FALSE(rebuilt.kerfs[0].is_finished());
  // Half of 20 mm, to within two rows of 0.1 mm nodes and one feed of 0.05 mm.
  EXPECT_NEAR(rebuilt.kerfs[0].done_fraction(), 0.5, 0.25 / 20.0);
}

TEST(Rebuild, NoEventsMeanAnUncutBone) {
  const RebuiltBone rebuilt = rebuilt_from({});
  EXPECT_TRUE(rebuilt.kerfs.empty());
  ASSERT_EQ(rebuilt.pieces.size(), 1U);
  EXPECT_DOUBLE_EQ(rebuilt.piece_volumes_mm3[0], testing::block_mm3);
}

TEST(Rebuild, TwoKerfsActInTurn) {
  const RebuiltBone rebuilt = rebuilt_from({Stroke{.face_z_mm = -10.0}, Stroke{}});
  ASSERT_EQ(rebuilt.pieces.size(), 3U);
  EXPECT_NEAR(rebuilt.removed_mm3, 2.0 * 1200.0 * testing::kerf_mm, 2.0 * volume_tolerance_mm3);
}

TEST(Rebuild, ProgressRisesAndCanStopIt) {
  const Bone bone = testing::block_bone();
  Recording recording;
  testing::add_stroke(recording, bone, {});
  double last = -1.0;
  const auto blade = testing::block_scenario().saw.blade;
  rebuild(bone, blade, recording, [&](double fraction) {
    EXPECT_GT(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_THROW(rebuild(bone, blade, recording, [](double) { return false; }), Cancelled);
}

TEST(CutFace, SamplesLieOnTheKeptWallAndCoverIt) {
  const RebuiltBone rebuilt = rebuilt_from({Stroke{}});
  const scenarios::Plan plan = plan_on(testing::block_scenario(), testing::block_bone());
  const std::vector<CutFace> faces = faces_of_cut(rebuilt, plan, 0, no_steps);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_TRUE(faces[0].is_finished);
  // The grid may gain or lose one row along each edge.
  EXPECT_NEAR(faces[0].area_mm2, 1200.0, 0.25 * (60.0 + 20.0) + 0.0625);
  for (const Vec3& sample : faces[0].samples_in_bone_mm) EXPECT_NEAR(sample.z, -8.0, 0.001);
  EXPECT_NEAR(faces[0].plane.normal.z, -1.0, 1e-9);
}

TEST(CutFace, TheFaceOfTheLargestPieceCountsFirst) {
  const RebuiltBone rebuilt = rebuilt_from({Stroke{.face_z_mm = -10.0}, Stroke{}});
  const scenarios::Plan plan = plan_on(testing::block_scenario(), testing::block_bone());
  const std::vector<CutFace> faces = faces_of_cut(rebuilt, plan, 0, no_steps);
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].kerf, 1);
  EXPECT_EQ(faces[0].piece, 0U);
}

TEST(CutFace, AnUnfinishedCutIsSampledWhereTheBladeWas) {
  const RebuiltBone rebuilt = rebuilt_from({Stroke{.last_y_mm = 9.0}});
  const scenarios::Plan plan = plan_on(testing::block_scenario(), testing::block_bone());
  const std::vector<CutFace> faces = faces_of_cut(rebuilt, plan, 0, no_steps);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_FALSE(faces[0].is_finished);
  EXPECT_GE(faces[0].samples_in_bone_mm.size(), 200U);
  for (const Vec3& sample : faces[0].samples_in_bone_mm) {
    EXPECT_NEAR(sample.z, -8.0, 0.001);
    EXPECT_GE(sample.y, 8.9);
  }
}

}  // namespace
}  // namespace hallux::assessment
