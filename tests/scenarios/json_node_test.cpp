#include "scenarios/json_node.h"

#include <gtest/gtest.h>

namespace hallux::scenarios {
namespace {

std::string refusal_of(std::string_view text) {
  try {
    parse_bounded_json(text, "a.json");
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(BoundedJson, NamesTheLineWhereItStopsBeingJson) {
  EXPECT_EQ(refusal_of("{\n  \"a\": 1,\n  \"b\" 2\n}"),
            "a.json: line 3, column 7: is not JSON from here on; mend the commas, quotes and "
            "brackets at this place");
  EXPECT_NE(refusal_of(""), "");
  EXPECT_NE(refusal_of("{\"a\": NaN}"), "");
  EXPECT_NE(refusal_of("{\"a\": \"\xff\"}"), "");
}

TEST(BoundedJson, RefusesAKeyThatIsTwiceInOneObjectOnly) {
  EXPECT_NE(refusal_of(R"({"a": 1, "a": 2})").find("\"a\": is twice"), std::string::npos);
  EXPECT_EQ(refusal_of(R"({"a": {"b": 1}, "c": {"b": 2, "a": 3}})"), "");
}

TEST(BoundedJson, RefusesTextDeeperThanItsBound) {
  const auto nested = [](int depth) {
    const auto count = static_cast<std::size_t>(depth);
    return std::string(count, '[') + std::string(count, ']');
  };
  EXPECT_EQ(refusal_of(nested(json_depth_max)), "");
  EXPECT_NE(refusal_of(nested(json_depth_max + 1)).find("deeper than 12"), std::string::npos);
  EXPECT_NE(refusal_of(nested(100'000)).find("deeper than 12"), std::string::npos);
}

TEST(BoundedJson, RefusesTextLongerThanItsBound) {
  const std::string spaces(json_bytes_max - 1, ' ');
  EXPECT_EQ(refusal_of("1" + spaces), "");
  EXPECT_NE(refusal_of("1 " + spaces).find("256 KiB"), std::string::npos);
}

TEST(BoundedJson, RefusesANumberBeyondDouble) {
  EXPECT_NE(refusal_of("[1e999]").find("too large"), std::string::npos);
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(text_of_number(0.1), "0.1");
  EXPECT_EQ(text_of_number(12.0), "12");
  EXPECT_EQ(text_of_number(-0.25), "-0.25");
}

}  // namespace
}  // namespace hallux::scenarios
