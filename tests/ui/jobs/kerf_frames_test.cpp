#include "ui/jobs/kerf_frames.h"

#include "simulator/base/progress.h"
#include "simulator/cutting/field/outline_tile.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/support/worlds.h"
#include "tests/ui/jobs/sweep_files.h"
#include "ui/jobs/cut_sweep.h"

namespace hallux::tests {
namespace {

using simulator::signed_volume_mm3;
using ui::CutGroup;
using ui::GroupOutcome;

/// What a straight edge of the outline may lose: its slack, and what floats round near zero.
constexpr double edge_mm = simulator::outline_slack_mm + 1.0e-6;

/// Corners of walls lie where shares on a lattice of 2^-20 mm put them; the walls of a kerf measure
/// some 6 mm2.
constexpr double balance_mm3 = 1.0e-5;

/// A block of 30 x 14 x 12 mm about the origin; its sections across x measure 168 mm2.
class SawnBlock : public SweepFiles {
 protected:
  /// The plane x = `offset_mm`, tilted about z.
  CutGroup across_x(double offset_mm, double tilt_degree = 0.0) {
    const double tilt_rad = tilt_degree * 3.14159265358979323846 / 180.0;
    CutGroup group;
    group.normal = Vec3(std::cos(tilt_rad), std::sin(tilt_rad), 0.0);
    group.offset = offset_mm * group.normal.x;
    return group;
  }
  /// The same, from y = -7 with the teeth stopping at `tip_y_mm`.
  CutGroup thrust_across_x(double offset_mm, double tip_y_mm, double tilt_degree = 0.0,
                           int poses = 2) {
    CutGroup group = across_x(offset_mm, tilt_degree);
    const Vec3 direction(-group.normal.y, group.normal.x, 0.0);
    const Vec3 tip_mm = Vec3(offset_mm, 0.0, 0.0) + tip_y_mm / direction.y * direction;
    group.sweep_file = sweep({tip_mm, direction, poses});
    return group;
  }
  GroupOutcome saw(const CutGroup& group) {
    GroupOutcome outcome = ui::saw(bone_, group, {});
    EXPECT_EQ(outcome.refused_frames, 0U);
    EXPECT_NO_THROW(simulator::check_closed_solid(bone_.solid().mesh, "what is left"));
    EXPECT_NEAR(signed_volume_mm3(bone_.solid().mesh) + bone_.removed_mm3(), 5040.0, balance_mm3);
    return outcome;
  }
  std::size_t piece_count() { return simulator::split_pieces(bone_.solid()).size(); }

