#include "simulator/history/bone_history.h"

#include <gtest/gtest.h>

#include "assessment/rebuild/opened_fields.h"
#include "simulator/history/bone_moment.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::SimulationRun;

constexpr double above_mm = 5.0;

/// 20 x 4 x 6 mm about the origin: kerfs at x = -6 and 6 leave two ends of 3.75 mm.
Bone block() { return tests::cancellous_bone(tests::solid_block({20.0, 4.0, 6.0})); }

constexpr Vec3 in_near_end(-8.0, 0.0, 0.0), in_far_end(8.0, 0.0, 0.0), in_middle(0.0, 0.0, 0.0);

/// An attempt by the step itself, in which both ends come free and one of them is picked up.
class TwinsAttempt {
 public:
  explicit TwinsAttempt(std::int32_t piece) : bone_(block()), run_(bone_, pose(-6.0)) {
    saw_off(-6.0);
    saw_off(6.0);
    run_.step({{CommandKind::PickUp, piece, 0}});
    run_.hold(5);
  }

  /// Whether bone stands at a place, by the attempt's own jobs.
  bool stands(const Vec3& point_in_bone_mm) const {
    return Bvh(run_.jobs().geometry().solid().mesh).contains(point_in_bone_mm);
  }
  std::vector<CutEvent> events(CutEventKind kind) const { return run_.events(kind); }
  std::shared_ptr<const BoneHistory> history() const {
    return build_history(
        {bone_, run_.recording(), assessment::opened_fields({}, bone_, run_.recording()), {}});
  }

 private:
  static RigidTransform pose(double x_mm) { return blade_down({x_mm, above_mm, 0.0}); }
  void saw_off(double x_mm) {
    run_.glide(pose(x_mm), 200);
    run_.glide(blade_down({x_mm, -8.0, 0.0}), 200);
    run_.hold(900);
    run_.glide(pose(x_mm), 50);
  }

  Bone bone_;
  SimulationRun run_;
};

class TwinPieces : public testing::TestWithParam<std::int32_t> {};

/// By volume nobody could tell which of the two is out.
TEST_P(TwinPieces, TheReplayTakesOutThePieceThatTheAttemptTookOut) {
  const TwinsAttempt attempt(GetParam());
  const auto freed = attempt.events(CutEventKind::PieceFreed);
  ASSERT_EQ(freed.size(), 2U);
  EXPECT_EQ(freed[0].value, freed[1].value);
  ASSERT_EQ(attempt.events(CutEventKind::PieceRemoved).size(), 1U);
  ASSERT_NE(attempt.stands(in_near_end), attempt.stands(in_far_end));

  const std::shared_ptr<const BoneHistory> history = attempt.history();
  ASSERT_EQ(history->fragments.size(), 1U);
  ASSERT_EQ(history->fragments[0].taken.size(), 1U);
  const Bvh& body = *history->fragments[0].taken.front().body;
  EXPECT_EQ(body.contains(in_near_end), !attempt.stands(in_near_end));
  EXPECT_EQ(body.contains(in_far_end), !attempt.stands(in_far_end));
  EXPECT_FALSE(body.contains(in_middle));
}

TEST_P(TwinPieces, ARayFindsBoneWhereTheAttemptHasSome) {
  const TwinsAttempt attempt(GetParam());
  const std::shared_ptr<const BoneHistory> history = attempt.history();
  BoneMoment moment(*history);
  const std::int64_t removed_tick = history->fragments[0].taken.at(0).tick;
  const RigidTransform& world_from_bone = history->world_from_bones.front();
  const Vec3 up(0.0, 10.0, 0.0), down(0.0, -1.0, 0.0);
  const auto hits = [&](const Vec3& place) {
    return moment
        .first_hit(transform_point(world_from_bone, place + up),
                   transform_direction(world_from_bone, down))
        .has_value();
  };
  moment.move_to(removed_tick - 1);
  EXPECT_TRUE(hits(in_near_end));
  EXPECT_TRUE(hits(in_far_end));
  moment.move_to(removed_tick);
  for (const Vec3& place : {in_near_end, in_far_end, in_middle}) {
    EXPECT_EQ(hits(place), attempt.stands(place)) << place.x;
  }
}

TEST_P(TwinPieces, TheKerfAtHandIsTheOneThatGrewLastAsFarAsItIsOpen) {
  const TwinsAttempt attempt(GetParam());
  const std::shared_ptr<const BoneHistory> history = attempt.history();
  BoneMoment moment(*history);
  moment.move_to(0);
  EXPECT_FALSE(moment.kerf_at_hand());
  const auto at_hand = [&](std::int64_t tick) {
    moment.move_to(tick);
    const std::optional<KerfAtHand> kerf = moment.kerf_at_hand();
    EXPECT_TRUE(kerf.has_value() && !kerf->opening.opened_mm.empty()) << tick;
    return kerf->opening.plane.bone_from_kerf.translation_mm.x;
  };
  const std::int64_t second = history->kerfs.at(1).ticks.front();
  EXPECT_NEAR(at_hand(history->kerfs.at(0).ticks.front()), -6.0, 1.0e-3);
  EXPECT_NEAR(at_hand(second - 1), -6.0, 1.0e-3) << "away from it, it stays the last";
  EXPECT_NEAR(at_hand(second), 6.0, 1.0e-3);
  EXPECT_NEAR(at_hand(history->fragments[0].taken.at(0).tick + 1), 6.0, 1.0e-3);
}

INSTANTIATE_TEST_SUITE_P(BoneHistory, TwinPieces, testing::Values(1, 2));

/// Two blocks that lie apart and turned; nothing was sawn.
BoneHistory two_bones() {
  BoneHistory history;
  history.world_from_bones = {
      {rotation_about(Vec3(0.0, 1.0, 0.0), 0.5), Vec3(5.0, 0.0, 0.0)},
      {rotation_about(Vec3(0.0, 0.0, 1.0), 1.0), Vec3(5.0, 0.0, 40.0)},
  };
  for (const std::int32_t bone : {0, 1}) {
    FragmentHistory& fragment = history.fragments.emplace_back();
    fragment.origin.bone = bone;
    fragment.whole = std::make_unique<WholeBone>(block().outer);
  }
  return history;
}

TEST(BoneHistory, APlaceSaidInTheFirstBonesFrameIsOnTheBoneThatHoldsIt) {
  const BoneHistory history = two_bones();
  for (const std::int32_t bone : {0, 1}) {
    const PlaceOnFragment place{bone, in_far_end};
    const PlaceOnFragment again = history.place_at_last(history.point_in_first_mm(place));
    EXPECT_EQ(again.fragment, bone);
    EXPECT_NEAR(length_of(again.point_mm - in_far_end), 0.0, 1.0e-12);
  }
}

}  // namespace
}  // namespace hallux::simulator
