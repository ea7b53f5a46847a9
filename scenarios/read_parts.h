/// Parts of a scenario's JSON that both formats have. Inside this corner only.
#pragma once

#include <span>

#include "scenarios/json_node.h"
#include "scenarios/scenario.h"

namespace hallux::scenarios {

inline constexpr std::size_t title_bytes_max = 120;
inline constexpr std::size_t text_bytes_max = 4000;
inline constexpr std::size_t origin_bytes_max = 1000;

/// errors  ScenarioError, all of them: shape and range of each value
std::string read_origin(const JsonNode& node);
std::string read_title(const JsonNode& node);
/// A direction along the axes of the bone frame, made of unit length.
Vec3 read_direction(const JsonNode& node);
PatientRequest read_bone_request(const JsonNode& node, std::span<const FootBone> bones);
/// The numbers of a blade, without its keys.
simulator::Saw read_saw(const JsonNode& node);
/// format  from 2 on they may name their bone
DangerZone read_danger_zone(const JsonNode& node, std::int32_t format);
JointSurface read_joint_surface(const JsonNode& node, std::int32_t format);

}  // namespace hallux::scenarios
