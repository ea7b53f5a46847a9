#include "simulator/jobs/geometry_job.h"

#include <gtest/gtest.h>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;

constexpr double size_x_mm = 20.0;
constexpr double section_mm2 = 4.0 * 6.0;
constexpr double block_mm3 = size_x_mm * section_mm2;
constexpr double kerf_mm = 0.5;

Bone block() { return tests::cortical_bone(tests::solid_block({size_x_mm, 4.0, 6.0})); }

void freeze(AttemptGeometry& geometry, std::int32_t kerf, double x_mm) {
  CutEvent event;
  event.kind = CutEventKind::PlaneFrozen;
  event.subject = kerf;
  event.pose = quantise(blade_down({x_mm, 2.0, 0.0}));
  geometry.apply(event);
}

/// The blade in that kerf, its teeth at `y_mm`; it is 20 mm deep and wider than the block.
void sweep(AttemptGeometry& geometry, const Bone& bone, std::int32_t kerf, double x_mm,
           double y_mm) {
  ToolSample sample;
  sample.world_from_tool = quantise(bone.world_from_bone * blade_down({x_mm, y_mm, 0.0}));
  sample.status = static_cast<std::uint32_t>(ToolStatus::SawOn);
  sample.kerf = kerf;
  geometry.apply(sample);
}

std::unique_ptr<const JobResult> cut(AttemptGeometry& geometry, const Bone& bone, std::int32_t kerf,
                                     double x_mm) {
  freeze(geometry, kerf, x_mm);
  geometry.run({2 * kerf, JobKind::Section, kerf, 0});
  sweep(geometry, bone, kerf, x_mm, -4.0);
  return geometry.run({2 * kerf + 1, JobKind::Pieces, kerf, 0});
}

TEST(ContactJob, FindsTheSection) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  freeze(geometry, 0, 3.0);
  const auto result = geometry.run({7, JobKind::Section, 0, 11});
  EXPECT_EQ(result->request.id, 7);
  EXPECT_EQ(result->request.tick, 11);
  EXPECT_NEAR(result->section_mm2, section_mm2, 1e-4);
}

TEST(ContactJob, ChangesNothing) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  freeze(geometry, 0, 3.0);
  geometry.run({0, JobKind::Section, 0, 0});
  EXPECT_EQ(geometry.solid().mesh, solid_of(bone));
}

TEST(PiecesJob, ACoveredSectionLeavesTwoPiecesLargestFirst) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  const auto result = cut(geometry, bone, 0, 5.0);
  ASSERT_EQ(result->pieces.size(), 2U);
  EXPECT_EQ(result->pieces[0].id, 0);
  EXPECT_FALSE(result->pieces[0].is_new);
  EXPECT_EQ(result->pieces[1].id, 1);
  EXPECT_TRUE(result->pieces[1].is_new);
  // The plane is rounded to 1e-6: over 10 mm that moves it by less than 0.05 um.
  EXPECT_NEAR(result->pieces[0].volume_mm3, (15.0 - 0.5 * kerf_mm) * section_mm2, 0.01);
  EXPECT_NEAR(result->pieces[1].volume_mm3, (5.0 - 0.5 * kerf_mm) * section_mm2, 0.01);
}

TEST(PiecesJob, PiecesDebrisAndWhatWasTakenAddUp) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  const auto result = cut(geometry, bone, 0, 5.0);
  double sum_mm3 = result->debris_mm3 + result->removed_mm3;
  for (const FoundPiece& piece : result->pieces) sum_mm3 += piece.volume_mm3;
  EXPECT_NEAR(sum_mm3, block_mm3, 1e-9 * block_mm3);
  EXPECT_NEAR(result->removed_mm3, kerf_mm * section_mm2, 0.001);
}

TEST(PiecesJob, AKerfThatStopsInTheBoneIsCutAndFreesNothing) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  freeze(geometry, 0, 5.0);
  geometry.run({0, JobKind::Section, 0, 0});
  // The block's top is at 2: the teeth are 3.5 deep.
  sweep(geometry, bone, 0, 5.0, -1.5);
  const auto result = geometry.run({1, JobKind::Pieces, 0, 0});
  ASSERT_EQ(result->pieces.size(), 1U);
  EXPECT_FALSE(result->pieces[0].is_new);
  EXPECT_TRUE(result->completed.empty());
  EXPECT_NEAR(result->removed_mm3, 3.5 * 6.0 * kerf_mm, 0.001);
  // The front lies on the lattice: within 1e-6 mm over its 3 mm2.
  EXPECT_NEAR(result->pieces[0].volume_mm3 + result->removed_mm3, block_mm3, 3e-6);
}

