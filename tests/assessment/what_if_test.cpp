#include "assessment/what_if.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/ledger.h"
#include "simulator/base/units.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::AkinAttempt;
using testing::examined;
using testing::ExaminedAttempt;

/// A face that is off in every way.
constexpr AkinAttempt leaning{.entry_x_mm = 7.2,
                              .transverse_deg = 4.0,
                              .sagittal1_deg = -5.0,
                              .wedge_deg = 11.0,
                              .sagittal2_deg = -2.0,
                              .apex_mm = 6.2,
                              .reach1_mm = 6.2,
                              .reach2_mm = 6.2};

/// The worked example, in which the saw's care counts as well.
scenarios::Scenario with_care() {
  scenarios::Scenario scenario = testing::akin_with_deeds();
  for (const char* metric : {"irrigated_share", "force_peak_newton"}) {
    scenarios::RubricItem item;
    item.id = item.title = item.metric = metric;
    item.group = "safety";
    item.weight_milli = 5000;
    scenario.rubric.items.push_back(item);
  }
  scenarios::RubricItem& share = scenario.rubric.items[scenario.rubric.items.size() - 2];
  share.full = 1.0;
  share.zero = 0.2;
  // The hand pushes with 9 N.
  scenario.rubric.items.back().unit = "N";
  scenario.rubric.items.back().full = 12.0;
  scenario.rubric.items.back().zero = 20.0;
  return scenario;
}

/// The examination of `made` is the other's.
struct Asked {
  ExaminedAttempt made;
  WhatIf what_if{made.scenario, made.bone, made.recording, "scripted", std::move(made.examination)};

  explicit Asked(const AkinAttempt& attempt) : made(examined(with_care(), attempt)) {}

  std::int64_t score_milli() const { return what_if.examination().card.score_milli; }
  /// The same before anything was changed.
  const Measurement& was(const Measurement& each) const {
    return *find_measurement(what_if.examination().measurements, each.metric, each.cut, each.hinge,
                             each.zone);
  }
  double known(const std::string& name) const {
    const auto found = std::ranges::find(what_if.known(), name, &KnownChange::name);
    EXPECT_NE(found, what_if.known().end()) << name;
    return found == what_if.known().end() ? NAN : found->from;
  }
};

double value_of(const WhatIfOutcome& outcome, const char* metric, const char* cut,
                const char* hinge = "") {
  const Measurement* found = find_measurement(outcome.measurements, metric, cut, hinge);
  EXPECT_TRUE(found != nullptr && found->is_measured()) << metric;
  return found == nullptr ? NAN : found->value;
}

TEST(WhatIf, KnowsHowAFaceLiesAgainstItsPlan) {
  const Asked asked(AkinAttempt{.entry_x_mm = 6.5});
  EXPECT_NEAR(asked.known("tilt:cut1"), 0.0, 1e-3);
  EXPECT_NEAR(asked.known("roll:cut1"), 0.0, 1e-3);
  EXPECT_NEAR(asked.known("offset:cut1"), 0.5, 2e-3);
  EXPECT_NEAR(asked.known("stop:lateral"), 1.0, 2e-3);
  // Dorsal is the axis: a tilt is a turn in the transverse plane, a roll one in the sagittal plane.
  const Asked tilted(AkinAttempt{.transverse_deg = 4.0});
  EXPECT_NEAR(std::abs(tilted.known("tilt:cut1")), 4.0, 2e-3);
  EXPECT_NEAR(tilted.known("roll:cut1"), 0.0, 2e-3);
  const Asked rolled(AkinAttempt{.sagittal1_deg = 4.0});
  EXPECT_NEAR(std::abs(rolled.known("roll:cut1")), 4.0, 2e-3);
  EXPECT_NEAR(rolled.known("tilt:cut1"), 0.0, 2e-3);
}

TEST(WhatIf, WithoutErrorsBothFacesLieInThePlan) {
  const Asked asked(leaning);
  EXPECT_GT(std::abs(asked.known("tilt:cut1")), 3.0);
  EXPECT_GT(std::abs(asked.known("roll:cut1")), 3.0);
  for (const char* cut : {"cut1", "cut2"}) {
    std::vector<Change> changes;
    for (const char* kind : {"tilt:", "roll:", "offset:"})
      changes.push_back({std::string(kind) + cut, 0.0});
    const WhatIfOutcome outcome = asked.what_if.with(changes);
    EXPECT_LT(value_of(outcome, "location_mm", cut), 1e-3) << cut;
    EXPECT_LT(value_of(outcome, "angle_deg", cut), 1e-3) << cut;
  }
}

