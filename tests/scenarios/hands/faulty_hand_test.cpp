// What each fault makes of aims, strokes and acts, and what comes of it in whole attempts on coarse
// bones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "scenarios/hands/cut_strokes.h"
#include "scenarios/hands/hand_acts.h"
#include "scenarios/hands/zone_touch.h"
#include "simulator/base/units.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/sample_force.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::scenarios {
namespace {

using simulator::CommandKind;
using simulator::CutEventKind;
using simulator::Recording;

/// An operation of format 1 on a coarse patient.
struct Operation {
  explicit Operation(const char* name) : scenario(scenarios_test::format_1(name)) {
    scenario.patient.edge_mm = 1.2;
    bone = make_patient_bones(scenario).front();
    plan = plan_on(scenario, bone);
  }
  HandSkill skill(const std::vector<std::string>& faults, const char* hand = "perfect") const {
    return with_faults(hand_skill(hand), parse_hand_faults(faults, scenario));
  }
  std::vector<AimedCut> aimed(const HandSkill& skill) const {
    return aim(scenario, plan, KnownBones(bone), skill, 1);
  }
  std::vector<Act> acts(const std::vector<std::string>& faults) const {
    const HandSkill made = skill(faults);
    const std::vector<AimedCut> cuts = aimed(made);
    return plan_acts({scenario, bone, plan, cuts, made, 1});
  }
  Recording operated(const std::vector<std::string>& faults) const {
    FeelingHand hand(scenario, bone, plan, skill(faults), 1);
    return tests::run_hand(scenario, bone, plan, hand).recording;
  }

