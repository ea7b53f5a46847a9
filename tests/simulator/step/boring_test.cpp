/// Wires, drills and screws in the hand: a bar of bone that is bored, and one that is sawn in two
/// and held by what stays in it.
#include <gtest/gtest.h>

#include <array>

#include "simulator/base/units.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::pointing;
using tests::SimulationRun;

constexpr double length_mm = 30.0, height_mm = 8.0, width_mm = 8.0, top_mm = 4.0;
constexpr std::int32_t saw = 0, wire = 1, drill = 2, screw = 3, thin_wire = 4, fine_saw = 5;
constexpr Command leave{CommandKind::LeaveImplant, 0, 0};
constexpr Command grip_last{CommandKind::Grip, piece_freed_last, 0};
constexpr Command release{CommandKind::Release, 0, 0};
const Vec3 down{0.0, -1.0, 0.0};

Command take(std::int32_t implant) { return {CommandKind::TakeImplant, implant, 0}; }
Command choose(std::int32_t place) { return {CommandKind::ChooseTool, place, 0}; }

Tray tray() {
  WireDriver thin;
  thin.wire.diameter_mm = 1.1;
  Screwdriver driver{.screw = cortical_screws[2]};
  driver.screw.length_mm = 7.0;
  const Saw fine{.blade = {.width_mm = 6.0, .depth_mm = 20.0, .kerf_mm = 0.4, .thickness_mm = 0.3}};
  const std::array<Tool, 5> further{WireDriver{}, Drill{}, driver, thin, fine};
  return {Saw{}, further};
}

Bone bar() { return tests::cancellous_bone(tests::solid_block({length_mm, height_mm, width_mm})); }

class Boring : public testing::Test {
 protected:
  void take_up(std::int32_t place, const RigidTransform& handle) {
    run_.glide(handle, 200);
    run_.step({choose(place)});
    run_.hold(3);
  }
  /// Bores from above at a place until the tip is so high.
  void bore(std::int32_t place, const Vec3& at_mm, double to_y_mm, std::int64_t ticks = 3000) {
    take_up(place, pointing({at_mm.x, 12.0, at_mm.z}, down));
    run_.glide(pointing({at_mm.x, to_y_mm - 6.0, at_mm.z}, down), ticks);
    hold_until(to_y_mm);
  }
  void hold_until(double y_mm) {
    for (int i = 0; i < 8000 && run_.bone_from_tool().translation_mm.y > y_mm; ++i) run_.hold(1);
  }
  void draw_out(const Vec3& at_mm) {
    run_.glide(pointing({at_mm.x, 30.0, at_mm.z}, down), 600);
    run_.hold(20);
  }
  void leave_wire(std::int32_t place, const Vec3& at_mm, double to_y_mm) {
    bore(place, at_mm, to_y_mm);
    run_.step({leave});
    draw_out(at_mm);
  }
  std::size_t count(CutEventKind kind) const { return run_.events(kind).size(); }
  bool is_replayed() const { return replay(run_.recording(), {bone_, tray()}).is_identical; }

  Bone bone_ = bar();
  SimulationRun run_{bone_, blade_down({-10.0, 20.0, 0.0}), tray()};
};

TEST_F(Boring, AToolIsChosenFromTheTray) {
  take_up(wire, pointing({0.0, 20.0, 0.0}, down));
  ASSERT_EQ(count(CutEventKind::ToolChosen), 1U);
  EXPECT_EQ(run_.events(CutEventKind::ToolChosen)[0].subject, wire);
  EXPECT_EQ(run_.simulation().tool_in_hand(), wire);
  EXPECT_NEAR(run_.bone_from_tool().translation_mm.y, 20.0, 0.001);
}

TEST_F(Boring, RefusesAToolThatIsNotThereAndOneWhileTheOtherStandsInBone) {
  const auto refused = [&] { return run_.events(CutEventKind::ToolRefused).back().subject; };
  run_.step({choose(6)});
  EXPECT_EQ(refused(), static_cast<std::int32_t>(ToolRefusal::NoSuchTool));
  bore(wire, {0.0, 0.0, 0.0}, 1.0);
  run_.step({choose(saw)});
  EXPECT_EQ(refused(), static_cast<std::int32_t>(ToolRefusal::ToolInBone));
  EXPECT_EQ(run_.simulation().tool_in_hand(), wire);
}