TEST(PiecesJob, AKerfThatGoesOnLaterIsOneCut) {
  const Bone bone = block();
  AttemptGeometry stopped(bone, {}), straight(bone, {});
  freeze(stopped, 0, 5.0);
  sweep(stopped, bone, 0, 5.0, -1.5);
  stopped.run({0, JobKind::Pieces, 0, 0});
  sweep(stopped, bone, 0, 5.0, -4.0);
  const auto later = stopped.run({1, JobKind::Pieces, 0, 0});
  const auto at_once = cut(straight, bone, 0, 5.0);
  ASSERT_EQ(later->pieces.size(), 2U);
  EXPECT_EQ(later->completed, (std::vector<std::int32_t>{0}));
  EXPECT_EQ(later->removed_mm3, at_once->removed_mm3);
  EXPECT_EQ(stopped.solid().mesh, straight.solid().mesh);
}

TEST(PiecesJob, ABodyThatWasTakenOutStaysOutWhenItsKerfGoesOn) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  const auto first = cut(geometry, bone, 0, 5.0);
  CutEvent event;
  event.kind = CutEventKind::PieceRemoved;
  event.subject = 1;
  geometry.apply(event);
  const auto second = cut(geometry, bone, 1, -5.0);
  ASSERT_EQ(second->pieces.size(), 2U);
  EXPECT_EQ(second->pieces[0].id, 0);
  EXPECT_EQ(second->pieces[1].id, 2);
  EXPECT_TRUE(second->pieces[1].is_new);
}

TEST(PiecesJob, APieceKeepsItsNumberWhileNothingCutsIt) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  cut(geometry, bone, 0, 6.0);
  const auto second = cut(geometry, bone, 1, -5.0);
  ASSERT_EQ(second->pieces.size(), 3U);
  EXPECT_EQ(second->pieces[0].id, 0);
  for (const FoundPiece& piece : second->pieces) {
    const bool is_first_piece = piece.volume_mm3 < 4.0 * section_mm2;
    if (is_first_piece) {
      EXPECT_EQ(piece.id, 1);
      EXPECT_FALSE(piece.is_new);
    }
  }
  EXPECT_NEAR(second->removed_mm3, 2.0 * kerf_mm * section_mm2, 0.002);
}

TEST(PiecesJob, ASliverBelowTheLimitIsDebris) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  // One micrometre of the block is left beyond the kerf: 0.024 mm3.
  const auto result = cut(geometry, bone, 0, 0.5 * size_x_mm - 0.5 * kerf_mm - 0.001);
  EXPECT_EQ(result->pieces.size(), 1U);
  EXPECT_NEAR(result->debris_mm3, 0.024, 0.002);
}

TEST(PiecesJob, APieceTakenOutIsNoMoreInTheSolid) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  const auto result = cut(geometry, bone, 0, 5.0);
  CutEvent event;
  event.kind = CutEventKind::PieceRemoved;
  event.subject = 1;
  geometry.apply(event);
  EXPECT_NEAR(signed_volume_mm3(geometry.solid().mesh), result->pieces[0].volume_mm3, 1e-9);
}

TEST(PiecesJob, TheSameHistoryGivesTheSameBits) {
  const Bone bone = block();
  AttemptGeometry one(bone, {}), other(bone, {});
  const auto first = cut(one, bone, 0, 5.0);
  const auto second = cut(other, bone, 0, 5.0);
  EXPECT_EQ(one.solid().mesh, other.solid().mesh);
  EXPECT_EQ(first->removed_mm3, second->removed_mm3);
}

TEST(JobDeathTest, AJobForAKerfThatIsNotThereIsABrokenPromise) {
  const Bone bone = block();
  AttemptGeometry geometry(bone, {});
  EXPECT_DEATH(geometry.run({0, JobKind::Section, 0, 0}), "kerfs_.count");
}

}  // namespace
}  // namespace hallux::simulator
