// The order of steps as a graph: what may follow, what is left out, and what nobody can carry out.
#include "scenarios/steps/step_order.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "scenarios/steps/step_words.h"
#include "tests/scenarios/format_1/format_1.h"

namespace hallux::scenarios {
namespace {

using Steps = std::vector<OperationStep>;

OperationStep step(const char* id, std::vector<std::string> after, const char* one_of = "",
                   bool is_optional = false) {
  OperationStep made;
  made.kind = StepKind::Retract;
  made.id = id;
  made.after = std::move(after);
  made.one_of = one_of;
  made.is_optional = is_optional;
  return made;
}

/// Between a verify "v" and a finish "f" after `last`.
Scenario ordered(Steps between, std::vector<std::string> last) {
  Scenario scenario;
  scenario.format = 2;
  scenario.steps = std::move(between);
  scenario.steps.insert(scenario.steps.begin(), step("v", {}));
  scenario.steps.front().kind = StepKind::Verify;
  scenario.steps.push_back(step("f", std::move(last)));
  scenario.steps.back().kind = StepKind::Finish;
  return scenario;
}

std::string refusal_of(const Scenario& scenario) {
  try {
    check_step_order(scenario, "f.json");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(StepOrder, OfFormat1IsTheChain) {
  const Scenario akin = scenarios_test::format_1("akin");
  std::vector<bool> is_done(akin.steps.size(), false);
  for (std::size_t next = 0; next < akin.steps.size(); ++next) {
    EXPECT_FALSE(is_all_done(akin, is_done));
    EXPECT_EQ(steps_at_hand(akin, is_done), std::vector<std::size_t>{next});
    is_done[next] = true;
  }
  EXPECT_TRUE(is_all_done(akin, is_done));
  EXPECT_TRUE(steps_at_hand(akin, is_done).empty());
}

TEST(StepOrder, PutsEachBehindAllThatLeadsToIt) {
  // "late" is listed first, and comes after either of a group.
  const Scenario scenario = ordered({step("late", {"pair"}), step("one", {"first"}, "pair"),
                                     step("other", {"v"}, "pair"), step("first", {"v"})},
                                    {"late"});
  EXPECT_EQ(refusal_of(scenario), "");
  const std::vector<std::size_t> order = steps_in_order(scenario);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 3, 4, 2, 1, 5}));
}

TEST(StepOrder, MayBeAnyThatTheStepsLeaveOpen) {
  const Scenario scenario =
      ordered({step("a", {"v"}), step("b", {"v"}), step("c", {"a", "b"})}, {"c"});
  ASSERT_EQ(refusal_of(scenario), "");
  std::vector<bool> is_done{true, false, false, false, false};
  EXPECT_EQ(steps_at_hand(scenario, is_done), (std::vector<std::size_t>{1, 2}));
  is_done[2] = true;
  EXPECT_EQ(steps_at_hand(scenario, is_done), std::vector<std::size_t>{1});
  is_done[1] = true;
  EXPECT_EQ(steps_at_hand(scenario, is_done), std::vector<std::size_t>{3});
}

TEST(StepOrder, LeavesOptionalStepsOutButNeverDoesThemAfterwards) {
  const Scenario scenario =
      ordered({step("a", {"v"}, "", true), step("b", {"a"}, "", true), step("c", {"b"})}, {"c"});
  ASSERT_EQ(refusal_of(scenario), "");
  std::vector<bool> is_done{true, false, false, false, false};
  EXPECT_EQ(steps_at_hand(scenario, is_done), (std::vector<std::size_t>{1, 2, 3}));
  is_done[2] = true;
  EXPECT_EQ(steps_at_hand(scenario, is_done), std::vector<std::size_t>{3}) << "a is passed over";
  is_done = {false, false, false, false, false};
  EXPECT_EQ(steps_at_hand(scenario, is_done), std::vector<std::size_t>{0})
      << "what comes before an optional step is not left out with it";
  is_done = {true, false, false, true, true};
  EXPECT_TRUE(is_all_done(scenario, is_done));
}

TEST(StepOrder, AsksForOneOfAlternatives) {
  const Scenario scenario =
      ordered({step("a", {"v"}, "way"), step("b", {"v"}, "way"), step("b2", {"way"})}, {"b2"});
  ASSERT_EQ(refusal_of(scenario), "");
  std::vector<bool> is_done{true, false, false, false, false};
  EXPECT_EQ(steps_at_hand(scenario, is_done), (std::vector<std::size_t>{1, 2}));
  is_done[2] = true;
  EXPECT_EQ(steps_at_hand(scenario, is_done), std::vector<std::size_t>{3});
  is_done = {true, true, false, true, false};
  EXPECT_FALSE(is_all_done(scenario, is_done));
  is_done[4] = true;
  EXPECT_TRUE(is_all_done(scenario, is_done));
}

TEST(StepOrder, RefusesUnknownAndDoubledIds) {
  EXPECT_EQ(refusal_of(ordered({step("a", {"v"}), step("a", {"v"})}, {"a"})),
            "f.json: steps[2].id: is \"a\", which is already taken; give each its own");
  EXPECT_EQ(refusal_of(ordered({step("a", {"w"})}, {"a"})),
            "f.json: steps[1].after[0]: is \"w\", which is no step and no group; name a group, or "
            "one of: v, a, f");
  EXPECT_EQ(refusal_of(ordered({step("a", {"v"}, "v"), step("b", {"v"}, "v")}, {"a"})),
            "f.json: steps[1].one_of: is \"v\", which is a step; give the group a name of its own");
  EXPECT_EQ(refusal_of(ordered({step("a", {"v"}, "way")}, {"a"})),
            "f.json: steps[1].one_of: is \"way\", which has no other alternative; name the same "
            "group in another step, or remove it");
}

TEST(StepOrder, RefusesCycles) {
  EXPECT_EQ(refusal_of(ordered({step("a", {"v", "c"}), step("b", {"a"}), step("c", {"b"})}, {"c"})),
            "f.json: steps[1].after: leads round about to \"a\" itself; let no step come after "
            "itself");
  EXPECT_EQ(refusal_of(ordered({step("a", {"v", "way"}, "way"), step("b", {"v"}, "way")}, {"way"})),
            "f.json: steps[1].after: leads round about to \"a\" itself; let no step come after "
            "itself");
}

TEST(StepOrder, RefusesWhatNobodyCanDo) {
  EXPECT_EQ(refusal_of(ordered(
                {step("a", {"v"}, "way"), step("b", {"v"}, "way"), step("c", {"a", "b"})}, {"c"})),
            "f.json: steps[3].after: asks for \"a\" and \"b\", of which one excludes the other; "
            "name the group \"way\" instead");
  EXPECT_EQ(refusal_of(ordered({step("a", {"v"}, "way"), step("b", {"a"}, "way")}, {"way"})),
            "f.json: steps[2].after: asks for \"a\" and \"b\", of which one excludes the other; "
            "name the group \"way\" instead");
  EXPECT_EQ(refusal_of(ordered({step("a", {"v"}, "way"), step("b", {"v"}, "way", true)}, {"way"})),
            "f.json: steps[2].optional: differs between the alternatives of a group; let all of "
            "\"way\" be optional, or none");
}

TEST(StepOrder, BeginsWithVerifyAndEndsWithFinish) {
  EXPECT_EQ(refusal_of(ordered({step("a", {})}, {"a"})),
            "f.json: steps[1].after: does not lead back to \"v\"; let every step come after the "
            "one \"verify\"");
  EXPECT_EQ(refusal_of(ordered({step("a", {"v"}), step("b", {"v"})}, {"a"})),
            "f.json: steps[3].after: does not wait for \"b\"; let the one \"finish\" come after "
            "every step");
  Scenario two = ordered({step("a", {"v"})}, {"a"});
  two.steps[1].kind = StepKind::Finish;
  EXPECT_EQ(refusal_of(two),
            "f.json: steps: have not exactly one \"finish\"; begin with the one \"verify\" and end "
            "with the one \"finish\"");
}

/// As many as a file may hold, each after all before it: every way through them is one too many to
/// walk.
TEST(StepOrder, IsWorkedOutAtOnceHoweverManyWaysLeadThroughIt) {
  Steps between;
  std::vector<std::string> before{"v"};
  std::vector<std::string> ids;
  ids.reserve(62);
  for (int i = 0; i < 62; ++i) ids.push_back("s" + std::to_string(i));
  for (const std::string& id : ids) {
    between.push_back(step(id.c_str(), before, "", true));
    before.push_back(id);
  }
  const Scenario scenario = ordered(between, before);
  EXPECT_EQ(refusal_of(scenario), "");
  std::vector<bool> is_done(scenario.steps.size(), false);
  is_done[0] = true;
  EXPECT_EQ(steps_at_hand(scenario, is_done).size(), 63U);
}

/// Whatever is taken of what is at hand, the end is reached, and never two of a group.
RC_GTEST_PROP(StepOrder, LeadsToItsEndByAnyWay, ()) {
  const Scenario scenario =
      ordered({step("a", {"v"}), step("o", {"v"}, "", true), step("x", {"a"}, "way"),
               step("y", {"a", "o"}, "way"), step("z", {"o"}), step("w", {"way", "z"})},
              {"w"});
  RC_ASSERT(refusal_of(scenario).empty());
  std::vector<bool> is_done(scenario.steps.size(), false);
  for (std::size_t steps = 0; steps <= scenario.steps.size(); ++steps) {
    const std::vector<std::size_t> at_hand = steps_at_hand(scenario, is_done);
    if (at_hand.empty()) break;
    is_done[*rc::gen::elementOf(at_hand)] = true;
    RC_ASSERT(!(is_done[3] && is_done[4]));
  }
  RC_ASSERT(is_all_done(scenario, is_done));
  RC_ASSERT(is_done.back());
}

TEST(StepWords, AreReadAsTheyAreWritten) {
  for (const char* word : {"verify", "mark", "guide_wire", "retract", "cut", "complete", "remove",
                           "shift", "close", "temporary_wire", "fix", "trim", "finish"}) {
    ASSERT_TRUE(find_step_kind(word).has_value()) << word;
    EXPECT_EQ(step_word(*find_step_kind(word)), word);
    EXPECT_NE(step_words().find(word), std::string::npos);
  }
  EXPECT_FALSE(find_step_kind("hammer").has_value());
}

}  // namespace
}  // namespace hallux::scenarios
