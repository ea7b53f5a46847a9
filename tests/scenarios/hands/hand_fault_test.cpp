// Faults as texts: what they are called, of what they may be, and how each is refused.
#include "scenarios/hands/hand_fault.h"

#include <gtest/gtest.h>

#include "scenarios/hands/hand_skill.h"
#include "scenarios/scenario.h"
#include "tests/scenarios/format_1/format_1.h"

namespace hallux::scenarios {
namespace {

const Scenario& akin() {
  static const Scenario scenario = scenarios_test::format_1("akin");
  return scenario;
}

std::vector<HandFault> parsed(const std::vector<std::string>& texts) {
  return parse_hand_faults(texts, akin());
}

std::string refusal_of(const std::vector<std::string>& texts, const Scenario& scenario = akin()) {
  try {
    parse_hand_faults(texts, scenario);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(HandFault, IsReadWithItsSubjectAndItsSize) {
  EXPECT_EQ(parsed({"tilt:proximal_face=-2.5", "roll", "skip:remove", "dry", "restarts=4"}),
            (std::vector<HandFault>{{FaultKind::Tilt, "proximal_face", -2.5},
                                    {FaultKind::Roll, "", 4.0},
                                    {FaultKind::Skip, "remove", 0.0},
                                    {FaultKind::Dry, "", 0.0},
                                    {FaultKind::Restarts, "", 4.0}}));
}

/// With what faults of format 2 may be of.
Scenario fixed_akin() {
  Scenario scenario = akin();
  scenario.fragments = {{.name = "toe", .title = "Toe", .bone = "", .holds = "", .origin = ""}};
  Implant screw;
  screw.name = "screw";
  scenario.implants = {screw};
  return scenario;
}

TEST(HandFault, IsWrittenAsItIsRead) {
  const Scenario scenario = fixed_akin();
  const auto read = [&](const HandFault& fault) {
    return parse_hand_faults(std::vector{text_of(fault)}, scenario);
  };
  for (const FaultRow& row : fault_table()) {
    HandFault fault{row.kind, "", row.usual_size};
    if (row.subject == FaultSubject::Step) fault.subject = "verify";
    if (row.subject == FaultSubject::Zone) fault.subject = scenario.danger_zones.at(0).name;
    if (row.subject == FaultSubject::Fragment) fault.subject = "toe";
    if (row.subject == FaultSubject::Implant) fault.subject = "screw";
    EXPECT_EQ(read(fault), std::vector{fault}) << row.name;
    if (row.subject != FaultSubject::MayBeCut) continue;
    fault.subject = "distal_face";
    EXPECT_EQ(read(fault), std::vector{fault}) << row.name;
  }
}

TEST(HandFault, OfAFragmentOrAnImplantNeedsOne) {
  EXPECT_EQ(refusal_of({"shift_by:toe"}),
            "fault \"shift_by:toe\": akin has none that it could be of");
  EXPECT_EQ(refusal_of({"length:nail=3"}, fixed_akin()),
            "fault \"length:nail=3\": akin has no \"nail\" that it could be of; write "
            "length:IMPLANT[=6 mm] with screw");
}

TEST(HandFault, NamesAStepOfFormat2ByItsId) {
  OperationStep step;
  step.kind = StepKind::Fix;
  step.id = "fix";
  EXPECT_EQ(fault_name_of(step), "fix");
  step.kind = StepKind::Finish;
  EXPECT_EQ(fault_name_of(step), "") << "no hand leaves it out";
}

TEST(HandFault, HasARowForEachKindWithAUsualSizeInItsRange) {
  const std::span<const FaultRow> rows = fault_table();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(rows[i].kind), i);
    EXPECT_LE(rows[i].least, rows[i].usual_size);
    EXPECT_LE(rows[i].usual_size, rows[i].greatest);
    EXPECT_FALSE(rows[i].effect.empty());
  }
  EXPECT_EQ(rows.back().kind, FaultKind::WrongBlade);
}

TEST(HandFault, NamesTheHandInTheRecord) {
  EXPECT_EQ(hand_with_faults("perfect", {}), "perfect");
  EXPECT_EQ(hand_with_faults("perfect", parsed({"tilt:proximal_face=4", "dry"})),
            "perfect with tilt:proximal_face=4, dry");
}

TEST(HandFault, OfAnUnknownNameIsRefusedWithAllThereAre) {
  const std::string refusal = refusal_of({"wobble"});
  EXPECT_EQ(refusal.find("there is no fault \"wobble\"; use tilt[:CUT][=4 degrees], roll"), 0U);
  for (const FaultRow& row : fault_table()) {
    EXPECT_NE(refusal.find(row.name), std::string::npos) << row.name;
  }
  EXPECT_NE(refusal_of({""}), "");
  EXPECT_NE(refusal_of({"Tilt"}), "");
}

TEST(HandFault, OfAnUnknownSubjectIsRefusedWithThoseThereAre) {
  EXPECT_EQ(refusal_of({"tilt:eminence=3"}),
            "fault \"tilt:eminence=3\": akin has no \"eminence\" that it could be of; write "
            "tilt[:CUT][=4 degrees] with proximal_face or distal_face");
  EXPECT_EQ(refusal_of({"skip"}),
            "fault \"skip\": it does not say what it is of; write skip:STEP with verify, "
            "proximal_face, distal_face, remove or close");
  for (const char* text : {"touch_zone", "touch_zone:nowhere"}) {
    for (const DangerZone& zone : akin().danger_zones) {
      EXPECT_NE(refusal_of({text}).find(zone.name), std::string::npos) << text << ' ' << zone.name;
    }
  }
  for (const char* text : {"skip:finish", "skip:", "tilt:", "skip:cut"}) {
    EXPECT_NE(refusal_of({text}), "") << text;
  }
  EXPECT_EQ(refusal_of({"dry:remove"}),
            "fault \"dry:remove\": it is of the whole attempt; write dry");
}

TEST(HandFault, OfASizeThatCannotBeIsRefusedWithItsRange) {
  EXPECT_EQ(refusal_of({"tilt=steep"}),
            "fault \"tilt=steep\": give a number from -45 to 45, degrees; tilt[:CUT][=4 degrees]");
  for (const char* text :
       {"tilt=", "tilt=90", "tilt=nan", "tilt=inf", "tilt=4deg", "tilt= 4", "over_cut=-1",
        "slow=0.5", "slow=11", "press=-1", "restarts=2.5", "restarts=0", "touch_zone:x=0", "dry=1",
        "skip:verify=2", "swap=1", "tilt=1e400"}) {
    EXPECT_NE(refusal_of({text}), "") << text;
  }
}

TEST(HandFault, TwiceTheSameOrTooManyForTheRecordIsRefused) {
  EXPECT_EQ(refusal_of({"dry", "dry"}), "fault \"dry\": it is given twice; give one of the two");
  EXPECT_NE(refusal_of({"tilt=1", "tilt=2"}), "");
  EXPECT_EQ(refusal_of({"tilt=1", "tilt:distal_face=2"}), "");
  std::vector<std::string> many;
  for (const FaultRow& row : fault_table()) {
    if (row.subject != FaultSubject::MayBeCut || row.unit.empty()) continue;
    for (const char* cut : {"", ":proximal_face", ":distal_face"}) {
      many.push_back(std::string(row.name) + cut + "=1.2345678");
    }
  }
  EXPECT_NE(refusal_of(many).find("255"), std::string::npos);
}

TEST(HandFault, SwapNeedsTwoCuts) {
  EXPECT_EQ(refusal_of({"swap"}), "");
  EXPECT_EQ(refusal_of({"swap"}, scenarios_test::format_1("silver")),
            "fault \"swap\": silver has one cut, and two are swapped");
}

TEST(HandFault, AddsUpForTheCutsThatItIsOf) {
  const std::vector<HandFault> faults = parsed({"tilt=1", "tilt:distal_face=2"});
  EXPECT_EQ(fault_size(faults, FaultKind::Tilt, "proximal_face"), 1.0);
  EXPECT_EQ(fault_size(faults, FaultKind::Tilt, "distal_face"), 3.0);
  EXPECT_EQ(fault_size(faults, FaultKind::Roll, "distal_face"), 0.0);
}

TEST(HandFault, OfPushAndWaterChangesTheSkill) {
  const HandSkill skill = with_faults(hand_skill("expert"), parsed({"press=5", "dry"}));
  EXPECT_EQ(skill.push.extra_newton, 5.0);
  EXPECT_FALSE(skill.cooling.has_water);
  EXPECT_EQ(skill.push.steady_newton, hand_skill("expert").push.steady_newton);
  EXPECT_TRUE(with_faults(hand_skill("expert"), {}).cooling.has_water);
}

}  // namespace
}  // namespace hallux::scenarios