TEST(WhatIf, OneChangeLeavesTheOthersAsTheyWere) {
  const Asked asked(leaning);
  const double tilt_deg = asked.known("tilt:cut1"), roll_deg = asked.known("roll:cut1");
  const auto angle_deg = [&](const std::vector<Change>& changes) {
    return value_of(asked.what_if.with(changes), "angle_deg", "cut1");
  };
  const auto angle_of = [](double tilt, double roll) {
    const double cosine = std::cos(radian_from_degree(tilt)) * std::cos(radian_from_degree(roll));
    return degree_from_radian(std::acos(cosine));
  };
  EXPECT_NEAR(angle_deg({}), angle_of(tilt_deg, roll_deg), 1e-3);
  EXPECT_NEAR(angle_deg({{"tilt:cut1", 0.0}}), std::abs(roll_deg), 1e-3);
  EXPECT_NEAR(angle_deg({{"roll:cut1", 0.0}}), std::abs(tilt_deg), 1e-3);
  EXPECT_NEAR(angle_deg({{"roll:cut1", 7.0}}), angle_of(tilt_deg, 7.0), 1e-3);
  EXPECT_NEAR(angle_deg({{"roll:cut1", 2.0}, {"tilt:cut1", -6.0}}), angle_of(6.0, 2.0), 1e-3);
  const WhatIfOutcome shifted = asked.what_if.with({{"offset:cut1", 0.0}});
  for (const Measurement& each : shifted.measurements) {
    if (each.metric != "angle_deg") continue;
    EXPECT_NEAR(each.value, asked.was(each).value, 1e-3) << each.cut;
  }
}

TEST(WhatIf, AStopGivesTheBridgeThatWasAskedFor) {
  for (const AkinAttempt& attempt :
       {AkinAttempt{}, leaning, AkinAttempt{.reach1_mm = 8.5, .reach2_mm = 6.0}}) {
    const Asked asked(attempt);
    for (const double bridge_mm : {0.5, 1.0, 2.2}) {
      const WhatIfOutcome outcome = asked.what_if.with({{"stop:lateral", bridge_mm}});
      EXPECT_NEAR(value_of(outcome, "hinge_mm", "", "lateral"), bridge_mm, 0.05);
      EXPECT_EQ(value_of(outcome, "over_cut_mm", "", "lateral"), 0.0);
      EXPECT_EQ(value_of(outcome, "hinge_lost", "", "lateral"), 0.0);
    }
  }
}

TEST(WhatIf, AStopHoldsWhereTheFacesAreTurnedAsWell) {
  const Asked asked(leaning);
  for (const char* kind : {"tilt:", "roll:", "offset:"}) {
    std::vector<Change> changes{{"stop:lateral", 1.2}};
    for (const char* cut : {"cut1", "cut2"}) changes.push_back({std::string(kind) + cut, 0.0});
    EXPECT_NEAR(value_of(asked.what_if.with(changes), "hinge_mm", "", "lateral"), 1.2, 0.05)
        << kind;
  }
}

TEST(WhatIf, AMetricOfTheWorkIsReplaced) {
  const Asked asked(AkinAttempt{});
  const WhatIfOutcome outcome = asked.what_if.with({{"irrigated_share", 0.6}});
  EXPECT_EQ(value_of(outcome, "irrigated_share", ""), 0.6);
  EXPECT_EQ(find_measurement(outcome.measurements, "irrigated_share", "")->remark, Remark::Assumed);
  // Half way between none and all: half of 5 of the 68 points that are measured.
  const std::int64_t gain_milli = outcome.card.score_milli - asked.score_milli();
  EXPECT_NEAR(static_cast<double>(gain_milli), 100000.0 * 2.5 / 68.0, 1.0);
  for (const Measurement& each : outcome.measurements) {
    if (each.metric == "irrigated_share") continue;
    EXPECT_EQ(each.value, asked.was(each).value) << each.metric;
  }
}

TEST(WhatIf, WithoutAChangeNothingChanges) {
  const Asked asked(leaning);
  EXPECT_EQ(asked.what_if.with({}).card.score_milli, asked.score_milli());
  // What is measured again where nothing moves is what was, as far as poses are rounded.
  const WhatIfOutcome same = asked.what_if.with({{"tilt:cut1", asked.known("tilt:cut1")}});
  for (const Measurement& each : same.measurements) {
    const Measurement& before = asked.was(each);
    EXPECT_EQ(each.absence, before.absence) << each.metric;
    EXPECT_NEAR(each.value, before.value, 2e-3) << each.metric << each.cut << each.hinge;
    EXPECT_EQ(each.done_fraction, before.done_fraction);
  }
}

