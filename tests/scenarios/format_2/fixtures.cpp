#include "tests/scenarios/format_2/fixtures.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace hallux::scenarios_test {

using nlohmann::json;

json fixture_json(std::string_view name) {
  return json::parse(scenarios::load_shipped_scenario(name).text);
}

scenarios::Scenario coarse(const json& whole) {
  json altered = whole;
  for (json& bone : altered["patient"]["bones"]) bone["edge_mm"] = 1.0;
  return scenarios::parse_scenario(altered.dump(), "coarse.json");
}

scenarios::Scenario fixture(std::string_view name) { return coarse(fixture_json(name)); }

std::string refusal_of(const json& whole) {
  try {
    scenarios::parse_scenario(whole.dump(), "f.json");
  } catch (const scenarios::ScenarioError& error) {
    return error.what();
  }
  return "";
}

std::string plan_refusal_of(const json& whole, const simulator::Bone& bone) {
  const scenarios::Scenario scenario = scenarios::parse_scenario(whole.dump(), "f.json");
  try {
    plan_on(scenario, bone);
  } catch (const scenarios::ScenarioError& error) {
    return error.what();
  }
  return "";
}

json block_json() {
  json block = fixture_json("chevron");
  block["name"] = "block";
  for (const char* part : {"points", "directions", "fragments", "shifts", "wires", "screws",
                           "joint_surfaces", "proof"})
    block.erase(part);
  block["danger_zones"] = json::array();
  block["cuts"] = {
      {{"name", "cut"},
       {"title", "Cut"},
       {"face",
        {{"through", "middle"}, {"contains", "dorsal"}, {"from", "lateral"}, {"angle_deg", 0}}},
       {"keep", "proximal"},
       {"approach", "medial"},
       {"origin", "author: a test."}}};
  const auto step = [](const char* id, const char* kind, json after) -> json {
    return {
        {"id", id}, {"kind", kind}, {"title", id}, {"text", "Do."}, {"after", std::move(after)}};
  };
  block["steps"] = {step("verify", "verify", json::array()), step("saw", "cut", {"verify"}),
                    step("finish", "finish", {"saw"})};
  block["steps"][1]["cut"] = "cut";
  block["rubric"]["groups"] = {
      {{"name", "tool_use"}, {"title", "Tool use"}, {"weight", 100}, {"origin", "author"}}};
  for (const json& item : json(block["rubric"]["items"]))
    if (item["id"] == "T1") block["rubric"]["items"] = {item};
  block["rubric"]["items"][0]["weight"] = 100;
  block["rubric"]["gates"] = json::array();
  return block;
}

simulator::Bone block() {
  simulator::Bone bone;
  bone.name = "block";
  bone.outer = tests::moved(tests::solid_block({60.0, 20.0, 20.0}), {{}, {30.0, 0.0, 0.0}});
  bone.landmarks = {{"base", Vec3(0.0, 0.0, 0.0)},
                    {"middle", Vec3(30.0, 0.0, 0.0)},
                    {"end", Vec3(60.0, 0.0, 0.0)}};
  return bone;
}

json& entry_named(json& list, std::string_view name) {
  for (json& entry : list) {
    if (entry["name"] == name) return entry;
  }
  ADD_FAILURE() << "there is no " << name;
  return list[0];
}

}  // namespace hallux::scenarios_test