TEST_F(Boring, AWireBoresAlongItsAxisAndComesThrough) {
  bore(wire, {0.0, 0.0, 0.0}, -4.5);
  ASSERT_EQ(count(CutEventKind::BoreBegun), 1U);
  EXPECT_EQ(run_.events(CutEventKind::BoreBegun)[0].value, 0);
  EXPECT_EQ(count(CutEventKind::BoreThrough), 1U);
  EXPECT_TRUE(has(run_.recording().samples.back().status, ToolStatus::InBore));
  const BorePlace& place = run_.simulation().bores().places()[0];
  EXPECT_GT(place.bore.depth_mm, 8.0);
  EXPECT_NEAR(place.bore.body_from_bore.translation_mm.y, top_mm, 0.05);
  EXPECT_EQ(place.bore.radius_mm, 0.8);
  EXPECT_TRUE(is_replayed());
}

TEST_F(Boring, AWireThatIsDrawnBackGoesInAgainByItsOwnBore) {
  bore(wire, {0.0, 0.0, 0.0}, 0.0);
  run_.glide(pointing({0.0, 8.0, 0.0}, down), 500);
  run_.glide(pointing({0.0, -6.0, 0.0}, down), 800);
  run_.hold(200);
  EXPECT_EQ(count(CutEventKind::BoreBegun), 1U);
  EXPECT_EQ(count(CutEventKind::BoreEntered), 1U);
}

TEST_F(Boring, AWireStaysAndTheNextOneIsInTheHandOnceItIsClear) {
  bore(wire, {0.0, 0.0, 0.0}, -4.5);
  run_.step({leave});
  ASSERT_EQ(count(CutEventKind::ImplantLeft), 1U);
  EXPECT_EQ(run_.events(CutEventKind::ImplantLeft)[0].value, 0);
  run_.hold(3);
  EXPECT_FALSE(has(run_.recording().samples.back().status, ToolStatus::InBore));
  draw_out({0.0, 0.0, 0.0});
  EXPECT_NEAR(run_.bone_from_tool().translation_mm.y, 30.0, 0.001);
  EXPECT_TRUE(run_.simulation().implants().is_there(0));
}

TEST_F(Boring, MetalStopsTheSawAndSaysSoOnce) {
  leave_wire(wire, {0.0, 0.0, 0.0}, -4.5);
  take_up(saw, blade_down({0.0, 20.0, 0.0}));
  run_.glide(blade_down({0.0, -6.0, 0.0}), 2000);
  run_.hold(2000);
  EXPECT_EQ(count(CutEventKind::MetalMet), 1U);
  EXPECT_EQ(count(CutEventKind::PlaneFrozen), 0U) << "the wire stands out of the bone here";
  EXPECT_TRUE(is_replayed());
}

TEST_F(Boring, AWireThatIsTakenAgainComesOutAndIsNoMetalAnyMore) {
  leave_wire(wire, {0.0, 0.0, 0.0}, -4.5);
  const Vec3 left_mm =
      transform_from(run_.events(CutEventKind::ImplantLeft)[0].pose).translation_mm;
  run_.step({take(0)});
  EXPECT_EQ(count(CutEventKind::ImplantTaken), 1U);
  EXPECT_EQ(count(CutEventKind::BoreEntered), 1U);
  EXPECT_NEAR(run_.bone_from_tool().translation_mm.y, left_mm.y, 0.01);
  run_.glide(pointing({0.0, 60.0, 0.0}, down), 1000);
  EXPECT_NEAR(run_.bone_from_tool().translation_mm.y, left_mm.y + 30.0, 0.01)
      << "it goes as the hand goes";
  EXPECT_FALSE(run_.simulation().implants().is_there(0));
  run_.step({take(0)});
  EXPECT_EQ(run_.events(CutEventKind::ImplantRefused).back().subject,
            static_cast<std::int32_t>(ImplantRefusal::NoSuchImplant));
  EXPECT_TRUE(is_replayed());
}

