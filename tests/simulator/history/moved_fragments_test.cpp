/// A bar that is sawn in two; its free half is moved, sawn and taken out: at each moment again.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "assessment/rebuild/rebuild.h"
#include "simulator/history/bone_moment.h"
#include "tests/simulator/history/shown_solid.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using testing::shown_mm3;
using testing::standing_count;
using tests::blade_down;

constexpr double cut_x_mm = 5.0, moved_z_mm = 4.0;
constexpr double bar_mm3 = 30.0 * 8.0 * 8.0, half_mm3 = 9.75 * 64.0;

/// The attempt, with the ticks at which something of it was done.
class MovedBar {
 public:
  MovedBar() {
    saw(cut_x_mm, 0.0);
    note("sawn");
    run_.step({{CommandKind::Grip, piece_freed_last, 0}});
    run_.hold(3);
    note("gripped");
    run_.glide(blade_down({cut_x_mm, 30.0, moved_z_mm}), 400);
    note("led");
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(2);
    note("released");
    saw(10.0, moved_z_mm);
    note("sawn in the half");
    run_.step({{CommandKind::PickUp, piece_freed_last, 0}});
    run_.hold(2);
    note("end taken");
    saw(-5.0, 0.0);
    note("sawn in the bone");
    run_.step({{CommandKind::PickUp, 1, 0}});
    run_.hold(2);
    note("half taken");
    history_ = build_history(
        {bone_, run_.recording(), assessment::opened_fields({}, bone_, run_.recording()), {}});
  }

  const BoneHistory& history() const { return *history_; }
  const Bone& bone() const { return bone_; }
  const Recording& recording() const { return run_.recording(); }
  std::int64_t tick(const std::string& done) const { return ticks_.at(done); }
  /// What scoring rebuilds of the recording up to a tick.
  assessment::RebuiltBone rebuilt(std::int64_t tick) const {
    Recording until = run_.recording();
    std::erase_if(until.samples, [&](const auto& sample) { return sample.tick > tick; });
    std::erase_if(until.events, [&](const auto& event) { return event.tick > tick; });
    return assessment::rebuild(bone_, {}, until);
  }

 private:
  void saw(double x_mm, double z_mm) {
    run_.glide(blade_down({x_mm, 12.0, z_mm}), 300);
    run_.glide(blade_down({x_mm, -9.0, z_mm}), 2000);
    run_.hold(1500);
    run_.glide(blade_down({x_mm, 30.0, z_mm}), 400);
    run_.hold(20);
  }
  void note(const std::string& done) { ticks_[done] = run_.recording().samples.back().tick; }

  Bone bone_ = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
  tests::SimulationRun run_{bone_, blade_down({cut_x_mm, 12.0, 0.0})};
  std::map<std::string, std::int64_t> ticks_;
  std::shared_ptr<const BoneHistory> history_;
};

/// The attempt is made once.
class MovedFragments : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { shared_bar = std::make_unique<MovedBar>(); }
  static void TearDownTestSuite() { shared_bar.reset(); }

  BoneMoment moment_at(const std::string& done) const {
    BoneMoment moment(shared_bar->history());
    moment.move_to(shared_bar->tick(done));
    return moment;
  }
  const MovedBar& bar() const { return *shared_bar; }

 private:
  static inline std::unique_ptr<MovedBar> shared_bar;
};

/// Of a fragment's pieces that scoring finds and nobody took out.
double rebuilt_mm3(const assessment::RebuiltBone& rebuilt, std::size_t fragment) {
  const assessment::RebuiltFragment& own = rebuilt.fragments[fragment];
  double sum_mm3 = 0.0;
  for (std::size_t i = own.first_piece; i < own.first_piece + own.piece_count; ++i)
    if (!rebuilt.is_piece_out[i]) sum_mm3 += rebuilt.piece_volumes_mm3[i];
  return sum_mm3;
}

