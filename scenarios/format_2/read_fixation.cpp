#include "scenarios/format_2/read_fixation.h"

#include "scenarios/read_parts.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

/// The thinnest wire and the thickest screw that a foot is fixed with, with room.
constexpr double thinnest_mm = 0.5, thickest_mm = 8.0;
constexpr double shortest_mm = 4.0, longest_mm = 120.0;

FragmentMove read_move(const JsonNode& node) {
  FragmentMove move;
  move.is_turn = node.has("turn");
  if (move.is_turn) {
    node.expect_keys({"turn", "through", "deg"});
    move.direction = node.at("turn").name();
    move.through = node.at("through").name();
    move.turn_rad = radian_from_degree(node.at("deg").number(-90.0, 90.0));
  } else {
    node.expect_keys({"slide", "mm"});
    move.direction = node.at("slide").name();
    move.slide_mm = node.at("mm").number(-30.0, 30.0);
  }
  return move;
}

ImplantClearance read_clearance(const JsonNode& node) {
  node.expect_keys({"joint_surface", "mm"});
  return {node.at("joint_surface").name(), node.at("mm").number(0.0, 20.0)};
}

Implant read_implant(const JsonNode& node, ImplantKind kind, std::string_view reach) {
  Implant implant;
  implant.kind = kind;
  implant.name = node.at("name").name();
  implant.title = read_title(node);
  implant.bone = node.name_where_given("bone");
  implant.entry = node.at("entry").name();
  implant.direction = node.at("direction").name();
  implant.diameter = read_range(node.at("diameter_mm"), thinnest_mm, thickest_mm);
  implant.length = read_range(node.at(reach), shortest_mm, longest_mm);
  for (const JsonNode& body : node.at("engages").list(1, 4)) implant.engages.push_back(body.name());
  implant.cortices = node.at("cortices").integer(1, 4);
  if (node.has("clear_of")) {
    for (const JsonNode& entry : node.at("clear_of").list(1, 4))
      implant.clear_of.push_back(read_clearance(entry));
  }
  implant.is_temporary = node.has("temporary") && node.at("temporary").boolean();
  implant.origin = read_origin(node);
  return implant;
}

}  // namespace

Range read_range(const JsonNode& node, double low, double high) {
  const std::vector<JsonNode> ends = node.list(2, 2);
  const Range range{ends[0].number(low, high), ends[1].number(low, high)};
  if (range.low_mm > range.high_mm) node.refuse_value("give the smaller number first");
  return range;
}

Fragment read_fragment(const JsonNode& node) {
  node.expect_keys({"name", "title", "holds", "origin"}, {"bone"});
  return {node.at("name").name(), read_title(node), node.name_where_given("bone"),
          node.at("holds").name(), read_origin(node)};
}

FragmentShift read_shift(const JsonNode& node) {
  node.expect_keys({"name", "title", "fragment", "moves", "origin"}, {"close"});
  FragmentShift shift{node.at("name").name(), read_title(node), node.at("fragment").name(), {}};
  for (const JsonNode& entry : node.at("moves").list(0, 8)) shift.moves.push_back(read_move(entry));
  shift.is_closed = node.has("close") && node.at("close").boolean();
  if (shift.moves.empty() && !shift.is_closed)
    node.at("moves").refuse_value("give a move, or \"close\": true");
  shift.origin = read_origin(node);
  return shift;
}

Implant read_wire(const JsonNode& node) {
  node.expect_keys({"name", "title", "entry", "direction", "diameter_mm", "depth_mm", "engages",
                    "cortices", "origin"},
                   {"bone", "clear_of", "temporary"});
  return read_implant(node, ImplantKind::Wire, "depth_mm");
}

Implant read_screw(const JsonNode& node) {
  node.expect_keys({"name", "title", "entry", "direction", "diameter_mm", "length_mm", "engages",
                    "cortices", "origin"},
                   {"bone", "clear_of", "temporary"});
  return read_implant(node, ImplantKind::Screw, "length_mm");
}

}  // namespace hallux::scenarios