TEST(WhatIf, WhatIsProposedGainsAsItSays) {
  for (const AkinAttempt& attempt : {leaning, AkinAttempt{.reach1_mm = 10.0, .reach2_mm = 7.0}}) {
    const Asked asked(attempt);
    const std::int64_t score_milli = asked.score_milli();
    const Proposals proposals = asked.what_if.propose();
    ASSERT_FALSE(proposals.changes.empty());
    EXPECT_LE(proposals.changes.size(), 3U);
    std::vector<Change> together;
    std::int64_t before_milli = 100000;
    for (const ProposedChange& each : proposals.changes) {
      EXPECT_GT(each.gain_milli, 0) << each.change.name;
      EXPECT_LE(each.gain_milli, before_milli) << "the greatest first";
      before_milli = each.gain_milli;
      EXPECT_EQ(asked.what_if.with({{each.change.name, each.to}}).card.score_milli,
                score_milli + each.gain_milli)
          << each.change.name;
      together.push_back({each.change.name, each.to});
    }
    EXPECT_EQ(asked.what_if.with(together).card.score_milli, proposals.score_milli);
    EXPECT_EQ(proposals.gain_milli, proposals.score_milli - score_milli);
  }
}

// Both blades went through the far cortex.
TEST(WhatIf, AProposalNamesTheGatesThatItLifts) {
  const Asked asked(AkinAttempt{.reach1_mm = 10.0, .reach2_mm = 10.0});
  const auto is_triggered = [](const database::ScoreCard& card, const std::string& name) {
    const auto gate = std::ranges::find(card.gates, name, &database::GateResult::name);
    return gate != card.gates.end() && gate->is_triggered;
  };
  ASSERT_TRUE(is_triggered(asked.what_if.examination().card, "hinge_lost"));
  const Proposals proposals = asked.what_if.propose();
  const auto stop = std::ranges::find(proposals.changes, "stop:lateral",
                                      [](const ProposedChange& each) { return each.change.name; });
  ASSERT_NE(stop, proposals.changes.end());
  EXPECT_NE(std::ranges::find(stop->lifted_gates, "hinge_lost"), stop->lifted_gates.end());
  const database::ScoreCard then = asked.what_if.with({{stop->change.name, stop->to}}).card;
  for (const std::string& gate : stop->lifted_gates) EXPECT_FALSE(is_triggered(then, gate)) << gate;
  for (const ProposedChange& each : proposals.changes) {
    EXPECT_TRUE(!each.change.is_replaced || each.lifted_gates.empty()) << each.change.name;
  }
}

// All is on plan but for the water: no kerf and no push is worth moving.
TEST(WhatIf, NothingIsProposedThatGainsNothing) {
  const Asked asked(AkinAttempt{});
  const Proposals proposals = asked.what_if.propose();
  ASSERT_EQ(proposals.changes.size(), 1U);
  EXPECT_EQ(proposals.changes[0].change.name, "irrigated_share");
  EXPECT_EQ(proposals.changes[0].to, 1.0);
  EXPECT_EQ(proposals.changes[0].items, std::vector<std::string>{"irrigated_share"});
  EXPECT_EQ(proposals.score_milli, 100000);
}

TEST(WhatIf, OfAnAttemptWithoutCutsOnlyTheWorkIsKnown) {
  const simulator::Bone bone = testing::oval_bone();
  ExaminedAttempt made = examined(with_care(), bone, simulator::Recording{});
  const WhatIf what_if(made.scenario, made.bone, made.recording, "scripted",
                       std::move(made.examination));
  for (const KnownChange& each : what_if.known()) EXPECT_TRUE(each.is_replaced) << each.name;
  EXPECT_TRUE(what_if.propose().changes.empty());
}

TEST(WhatIf, RefusesAnUnknownChangeWithTheListOfThoseThereAre) {
  const Asked asked(AkinAttempt{});
  for (const std::vector<Change>& changes :
       {std::vector<Change>{{"tilt:cut3", 0.0}},
        std::vector<Change>{{"tilt:cut1", 0.0}, {"tilt:cut3", 0.0}}}) {
    try {
      asked.what_if.with(changes);
      FAIL() << "there is no third cut";
    } catch (const scenarios::ScenarioError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("\"tilt:cut3\""), std::string::npos) << message;
      for (const KnownChange& each : asked.what_if.known())
        EXPECT_NE(message.find(each.name), std::string::npos) << each.name;
    }
  }
}

}  // namespace
}  // namespace hallux::assessment
