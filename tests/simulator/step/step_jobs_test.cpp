/// Jobs as the step sees them: asked for, late, applied, and what follows from them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::kinds_of;
using tests::SimulationRun;

constexpr double top_mm = 2.0;
constexpr double above_mm = top_mm + 1.0;
/// The block's part beyond the kerf at x = 5: 10 - 5.25 long.
constexpr double piece_mm3 = 4.75 * 4.0 * 6.0;

Bone block() { return tests::cancellous_bone(tests::solid_block({20.0, 4.0, 6.0})); }

/// One stroke at x through the whole block, and the blade withdrawn.
void saw_off(SimulationRun& run, double x_mm) {
  run.glide(blade_down({x_mm, above_mm, 0.0}), 50);
  run.glide(blade_down({x_mm, top_mm - 10.0, 0.0}), 200);
  run.hold(900);
  run.glide(blade_down({x_mm, above_mm + 2.0, 0.0}), 50);
}

std::size_t place_of(const std::vector<CutEventKind>& kinds, CutEventKind kind) {
  return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

TEST(StepJobs, AStrokeThroughTheBoneGoesFromContactToAFreePiece) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  const auto kinds = kinds_of(run.recording());
  const std::vector<CutEventKind> order{CutEventKind::Contact,        CutEventKind::PlaneFrozen,
                                        CutEventKind::SectionKnown,   CutEventKind::Breakthrough,
                                        CutEventKind::SectionCovered, CutEventKind::PieceFreed};
  std::size_t last = 0;
  for (const CutEventKind kind : order) {
    const std::size_t place = place_of(kinds, kind);
    ASSERT_LT(place, kinds.size()) << static_cast<int>(kind);
    EXPECT_GT(place, last) << static_cast<int>(kind);  // the first event is the start
    last = place;
  }
  // The pieces are asked for as the teeth leave the bone and, as the kerf has grown since, when the
  // blade leaves it.
  ASSERT_EQ(run.requests().size(), 3U);
  EXPECT_EQ(run.requests()[0].kind, JobKind::Section);
  EXPECT_EQ(run.requests()[1].kind, JobKind::Pieces);
  EXPECT_EQ(run.requests()[2].kind, JobKind::Pieces);
}

TEST(StepJobs, EventsCarryTheSectionsAreaAndThePiecesVolume) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  const auto known = run.events(CutEventKind::SectionKnown);
  const auto freed = run.events(CutEventKind::PieceFreed);
  ASSERT_EQ(known.size(), 1U);
  ASSERT_EQ(freed.size(), 1U);
  EXPECT_NEAR(static_cast<double>(known[0].value) / 1000.0, 4.0 * 6.0, 0.001);
  EXPECT_NEAR(static_cast<double>(freed[0].value) / 1000.0, piece_mm3, 0.1);
}

TEST(StepJobs, AJobIsAskedForAtTheTickWhoseStateItSees) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  ASSERT_GE(run.requests().size(), 2U);
  EXPECT_EQ(run.requests()[0].tick, run.events(CutEventKind::PlaneFrozen).at(0).tick);
  EXPECT_EQ(run.requests()[1].tick, run.events(CutEventKind::Breakthrough).at(0).tick);
  EXPECT_EQ(run.events(CutEventKind::SectionKnown).at(0).tick, run.requests()[0].tick + 1);
}

TEST(StepJobs, WithoutTheirResultsNothingIsKnownOfSectionsAndPieces) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  run.applies_jobs = false;
  saw_off(run, 5.0);
  EXPECT_TRUE(run.events(CutEventKind::SectionKnown).empty());
  EXPECT_TRUE(run.events(CutEventKind::PieceFreed).empty());
  EXPECT_EQ(run.events(CutEventKind::Breakthrough).size(), 1U);
}

TEST(StepJobs, ALateResultFindsTheSectionCoveredAlready) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  run.applies_jobs = false;
  saw_off(run, 5.0);
  run.applies_jobs = true;
  run.hold(10);
  EXPECT_EQ(run.events(CutEventKind::SectionCovered).size(), 1U);
  EXPECT_EQ(run.events(CutEventKind::PieceFreed).size(), 1U);
}

TEST(StepJobs, AKerfThatStopsInTheBoneIsCommittedWhenTheBladeLeavesIt) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  run.glide(blade_down({5.0, above_mm, 0.0}), 50);
  run.glide(blade_down({5.0, 0.0, 0.0}), 200);
  run.hold(900);
  EXPECT_EQ(run.requests().size(), 1U);
  run.glide(blade_down({5.0, above_mm + 2.0, 0.0}), 200);
  ASSERT_EQ(run.requests().size(), 2U);
  EXPECT_EQ(run.requests()[1].kind, JobKind::Pieces);
  EXPECT_TRUE(run.events(CutEventKind::PieceFreed).empty());
  EXPECT_TRUE(run.events(CutEventKind::SectionCovered).empty());
  EXPECT_LT(signed_volume_mm3(run.jobs().geometry().solid().mesh), 20.0 * 4.0 * 6.0 - 2.0);
}

TEST(StepJobs, AHingeThatWasNotPlannedIsRefusedOnce) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  run.step({{CommandKind::CloseHinge, 0, 0}, {CommandKind::CloseHinge, 0, 0}});
  run.hold(2);
  const auto refused = run.events(CutEventKind::HingeRefused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].subject, static_cast<std::int32_t>(HingeOutcome::FacesMissing));
}

