#include "scenarios/format_2/read_operation.h"

#include "scenarios/format_2/read_fixation.h"
#include "scenarios/format_2/read_geometry.h"
#include "scenarios/read_cuts.h"
#include "scenarios/read_parts.h"
#include "scenarios/steps/step_words.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

constexpr std::string_view both_sides = "both";

void read_bones(const JsonNode& node, std::span<const FootBone> bones, Scenario& scenario) {
  node.expect_keys({"bones"});
  const std::vector<JsonNode> asked = node.at("bones").list(1, 4);
  scenario.patient = read_bone_request(asked.front(), bones);
  for (std::size_t i = 1; i < asked.size(); ++i)
    scenario.further_bones.push_back(read_bone_request(asked[i], bones));
}

void read_blades(const JsonNode& node, Scenario& scenario) {
  for (const JsonNode& entry : node.list(1, 8)) {
    entry.expect_keys({"name", "title", "width_mm", "depth_mm", "thickness_mm", "kerf_mm",
                       "cycles_per_minute", "origin"},
                      {"sharpness"});
    scenario.blades.push_back(
        {entry.at("name").name(), read_title(entry), read_saw(entry), read_origin(entry)});
  }
  const BladeOffer& first = scenario.blades.front();
  scenario.saw = first.saw;
  scenario.blade_name = first.title;
  scenario.blade_origin = first.origin;
}

double read_angle_rad(const JsonNode& node, double most_deg) {
  return radian_from_degree(node.number(-most_deg, most_deg));
}

LandmarkPlane read_plane(const JsonNode& node) {
  node.expect_keys({"through", "contains", "from", "angle_deg"}, {"roll_deg"});
  LandmarkPlane plane;
  plane.kind = FaceKind::Turned;
  plane.through = node.at("through").name();
  plane.contains = node.at("contains").name();
  plane.turned_from = node.at("from").name();
  plane.angle_rad = read_angle_rad(node.at("angle_deg"), 180.0);
  if (node.has("roll_deg")) plane.roll_rad = read_angle_rad(node.at("roll_deg"), 90.0);
  return plane;
}

ReferenceWindow read_window(const JsonNode& node) {
  node.expect_keys({"beyond", "along"}, {"across", "across_mm"});
  ReferenceWindow window{node.at("beyond").name(), node.at("along").name()};
  if (node.has("across") != node.has("across_mm"))
    node.refuse_value("give \"across\" and \"across_mm\", or neither");
  if (!node.has("across")) return window;
  window.across = node.at("across").name();
  window.limits = read_range(node.at("across_mm"), -100.0, 100.0);
  return window;
}

/// The side that is kept and measured: `keep`, or `measured` where both are kept.
void read_sides(const JsonNode& node, ReferenceCut& cut) {
  cut.keep = node.at("keep").name();
  cut.keeps_both = cut.keep == both_sides;
  if (node.has("measured") != cut.keeps_both) {
    node.refuse_value(cut.keeps_both
                          ? "give \"measured\": the side whose finished face lies in the plane"
                          : "remove \"measured\": the kept side's face is measured");
  }
  if (cut.keeps_both) cut.keep = node.at("measured").name();
}

ReferenceCut read_turned_cut(const JsonNode& node) {
  node.expect_keys({"name", "title", "face", "keep", "approach", "origin"},
                   {"bone", "measured", "window", "depth_at", "flush_at", "blade"});
  ReferenceCut cut;
  cut.name = node.at("name").name();
  cut.title = read_title(node);
  cut.face = read_plane(node.at("face"));
  read_sides(node, cut);
  cut.approach = node.at("approach").name();
  if (node.has("window")) cut.window = read_window(node.at("window"));
  if (node.has("depth_at") != node.has("flush_at"))
    node.refuse_value(
        "give \"depth_at\" and \"flush_at\", or neither: they belong to a face along "
        "the bone");
  cut.depth_landmark = node.name_where_given("depth_at");
  cut.exit_landmark = node.name_where_given("flush_at");
  cut.bone = node.name_where_given("bone");
  cut.blade = node.name_where_given("blade");
  cut.origin = read_origin(node);
  return cut;
}

ReferenceHinge read_turned_hinge(const JsonNode& node) {
  node.expect_keys({"name", "title", "first_cut", "second_cut", "side", "along", "thickness_mm",
                    "target_mm", "breaks_below_mm", "bends_up_to_mm", "origin", "provisional"},
                   {"moves"});
  ReferenceHinge hinge;
  hinge.name = node.at("name").name();
  hinge.title = read_title(node);
  hinge.first_cut = node.at("first_cut").name();
  hinge.second_cut = node.at("second_cut").name();
  hinge.side = node.at("side").name();
  hinge.along = node.at("along").name();
  hinge.moves = node.name_where_given("moves");
  hinge.origin = read_origin(node);
  read_bridge(node, hinge);
  return hinge;
}

StepKind read_step_word(const JsonNode& node) {
  const std::optional<StepKind> kind = find_step_kind(node.text(1, 64));
  if (!kind) node.refuse_value("use one of: " + step_words());
  return *kind;
}

std::vector<std::string> read_names(const JsonNode& node, std::size_t most) {
  std::vector<std::string> names;
  for (const JsonNode& entry : node.list(0, most)) names.push_back(entry.name());
  return names;
}

OperationStep read_ordered_step(const JsonNode& node) {
  node.expect_keys({"id", "kind", "title", "text", "after"},
                   {"one_of", "optional", "cut", "hinge", "point", "shift", "implants"});
  OperationStep step;
  step.id = node.at("id").name();
  step.kind = read_step_word(node.at("kind"));
  step.title = read_title(node);
  step.text = node.at("text").text(1, text_bytes_max);
  step.after = read_names(node.at("after"), 16);
  step.one_of = node.name_where_given("one_of");
  step.is_optional = node.has("optional") && node.at("optional").boolean();
  step.cut = node.name_where_given("cut");
  step.hinge = node.name_where_given("hinge");
  step.point = node.name_where_given("point");
  step.shift = node.name_where_given("shift");
  if (node.has("implants")) step.implants = read_names(node.at("implants"), 8);
  return step;
}

template <typename Part, typename Read>
void read_list(const JsonNode& root, std::string_view key, std::size_t most, Read read,
               std::vector<Part>& parts) {
  if (!root.has(key)) return;
  for (const JsonNode& entry : root.at(key).list(1, most)) parts.push_back(read(entry));
}

}  // namespace

void read_operation(const JsonNode& root, std::span<const FootBone> bones, Scenario& scenario) {
  read_bones(root.at("patient"), bones, scenario);
  read_blades(root.at("blades"), scenario);
  read_list(root, "points", 64, read_point, scenario.points);
  read_list(root, "directions", 64, read_named_direction, scenario.directions);
  read_list(root, "cuts", 16, read_turned_cut, scenario.cuts);
  read_list(root, "hinges", 4, read_turned_hinge, scenario.hinges);
  read_list(root, "fragments", 8, read_fragment, scenario.fragments);
  read_list(root, "shifts", 8, read_shift, scenario.shifts);
  read_list(root, "wires", 16, read_wire, scenario.implants);
  read_list(root, "screws", 16, read_screw, scenario.implants);
  for (const JsonNode& entry : root.at("steps").list(3, 64))
    scenario.steps.push_back(read_ordered_step(entry));
}

}  // namespace hallux::scenarios
