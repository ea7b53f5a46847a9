/// The scenarios of format 2 that the tests plan and alter.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios_test {

/// A shipped operation's file.
nlohmann::json fixture_json(std::string_view name);
scenarios::Scenario fixture(std::string_view name);
/// With coarse bones: landmarks and planes lie where they lie at any edge length.
scenarios::Scenario coarse(const nlohmann::json& json);

/// What the reading of the altered fixture says; empty where it is read.
std::string refusal_of(const nlohmann::json& json);
/// What planning it on these bones says; empty where it is planned.
std::string plan_refusal_of(const nlohmann::json& json, const simulator::Bone& bone);

/// A scenario of one cut through a block of 60 x 20 x 20 mm about the x axis, from x = 0: nothing
/// in it is named but what a test adds.
nlohmann::json block_json();
simulator::Bone block();

/// The entry of that name in a list.
nlohmann::json& entry_named(nlohmann::json& list, std::string_view name);

}  // namespace hallux::scenarios_test