TEST_F(MovedFragments, AreThereFromWhenTheyPartUntilTheyAreTakenOut) {
  EXPECT_EQ(standing_count(moment_at("sawn")), 1);
  EXPECT_EQ(standing_count(moment_at("gripped")), 2);
  EXPECT_EQ(standing_count(moment_at("sawn in the bone")), 2);
  EXPECT_EQ(standing_count(moment_at("half taken")), 1);
  EXPECT_FALSE(moment_at("half taken").fragment(1).is_there());
}

TEST_F(MovedFragments, HoldAtEachMomentWhatScoringRebuilds) {
  for (const char* done :
       {"sawn", "gripped", "released", "sawn in the half", "end taken", "sawn in the bone"}) {
    const BoneMoment moment = moment_at(done);
    const assessment::RebuiltBone rebuilt = bar().rebuilt(bar().tick(done));
    ASSERT_EQ(standing_count(moment), std::ssize(rebuilt.fragments)) << done;
    for (std::int32_t number = 0; number < standing_count(moment); ++number) {
      EXPECT_NEAR(shown_mm3(moment.fragment(number)),
                  rebuilt_mm3(rebuilt, static_cast<std::size_t>(number)), 1.0e-6 * bar_mm3)
          << done << ", fragment " << number;
      EXPECT_EQ(moment.world_from_fragment(number).translation_mm,
                rebuilt.fields.fragments()[number].world_from_fragment.translation_mm)
          << done << ", fragment " << number;
    }
  }
}

TEST_F(MovedFragments, APieceOfAFragmentIsShownNoMoreOnceItIsTakenOut) {
  const double sawn_mm3 = shown_mm3(moment_at("sawn in the half").fragment(1));
  EXPECT_LT(sawn_mm3, half_mm3);
  const double left_mm3 = shown_mm3(moment_at("end taken").fragment(1));
  EXPECT_NEAR(sawn_mm3 - left_mm3, 64.0 * 4.5, 0.5) << "the smaller part, from 5.25 to 9.75 mm";
}

TEST_F(MovedFragments, LieWhileTheyAreHeldWhereTheSamplesSay) {
  BoneMoment moment(bar().history());
  for (std::int64_t tick = bar().tick("gripped"); tick <= bar().tick("led"); tick += 40) {
    moment.move_to(tick);
    const RigidTransform said =
        transform_from(bar().recording().samples[static_cast<std::size_t>(tick)].world_from_tool);
    ASSERT_EQ(bar().recording().samples[static_cast<std::size_t>(tick)].tick, tick);
    EXPECT_EQ(moment.world_from_fragment(1).translation_mm, said.translation_mm);
    EXPECT_EQ(moment.world_from_fragment(1).rotation, said.rotation);
  }
  const RigidTransform bone_from_half =
      inverse(bar().bone().world_from_bone) * moment.world_from_fragment(1);
  EXPECT_NEAR(bone_from_half.translation_mm.z, moved_z_mm, 0.05);
}

TEST_F(MovedFragments, AreTheSameHoweverOneComesToTheMoment) {
  BoneMoment forwards(bar().history());
  std::vector<std::pair<double, double>> shown;
  const std::int64_t last_tick = bar().recording().samples.back().tick;
  for (std::int64_t tick = 0; tick <= last_tick; tick += 97) {
    forwards.move_to(tick);
    shown.emplace_back(shown_mm3(forwards.fragment(0)), shown_mm3(forwards.fragment(1)));
  }
  BoneMoment backwards(bar().history());
  for (std::size_t i = shown.size(); i-- > 0;) {
    backwards.move_to(97 * static_cast<std::int64_t>(i));
    EXPECT_EQ(shown[i],
              std::pair(shown_mm3(backwards.fragment(0)), shown_mm3(backwards.fragment(1))))
        << 97 * i;
  }
}