  simulator::SawnBone bone_{solid_block(Vec3(30.0, 14.0, 12.0))};
};

TEST_F(SawnBlock, LosesWhatTheBladeCoveredWhereASweepStopsInside) {
  const GroupOutcome outcome = saw(thrust_across_x(1.0, 2.0));
  EXPECT_NEAR(outcome.removed_mm3, 0.5 * 12.0 * 9.0, 0.5 * 12.0 * edge_mm);
  EXPECT_EQ(outcome.kerf, 0U);
  EXPECT_EQ(piece_count(), 1U);
}

TEST_F(SawnBlock, ShowsOneFrameAPoseAndItsPatchStaysSmall) {
  const GroupOutcome few = saw(thrust_across_x(5.0, 2.0, 0.0, 30));
  bone_ = simulator::SawnBone(solid_block(Vec3(30.0, 14.0, 12.0)));
  const GroupOutcome many = saw(thrust_across_x(5.0, 2.0, 0.0, 300));
  EXPECT_EQ(few.frame_ms.size(), 30U);
  EXPECT_EQ(many.frame_ms.size(), 300U);
  for (const double frame_ms : many.frame_ms) EXPECT_GT(frame_ms, 0.0);
  EXPECT_GT(few.triangles_max, 12U);
  EXPECT_LE(many.triangles_max, few.triangles_max + few.triangles_max / 10U);
  EXPECT_NEAR(many.removed_mm3, few.removed_mm3, 1.0e-4 * few.removed_mm3);
}

TEST_F(SawnBlock, FallsInTwoWithoutASweep) {
  const GroupOutcome outcome = saw(across_x(1.0));
  EXPECT_NEAR(outcome.removed_mm3, 84.0, 1.0e-9);
  EXPECT_TRUE(outcome.frame_ms.empty());
  EXPECT_GE(outcome.contact_ms, 0.0);
  EXPECT_EQ(piece_count(), 2U);
}

TEST_F(SawnBlock, OpensTheKerfThatIsThereWhereThePlaneComesAgain) {
  saw(thrust_across_x(1.0, 0.0));
  const GroupOutcome again = saw(thrust_across_x(1.05, 7.5, 0.3));
  EXPECT_EQ(again.kerf, 0U);
  EXPECT_EQ(bone_.kerf_count(), 1U);
  EXPECT_EQ(piece_count(), 2U);
  EXPECT_NEAR(bone_.removed_mm3(), 84.0, 1.0e-9);
  // As if it had been one kerf from the beginning: no sliver, no face more.
  simulator::SawnBone at_once(solid_block(Vec3(30.0, 14.0, 12.0)));
  ui::saw(at_once, across_x(1.0), {});
  EXPECT_EQ(bone_.solid().mesh.triangles.size(), at_once.solid().mesh.triangles.size());
}

TEST_F(SawnBlock, TakesNothingWhereTheSameSweepComesTwice) {
  saw(thrust_across_x(1.0, 2.0));
  const auto before = bone_.solid().mesh;
  const GroupOutcome again = saw(thrust_across_x(1.0, 2.0));
  EXPECT_EQ(again.removed_mm3, 0.0);
  EXPECT_EQ(bone_.solid().mesh, before);
}

TEST_F(SawnBlock, TheSamePlaneFromTheOtherSideIsTheSamePlane) {
  saw(thrust_across_x(1.0, 2.0));
  CutGroup turned = across_x(1.0);
  turned.normal = -turned.normal;
  turned.offset = -turned.offset;
  EXPECT_EQ(saw(turned).kerf, 0U);
  EXPECT_NEAR(bone_.removed_mm3(), 84.0, 1.0e-9);
}

TEST_F(SawnBlock, AKerfIsOpenedAgainUnderKerfsThatCrossIt) {
  saw(thrust_across_x(0.0, 0.0));
  CutGroup level;
  level.offset = 1.0;
  saw(level);
  const GroupOutcome again = saw(thrust_across_x(0.0, 7.5));
  EXPECT_EQ(again.kerf, 0U);
  // The union of both slabs: 84 and 0.5 * 30 * 14, less the bar in which they cross.
  EXPECT_NEAR(bone_.removed_mm3(), 84.0 + 210.0 - 0.5 * 0.5 * 14.0, 1.0e-6);
  EXPECT_EQ(piece_count(), 4U);
}

TEST_F(SawnBlock, OtherPlanesAndOtherThicknessBeginKerfsOfTheirOwn) {
  saw(thrust_across_x(1.0, 0.0));
  EXPECT_EQ(saw(thrust_across_x(1.2, 0.0)).kerf, 1U);
  EXPECT_EQ(saw(thrust_across_x(1.0, 0.0, 1.0)).kerf, 2U);
  CutGroup thinner = thrust_across_x(1.0, 0.0);
  thinner.kerf_mm = 0.3;
  const GroupOutcome inside = saw(thinner);
  EXPECT_EQ(inside.kerf, 3U);
  EXPECT_NEAR(inside.removed_mm3, 0.0, 12.0 * 0.3 * edge_mm);
}

TEST_F(SawnBlock, IsWholeWhereThePlaneOrTheBladeMisses) {
  EXPECT_FALSE(saw(across_x(80.0)).kerf.has_value());
  EXPECT_EQ(saw(thrust_across_x(1.0, -9.0)).removed_mm3, 0.0);
  EXPECT_EQ(bone_.solid().mesh, bone_.whole().mesh);
}

TEST_F(SawnBlock, MayVanishWholly) {
  CutGroup all = across_x(0.0);
  all.kerf_mm = 50.0;
  EXPECT_NEAR(ui::saw(bone_, all, {}).removed_mm3, 5040.0, 1.0e-6);
  EXPECT_TRUE(bone_.solid().mesh.triangles.empty());
  EXPECT_EQ(ui::saw(bone_, thrust_across_x(1.0, 2.0), {}).removed_mm3, 0.0);
}

TEST_F(SawnBlock, StopsBetweenFramesWhenItIsToldTo) {
  const CutGroup group = thrust_across_x(1.0, 7.5, 0.0, 100);
  double reached = 0.0;
  const auto progress = [&reached](double fraction) {
    reached = fraction;
    return fraction < 0.5;
  };
  EXPECT_THROW(ui::saw(bone_, group, progress), Cancelled);
  EXPECT_DOUBLE_EQ(reached, 0.5);
  EXPECT_EQ(bone_.solid().mesh, bone_.whole().mesh);
}

TEST_F(SawnBlock, ASectionTooWideForASweepIsRefusedAndCutWithoutOne) {
  simulator::SawnBone wide(solid_block(Vec3(30.0, 250.0, 12.0)));
  EXPECT_THROW(ui::saw(wide, thrust_across_x(1.0, 7.5), {}), ui::CutInputError);
  EXPECT_NEAR(ui::saw(wide, across_x(1.0), {}).removed_mm3, 0.5 * 250.0 * 12.0, 1.0e-6);
}

}  // namespace
}  // namespace hallux::tests