TEST_F(Boring, AWireWhoseTipWentOnThroughTheAirIsInItsBoreWhenItIsTaken) {
  leave_wire(wire, {0.0, 0.0, 0.0}, -9.0);
  run_.step({take(0)});
  EXPECT_EQ(count(CutEventKind::BoreEntered), 1U);
  run_.hold(1);
  EXPECT_TRUE(has(run_.recording().samples.back().status, ToolStatus::InBore));
  EXPECT_TRUE(is_replayed());
}

TEST_F(Boring, RefusesToLeaveAndToTakeWhatCannotBe) {
  const auto refused = [&] { return run_.events(CutEventKind::ImplantRefused).back().subject; };
  run_.step({leave});
  EXPECT_EQ(refused(), static_cast<std::int32_t>(ImplantRefusal::NothingToLeave));
  bore(drill, {5.0, 0.0, 0.0}, 0.0);
  run_.step({leave});
  EXPECT_EQ(refused(), static_cast<std::int32_t>(ImplantRefusal::NothingToLeave));
  draw_out({5.0, 0.0, 0.0});
  leave_wire(wire, {0.0, 0.0, 0.0}, -4.5);
  take_up(thin_wire, pointing({0.0, 30.0, 0.0}, down));
  run_.step({take(0)});
  EXPECT_EQ(refused(), static_cast<std::int32_t>(ImplantRefusal::OtherTool));
}

TEST_F(Boring, AScrewGoesIntoADrilledHoleUntilItsHeadStandsOnBone) {
  bore(drill, {0.0, 0.0, 0.0}, -4.5);
  draw_out({0.0, 0.0, 0.0});
  take_up(screw, pointing({0.0, 20.0, 0.0}, down));
  run_.glide(pointing({0.0, -10.0, 0.0}, down), 2000);
  run_.hold(6000);
  EXPECT_EQ(count(CutEventKind::ScrewSeated), 1U);
  EXPECT_NEAR(run_.bone_from_tool().translation_mm.y, top_mm - 7.0, 0.1);
  run_.step({leave});
  EXPECT_EQ(count(CutEventKind::ImplantLeft), 1U);
  draw_out({0.0, 0.0, 0.0});
  run_.step({take(0)});
  run_.glide(pointing({0.0, 60.0, 0.0}, down), 1000);
  run_.hold(6000);
  EXPECT_GT(run_.bone_from_tool().translation_mm.y, top_mm) << "turned out again";
  EXPECT_TRUE(is_replayed());
}

TEST_F(Boring, AnotherBladeCutsAKerfOfItsOwnWidth) {
  run_.glide(blade_down({-8.0, 12.0, 0.0}), 300);
  run_.glide(blade_down({-8.0, 0.0, 0.0}), 1500);
  run_.hold(500);
  run_.glide(blade_down({-8.0, 20.0, 0.0}), 400);
  take_up(fine_saw, blade_down({-8.0, 20.0, 0.0}));
  run_.glide(blade_down({-8.0, -3.0, 0.0}), 1500);
  run_.hold(1000);
  const KerfSet& kerfs = run_.simulation().kerfs();
  ASSERT_GE(kerfs.count(), 1);
  EXPECT_EQ(kerfs.plane(0).thickness_mm, 0.5);
  EXPECT_EQ(kerfs.blade().kerf_mm, 0.4);
  for (std::int32_t kerf = 1; kerf < kerfs.count(); ++kerf)
    EXPECT_EQ(kerfs.plane(kerf).thickness_mm, 0.4);
  EXPECT_TRUE(is_replayed());
}