TEST_F(MovedFragments, ARayMeetsThemWhereTheyLie) {
  const RigidTransform& world_from_bone = bar().bone().world_from_bone;
  const auto hit = [&](const BoneMoment& moment, const Vec3& over_mm) {
    return moment.first_hit(transform_point(world_from_bone, over_mm),
                            transform_direction(world_from_bone, Vec3(0.0, -1.0, 0.0)));
  };
  // Beside the bar, over where the half was moved to.
  const Vec3 beside_mm(8.0, 20.0, 6.0);
  EXPECT_FALSE(hit(moment_at("sawn"), beside_mm));
  const auto met = hit(moment_at("released"), beside_mm);
  ASSERT_TRUE(met.has_value());
  EXPECT_EQ(met->fragment, 1);
  EXPECT_NEAR(met->point_mm.z, 6.0 - moved_z_mm, 0.02) << "in the half's own frame";
  EXPECT_FALSE(hit(moment_at("half taken"), beside_mm));
  const auto on_bone = hit(moment_at("released"), Vec3(-8.0, 20.0, 0.0));
  ASSERT_TRUE(on_bone.has_value());
  EXPECT_EQ(on_bone->fragment, 0);
}

TEST_F(MovedFragments, APlaceGoesWithTheFragmentThatItIsOnAtLast) {
  const Vec3 on_half_mm(8.0, 4.0, 0.0), on_bone_mm(-8.0, 4.0, 0.0);
  const PlaceOnFragment half = bar().history().place_at_last({0, on_half_mm});
  EXPECT_EQ(half.fragment, 1);
  EXPECT_EQ(bar().history().place_at_last({0, on_bone_mm}).fragment, 0);
  const RigidTransform bone_from_world = inverse(bar().bone().world_from_bone);
  const auto place_at = [&](const char* done) {
    return transform_point(bone_from_world, moment_at(done).world_place_mm(half));
  };
  EXPECT_NEAR(length_of(place_at("sawn") - on_half_mm), 0.0, 1.0e-9);
  EXPECT_NEAR(length_of(place_at("released") - on_half_mm - Vec3(0.0, 0.0, moved_z_mm)), 0.0, 0.05);
}

TEST_F(MovedFragments, TheKerfAtHandSaysItsFragment) {
  const auto fragment_at = [&](const char* done) {
    BoneMoment moment = moment_at(done);
    const std::optional<KerfAtHand> kerf = moment.kerf_at_hand();
    EXPECT_TRUE(kerf && !kerf->opening.opened_mm.empty()) << done;
    return kerf ? kerf->fragment : -1;
  };
  EXPECT_EQ(fragment_at("sawn"), 0);
  EXPECT_EQ(fragment_at("sawn in the half"), 1);
  EXPECT_EQ(fragment_at("sawn in the bone"), 0);
}

TEST_F(MovedFragments, TheSameMomentAgainChangesNothing) {
  BoneMoment moment = moment_at("led");
  const std::uint64_t revision = moment.revision();
  moment.move_to(bar().tick("led"));
  EXPECT_EQ(moment.revision(), revision);
  moment.move_to(bar().tick("led") - 50);
  EXPECT_NE(moment.revision(), revision) << "the half lies elsewhere";
  EXPECT_NE(moment.revision_of(0), moment.revision_of(1));
}

TEST_F(MovedFragments, TheHandHeldTheHalfInBetween) {
  const HandHistory& hand = bar().history().hand;
  ASSERT_EQ(hand.grips.size(), 1U);
  EXPECT_EQ(hand.grip_at(bar().tick("sawn")), nullptr);
  ASSERT_NE(hand.grip_at(bar().tick("led")), nullptr);
  EXPECT_EQ(hand.grip_at(bar().tick("led"))->fragment, 1);
  EXPECT_EQ(hand.grip_at(bar().tick("released")), nullptr);
  EXPECT_EQ(hand.tool_at(bar().tick("led")), 0);
}

}  // namespace
}  // namespace hallux::simulator
