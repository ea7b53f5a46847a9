#include "ui/report/what_if_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/assessment/examined_attempt.h"

namespace hallux::ui {
namespace {

using assessment::KnownChange;
using assessment::Proposals;
using assessment::testing::AkinAttempt;
using assessment::testing::ExaminedAttempt;

/// What is said of the attempt when that change leads to the plan.
SaidChange said_of(const AkinAttempt& attempt, const std::string& name, double to = 0.0,
                   const std::vector<std::string>& items = {}) {
  ExaminedAttempt made =
      assessment::testing::examined(assessment::testing::akin_with_deeds(), attempt);
  const assessment::WhatIf what_if(made.scenario, made.bone, made.recording, "scripted",
                                   std::move(made.examination));
  const auto known = std::ranges::find(what_if.known(), name, &KnownChange::name);
  if (known == what_if.known().end()) {
    ADD_FAILURE() << name << " is not known";
    return {};
  }
  Proposals proposals;
  proposals.changes = {{*known, to, 4'200, items, {}}};
  return said_what_if(proposals, made.scenario, what_if.examination().plan,
                      what_if.examination().card)
      .changes.front();
}

// The recordings say which edge lies further distal; the waste of the first cut is distal.
TEST(WhatIfText, ATurnNamesTheEdgeThatLayTooFar) {
  const SaidChange turned = said_of({.transverse_deg = 4.0}, "tilt:cut1", 0.0, {"A1", "A4"});
  EXPECT_EQ(turned.head, "First cut: turned back by 4.0°, seen from dorsal");
  EXPECT_EQ(turned.body, "Its medial edge lay too far distal. More points for: A1 and A4.");
  EXPECT_EQ(turned.gain, "+4.2 points");
  EXPECT_EQ(turned.items, (std::vector<std::string>{"A1", "A4"}));
  EXPECT_EQ(said_of({.transverse_deg = -4.0}, "tilt:cut1").body,
            "Its lateral edge lay too far distal.");
  const SaidChange leaning = said_of({.sagittal1_deg = 3.0}, "roll:cut1");
  EXPECT_EQ(leaning.head, "First cut: turned back by 3.0°, seen from the side");
  EXPECT_EQ(leaning.body, "Its plantar edge lay too far distal.");
  EXPECT_EQ(said_of({.sagittal1_deg = -3.0}, "roll:cut1").body,
            "Its dorsal edge lay too far distal.");
}

// The kept bone of the second cut lies distal: its waste is proximal.
TEST(WhatIfText, ATurnOfTheSecondFaceIsSaidFromItsOwnWaste) {
  const std::string body = said_of({.sagittal2_deg = 3.0}, "roll:cut2").body;
  EXPECT_EQ(body, "Its dorsal edge lay too far proximal.");
}

TEST(WhatIfText, AShiftSaysWhereTo) {
  const SaidChange late = said_of({.entry_x_mm = 6.5}, "offset:cut1");
  EXPECT_EQ(late.head, "First cut: 0.50 mm further proximal");
  EXPECT_EQ(late.body, "Its middle lay too far distal.");
  const SaidChange early = said_of({.entry_x_mm = 5.5}, "offset:cut1");
  EXPECT_EQ(early.head, "First cut: 0.50 mm further distal");
  EXPECT_EQ(early.body, "Its middle lay too far proximal.");
}

TEST(WhatIfText, AStopSaysWhatIsLeft) {
  const SaidChange early = said_of({.reach1_mm = 5.0, .reach2_mm = 5.0}, "stop:lateral", 1.0);
  EXPECT_EQ(early.head, "Lateral hinge: 1.00 mm of bone left instead of 2.50 mm");
  EXPECT_EQ(early.body, "The cuts ended too early.");
  EXPECT_EQ(said_of({.reach1_mm = 7.0, .reach2_mm = 7.0}, "stop:lateral", 1.0).body,
            "The cuts went too deep.");
  const SaidChange beyond = said_of({.reach1_mm = 8.5, .reach2_mm = 8.5}, "stop:lateral", 1.0);
  EXPECT_EQ(beyond.head, "Lateral hinge: 1.00 mm of bone left");
  EXPECT_EQ(beyond.body, "The blade went 1.00 mm beyond the far cortex.");
}

/// Of Silver, whose card stands at 72.04.
struct SilverSaid {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario("silver");
  Proposals proposals;
  database::ScoreCard card;

  SilverSaid() {
    card.score_milli = 72'040;
    card.measured_milli = card.rubric_milli = 100'000;
  }
  void propose(const std::string& name, double from, double to, std::int64_t gain_milli,
               const std::vector<std::string>& items) {
    proposals.changes.push_back({{name, "", from, true}, to, gain_milli, items, {}});
  }
  SaidWhatIf said() const { return said_what_if(proposals, scenario, {}, card); }
};

TEST(WhatIfText, AValueOfTheWorkIsSaidByTheRubric) {
  SilverSaid silver;
  silver.propose("irrigated_share", 0.5, 0.9, 700, {"T5"});
  silver.propose("started_in_bone", 1.0, 0.0, 1'000, {"T6"});
  silver.propose("time_s", 160.26, 60.0, 40, {"E1"});
  silver.propose("sparc", -3.16, -2.0, 600, {"T4"});
  silver.propose("danger_contacts_count:tibial_sesamoid_cartilage", 2.0, 0.0, 5'000, {"H2"});
  const SaidWhatIf said = silver.said();
  EXPECT_EQ(said.changes[0].head, "Water while sawing: 0.9 instead of 0.5");
  EXPECT_FALSE(said.changes[0].body.empty()) << "advice";
  EXPECT_EQ(said.changes[1].head, "Saw switched on in the bone: no instead of yes");
  EXPECT_EQ(said.changes[2].head, "Time: 60.0 s instead of 160.3 s");
  EXPECT_EQ(said.changes[2].gain, "less than +0.1") << "never 0";
  EXPECT_EQ(said.changes[3].head, "Smoothness of the free movements: −2 instead of −3.16");
  EXPECT_EQ(said.changes[4].head, "Contacts with the tibial sesamoid: 0 instead of 2");
}

TEST(WhatIfText, AGateThatWouldNotCapIsNamed) {
  SilverSaid silver;
  silver.propose("danger_contacts_count:tibial_sesamoid_cartilage", 2.0, 0.0, 5'000, {"H2"});
  silver.proposals.changes.front().lifted_gates = {"sesamoid_cut"};
  EXPECT_NE(
      silver.said().changes.front().body.find("No longer capped for: Tibial sesamoid touched."),
      std::string::npos);
}

TEST(WhatIfText, TogetherAReadersSubtractionIsRight) {
  SilverSaid silver;
  silver.propose("time_s", 160.0, 60.0, 2'000, {"E1"});
  EXPECT_TRUE(silver.said().together.empty()) << "one alone";
  silver.propose("irrigated_share", 0.5, 0.9, 700, {"T5"});
  silver.proposals.score_milli = 74'660;
  silver.proposals.gain_milli = 2'620;
  EXPECT_EQ(silver.said().together, "Both together");
  EXPECT_EQ(silver.said().together_score,
            "The machine’s score would have been 74.7 instead of 72.0.");
  EXPECT_EQ(silver.said().together_gain, "+2.7 points");
  silver.proposals.gain_milli = 1'900;
  EXPECT_NE(silver.said().together_score.find("no more than the first alone"), std::string::npos);
}

TEST(WhatIfText, WhereNothingIsProposedItSaysWhy) {
  SilverSaid silver;
  EXPECT_EQ(silver.said().nothing,
            "No single change of what was measured would have earned more by itself.");
  database::GateResult gate;
  gate.is_triggered = true;
  silver.card.gates = {gate};
  EXPECT_NE(silver.said().nothing.find("A gate caps this score"), std::string::npos);
  silver.card.gates.clear();
  silver.card.score_milli = 100'000;
  EXPECT_EQ(silver.said().nothing, "Every point was earned: nothing would have earned more.");
  silver.card.score_milli = silver.card.measured_milli = 0;
  EXPECT_NE(silver.said().nothing.find("could be measured"), std::string::npos);
  silver.propose("time_s", 160.0, 60.0, 2'000, {"E1"});
  EXPECT_TRUE(silver.said().nothing.empty());
}

}  // namespace
}  // namespace hallux::ui
