#include "scenarios/scenario.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "simulator/base/units.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/support/temporary_directory.h"

namespace hallux::scenarios_test {
std::span<const EmbeddedText> planted_faults() noexcept;
}

namespace hallux::scenarios {
namespace {

using nlohmann::json;

json silver_json() { return json::parse(scenarios_test::format_1("silver").text); }

std::string refusal_of(std::string_view text, std::string_view name = "silver.json") {
  try {
    parse_scenario(text, name);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(Scenario, ShippedOnesAreReadableAndNamedLikeTheirFile) {
  ASSERT_FALSE(shipped_scenarios().empty());
  for (const EmbeddedText& shipped : shipped_scenarios()) {
    const Scenario scenario = parse_scenario(shipped.text, shipped.name);
    EXPECT_EQ(scenario.name + ".json", shipped.name);
    EXPECT_EQ(scenario.text, shipped.text);
  }
}

TEST(Scenario, SilverCutsAlongTheShaftOneMillimetreMedialToTheSulcus) {
  const Scenario silver = scenarios_test::format_1("silver");
  ASSERT_EQ(silver.cuts.size(), 1U);
  const ReferenceCut& cut = silver.cuts[0];
  EXPECT_EQ(cut.name, "eminence");
  EXPECT_EQ(cut.face.through, "med_sulcus");
  EXPECT_EQ(cut.face.offset_mm, 1.0);
  EXPECT_EQ(cut.face.frontal_tilt_rad, radian_from_degree(5.0));
  EXPECT_EQ(cut.waste_side, "medial");
  EXPECT_EQ(silver.patient.eminence_mm, 4.0);
  EXPECT_FALSE(silver.is_reviewed);
}

std::map<std::string, std::int64_t> weights_of(const Rubric& rubric) {
  std::map<std::string, std::int64_t> weights;
  for (const RubricItem& item : rubric.items) weights[item.group] += item.weight_milli;
  return weights;
}

const std::map<std::string, std::int64_t> whole_weights{{"accuracy", 50'000},
                                                        {"safety", 22'000},
                                                        {"tool_use", 12'000},
                                                        {"procedure", 8'000},
                                                        {"efficiency", 8'000}};

TEST(Scenario, SilverWeighsAllOfItsGroups) {
  const Rubric rubric = scenarios_test::format_1("silver").rubric;
  ASSERT_EQ(rubric.groups.size(), 5U);
  ASSERT_EQ(rubric.items.size(), 20U);
  EXPECT_EQ(rubric.groups[0].weight_milli, 50'000);
  EXPECT_EQ(rubric.items[0].weight_milli, 16'000);
  EXPECT_EQ(rubric.items[0].unit, "deg");
  for (const RubricItem& item : rubric.items) {
    EXPECT_TRUE(item.is_provisional);
    EXPECT_FALSE(item.origin.empty());
  }
  EXPECT_EQ(weights_of(rubric), whole_weights);
  ASSERT_EQ(rubric.gates.size(), 7U);
  EXPECT_EQ(rubric.gates[1].cap_milli, 59'000);
  EXPECT_EQ(rubric.gates[2].cap_milli, 69'000);
}

TEST(Scenario, AkinJoinsTwoFacesAcrossTheBoneAtAHingeInsideTheLateralCortex) {
  const Scenario akin = scenarios_test::format_1("akin");
  ASSERT_EQ(akin.cuts.size(), 2U);
  EXPECT_EQ(akin.cuts[0].face.kind, FaceKind::Transverse);
  EXPECT_EQ(akin.cuts[0].face.offset_mm, 6.0);
  EXPECT_EQ(akin.cuts[1].face.kind, FaceKind::ThroughHinge);
  EXPECT_EQ(akin.cuts[1].face.wedge_rad, radian_from_degree(10.0));
  ASSERT_EQ(akin.hinges.size(), 1U);
  const ReferenceHinge& hinge = akin.hinges[0];
  EXPECT_EQ(hinge.first_cut, akin.cuts[0].name);
  EXPECT_EQ(hinge.second_cut, akin.cuts[1].name);
  EXPECT_EQ(akin.cuts[1].face.through, hinge.name);
  EXPECT_EQ(hinge.thickness_mm, 1.0);
  EXPECT_EQ(hinge.breaks_below_mm, 0.3);
  EXPECT_EQ(hinge.bends_up_to_mm, 2.5);
  std::vector<StepKind> kinds;
  for (const OperationStep& step : akin.steps) kinds.push_back(step.kind);
  EXPECT_EQ(kinds, (std::vector{StepKind::Verify, StepKind::Cut, StepKind::Cut, StepKind::Remove,
                                StepKind::Close, StepKind::Finish}));
  EXPECT_FALSE(akin.is_reviewed);
}

TEST(Scenario, AkinWeighsAllOfItsGroups) {
  const Rubric rubric = scenarios_test::format_1("akin").rubric;
  for (const RubricItem& item : rubric.items) EXPECT_TRUE(item.is_provisional) << item.id;
  EXPECT_EQ(weights_of(rubric), whole_weights);
  ASSERT_EQ(rubric.gates.size(), 9U);
  EXPECT_EQ(rubric.gates[2].metric, "hinge_lost");
  EXPECT_EQ(rubric.gates[2].cap_milli, 69'000);
  EXPECT_EQ(rubric.gates[3].metric, "over_cut_mm");
  EXPECT_EQ(rubric.gates[3].limit, 2.0);
  EXPECT_EQ(rubric.gates[3].cap_milli, 59'000);
}

std::string metric_of_deed(StepKind kind) {
  if (kind == StepKind::Remove) return "piece_out";
  if (kind == StepKind::Close) return "wedge_closed";
  return kind == StepKind::Shift ? "shifted" : "";
}

std::string shifted_fragment(const Scenario& scenario, const OperationStep& step) {
  const auto shift = std::ranges::find(scenario.shifts, step.shift, &FragmentShift::name);
  return shift == scenario.shifts.end() ? "" : shift->fragment;
}

/// What an operation removes, closes or shifts is asked for by a gate that leaves nobody above the
/// pass mark without it.
TEST(Scenario, EveryShippedOneGatesItsDeeds) {
  constexpr std::int64_t pass_mark_milli = 60'000;
  for (const EmbeddedText& shipped : shipped_scenarios()) {
    const Scenario scenario = parse_scenario(shipped.text, shipped.name);
    for (const OperationStep& step : scenario.steps) {
      const std::string metric = metric_of_deed(step.kind);
      if (metric.empty()) continue;
      const auto gate = std::find_if(
          scenario.rubric.gates.begin(), scenario.rubric.gates.end(), [&](const Gate& each) {
            return each.metric == metric && each.cut == step.cut && each.hinge == step.hinge &&
                   each.fragment == shifted_fragment(scenario, step) && each.is_at_least;
          });
      ASSERT_NE(gate, scenario.rubric.gates.end()) << scenario.name << ": " << step.title;
      EXPECT_EQ(gate->limit, 1.0);
      EXPECT_LT(gate->cap_milli, pass_mark_milli);
    }
  }
}

TEST(Scenario, AFileCannotReviewItself) {
  std::string text = scenarios_test::format_1("silver").text;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"reviewed\": false", "\"reviewed\": true");
  replace("\"reviewed_by\": \"\"", "\"reviewed_by\": \"A. Surgeon\"");
  const Scenario stored = parse_scenario(text, "silver.json");
  EXPECT_TRUE(stored.claims_review) << "what was stored before is read";
  EXPECT_EQ(review_label(stored), "not surgeon-reviewed");
  const tests::TemporaryDirectory temporary;
  const std::filesystem::path file = temporary.path() / "silver.json";
  std::ofstream(file) << text;
  try {
    read_scenario(file);
    ADD_FAILURE();
  } catch (const ScenarioError& error) {
    EXPECT_NE(std::string(error.what()).find("reviewed: a file cannot review itself"),
              std::string::npos)
        << error.what();
  }
}

TEST(Scenario, OfAnUnknownNameSaysWhichThereAre) {
  try {
    load_shipped_scenario("gold");
    FAIL() << "gold is not shipped";
  } catch (const ScenarioError& error) {
    EXPECT_STREQ(error.what(), "there is no scenario \"gold\"; use one of: akin, chevron, silver");
  }
}

TEST(Scenario, WithAPlantedFaultIsRefusedWithFilePathAndMend) {
  for (const json& fault : json::parse(scenarios_test::planted_faults()[0].text)) {
    const std::string name = fault.value("of", "silver");
    const json whole = json::parse(scenarios_test::format_1(name).text);
    const std::string sentence = refusal_of(whole.patch(fault.at("patch")).dump(), name + ".json");
    const std::string start = name + ".json: " + fault.at("path").get<std::string>() + ": ";
    EXPECT_EQ(sentence.substr(0, start.size()), start) << fault.at("name") << "\n" << sentence;
    EXPECT_NE(sentence.find(fault.at("says").get<std::string>()), std::string::npos)
        << fault.at("name") << "\n"
        << sentence;
    EXPECT_NE(sentence.find("; "), std::string::npos) << sentence;
  }
}

TEST(Scenario, HasABladeAsSharpAsItSaysAndANewOneWhereItSaysNothing) {
  json silver = silver_json();
  EXPECT_FALSE(silver["blade"].contains("sharpness")) << "the shipped blades are new";
  EXPECT_EQ(parse_scenario(silver.dump(), "silver.json").saw.sharpness, 1.0);
  for (const double sharpness : {0.2, 0.65, 1.0}) {
    silver["blade"]["sharpness"] = sharpness;
    EXPECT_EQ(parse_scenario(silver.dump(), "silver.json").saw.sharpness, sharpness);
  }
}

TEST(Scenario, HasBoneOfTheQualityItSaysAndUsualBoneWhereItSaysNothing) {
  for (const EmbeddedText& shipped : shipped_scenarios()) {
    EXPECT_FALSE(json::parse(shipped.text)["patient"].contains("bone_quality")) << shipped.name;
    EXPECT_EQ(parse_scenario(shipped.text, shipped.name).patient.bone_quality, 1.0);
  }
  json silver = silver_json();
  for (const double quality : {0.5, 0.8, 1.5}) {
    silver["patient"]["bone_quality"] = quality;
    EXPECT_EQ(parse_scenario(silver.dump(), "silver.json").patient.bone_quality, quality);
  }
}

TEST(Scenario, TakesABandInPlaceOfALine) {
  json silver = silver_json();
  json& item = silver["rubric"]["items"][0];
  item.erase("full");
  item.erase("zero");
  item["band"] = {-1, 0.5, 0.5, 3};
  const RubricItem read = parse_scenario(silver.dump(), "silver.json").rubric.items[0];
  EXPECT_TRUE(read.is_band);
  EXPECT_EQ(read.zero_low, -1.0);
  EXPECT_EQ(read.full_low, 0.5);
  EXPECT_EQ(read.full_high, 0.5);
  EXPECT_EQ(read.zero_high, 3.0);
}

TEST(Scenario, ReadsFractionsOfAPointAsWholeThousandths) {
  json silver = silver_json();
  silver["rubric"]["items"][0]["weight"] = 16.1;
  silver["rubric"]["items"][1]["weight"] = 15.9;
  const Rubric rubric = parse_scenario(silver.dump(), "silver.json").rubric;
  EXPECT_EQ(rubric.items[0].weight_milli, 16'100);
  EXPECT_EQ(rubric.items[1].weight_milli, 15'900);
}

TEST(Scenario, InAFileThatIsNotThereIsRefused) {
  EXPECT_THROW(read_scenario("/nowhere/silver.json"), ScenarioError);
  EXPECT_THROW(read_scenario("/"), ScenarioError);
}

RC_GTEST_PROP(Scenario, WithDamagedBytesIsReadOrRefusedButNeverAnythingElse, ()) {
  std::string text = scenarios_test::format_1("silver").text;
  const int damages = *rc::gen::inRange(1, 6);
  for (int i = 0; i < damages; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    text[at] = *rc::gen::arbitrary<char>();
  }
  text.resize(*rc::gen::element(text.size(), *rc::gen::inRange<std::size_t>(0, text.size())));
  refusal_of(text);
}

}  // namespace
}  // namespace hallux::scenarios
