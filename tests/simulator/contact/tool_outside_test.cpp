/// The blade outside a kerf: its faces and edges meet bone, slide on it with friction, and come
/// after bone that is gone.
#include "simulator/contact/tool_outside.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulator/base/random.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr double top_mm = 10.0;
/// The faces are half a kerf from the blade's middle.
constexpr double half_blade_mm = 0.25;

double length(const Vec3& way) { return std::sqrt(glm::dot(way, way)); }

/// The blade's face towards the block's top: teeth towards +x, tooth line along z.
RigidTransform flat_at(const Vec3& tip_mm) {
  return {rotation_from_axes(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 1.0}), tip_mm};
}

/// The blade on its edge: tooth line along y.
RigidTransform on_edge_at(const Vec3& tip_mm) {
  return {rotation_from_axes(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}), tip_mm};
}

class World {
 public:
  World(IndexedMesh mesh, const RigidTransform& start)
      : bone_(tests::cortical_bone(std::move(mesh))) {
    tool.bone_from_tool = start;
  }

  ToolOutcome hold(const RigidTransform& bone_from_handle, int ticks, bool saw_runs = false) {
    ToolOutcome outcome;
    for (int i = 0; i < ticks; ++i) {
      outcome = move_tool(tool, {saw, bone_from_handle, saw_runs}, standing(), settings);
    }
    return outcome;
  }
  ToolOutcome glide(const RigidTransform& bone_from_handle, int ticks) {
    const RigidTransform from = tool.knows_handle ? tool.bone_from_handle : tool.bone_from_tool;
    ToolOutcome outcome;
    for (int i = 1; i <= ticks; ++i) {
      outcome = hold(interpolate(from, bone_from_handle, static_cast<double>(i) / ticks), 1);
    }
    return outcome;
  }
  RemainingTissue standing() const { return {tissue_, kerfs_, gone}; }
  const Bone& bone() const { return bone_; }
  Vec3 tip_mm() const { return tool.bone_from_tool.translation_mm; }
  /// How deep the deepest face or edge is in bone.
  double depth_mm() const {
    OfFragments<BladeMemory> nothing;
    double depth = 0.0;
    const auto contacts = find_contacts(tool.bone_from_tool, standing(), 0.1, nothing);
    for (const BladeContact& contact : contacts.all()) {
      if (!contact.is_tooth) depth = std::max(depth, -contact.gap_mm);
    }
    return depth;
  }

  ToolState tool;
  Saw saw;
  ContactSettings settings;
  std::vector<const Bvh*> gone;

 private:
  Bone bone_;
  TissueMap tissue_{bone_};
  KerfSet kerfs_{{}, bone_.world_from_bone};
};

World block_below(const RigidTransform& start) {
  return {tests::solid_block({40.0, 20.0, 6.0}), start};
}

TEST(LaidBlade, BoneHoldsAFaceAndPushesBackWithTheSpring) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  const ToolOutcome outcome = world.glide(flat_at({10.0, top_mm - 3.0, 0.0}), 200);
  EXPECT_EQ(world.tool.stage, ToolStage::Free);  // no tooth stands in bone
  EXPECT_NEAR(world.tip_mm().y, top_mm + half_blade_mm, 0.005);
  EXPECT_NEAR(outcome.force_in_bone_newton.y, 2.0 * (3.0 + half_blade_mm), 0.02);
  // The hand pulls at the teeth, the nearest point of the face lies a millimetre behind them.
  EXPECT_NEAR(length(outcome.torque_in_bone_newton_mm), 1.0 * 2.0 * (3.0 + half_blade_mm), 1.0);
  EXPECT_FALSE(outcome.began_contact);
}

TEST(LaidBlade, BoneHoldsAnEdge) {
  World world = block_below(on_edge_at({10.0, top_mm + 7.0, 0.0}));
  const ToolOutcome outcome = world.glide(on_edge_at({10.0, top_mm + 3.0, 0.0}), 200);
  EXPECT_NEAR(world.tip_mm().y, top_mm + 5.0, 0.01);
  EXPECT_NEAR(outcome.force_in_bone_newton.y, 2.0 * 2.0, 0.04);
}

