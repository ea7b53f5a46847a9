// The health panel with an arm: the modelled one stands where a driver stands.
#include "ui/screens/operating/hud/operating_health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/device/force_output.h"
#include "simulator/device/modelled/modelled_arm.h"
#include "tests/ui/screens/operating/shown_panels.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/screens/result/recording_card.h"

namespace hallux::ui {
namespace {

using simulator::ForceLimit;
using testing::IsEmpty;

constexpr std::uint32_t every_limit = (1U << 7U) - 1U;

struct Panels : ShownPanels {
  using ShownPanels::ShownPanels;

  void show(const OperatingHealth& health) {
    hud.is_health_open = true;
    hud.health = health;
    driver.frame();
  }
};

TEST(OperatingHealth, SaysNothingOfAnArmWhereNobodyIsPushedBack) {
  Panels panels;
  panels.show(health_of({}, std::nullopt, every_limit));
  EXPECT_TRUE(panels.driver.sees("Ticks missed"));
  EXPECT_FALSE(panels.driver.sees("share of the force"));
  EXPECT_FALSE(panels.driver.sees("Held back by"));
}

TEST(OperatingHealth, ShowsWhatAnArmIsGivenAndWhatHoldsItBack) {
  simulator::LoopView view;
  view.device_force_newton = Vec3(0.0, 3.0, 4.0);
  Panels panels;
  panels.show(health_of(view, 0.24, 0));
  EXPECT_TRUE(panels.driver.sees("24 %"));
  EXPECT_TRUE(panels.driver.sees("5.0 N"));
  EXPECT_TRUE(panels.driver.sees("nothing"));
  panels.show(health_of(view, 0.24, bit(ForceLimit::Heat) | bit(ForceLimit::SoftStart)));
  EXPECT_TRUE(panels.driver.sees("warm motors"));
  EXPECT_TRUE(panels.driver.sees("a soft start"));
  EXPECT_FALSE(panels.driver.sees("nothing"));
}

TEST(OperatingHealth, StaysInsideTheWindowAtEveryScaleWithAllThatMayBeSaid) {
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Panels panels(scale, {1280.0F, 720.0F});
    panels.show(health_of({}, 0.24, every_limit));
    EXPECT_THAT(panels.driver.faults(), IsEmpty()) << scale;
    const Rect display = panels.driver.ui().display();
    EXPECT_TRUE(display.encloses(panels.driver.widget("operate.panel.health").rect)) << scale;
    for (const char* words : {"a stop", "its speed", "warm motors", "its strength", "damping",
                              "a soft start", "its quickness"})
      EXPECT_TRUE(panels.driver.sees(words)) << words << " at " << scale;
  }
}

TEST(RecentLimits, AreReadForASecondAndGoAfterTwo) {
  RecentLimits limits;
  limits.observe(bit(ForceLimit::Slew), 10.0);
  limits.observe(0, 10.5);
  EXPECT_EQ(limits.bits(), bit(ForceLimit::Slew));
  limits.observe(bit(ForceLimit::Heat), 11.1);
  EXPECT_EQ(limits.bits(), bit(ForceLimit::Slew) | bit(ForceLimit::Heat));
  limits.observe(0, 12.2);
  EXPECT_EQ(limits.bits(), bit(ForceLimit::Heat));
  limits.observe(0, 13.3);
  EXPECT_EQ(limits.bits(), 0U);
}

/// An attempt that ada makes with a modelled arm of 8 N, held still over the bone.
struct ArmAttempt {
  ArmAttempt() {
    const std::shared_ptr<SignedInSession> signed_in = course.visit_of_ada();
    prepared_case = course.prepared_case(*signed_in);
    LiveBegin what;
    what.scenario = course.version();
    what.person = signed_in->person().id;
    simulator::HandMotion motion;
    motion.keys = {{0, start_pose(*prepared_case), 0}};
    live = begin_operation(
        *signed_in, prepared_case, what,
        std::make_unique<simulator::ModelledArm>(motion, simulator::ModelledArmSetup{}));
  }

  OperableCourse course{"silver"};
  std::shared_ptr<const PreparedCase> prepared_case;
  std::unique_ptr<LiveAttempt> live;
};

TEST(OperatingHealth, OfAModelledArmIsShownWhileItOperatesAndKeptForWhoeverDecides) {
  ArmAttempt attempt;
  ASSERT_TRUE(attempt.live->force_scale().has_value());
  EXPECT_NEAR(*attempt.live->force_scale(), 0.24, 1.0e-12) << "six tenths of 8 N for 20 N";
  RecentLimits limits;
  ASSERT_TRUE(soon([&] {
    const simulator::LoopView& view = attempt.live->view();
    limits.observe(view.force_limits, 0.0);
    return view.lines > 200;
  }));
  EXPECT_NE(limits.bits(), 0U) << "it began softly";
  Panels panels;
  panels.show(health_of(attempt.live->view(), attempt.live->force_scale(), limits.bits()));
  EXPECT_TRUE(panels.driver.sees("24 %"));
  EXPECT_FALSE(panels.driver.sees("nothing"));
  attempt.live->finish();
  ASSERT_TRUE(soon([&] { return attempt.live->end() != nullptr; }));
  ASSERT_TRUE(attempt.live->end()->is_sealed);

  ResultFacts facts;
  facts.header = attempt.course.attempt();
  facts.quality = quality_from_json(facts.header.quality_json);
  ASSERT_TRUE(facts.quality.has_value());
  EXPECT_DOUBLE_EQ(facts.quality->force_scale, *attempt.live->force_scale());
  EXPECT_EQ(facts.quality->force_limits, attempt.live->end()->loop.force_limits);
  Driver decider(panels.texts, [&](Ui& ui) {
    const float height = recording_card_height(ui, facts, 900.0F);
    draw_recording_card(ui, {0.0F, 0.0F, 900.0F, height}, facts);
  });
  EXPECT_TRUE(decider.sees("24 %"));
  EXPECT_TRUE(decider.sees("a soft start"));
  EXPECT_THAT(decider.faults(), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
