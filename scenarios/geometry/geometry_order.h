/// The order in which named points and directions can be laid: each after all that it is made
/// from. Inside this corner only.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/geometry/named_geometry.h"

namespace hallux::scenarios {

/// The six axes of a bone's frame and the six of the foot's, by name: "distal", "foot_plantar".
std::span<const std::string_view> axis_names() noexcept;
bool is_axis_name(std::string_view name) noexcept;

/// One of the two lists' entries.
struct GeometryEntry {
  bool is_point = false;
  std::size_t index = 0;
};

/// The lists of a scenario. Borrowed.
struct NamedGeometry {
  const std::vector<NamedPoint>& points;
  const std::vector<NamedDirection>& directions;
};

/// Both lists in one order, each list in its own. A name that no entry has is a landmark's where a
/// point is asked for.
/// file    stands in the messages
/// errors  ScenarioError: a direction that nobody knows, with those that are known; an entry that
///         refers to a later one of its own list, or round about to itself
std::vector<GeometryEntry> geometry_order(const NamedGeometry& geometry, std::string_view file);

}  // namespace hallux::scenarios
