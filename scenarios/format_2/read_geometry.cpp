// The keys say the kind, and exactly one kind's keys are there: expect_keys refuses the others.
#include "scenarios/format_2/read_geometry.h"

#include "scenarios/read_parts.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

/// Further than a bone is long nothing is placed.
constexpr double far_mm = 100.0;

void read_moved(const JsonNode& node, NamedPoint& point) {
  node.expect_keys({"name", "at", "origin"}, {"move", "bone"});
  point.kind = PointKind::Moved;
  point.from = node.at("at").name();
  if (!node.has("move")) return;
  for (const JsonNode& entry : node.at("move").list(1, 4)) {
    entry.expect_keys({"along", "mm"});
    point.moves.push_back({entry.at("along").name(), entry.at("mm").number(-far_mm, far_mm)});
  }
}

void read_between(const JsonNode& node, NamedPoint& point) {
  node.expect_keys({"name", "between", "share", "origin"}, {"bone"});
  point.kind = PointKind::Between;
  const std::vector<JsonNode> ends = node.at("between").list(2, 2);
  point.from = ends[0].name();
  point.to = ends[1].name();
  point.share = node.at("share").number(0.0, 1.0);
}

void read_on_surface(const JsonNode& node, NamedPoint& point) {
  node.expect_keys({"name", "on_surface", "origin"}, {"bone"});
  point.kind = PointKind::OnSurface;
  const JsonNode ray = node.at("on_surface");
  ray.expect_keys({"from", "along"});
  point.from = ray.at("from").name();
  point.along = ray.at("along").name();
}

}  // namespace

NamedPoint read_point(const JsonNode& node) {
  NamedPoint point;
  if (node.has("between")) {
    read_between(node, point);
  } else if (node.has("on_surface")) {
    read_on_surface(node, point);
  } else {
    read_moved(node, point);
  }
  point.name = node.at("name").name();
  point.bone = node.name_where_given("bone");
  point.origin = read_origin(node);
  return point;
}

NamedDirection read_named_direction(const JsonNode& node) {
  NamedDirection direction;
  if (node.has("square_to_both")) {
    node.expect_keys({"name", "square_to_both", "origin"}, {"bone"});
    direction.kind = DirectionKind::SquareToBoth;
    const std::vector<JsonNode> both = node.at("square_to_both").list(2, 2);
    direction.first = both[0].name();
    direction.second = both[1].name();
  } else if (node.has("turn")) {
    node.expect_keys({"name", "turn", "about", "deg", "origin"}, {"bone"});
    direction.kind = DirectionKind::Turned;
    direction.first = node.at("turn").name();
    direction.second = node.at("about").name();
    direction.turn_rad = radian_from_degree(node.at("deg").number(-180.0, 180.0));
  } else if (node.has("lay")) {
    node.expect_keys({"name", "lay", "square_to", "origin"}, {"bone"});
    direction.kind = DirectionKind::LaidSquare;
    direction.first = node.at("lay").name();
    direction.second = node.at("square_to").name();
  } else {
    node.expect_keys({"name", "from", "to", "origin"}, {"bone"});
    direction.first = node.at("from").name();
    direction.second = node.at("to").name();
  }
  direction.name = node.at("name").name();
  direction.bone = node.name_where_given("bone");
  direction.origin = read_origin(node);
  return direction;
}

}  // namespace hallux::scenarios