TEST(StepJobs, TeethFindNoBoneWhereAPieceWasPickedUp) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  const std::int32_t piece = run.events(CutEventKind::PieceFreed).at(0).subject;
  run.step({{CommandKind::PickUp, piece, 0}});
  ASSERT_EQ(run.events(CutEventKind::PieceRemoved).size(), 1U);
  run.glide(blade_down({8.0, above_mm + 2.0, 0.0}), 20);
  const std::size_t contacts = run.events(CutEventKind::Contact).size();
  run.glide(blade_down({8.0, -top_mm - 2.0, 0.0}), 100);
  EXPECT_EQ(run.events(CutEventKind::Contact).size(), contacts);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, -top_mm - 2.0, 0.01);
}

TEST(StepJobs, TeethFindBoneInAPieceThatStillLiesThere) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  run.switches = 0;
  run.glide(blade_down({8.0, above_mm + 2.0, 0.0}), 20);
  run.glide(blade_down({8.0, -top_mm - 2.0, 0.0}), 100);
  EXPECT_NEAR(run.bone_from_tool().translation_mm.y, top_mm, 0.15);
}

TEST(StepJobs, APieceIsToldWithItsVolumeAndAPointInsideItWhenItComesFreeAndWhenItGoes) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  run.step({{CommandKind::PickUp, piece_freed_last, 0}});
  const CutEvent freed = run.events(CutEventKind::PieceFreed).at(0);
  const CutEvent removed = run.events(CutEventKind::PieceRemoved).at(0);
  EXPECT_GT(freed.value, 0);
  EXPECT_EQ(removed.value, freed.value);
  EXPECT_EQ(removed.pose, freed.pose);
  const Vec3 inside_mm = transform_from(removed.pose).translation_mm;
  EXPECT_GT(inside_mm.x, 5.25) << "beyond the kerf";
  EXPECT_LT(Bvh(solid_of(bone)).signed_distance_mm(inside_mm), -0.5);
}

TEST(StepJobs, APieceIsPickedUpOnce) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  const std::int32_t piece = run.events(CutEventKind::PieceFreed).at(0).subject;
  run.step({{CommandKind::PickUp, piece, 0}, {CommandKind::PickUp, piece, 0}});
  run.step({{CommandKind::PickUp, piece, 0}});
  EXPECT_EQ(run.events(CutEventKind::PieceRemoved).size(), 1U);
}

TEST(StepJobs, ThePieceThatCameFreeLastCanBePickedUpWithoutItsNumber) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({6.0, above_mm, 0.0}));
  run.step({{CommandKind::PickUp, piece_freed_last, 0}});
  saw_off(run, 6.0);
  saw_off(run, -6.0);
  run.step({{CommandKind::PickUp, piece_freed_last, 0}});
  const auto removed = run.events(CutEventKind::PieceRemoved);
  ASSERT_EQ(removed.size(), 1U);
  EXPECT_EQ(removed[0].subject, run.events(CutEventKind::PieceFreed).at(1).subject);
}

/// The blade is withdrawn while the pieces of the last stroke are worked out: asked for once more,
/// not applied yet.
void saw_off_with_pieces_waiting(SimulationRun& run, double x_mm) {
  saw_off(run, x_mm);
  run.glide(blade_down({-x_mm, above_mm, 0.0}), 50);
  run.glide(blade_down({-x_mm, top_mm - 10.0, 0.0}), 200);
  run.hold(900);
  run.applies_jobs = false;
  run.glide(blade_down({-x_mm, above_mm + 2.0, 0.0}), 50);
}

TEST(StepJobs, APieceAskedForWhileThePiecesAreWorkedOutComesAfterThem) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({6.0, above_mm, 0.0}));
  saw_off_with_pieces_waiting(run, 6.0);
  ASSERT_EQ(run.events(CutEventKind::PieceFreed).size(), 2U);
  run.step({{CommandKind::PickUp, piece_freed_last, 0}});
  run.hold(100);
  EXPECT_TRUE(run.events(CutEventKind::PieceRemoved).empty());
  run.applies_jobs = true;
  run.hold(3);
  const auto removed = run.events(CutEventKind::PieceRemoved);
  ASSERT_EQ(removed.size(), 1U);
  EXPECT_EQ(removed[0].subject, run.events(CutEventKind::PieceFreed).at(1).subject);
  run.hold(100);
  EXPECT_EQ(run.events(CutEventKind::PieceRemoved).size(), 1U);
}

TEST(StepJobs, AHingeAskedForWhileThePiecesAreWorkedOutComesAfterThem) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({6.0, above_mm, 0.0}));
  saw_off_with_pieces_waiting(run, 6.0);
  run.step({{CommandKind::CloseHinge, 0, 0}});
  run.hold(100);
  EXPECT_TRUE(run.events(CutEventKind::HingeRefused).empty());
  run.applies_jobs = true;
  run.hold(4);
  EXPECT_EQ(run.events(CutEventKind::HingeRefused).size(), 1U);
  EXPECT_EQ(run.requests().back().kind, JobKind::Hinge);
}

TEST(StepJobs, TheLargestPieceIsTheBoneAndStays) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({5.0, above_mm, 0.0}));
  saw_off(run, 5.0);
  run.step({{CommandKind::PickUp, 0, 0}});
  EXPECT_TRUE(run.events(CutEventKind::PieceRemoved).empty());
}

TEST(StepJobs, TwoCutsFreeTwoPiecesWithNumbersOfTheirOwn) {
  const Bone bone = block();
  SimulationRun run(bone, blade_down({6.0, above_mm, 0.0}));
  saw_off(run, 6.0);
  saw_off(run, -6.0);
  const auto freed = run.events(CutEventKind::PieceFreed);
  ASSERT_EQ(freed.size(), 2U);
  EXPECT_NE(freed[0].subject, freed[1].subject);
  for (const CutEvent& event : freed) EXPECT_GT(event.subject, 0);
}

}  // namespace
}  // namespace hallux::simulator
