/// The same pushes through a mouse's coupling and through an arm in a hand: what docs/haptics.md
/// says of the difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/device/modelled/modelled_arm.h"
#include "simulator/device/mouse.h"
#include "simulator/record/sample_force.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t last_tick = 4000;
constexpr std::int64_t held_ticks = 500;  ///< above the bone, before the push

/// A pointer led along a motion.
class LedMouse final : public HapticDevice {
 public:
  explicit LedMouse(const HandMotion& motion)
      : pointer_(motion), mouse_(motion.keys.front().world_from_handle) {}
  DeviceDescription description() const override { return mouse_.description(); }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override {
    RawDeviceState wanted;
    pointer_.exchange(Vec3(0.0), tick, wanted);
    mouse_.aim({wanted.world_from_handle, wanted.switches, {}});
    return mouse_.exchange(force_in_world_newton, tick, state);
  }

 private:
  ScriptedDevice pointer_;
  MouseDevice mouse_;
};

/// Held over the block, then a push that goes on as if nothing had given way.
HandMotion pushed_through(const Bone& bone) {
  const auto handle = [&](double y_mm) {
    return bone.world_from_bone * tests::blade_down({5.0, y_mm, 0.2});
  };
  HandMotion motion = tests::sawing_motion(bone, last_tick);
  motion.keys = {{0, handle(2.0), tests::saw_runs},
                 {held_ticks, handle(2.0), tests::saw_runs},
                 {held_ticks + 1000, handle(-9.0), tests::saw_runs},
                 {last_tick, handle(-9.0), tests::saw_runs}};
  return motion;
}

struct Push {
  double wander_mm = 0.0;        ///< of the tool while it is held in the air, root mean square
  double plunge_mm = 0.0;        ///< in the tenth of a second after the break-through
  double greatest_newton = 0.0;  ///< in the bone
};

double depth_mm(const Bone& bone, const ToolSample& sample) {
  const RigidTransform bone_from_tool =
      inverse(bone.world_from_bone) * transform_from(sample.world_from_tool);
  return -bone_from_tool.translation_mm.y;
}

Push pushed_by(HapticDevice& device, const Bone& bone, const HandMotion& motion) {
  const Recording recording =
      tests::record(tests::setup_for(bone, motion, last_tick), device).recording;
  Push push;
  double mean_mm = 0.0, square_mm2 = 0.0;
  constexpr std::int64_t first = 100;  // at rest by then
  for (std::int64_t tick = first; tick < held_ticks; ++tick) {
    const double mm = depth_mm(bone, recording.samples.at(static_cast<std::size_t>(tick)));
    mean_mm += mm / static_cast<double>(held_ticks - first);
    square_mm2 += mm * mm / static_cast<double>(held_ticks - first);
  }
  push.wander_mm = std::sqrt(std::max(square_mm2 - mean_mm * mean_mm, 0.0));
  const auto through =
      std::find_if(recording.events.begin(), recording.events.end(),
                   [](const CutEvent& event) { return event.kind == CutEventKind::Breakthrough; });
  EXPECT_NE(through, recording.events.end());
  if (through == recording.events.end()) return push;
  const auto at = static_cast<std::size_t>(through->tick);
  push.plunge_mm =
      depth_mm(bone, recording.samples.at(at + 100)) - depth_mm(bone, recording.samples.at(at));
  for (std::size_t tick = 0; tick < at; ++tick) {
    push.greatest_newton =
        std::max(push.greatest_newton, force_size_newton(recording.samples[tick]));
  }
  return push;
}

TEST(MouseAgainstArm, TheMouseIsStillerAndPlungesLessAsIsStated) {
  const Bone bone = tests::loop_block();
  const HandMotion motion = pushed_through(bone);
  LedMouse mouse(motion);
  ModelledArm arm(motion, {});
  const Push by_mouse = pushed_by(mouse, bone, motion), by_arm = pushed_by(arm, bone, motion);
  EXPECT_LT(by_mouse.wander_mm, 0.001);
  EXPECT_NEAR(by_arm.wander_mm, ModelledHand{}.tremor_mm, 0.02) << "the tremor of the hand";
  EXPECT_NEAR(by_mouse.plunge_mm, 7.6, 0.3);
  EXPECT_NEAR(by_arm.plunge_mm, 8.6, 0.3);
  EXPECT_NEAR(by_mouse.greatest_newton, 6.2, 0.3);
  EXPECT_NEAR(by_arm.greatest_newton, 7.0, 0.3);
}

}  // namespace
}  // namespace hallux::simulator
