/// A bar that was sawn in two, held against plans whose numbers are known by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "assessment/fixation/measure_fragments.h"
#include "assessment/fixation/measure_implants.h"
#include "simulator/base/units.h"
#include "tests/assessment/rebuild/sawn_bar.h"

namespace hallux::assessment {
namespace {

using scenarios::ImplantKind;
using scenarios::OperationStep;
using scenarios::PlannedImplant;
using scenarios::StepKind;

/// One of the alternatives with which the half may be fixed.
OperationStep fixing(const std::string& id, const std::vector<std::string>& implants) {
  OperationStep step;
  step.kind = StepKind::Fix;
  step.id = id;
  step.one_of = "fixing";
  step.implants = implants;
  return step;
}

/// Along the bar, from its end.
PlannedImplant along(ImplantKind kind, const std::string& name, double y_mm, double z_mm,
                     double length_mm) {
  PlannedImplant planned;
  planned.kind = kind;
  planned.name = name;
  planned.entry_in_bone_mm = {15.0, y_mm, z_mm};
  planned.tip_in_bone_mm = {15.0 - length_mm, y_mm, z_mm};
  planned.direction_in_bone = {-1.0, 0.0, 0.0};
  planned.length_mm = length_mm;
  planned.lengths = {length_mm - 1.0, length_mm + 1.0};
  planned.diameters = {1.5, 2.7};
  planned.engages = {"end", "bar"};
  return planned;
}

/// A wire along the bar, 1 mm off its middle to both sides.
scenarios::Plan plan_of_a_pin() {
  scenarios::Plan plan = plan_of_the_end();
  plan.fixation.implants = {along(ImplantKind::Wire, "pin", 1.0, 1.0, 23.0)};
  return plan;
}

class Fixed : public SawnBar {
 protected:
  using SawnBar::SawnBar;

  void measure(const scenarios::Plan& plan) {
    const RebuiltBone rebuilt = SawnBar::rebuilt();
    const std::vector<std::vector<CutFace>> faces;
    const Evidence evidence{scenario_, plan, rebuilt, faces, bone_, run_.recording()};
    const WhatIsLeft left = what_is_left(run_.recording(), rebuilt, bone_, plan);
    all_ = measure_fragments(left, evidence);
    for (Measurement& each : measure_implants(left, evidence)) all_.push_back(std::move(each));
  }
  const Measurement& find(const std::string& metric, const std::string& subject) const {
    for (const Measurement& each : all_) {
      if (each.metric == metric && (each.fragment == subject || each.implant == subject))
        return each;
    }
    ADD_FAILURE() << metric << " of " << subject << " is not there";
    return all_.front();
  }
  double value(const std::string& metric, const std::string& subject) const {
    const Measurement& found = find(metric, subject);
    EXPECT_TRUE(found.is_measured()) << metric << " of " << subject;
    return found.value;
  }
  void set_wire(double y_mm, double z_mm, double to_x_mm = -8.0) {
    bore(bar_wire, y_mm, z_mm, to_x_mm);
    leave();
  }
  void take(std::int32_t implant) {
    run_.step({{simulator::CommandKind::TakeImplant, implant, 0}});
    run_.glide(tests::pointing({180.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}), 1500);
    run_.hold(10);
    run_.step({{simulator::CommandKind::ChooseTool, bar_wire, 0}});
    run_.hold(3);
  }

  /// Five millimetres of the bar, with all that lay in them.
  void saw_end_off() {
    const auto over = [](double y_mm) { return tests::blade_down({10.0, y_mm, 0.0}); };
    run_.glide(over(40.0), 600);
    run_.step({{simulator::CommandKind::ChooseTool, 0, 0}});
    run_.hold(3);
    run_.glide(over(12.0), 300);
    run_.glide(over(-9.0), 2300);
    run_.hold(1500);
    run_.glide(over(30.0), 400);
    const auto freed = run_.events(simulator::CutEventKind::PieceFreed);
    run_.step({{simulator::CommandKind::PickUp, freed.back().subject, 0}});
    run_.hold(20);
    ASSERT_EQ(run_.events(simulator::CutEventKind::PieceRemoved).size(), 1U);
  }

