/// A bar that is sawn in two: its halves led, wired and screwed.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "assessment/rebuild/implants.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {

/// On its tray.
inline constexpr std::int32_t bar_wire = 1, bar_drill = 2, bar_screw = 3;

inline simulator::Tray bar_tray() {
  simulator::Screwdriver driver{.screw = simulator::cortical_screws[2]};
  driver.screw.length_mm = 24.0;
  simulator::Drill bit;
  bit.bit.length_mm = 60.0;
  const std::array<simulator::Tool, 3> further{simulator::WireDriver{}, bit, driver};
  return {simulator::Saw{}, further};
}

/// The half beyond the cut is to be led by 4 mm to lateral.
inline scenarios::Plan plan_of_the_end() {
  scenarios::Plan plan;
  plan.fixation.fragments.push_back({.name = "end",
                                     .bone = 0,
                                     .holds_in_bone_mm = {10.0, 0.0, 0.0},
                                     .volume_mm3 = 9.75 * 64.0,
                                     .bone_from_rest = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 4.0}}});
  return plan;
}

class SawnBar : public testing::Test {
 protected:
  static constexpr double cut_x_mm = 5.0, bar_mm3 = 30.0 * 8.0 * 8.0;

  static simulator::Bone bar() {
    simulator::Bone bone = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
    bone.name = "bar";
    return bone;
  }

  explicit SawnBar(simulator::Bone bone = bar()) : bone_(std::move(bone)) {
    run_.glide(tests::blade_down({cut_x_mm, -9.0, 0.0}), 2300);
    run_.hold(1500);
    run_.glide(tests::blade_down({cut_x_mm, 30.0, 0.0}), 400);
    run_.hold(20);
  }
  /// Grips the half beyond the cut, leads it by so much, and lets it go.
  void lead(const Vec3& by_mm, bool impacts = false) {
    run_.step({{simulator::CommandKind::Grip, 1, 0}});
    run_.hold(3);
    run_.glide(tests::blade_down(Vec3{cut_x_mm, 30.0, 0.0} + by_mm), 400);
    if (impacts) {
      run_.step({{simulator::CommandKind::Impact, 0, 0}});
      run_.hold(1200);
    }
    run_.step({{simulator::CommandKind::Release, 0, 0}});
    run_.hold(5);
  }
  /// Along the bar, from its end beyond the cut, until the tip is there.
  void bore(std::int32_t tool, double y_mm, double z_mm, double to_x_mm) {
    const auto at = [&](double x_mm) {
      return tests::pointing({x_mm, y_mm, z_mm}, {-1.0, 0.0, 0.0});
    };
    run_.glide(tests::blade_down({30.0, 40.0, 0.0}), 300);
    run_.glide(at(40.0), 400);
    run_.step({{simulator::CommandKind::ChooseTool, tool, 0}});
    run_.hold(3);
    run_.glide(at(to_x_mm - 6.0), 5000);
    for (int i = 0; i < 30000 && run_.bone_from_tool().translation_mm.x > to_x_mm; ++i)
      run_.hold(1);
  }
  void draw_out() {
    const Vec3 tip_mm = run_.bone_from_tool().translation_mm;
    run_.glide(tests::pointing({80.0, tip_mm.y, tip_mm.z}, {-1.0, 0.0, 0.0}), 800);
    run_.hold(20);
  }
  void leave() {
    run_.step({{simulator::CommandKind::LeaveImplant, 0, 0}});
    draw_out();
  }

  RebuiltBone rebuilt() const { return rebuild(bone_, bar_tray(), run_.recording()); }
  Fixation fixation(const RebuiltBone& rebuilt, const std::vector<Body>& bodies,
                    const scenarios::Plan& plan = {}) const {
    return fixation_of(run_.recording(), rebuilt, bodies, bone_, plan);
  }

  simulator::Bone bone_;
  tests::SimulationRun run_{bone_, tests::blade_down({cut_x_mm, 12.0, 0.0}), bar_tray()};
};

}  // namespace hallux::assessment