  Scenario scenario;
  simulator::Bone bone;
  Plan plan;
};

/// Each is made once.
const Operation& silver() {
  static const Operation operation("silver");
  return operation;
}
const Operation& akin() {
  static const Operation operation("akin");
  return operation;
}

std::ptrdiff_t count_of(const std::vector<Act>& acts, Act::Kind kind) {
  return std::count_if(acts.begin(), acts.end(),
                       [kind](const Act& act) { return act.kind == kind; });
}

std::vector<std::int32_t> steps_declared(const std::vector<Act>& acts) {
  std::vector<std::int32_t> steps;
  for (const Act& act : acts) {
    if (act.kind == Act::Kind::Say && act.command.kind == CommandKind::StepDone) {
      steps.push_back(act.command.argument);
    }
  }
  return steps;
}

bool says(const std::vector<Act>& acts, CommandKind kind) {
  return std::any_of(acts.begin(), acts.end(), [kind](const Act& act) {
    return act.kind == Act::Kind::Say && act.command.kind == kind;
  });
}

std::ptrdiff_t events_of(const Recording& recording, CutEventKind kind) {
  return std::count_if(recording.events.begin(), recording.events.end(),
                       [kind](const simulator::CutEvent& event) { return event.kind == kind; });
}

/// The middle of the planned section on the finished face, as the blade without errors sees it.
Vec3 middle_in_bone_mm(const Operation& operation, std::size_t cut) {
  const AimedCut exact = operation.aimed(hand_skill("perfect")).at(cut);
  const Vec2 middle = 0.5 * (exact.region.min_mm + exact.region.max_mm);
  return transform_point(exact.plane.bone_from_kerf, Vec3{middle.x, middle.y, 0.0}) -
         0.5 * exact.plane.thickness_mm * exact.face.normal;
}

double angle_deg(const Vec3& a, const Vec3& b) {
  return degree_from_radian(std::atan2(length_of(glm::cross(a, b)), glm::dot(a, b)));
}

TEST(FaultyAim, TiltTurnsTheFaceAboutThePlansDirectionAndItsMiddle) {
  for (const Operation* operation : {&silver(), &akin()}) {
    for (std::size_t i = 0; i < operation->plan.cuts.size(); ++i) {
      const PlannedCut& planned = operation->plan.cuts[i];
      const AimedCut aimed =
          operation->aimed(operation->skill({"tilt:" + planned.name + "=4"})).at(i);
      EXPECT_NEAR(angle_deg(planned.face.normal, aimed.face.normal), 4.0, 1.0e-9);
      EXPECT_NEAR(degree_from_radian(aimed.angle_error_rad), 4.0, 1.0e-9);
      EXPECT_NEAR(glm::dot(aimed.face.normal, planned.axis), 0.0, 1.0e-12) << "still contains it";
      EXPECT_GT(glm::dot(glm::cross(planned.face.normal, aimed.face.normal), planned.axis), 0.0);
      EXPECT_NEAR(glm::dot(aimed.face.normal, middle_in_bone_mm(*operation, i)),
                  aimed.face.offset_mm, 1.0e-9);
      EXPECT_GT(aimed.location_error_mm, 0.1);
    }
  }
}

TEST(FaultyAim, RollTurnsTheFaceOutOfThePlansDirection) {
  for (const Operation* operation : {&silver(), &akin()}) {
    for (std::size_t i = 0; i < operation->plan.cuts.size(); ++i) {
      const PlannedCut& planned = operation->plan.cuts[i];
      const AimedCut aimed = operation->aimed(operation->skill({"roll=-3"})).at(i);
      EXPECT_NEAR(angle_deg(planned.face.normal, aimed.face.normal), 3.0, 1.0e-9);
      // Positive leans the normal towards the direction.
      EXPECT_NEAR(90.0 - angle_deg(aimed.face.normal, planned.axis), -3.0, 1.0e-9);
      EXPECT_NEAR(glm::dot(aimed.face.normal, middle_in_bone_mm(*operation, i)),
                  aimed.face.offset_mm, 1.0e-9);
    }
  }
}

TEST(FaultyAim, OffsetShiftsTheFaceTowardsTheWaste) {
  const AimedCut aimed = silver().aimed(silver().skill({"offset=1.5"})).at(0);
  const ReferenceFace& planned = silver().plan.cuts.at(0).face;
  EXPECT_NEAR(angle_deg(planned.normal, aimed.face.normal), 0.0, 1.0e-9);
  EXPECT_NEAR(aimed.face.offset_mm, planned.offset_mm + 1.5, 1.0e-9);
  EXPECT_NEAR(aimed.location_error_mm, 1.5, 1.0e-9);
}

TEST(FaultyAim, OfOneCutLeavesTheOtherAlone) {
  const auto exact = akin().aimed(hand_skill("perfect"));
  const auto aimed = akin().aimed(akin().skill({"tilt:proximal_face=4", "over_cut:proximal_face"}));
  EXPECT_NE(aimed.at(0).face.normal, exact.at(0).face.normal);
  EXPECT_EQ(aimed.at(1).face.normal, exact.at(1).face.normal);
  EXPECT_EQ(aimed.at(1).face.offset_mm, exact.at(1).face.offset_mm);
  EXPECT_EQ(aimed.at(1).stop_mm, exact.at(1).stop_mm);
}

TEST(FaultyAim, OfAnExpertComesOnTopOfItsErrors) {
  const auto plain = silver().aimed(hand_skill("expert"));
  const auto faulty = silver().aimed(silver().skill({"offset=1"}, "expert"));
  EXPECT_EQ(faulty.at(0).face.normal, plain.at(0).face.normal);
  const double cosine = glm::dot(plain.at(0).face.normal, silver().plan.cuts.at(0).face.normal);
  EXPECT_NEAR(faulty.at(0).face.offset_mm - plain.at(0).face.offset_mm, cosine, 1.0e-9);
}

TEST(FaultyAim, ThatNeverMeetsTheBoneIsRefused) {
  EXPECT_THROW(silver().aimed(silver().skill({"offset=10"})), ScenarioError);
}

TEST(FaultyStrokes, GoFartherOrStopShortOfTheHingeLine) {
  const auto stop_mm = [](const std::vector<std::string>& faults) {
    return akin().aimed(akin().skill(faults)).at(0).stop_mm.value();
  };
  const double exact_mm = stop_mm({});
  EXPECT_NEAR(stop_mm({"over_cut:proximal_face=0.5"}), exact_mm + 0.5, 1.0e-12);
  EXPECT_NEAR(stop_mm({"stop_short=0.7"}), exact_mm - 0.7, 1.0e-12);
  EXPECT_FALSE(akin().aimed(akin().skill({"over_cut=0.5"})).at(0).loses_hinge);
  EXPECT_TRUE(akin().aimed(akin().skill({"over_cut=1.5"})).at(0).loses_hinge);
}

TEST(FaultyStrokes, GoFartherOrStopShortOfTheLastBone) {
  const auto strokes = [](const std::vector<std::string>& faults) {
    const HandSkill skill = silver().skill(faults);
    return cut_strokes(silver().aimed(skill).at(0), silver().scenario.saw.blade, skill);
  };
  const std::vector<Stroke> exact = strokes({}), over = strokes({"over_cut=3"}),
                            shorter = strokes({"stop_short=2"});
  ASSERT_EQ(exact.size(), over.size());
  ASSERT_EQ(exact.size(), shorter.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(over[i].end_mm, exact[i].end_mm + 3.0, 1.0e-12);
    EXPECT_EQ(over[i].last_mm, exact[i].last_mm);
    EXPECT_NEAR(shorter[i].end_mm, exact[i].last_mm - 2.0, 1.0e-12);
    EXPECT_TRUE(shorter[i].stops_in_bone);
  }
  EXPECT_TRUE(strokes({"stop_short=20"}).size() < exact.size()) << "too thin to be begun";
}

TEST(FaultyActs, LeaveAStepOutAndDoNotDeclareIt) {
  const std::vector<Act> all = akin().acts({});
  EXPECT_EQ(steps_declared(all), (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(steps_declared(akin().acts({"skip:verify"})),
            (std::vector<std::int32_t>{1, 2, 3, 4, 5}));
  const std::vector<Act> without_second = akin().acts({"skip:distal_face"});
  EXPECT_EQ(steps_declared(without_second), (std::vector<std::int32_t>{0, 1, 3, 4, 5}));
  EXPECT_EQ(count_of(without_second, Act::Kind::TurnTo), 0);
  EXPECT_LT(count_of(without_second, Act::Kind::Saw), count_of(all, Act::Kind::Saw));
  EXPECT_FALSE(says(akin().acts({"skip:remove"}), CommandKind::PickUp));
  EXPECT_EQ(count_of(akin().acts({"skip:remove"}), Act::Kind::TakeRest), 0);
  EXPECT_FALSE(says(akin().acts({"skip:close"}), CommandKind::CloseHinge));
  EXPECT_TRUE(says(all, CommandKind::PickUp) && says(all, CommandKind::CloseHinge));
}

TEST(FaultyActs, SwapTheCutsAndDeclareThemSo) {
  const HandSkill skill = akin().skill({"swap"});
  EXPECT_EQ(steps_declared(akin().acts({"swap"})), (std::vector<std::int32_t>{0, 2, 1, 3, 4, 5}));
  const std::vector<AimedCut> cuts = akin().aimed(skill);
  const Act start = starting_act({akin().scenario, akin().bone, akin().plan, cuts, skill, 1});
  EXPECT_EQ(start.bone_from_blade, cuts.at(1).plane.bone_from_kerf);
  const std::vector<Act> acts = akin().acts({"swap"});
  const auto turn = std::find_if(acts.begin(), acts.end(),
                                 [](const Act& act) { return act.kind == Act::Kind::TurnTo; });
  ASSERT_NE(turn, acts.end());
  EXPECT_EQ(turn->bone_from_blade, cuts.at(0).plane.bone_from_kerf);
}

TEST(FaultyActs, WaitAfterEachStrokeAndBeforeTheEnd) {
  EXPECT_EQ(count_of(akin().acts({}), Act::Kind::Idle), 0);
  const std::vector<Act> slow = akin().acts({"slow=3"});
  EXPECT_EQ(count_of(slow, Act::Kind::Idle), count_of(slow, Act::Kind::Saw) + 1);
  for (const Act& act : slow) {
    if (act.kind == Act::Kind::Idle) {
      EXPECT_EQ(act.idle_share, 2.0);
    }
  }
}

TEST(FaultyActs, RestartInTheFirstStrokeAlone) {
  std::vector<std::int32_t> restarts;
  for (const Act& act : akin().acts({"restarts=4"})) {
    if (act.kind == Act::Kind::Saw) restarts.push_back(act.stroke.restarts);
  }
  ASSERT_GT(restarts.size(), 1U);
  EXPECT_EQ(restarts.front(), 4);
  EXPECT_EQ(std::count(restarts.begin(), restarts.end(), 0),
            static_cast<std::ptrdiff_t>(restarts.size()) - 1);
}

TEST(FaultyActs, TouchAZoneThroughTheAirBeforeTheFirstCut) {
  for (const Operation* operation : {&silver(), &akin()}) {
    const simulator::Blade& blade = operation->scenario.saw.blade;
    for (const PlannedZone& zone : operation->plan.danger_zones) {
      const std::vector<Act> acts = operation->acts({"touch_zone:" + zone.name + "=0.5"});
      const auto is_saw = [](const Act& act) { return act.kind == Act::Kind::Saw; };
      const auto is_lead = [](const Act& act) { return act.kind == Act::Kind::Lead; };
      const auto first_lead = std::find_if(acts.begin(), acts.end(), is_lead);
      ASSERT_LT(first_lead, std::find_if(acts.begin(), acts.end(), is_saw)) << zone.name;
      EXPECT_TRUE(first_lead->saw_runs);
      EXPECT_EQ(std::next(first_lead)->wait_s, 0.5);
      const RigidTransform& touch = std::prev(first_lead)->bone_from_blade;
      EXPECT_LT(distance_to_capsule_mm(touch, blade, zone.capsule), -0.3) << zone.name;
      const ZoneTouch way = plan_touch(operation->bone, operation->plan, blade,
                                       {zone.name, acts.front().bone_from_blade});
      EXPECT_GT(way.room_mm, 1.0) << zone.name << ": a free way there";
    }
  }
}

TEST(FaultyHand, TouchesTheZoneOnceAndNoBoneOnTheWay) {
  for (const Operation* operation : {&silver(), &akin()}) {
    const std::vector<PlannedZone>& zones = operation->plan.danger_zones;
    for (std::size_t zone = 0; zone < zones.size(); ++zone) {
      // Without its cuts it does nothing else.
      std::vector<std::string> faults{"touch_zone:" + zones[zone].name};
      for (const PlannedCut& cut : operation->plan.cuts) faults.push_back("skip:" + cut.name);
      const Recording recording = operation->operated(faults);
      std::vector<std::int32_t> touched;
      for (const simulator::CutEvent& event : recording.events) {
        if (event.kind == CutEventKind::DangerContact) touched.push_back(event.subject);
      }
      EXPECT_EQ(touched, std::vector{static_cast<std::int32_t>(zone)}) << zones[zone].name;
      for (const simulator::ToolSample& sample : recording.samples) {
        ASSERT_FALSE(has(sample.status, simulator::ToolStatus::InContact))
            << zones[zone].name << ' ' << sample.tick;
      }
      EXPECT_EQ(recording.events.back().kind, CutEventKind::Finished);
    }
  }
}

double most_push_newton(const Recording& recording) {
  double most_newton = 0.0;
  for (const simulator::ToolSample& sample : recording.samples) {
    most_newton = std::max(most_newton, length_of(simulator::force_newton(sample)));
  }
  return most_newton;
}

std::ptrdiff_t ticks_with(const Recording& recording, simulator::ToolStatus status) {
  return std::count_if(recording.samples.begin(), recording.samples.end(),
                       [status](const auto& sample) { return has(sample.status, status); });
}

/// How often the teeth left the bone by more than 3 mm and met it again: by the feed of the tool.
int entries_of(const Operation& operation, const Recording& recording) {
  const simulator::Bvh outer(operation.bone.outer);
  const RigidTransform bone_from_world = inverse(operation.bone.world_from_bone);
  int entries = 0;
  bool is_away = true;
  for (const simulator::ToolSample& sample : recording.samples) {
    if (has(sample.status, simulator::ToolStatus::Cutting)) {
      entries += is_away ? 1 : 0;
      is_away = false;
    } else if (!is_away) {
      const RigidTransform world_from_tool = simulator::transform_from(sample.world_from_tool);
      const Vec3 tip = transform_point(bone_from_world, world_from_tool.translation_mm);
      is_away = outer.signed_distance_mm(tip) > 3.0;
    }
  }
  return entries;
}

// One test, because the attempt without faults is what the others are held against.
TEST(FaultyHand, DoesWhatItsFaultSays) {
  const Recording exact = silver().operated({});
  const auto ticks = [](const Recording& recording) {
    return static_cast<double>(recording.samples.size());
  };
  ASSERT_EQ(events_of(exact, CutEventKind::SectionCovered), 1);

  const Recording dry = silver().operated({"dry"});
  EXPECT_EQ(ticks_with(dry, simulator::ToolStatus::Irrigated), 0);
  EXPECT_GT(ticks_with(exact, simulator::ToolStatus::Irrigated), 10000);
  EXPECT_EQ(dry.tape, silver().operated({"dry"}).tape);

  const Recording slow = silver().operated({"slow=2"});
  EXPECT_NEAR(ticks(slow) / ticks(exact), 2.0, 0.01);
  EXPECT_EQ(ticks_with(slow, simulator::ToolStatus::InContact),
            ticks_with(exact, simulator::ToolStatus::InContact));

  const Recording press = silver().operated({"press=8"});
  EXPECT_NEAR(most_push_newton(press), most_push_newton(exact) + 8.0, 1.5);
  EXPECT_LT(ticks(press), ticks(exact));

  const Recording restarts = silver().operated({"restarts=5"});
  EXPECT_EQ(entries_of(silver(), restarts), entries_of(silver(), exact) + 5);
  EXPECT_EQ(events_of(restarts, CutEventKind::PlaneFrozen), 1);
  EXPECT_EQ(events_of(restarts, CutEventKind::SectionCovered), 1);

  const Recording shorter = silver().operated({"stop_short=3"});
  EXPECT_EQ(events_of(shorter, CutEventKind::SectionCovered), 0);
  EXPECT_EQ(events_of(shorter, CutEventKind::PieceFreed), 0);
  EXPECT_EQ(shorter.events.back().kind, CutEventKind::Finished);
}

TEST(FaultyHand, ThatIsSlowMayTakeLongerThanOthersMay) {
  const FeelingHand hand(silver().scenario, silver().bone, silver().plan,
                         silver().skill({"slow=4"}), 1);
  EXPECT_EQ(hand.end_tick(), 4 * FeelingHand::last_tick);
}

TEST(FaultyHand, WithoutTheStepLeavesTheWedgeOpen) {
  const Recording recording = akin().operated({"skip:close"});
  EXPECT_EQ(events_of(recording, CutEventKind::HingeClosed), 0);
  EXPECT_GE(events_of(recording, CutEventKind::PieceRemoved), 1);
}

TEST(FaultyHand, ThatCutsOverTheLineLosesTheHinge) {
  const Recording recording = akin().operated({"over_cut=3"});
  EXPECT_EQ(events_of(recording, CutEventKind::HingeClosed), 0);
}

}  // namespace
}  // namespace hallux::scenarios