  scenarios::Scenario scenario_;
  std::vector<Measurement> all_;
};

TEST_F(Fixed, AFragmentThatWasLedTooShort) {
  lead({0.0, 0.0, 3.0});
  measure(plan_of_the_end());
  EXPECT_NEAR(value("shift_mm", "end"), 3.0, 0.02);
  EXPECT_NEAR(value("shift_error_mm", "end"), 1.0, 0.02);
  EXPECT_EQ(find("shift_error_mm", "end").direction, "medial");
  EXPECT_NEAR(value("turn_error_deg", "end"), 0.0, 0.05);
  EXPECT_NEAR(value("elevation_mm", "end"), 0.0, 0.02);
  EXPECT_EQ(value("contact_share", "end"), 0.0) << "the kerf is between them";
  EXPECT_NEAR(value("gap_mm", "end"), 0.5, 0.02);
  EXPECT_EQ(value("shifted", "end"), 1.0);
  EXPECT_EQ(value("fixed", "end"), 0.0);
  EXPECT_EQ(find("shift_error_mm", "end").start_us,
            run_.events(simulator::CutEventKind::Released).back().tick * 1000);
}

TEST_F(Fixed, AFragmentThatWasLedLessThanHalfItsWayIsNotShifted) {
  lead({0.0, 0.0, 1.5});
  measure(plan_of_the_end());
  EXPECT_NEAR(value("shift_error_mm", "end"), 2.5, 0.02);
  EXPECT_EQ(value("shifted", "end"), 0.0);
}

TEST_F(Fixed, AFragmentThatWasLedTheOtherWayIsNotShifted) {
  lead({0.0, 0.0, -4.0});
  measure(plan_of_the_end());
  EXPECT_NEAR(value("shift_mm", "end"), 4.0, 0.02);
  EXPECT_EQ(value("shifted", "end"), 0.0);
}

TEST_F(Fixed, AFragmentThatIsRaised) {
  lead({0.0, 1.0, 4.0});
  measure(plan_of_the_end());
  EXPECT_NEAR(value("elevation_mm", "end"), 1.0, 0.02);
  EXPECT_EQ(find("elevation_mm", "end").direction, "dorsal");
}

TEST_F(Fixed, WhatWasNeverPartedIsNotDone) {
  scenarios::Plan plan = plan_of_the_end();
  plan.fixation.fragments[0].name = "elsewhere";
  plan.fixation.fragments[0].holds_in_bone_mm = {10.0, 20.0, 0.0};
  plan.fixation.implants = {along(ImplantKind::Wire, "pin", 1.0, 1.0, 23.0)};
  measure(plan);
  for (const Measurement& each : all_)
    EXPECT_EQ(each.absence, each.metric == "shifted" ? Absence::None : Absence::NotDone);
  EXPECT_EQ(value("shifted", "elsewhere"), 0.0) << "for a gate";
  EXPECT_EQ(all_.size(), 16U);
}

TEST_F(Fixed, AWireAgainstItsPlan) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0);
  scenarios::Plan plan = plan_of_the_end();
  plan.fixation.implants = {along(ImplantKind::Wire, "pin", 0.0, 1.0, 26.0)};
  measure(plan);
  EXPECT_NEAR(value("entry_mm", "pin"), 1.0, 0.01);
  EXPECT_EQ(find("entry_mm", "pin").direction, "dorsal");
  EXPECT_NEAR(value("direction_deg", "pin"), 0.0, 0.1);
  EXPECT_NEAR(value("length_error_mm", "pin"), 2.0, 0.3);
  EXPECT_EQ(find("length_error_mm", "pin").direction, "short");
  EXPECT_EQ(value("protrusion_mm", "pin"), 0.0);
  EXPECT_EQ(value("cortices", "pin"), 1.0);
  EXPECT_EQ(value("insertions", "pin"), 1.0);
  EXPECT_EQ(value("right_tool", "pin"), 1.0);
  EXPECT_EQ(find("tip_to_joint_mm", "pin").absence, Absence::Undefined) << "no joint is planned";
  EXPECT_EQ(value("fixed", "end"), 0.0) << "it may turn";
}

TEST_F(Fixed, ATipStandsOutOfTheSkinThatItWentThrough) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0, -18.0);
  scenarios::Plan plan = plan_of_a_pin();
  measure(plan);
  EXPECT_NEAR(value("protrusion_mm", "pin"), 3.0, 0.3);
  EXPECT_EQ(value("cortices", "pin"), 2.0);
}

/// A joint surface at the bar's other end.
scenarios::PlannedJointSurface joint_at_the_end(const simulator::IndexedMesh& outer) {
  scenarios::PlannedJointSurface joint;
  joint.name = "joint";
  for (std::uint32_t triangle = 0; triangle < outer.triangles.size(); ++triangle) {
    const auto corners = simulator::corners_of(outer, triangle);
    const bool is_of_end =
        std::ranges::all_of(corners, [](const Vec3& corner) { return corner.x == -15.0; });
    if (is_of_end) joint.triangles.push_back(triangle);
  }
  return joint;
}

TEST_F(Fixed, ATipThatWentThroughAJointSurfaceIsNotClearOfIt) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0, -8.0);
  scenarios::Plan plan = plan_of_a_pin();
  plan.joint_surfaces = {joint_at_the_end(bone_.outer)};
  ASSERT_EQ(plan.joint_surfaces[0].triangles.size(), 2U);
  measure(plan);
  EXPECT_NEAR(value("tip_to_joint_mm", "pin"), 7.0, 0.3);
  set_wire(-1.0, -1.0, -20.0);
  plan.fixation.implants[0] = along(ImplantKind::Wire, "pin", -1.0, -1.0, 35.0);
  measure(plan);
  EXPECT_EQ(value("tip_to_joint_mm", "pin"), 0.0) << "the tip is 5 mm beyond it";
}