TEST(LaidBlade, NoHandIsFastEnoughToCarryAFaceThroughBone) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  world.hold(flat_at({10.0, -40.0, 0.0}), 100);
  // Bent down a little over the first row.
  EXPECT_NEAR(world.tip_mm().y, top_mm + half_blade_mm, 0.04);
}

TEST(LaidBlade, ATiltedHandIsTurnedTowardsTheSurface) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  RigidTransform tilted = flat_at({10.0, top_mm - 2.0, 0.0});
  tilted.rotation = normalised(rotation_about(Vec3{0.0, 0.0, 1.0}, 0.05) * tilted.rotation);
  const ToolOutcome outcome = world.glide(tilted, 200);
  world.hold(tilted, 50);
  EXPECT_LT(world.depth_mm(), 0.005);
  const ProxyMotion stretch = motion_between(tilted, world.tool.bone_from_tool);
  EXPECT_LT(stretch.rotation_rad.z, -0.002);  // towards lying flat
  EXPECT_NEAR(outcome.torque_in_bone_newton_mm.z,
              world.settings.torsion_newton_mm_per_rad * stretch.rotation_rad.z, 0.5);
}

TEST(LaidBlade, FrictionHoldsItAndThenLetsItSlide) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  world.glide(flat_at({10.0, top_mm - 3.0, 0.0}), 200);
  const double normal_mm = 3.0 + half_blade_mm;
  ToolOutcome outcome = world.glide(flat_at({10.0, top_mm - 3.0, 0.28 * normal_mm}), 100);
  EXPECT_NEAR(world.tip_mm().z, 0.0, 0.001);
  EXPECT_NEAR(outcome.force_in_bone_newton.z, -2.0 * 0.28 * normal_mm, 0.01);
  outcome = world.glide(flat_at({10.0, top_mm - 3.0, 3.0}), 300);
  EXPECT_NEAR(world.tip_mm().z, 3.0 - 0.18 * normal_mm, 0.01);
  EXPECT_NEAR(outcome.force_in_bone_newton.z, -2.0 * 0.18 * normal_mm, 0.02);
}

TEST(LaidBlade, BoneThatIsGoneLetsItComeAtTwoTenthsOfAMetreASecond) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  const RigidTransform pressed = flat_at({10.0, top_mm - 3.0, 0.0});
  world.glide(pressed, 200);
  const Bvh all(world.bone().outer);
  world.gone = {&all};
  double last_mm = world.tip_mm().y;
  int ticks = 0;
  while (world.tip_mm().y > top_mm - 3.0 + 0.001 && ticks < 100) {
    world.hold(pressed, 1);
    EXPECT_LE(last_mm - world.tip_mm().y, 0.2 + 1e-9);
    last_mm = world.tip_mm().y;
    ++ticks;
  }
  EXPECT_NEAR(ticks, (3.0 + half_blade_mm) / 0.2, 1.0);
  EXPECT_EQ(world.hold(pressed, 2).force_in_bone_newton, Vec3(0.0, 0.0, 0.0));
}

TEST(LaidBlade, SlippingOffABoneIsNoJumpEither) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  world.glide(flat_at({10.0, top_mm - 3.0, 0.0}), 200);
  double last_mm = world.tip_mm().y;
  for (int i = 1; i <= 400; ++i) {
    world.hold(flat_at({10.0, top_mm - 3.0, 0.03 * i}), 1);
    EXPECT_LE(last_mm - world.tip_mm().y, 0.2 + 0.03 + 1e-9);
    last_mm = world.tip_mm().y;
  }
  EXPECT_NEAR(world.tip_mm().y, top_mm - 3.0, 1e-6);
}

