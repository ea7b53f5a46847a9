// The sheet that a surgeon reads in place of JSON: nothing of a scenario may be missing on it.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/temporary_directory.h"
#include "ui/jobs/course/scenario_jobs.h"

namespace hallux::ui {
namespace {

using nlohmann::json;

/// Every text under one of these keys.
void collect(const json& node, std::vector<std::string>& texts) {
  for (const auto& [key, value] : node.items()) {
    const bool is_shown = key == "origin" || key == "name" || key == "id" || key == "after";
    if (value.is_structured()) {
      collect(value, texts);
    } else if (node.is_object() && is_shown && key != "id") {
      texts.push_back(value.get<std::string>());
    }
  }
}

TEST(ScenarioSheet, NamesEveryPartOfFormat2WithItsOrigin) {
  for (const EmbeddedText& file : scenarios::shipped_scenarios()) {
    const std::string sheet = scenario_sheet(scenarios::parse_scenario(file.text, file.name));
    json parts = json::parse(file.text);
    for (const char* not_on_it : {"sources", "rubric", "joint_surfaces", "start", "proof"})
      parts.erase(not_on_it);
    std::vector<std::string> texts;
    collect(parts, texts);
    ASSERT_GT(texts.size(), 20U);
    for (const std::string& text : texts)
      EXPECT_NE(sheet.find(text), std::string::npos) << file.name << ": " << text;
  }
}

TEST(ScenarioSheet, SaysAnglesLengthsAndTheOrderOfSteps) {
  const std::string sheet = scenario_sheet(scenarios::load_shipped_scenario("chevron"));
  for (const char* line :
       {"through apex, contains wire, turned about it by -30 deg from shaft",
        "both sides are kept, measured is dorsal_of_shaft; approach medial_of_shaft;",
        "approach medial_of_shaft; only beyond apex base_wards",
        "to_lateral: Head to lateral, of head; 5 mm along wire; closed until the faces touch",
        "screw of 2.5 to 3 mm from screw_entry along screw_axis", "20 to 24 mm deep",
        "2 mm clear of head_surface", "[fix screw, after hold]",
        "[retract, after verify, optional]", "medial_of_shaft turned by 5 deg about shaft",
        "shifted of head below 1 caps the score", "shift_mm of head above 8 mm"})
    EXPECT_NE(sheet.find(line), std::string::npos) << line << "\n" << sheet;
}

/// A patient of two bones is planned on both.
TEST(ScenarioSheet, ChecksAFileOnAllOfItsBones) {
  json chevron = json::parse(scenarios::load_shipped_scenario("chevron").text);
  chevron["patient"]["bones"].push_back({{"bone", "first_proximal_phalanx"},
                                         {"length_mm", 33},
                                         {"edge_mm", 0.3},
                                         {"origin", "author: a test."}});
  chevron["danger_zones"][0]["bone"] = "first_proximal_phalanx";
  chevron["danger_zones"][0]["from_in_bone_mm"] = {0, 12, 2};
  const tests::TemporaryDirectory temporary;
  const std::filesystem::path file = temporary.path() / "chevron.json";
  std::ofstream(file) << chevron.dump();
  const CheckedScenario checked = check_scenario_file(file);
  EXPECT_EQ(checked.bones.front().name, "first_metatarsal");
  EXPECT_EQ(checked.plan.danger_zones.at(0).bone, 1U);
  EXPECT_EQ(checked.plan.cuts.size(), 4U);
}

}  // namespace
}  // namespace hallux::ui