/// With a canal in the half that stays.
class FixedInAHollowBar : public Fixed {
 protected:
  FixedInAHollowBar() : Fixed(hollow_bar()) {}

 private:
  static simulator::Bone hollow_bar() {
    simulator::Bone bone = bar();
    bone.canal = tests::solid_block({10.0, 4.0, 4.0});
    for (Vec3& point_mm : bone.canal.points_mm) point_mm.x -= 7.0;
    for (auto& triangle : bone.canal.triangles) std::swap(triangle[1], triangle[2]);
    return bone;
  }
};

TEST_F(FixedInAHollowBar, ATipInTheCanalDoesNotStandOut) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0, -8.0);
  scenarios::Plan plan = plan_of_a_pin();
  measure(plan);
  EXPECT_EQ(value("protrusion_mm", "pin"), 0.0);
  EXPECT_EQ(value("cortices", "pin"), 1.0);
}

TEST_F(Fixed, AWireOfAnotherDiameterIsNotTheRightTool) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0);
  scenarios::Plan plan = plan_of_a_pin();
  plan.fixation.implants[0].diameters = {1.1, 1.4};
  measure(plan);
  EXPECT_EQ(value("right_tool", "pin"), 0.0);
}

TEST_F(Fixed, ATryThatWasTakenOutCountsAndTheLastOneIsMeasured) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0);
  take(0);
  set_wire(-1.0, -1.0);
  scenarios::Plan plan = plan_of_a_pin();
  measure(plan);
  EXPECT_EQ(value("insertions", "pin"), 2.0);
  EXPECT_NEAR(value("entry_mm", "pin"), 2.0 * std::sqrt(2.0), 0.02);
  plan.fixation.implants[0].is_temporary = true;
  measure(plan);
  EXPECT_EQ(value("insertions", "pin"), 2.0);
  EXPECT_NEAR(value("entry_mm", "pin"), 2.0 * std::sqrt(2.0), 0.02) << "of tries the last counts";
}

TEST_F(Fixed, WhatWasToComeOutAgainIsMeasuredAsItWasLeft) {
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0);
  take(0);
  scenarios::Plan plan = plan_of_a_pin();
  measure(plan);
  EXPECT_EQ(find("entry_mm", "pin").absence, Absence::NotDone) << "it was to stay";
  plan.fixation.implants[0].is_temporary = true;
  measure(plan);
  EXPECT_NEAR(value("entry_mm", "pin"), 0.0, 0.01);
  EXPECT_EQ(value("cortices", "pin"), 1.0);
}

TEST_F(Fixed, WhatWasToComeOutAgainIsMeasuredInTheBoneThatWasSawnAwayLater) {
  lead({0.0, 0.0, 0.0});
  for (const double z_mm : {-1.0, 1.0}) {
    set_wire(1.0, z_mm);
    take(z_mm < 0.0 ? 0 : 1);
  }
  saw_end_off();
  scenarios::Plan plan = plan_of_a_pin();
  plan.fixation.implants[0].is_temporary = true;
  measure(plan);
  EXPECT_NEAR(value("entry_mm", "pin"), 0.0, 0.01) << "where it went in is no bone any more";
  EXPECT_NEAR(value("length_error_mm", "pin"), 0.0, 0.3);
  EXPECT_EQ(value("cortices", "pin"), 1.0);
  EXPECT_EQ(value("insertions", "pin"), 2.0);
}

TEST_F(Fixed, OfAlternativesThatWhichWasCarriedOutIsMeasuredAndTheOtherLosesNothing) {
  scenarios::Plan plan = plan_of_the_end();
  plan.fixation.implants = {along(ImplantKind::Wire, "first", 1.0, 1.0, 23.0),
                            along(ImplantKind::Wire, "second", -2.0, -1.0, 23.0),
                            along(ImplantKind::Screw, "screw", 0.0, 0.0, 23.0)};
  scenario_.steps = {fixing("a", {"screw"}), fixing("b", {"first", "second"})};
  measure(plan);
  EXPECT_EQ(find("entry_mm", "fixing").absence, Absence::NotDone);
  lead({0.0, 0.0, 0.0});
  set_wire(1.0, 1.0);
  measure(plan);
  EXPECT_EQ(find("entry_mm", "fixing").absence, Absence::NotDone) << "the second is missing";
  set_wire(-1.0, -1.0);
  measure(plan);
  EXPECT_NEAR(value("entry_mm", "first"), 0.0, 0.02);
  EXPECT_NEAR(value("entry_mm", "second"), 1.0, 0.02);
  EXPECT_NEAR(value("entry_mm", "fixing"), 1.0, 0.02) << "the worse of the two";
  EXPECT_EQ(find("entry_mm", "screw").absence, Absence::Undefined) << "it was not chosen";
}

}  // namespace
}  // namespace hallux::assessment