/// The blade in the x-y plane, one corner down: its teeth go to +x and down.
RigidTransform corner_down_at(const Vec3& tip_mm, double down_rad) {
  const Quat turn = rotation_about(Vec3{0.0, 0.0, 1.0}, -down_rad);
  return {normalised(turn * on_edge_at({}).rotation), tip_mm};
}

class CornerOfARunningBlade : public testing::TestWithParam<double> {
 protected:
  /// Pushed along its feed by four millimetres, from just above the block, until a kerf is wanted.
  bool is_cut_into(bool saw_runs) {
    const RigidTransform above = corner_down_at({10.0, top_mm + 5.5, 0.0}, GetParam());
    const Vec3 ahead = axis_x(above);
    for (int tick = 0; tick < 3000; ++tick) {
      const double way_mm = std::min(0.004 * tick, 4.0 / -ahead.y);
      const RigidTransform hand{above.rotation, above.translation_mm + way_mm * ahead};
      if (world_.hold(hand, 1, saw_runs).wants_freeze) return true;
    }
    return false;
  }

  World world_ = block_below(corner_down_at({10.0, top_mm + 5.5, 0.0}, GetParam()));
};

TEST_P(CornerOfARunningBlade, CutsIntoBoneThatItsTeethDoNotStandBefore) {
  EXPECT_TRUE(is_cut_into(true));
  EXPECT_LT(world_.depth_mm(), 0.005);
}

TEST_P(CornerOfARunningBlade, StandsOnBoneWhileTheSawIsOff) { EXPECT_FALSE(is_cut_into(false)); }

/// Of its feed to the bone's surface [rad]: 40, 30 and 20 degrees.
INSTANTIATE_TEST_SUITE_P(Angles, CornerOfARunningBlade, testing::Values(0.698, 0.524, 0.349));

/// Whatever a hand does at a round bone: no face stays in it.
TEST(LaidBlade, StaysOutOfARoundBoneInAnyHand) {
  Random random(7, "laid blade");
  World world(
      {tests::hollow_tube(
          {.outer_radius_mm = 6.0, .inner_radius_mm = 0.0, .length_mm = 30.0, .segments = 48})},
      flat_at({10.0, 8.0, 0.0}));
  double deepest_mm = 0.0;
  for (int way = 0; way < 60; ++way) {
    const auto within = [&](double size) { return random.uniform(-size, size); };
    RigidTransform pose = flat_at({10.0 + within(6.0), 6.5 + within(2.5), within(6.0)});
    pose.rotation = normalised(rotation_about(Vec3{0.0, 0.0, 1.0}, within(0.3)) *
                               rotation_about(Vec3{1.0, 0.0, 0.0}, within(0.4)) * pose.rotation);
    for (int i = 0; i < 100; ++i) {
      world.hold(interpolate(world.tool.bone_from_handle, pose, 0.03), 1);
      deepest_mm = std::max(deepest_mm, world.depth_mm());
    }
  }
  EXPECT_LT(deepest_mm, 0.06);
}

TEST(LaidBlade, AnswersDoNotDependOnWhatWasAskedBefore) {
  World world = block_below(flat_at({10.0, top_mm + 2.0, 0.0}));
  OfFragments<BladeMemory> memory;
  for (int i = 0; i < 200; ++i) {
    const RigidTransform pose =
        on_edge_at({0.1 * i - 10.0, top_mm + 5.0 + 0.3 * std::sin(0.1 * i), 1.0});
    OfFragments<BladeMemory> nothing;
    const BladeContacts known = find_contacts(pose, world.standing(), 0.25, memory);
    const BladeContacts asked = find_contacts(pose, world.standing(), 0.25, nothing);
    ASSERT_EQ(known.count, asked.count);
    for (std::size_t c = 0; c < known.count; ++c) {
      EXPECT_EQ(known.list[c].gap_mm, asked.list[c].gap_mm);
      EXPECT_EQ(known.list[c].normal, asked.list[c].normal);
    }
  }
}

}  // namespace
}  // namespace hallux::simulator
