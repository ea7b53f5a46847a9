// The numbers of one screen agree: the label beside the teeth, the section in the blade's plane and
// the end of the stroke are told from one way ahead, over a stroke to the far side and to a hinge.
#include "ui/screens/operating/hud_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/ui/screens/operating/obedient_hand.h"
#include "tests/ui/screens/operating/shown_panels.h"

namespace hallux::ui {
namespace {

using testing::StartsWith;

/// The first stroke of an operation, led by hints, with its panels.
class Stroke {
 public:
  explicit Stroke(const std::string& scenario) : operation_(scenario) {
    section_.section.bone_mm = {{{0.0, -9.0}, {15.0, -9.0}, {15.0, 9.0}, {0.0, 9.0}}};
  }

  /// A look of the hand; then the panels show what is known, the section with its own bone.
  void go_on() {
    const std::optional<Hint> hint = next_hint(coach_view(operation_.sources()));
    hint ? obey(operation_, *hint) : operation_.advance(ticks_per_look);
    HudSources from = operation_.sources();
    from.cut = &operation_.prepared_case().plan.cuts.front();
    hud_ = hud_of(from, true);
    section_.way = hud_.way;
    panels_.hud = hud_;
    panels_.hud.tip = Point{600.0F, 500.0F};
    panels_.hud.inset = &section_;
    panels_.driver.frame();
  }
  bool is_in_kerf() { return coach_view(operation_.sources()).is_in_kerf; }
  double time_s() const { return operation_.time_s(); }
  const OperatingHud& hud() const { return hud_; }
  double far_side_mm() { return operation_.site()->ahead.to_far_side_mm.value_or(0.0); }
  std::string told(std::string_view id) const { return panels_.told(id); }
  /// Words and numbers of the section itself, as drawn.
  bool is_drawn(const std::string& words) const { return panels_.driver.sees(words); }

 private:
  VirtualOperation operation_;
  OperatingHud hud_;
  BladeSection section_;
  ShownPanels panels_;
};

class OneWayAhead : public testing::TestWithParam<std::tuple<std::string, WayEnd>> {};

TEST_P(OneWayAhead, IsToldByLabelSectionAndEndOfTheStroke) {
  const auto& [scenario, end] = GetParam();
  Stroke stroke(scenario);
  std::set<WayEnd> told;
  int in_kerf = 0;
  while (in_kerf < 12 && stroke.time_s() < 120.0) {
    stroke.go_on();
    if (!stroke.hud().way) continue;
    const WayAhead way = *stroke.hud().way;
    told.insert(way.to);
    const std::string words = stroke.told("operate.inset");
    EXPECT_FALSE(words.empty());
    EXPECT_THAT(stroke.told("operate.ahead"), StartsWith(words + ". Plan "));
    EXPECT_TRUE(stroke.is_drawn(words));
    if (!stroke.is_in_kerf()) continue;
    ++in_kerf;
    if (way.to != end) continue;
    const PlanReading& blade = stroke.hud().plan->blade;
    ASSERT_TRUE(blade.end_distance_mm);
    EXPECT_DOUBLE_EQ(*blade.end_distance_mm, distance_ahead_mm(blade, way.way_mm));
    if (end == WayEnd::Hinge) {
      EXPECT_LT(way.way_mm, stroke.far_side_mm()) << "the stroke stops before the far side";
    }
  }
  EXPECT_TRUE(told.contains(WayEnd::Bone));
  EXPECT_TRUE(told.contains(end));
  const WayEnd other = end == WayEnd::Hinge ? WayEnd::FarSide : WayEnd::Hinge;
  EXPECT_FALSE(told.contains(other));
}

INSTANTIATE_TEST_SUITE_P(Scenarios, OneWayAhead,
                         testing::Values(std::tuple{std::string("silver"), WayEnd::FarSide},
                                         std::tuple{std::string("akin"), WayEnd::Hinge}));

}  // namespace
}  // namespace hallux::ui
