// Planted faults of format 2, each refused with file, path and mend. The schema is held against the
// same list (tests/scenarios/schema).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/scenarios/format_2/fixtures.h"

namespace hallux::scenarios_test {
std::span<const EmbeddedText> planted_faults_of_format_2() noexcept;
}

namespace hallux::scenarios {
namespace {

using nlohmann::json;

TEST(Format2, IsRead) {
  for (const char* name : {"chevron", "akin"}) {
    EXPECT_EQ(scenarios_test::refusal_of(scenarios_test::fixture_json(name)), "") << name;
    const Scenario scenario = scenarios_test::fixture(name);
    EXPECT_EQ(scenario.format, 2);
    EXPECT_EQ(scenario.saw.blade.width_mm, scenario.blades.at(0).saw.blade.width_mm);
    EXPECT_EQ(review_label(scenario), "not surgeon-reviewed");
  }
}

TEST(Format2, OfALaterProgramIsRefusedByItsFormat) {
  json later = scenarios_test::fixture_json("chevron");
  later["format"] = 3;
  later["colour"] = "red";
  EXPECT_EQ(scenarios_test::refusal_of(later),
            "f.json: format: is 3; this program reads formats 1 and 2; update the program, or "
            "write one of them");
}

TEST(Format2, WithAPlantedFaultIsRefusedWithFilePathAndMend) {
  const json faults = json::parse(scenarios_test::planted_faults_of_format_2()[0].text);
  ASSERT_GT(faults.size(), 40U);
  for (const json& fault : faults) {
    const json whole = scenarios_test::fixture_json(fault.value("of", "chevron"));
    const std::string sentence = scenarios_test::refusal_of(whole.patch(fault.at("patch")));
    const std::string start = "f.json: " + fault.at("path").get<std::string>() + ": ";
    EXPECT_EQ(sentence.substr(0, start.size()), start) << fault.at("name") << "\n" << sentence;
    EXPECT_NE(sentence.find(fault.at("says").get<std::string>()), std::string::npos)
        << fault.at("name") << "\n"
        << sentence;
    EXPECT_NE(sentence.find("; "), std::string::npos) << sentence;
  }
}

RC_GTEST_PROP(Format2, WithDamagedBytesIsReadOrRefusedButNeverAnythingElse, ()) {
  std::string text = scenarios_test::fixture_json("chevron").dump();
  const int damages = *rc::gen::inRange(1, 6);
  for (int i = 0; i < damages; ++i)
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
  try {
    parse_scenario(text, "f.json");
  } catch (const ScenarioError&) {
  }
}

}  // namespace
}  // namespace hallux::scenarios
