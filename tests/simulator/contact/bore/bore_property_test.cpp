/// Hands by chance: no jump, no force beyond the limit, no pose that is no pose, no depth that
/// nobody bored.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "simulator/contact/coupling.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

BoreTool random_tool(Random& random) {
  const std::uint64_t kind = random.bits() % 3;
  if (kind == 0) return bore_tool(WireDriver{.wire = {.diameter_mm = random.uniform(0.9, 2.0)}});
  if (kind == 1) return bore_tool(Drill{.bit = {.diameter_mm = random.uniform(1.1, 3.2)}});
  return bore_tool(Screwdriver{.screw = {.length_mm = 10.0, .is_self_drilling = true}});
}

bool is_pose(const RigidTransform& pose) {
  const Quat& turn = pose.rotation;
  const double length =
      std::sqrt(turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
  return is_finite(pose.translation_mm) && std::abs(length - 1.0) < 1.0e-9;
}

/// A hand that goes from target to target about the bone, now gently and now as fast as none.
class AnyHand {
 public:
  AnyHand(Random& random, const RigidTransform& start) : random_(random), pose_(start) {}

  RigidTransform next() {
    if (left_ == 0) {
      from_ = pose_;
      const Vec3 place{random_.uniform(-12.0, 12.0), random_.uniform(4.0, 14.0),
                       random_.uniform(-3.0, 3.0)};
      const Vec3 ahead =
          unit(Vec3{0.0, -1.0, 0.0} + random_.uniform(0.0, 1.2) * random_direction(random_));
      to_ = pointing(place, ahead);
      ticks_ = left_ = 5 + static_cast<int>(random_.bits() % 400);
      runs = random_.bits() % 4 != 0;
    }
    --left_;
    pose_ = interpolate(from_, to_, 1.0 - static_cast<double>(left_) / ticks_);
    return pose_;
  }
  bool runs = true;

 private:
  Random& random_;
  RigidTransform pose_, from_, to_;
  int left_ = 0, ticks_ = 1;
};

RC_GTEST_PROP(BoreProperty, AnyHandIsFollowedWithinTheLimits, (std::uint64_t seed)) {
  Random random(seed);
  BoreWorld world(cortical_bone(solid_block({20.0, 16.0, 10.0})), random_tool(random));
  world.holes.push_back({{3.0, 9.0, 0.0}, {3.0, 0.0, 0.0}, 1.2});
  world.bores.push_back(begin_bore(pointing({3.0, 8.0, 0.0}, {0.0, -1.0, 0.0}), 0.0, 1.2));
  world.bores[0].depth_mm = 9.2;
  world.state.wound_from_tool = pointing({0.0, 12.0, 0.0}, {0.0, -1.0, 0.0});
  AnyHand hand(random, world.state.wound_from_tool);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 before_mm = world.tip_mm();
    const RigidTransform handle = hand.next();
    const BoreOutcome outcome = world.tick(handle, hand.runs);
    RC_ASSERT(is_pose(world.state.wound_from_tool));
    // Along the axis and aside of it each within the limit, and a feed of at most 0.005 mm.
    RC_ASSERT(length_of(world.tip_mm() - before_mm) <= 1.4143 * tick_travel_limit_mm + 0.006);
    RC_ASSERT(length_of(outcome.force_in_wound_newton) <=
              world.settings.force_limit_newton + 1.0e-9);
    RC_ASSERT(length_of(outcome.torque_in_wound_newton_mm) <=
              world.settings.torque_limit_newton_mm + 1.0e-9);
    RC_ASSERT(outcome.advance_mm >= 0.0);
    if (world.state.stage == BoreStage::InBore) continue;
    // Outside of bores a tip is no deeper than a touch, seen from skin and holes.
    const auto found = world.standing().remaining().nearest(world.tip_mm());
    const bool is_inside = world.standing().at(world.tip_mm()) != Tissue::None;
    double depth_mm = is_inside ? found->distance_mm : 0.0;
    for (const Capsule& hole : world.holes)
      depth_mm = std::min(depth_mm, std::max(0.0, distance_mm(hole, world.tip_mm())));
    RC_ASSERT(depth_mm <= 0.45);
  }
}

RC_GTEST_PROP(BoreProperty, NothingIsBoredWithoutARunningDrive, (std::uint64_t seed)) {
  Random random(seed);
  BoreWorld world(cortical_bone(solid_block({20.0, 16.0, 10.0})), random_tool(random));
  world.state.wound_from_tool = pointing({0.0, 12.0, 0.0}, {0.0, -1.0, 0.0});
  AnyHand hand(random, world.state.wound_from_tool);
  for (int i = 0; i < 2000; ++i) {
    const BoreOutcome outcome = world.tick(hand.next(), false);
    RC_ASSERT(!outcome.wants_bore && outcome.advance_mm == 0.0);
  }
  RC_ASSERT(world.bores.empty());
}

RC_GTEST_PROP(BoreProperty, TheSameHandGivesTheSameBits, (std::uint64_t seed)) {
  const auto run = [&] {
    Random random(seed);
    BoreWorld world(cancellous_bone(solid_block({20.0, 16.0, 10.0})), random_tool(random));
    world.state.wound_from_tool = pointing({0.0, 12.0, 0.0}, {0.0, -1.0, 0.0});
    AnyHand hand(random, world.state.wound_from_tool);
    for (int i = 0; i < 1000; ++i) world.tick(hand.next(), hand.runs);
    return world.state.wound_from_tool;
  };
  RC_ASSERT(run() == run());
}

}  // namespace
}  // namespace hallux::tests