/// The bar sawn through at x = 5; what lies beyond is piece 1.
class FixedBar : public Boring {
 protected:
  FixedBar() {
    run_.glide(blade_down({5.0, 12.0, 0.0}), 300);
    run_.glide(blade_down({5.0, -9.0, 0.0}), 2000);
    run_.hold(1500);
    run_.glide(blade_down({5.0, 30.0, 0.0}), 400);
    run_.hold(20);
  }
  /// Parts the piece and lays it down where it was.
  void part() {
    run_.step({grip_last});
    run_.hold(3);
    run_.step({release});
    run_.hold(5);
  }
  /// From the piece's side along the bar through both.
  void wire_along(const Vec3& through_mm, const Vec3& ahead) {
    const auto at = [&](double way_mm) { return pointing(through_mm + way_mm * ahead, ahead); };
    take_up(wire, at(-30.0));
    run_.glide(at(12.0), 4000);
    for (int i = 0;
         i < 12000 && glm::dot(run_.bone_from_tool().translation_mm - through_mm, ahead) < 6.0; ++i)
      run_.hold(1);
    run_.step({leave});
    run_.glide(at(-30.0), 600);
    run_.hold(20);
  }
  /// By how much the piece moves when the hand goes by so much.
  RigidTransform led_by(const Vec3& by_mm) {
    const RigidTransform hand = pointing({20.0, 30.0, 0.0}, down);
    run_.glide(hand, 400);
    run_.step({{CommandKind::Grip, 1, 0}});
    run_.hold(3);
    run_.glide({hand.rotation, hand.translation_mm + by_mm}, 800);
    run_.hold(300);
    run_.step({release});
    const auto released = run_.events(CutEventKind::Released);
    return transform_from(released.back().pose);
  }
};

TEST_F(FixedBar, AWireThroughBothHalvesBoresInEachAlongOneAxis) {
  part();
  wire_along({5.0, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  const auto begun = run_.events(CutEventKind::BoreBegun);
  ASSERT_EQ(begun.size(), 2U);
  EXPECT_EQ(begun[0].value, 1);
  EXPECT_EQ(begun[1].value, 0);
  EXPECT_EQ(begun[0].pose, begun[1].pose) << "neither half has moved";
  EXPECT_TRUE(is_replayed());
}

TEST_F(FixedBar, OneWireLeavesThePieceTheTurnAboutIt) {
  part();
  wire_along({5.0, 1.0, 1.0}, {-1.0, 0.0, 0.0});
  const RigidTransform piece = led_by({6.0, 0.0, 6.0});
  EXPECT_NEAR(piece.translation_mm.x, 0.0, 0.02) << "it does not slide along the wire";
  const Vec3 on_wire{10.0, 1.0, 1.0};
  EXPECT_NEAR(length_of(transform_point(piece, on_wire) - on_wire), 0.0, 0.05);
}

TEST_F(FixedBar, ParallelWiresLeaveItTheWayAlongThem) {
  part();
  wire_along({5.0, 2.0, 2.0}, {-1.0, 0.0, 0.0});
  wire_along({5.0, -2.0, -2.0}, {-1.0, 0.0, 0.0});
  const RigidTransform piece = led_by({4.0, 3.0, 3.0});
  EXPECT_NEAR(piece.translation_mm.x, 4.0, 0.1);
  EXPECT_NEAR(piece.translation_mm.y, 0.0, 0.01);
  EXPECT_NEAR(piece.translation_mm.z, 0.0, 0.01);
}

TEST_F(FixedBar, WiresThatCrossHoldIt) {
  part();
  wire_along({5.0, 2.0, 0.0}, {-1.0, 0.0, 0.0});
  wire_along({5.0, -1.0, 0.0}, glm::normalize(Vec3{-1.0, 0.0, 0.4}));
  run_.step({{CommandKind::Grip, 1, 0}});
  run_.hold(3);
  const auto refused = run_.events(CutEventKind::GripRefused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].subject, static_cast<std::int32_t>(GripRefusal::Held));
  EXPECT_EQ(run_.simulation().gripped(), -1);
  EXPECT_TRUE(is_replayed());
}

TEST_F(FixedBar, AWireInThePieceAloneGoesAlongWithIt) {
  leave_wire(wire, {12.0, 0.0, 0.0}, -4.5);
  run_.step({grip_last});
  run_.hold(30);
  const auto carried = run_.events(CutEventKind::ImplantCarried);
  ASSERT_EQ(carried.size(), 1U);
  EXPECT_EQ(carried[0].value, 1);
  EXPECT_EQ(run_.simulation().implants()[0].fragment, 1);
  EXPECT_TRUE(is_replayed());
}

}  // namespace
}  // namespace hallux::simulator
