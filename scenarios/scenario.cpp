/// One function reads one kind of thing and bounds every number in the field's own terms; what
/// binds several of them together is checked afterwards (check_references.h). Text and JSON of a
/// scenario are kept as they came, since their digest is the scenario's name in the records.
#include "scenarios/scenario.h"

#include <cmath>
#include <fstream>

#include "scenarios/check_references.h"
#include "scenarios/format_2/read_operation.h"
#include "scenarios/hidden_letters.h"
#include "scenarios/json_node.h"
#include "scenarios/read_cuts.h"
#include "scenarios/read_parts.h"
#include "scenarios/read_rubric.h"

namespace hallux::scenarios {
namespace {

SourceNote read_source(const JsonNode& node) {
  node.expect_keys({"key", "text"});
  return {.key = node.at("key").text(1, 64), .text = node.at("text").text(1, origin_bytes_max)};
}

void read_blade(const JsonNode& node, Scenario& scenario) {
  node.expect_keys(
      {"name", "width_mm", "depth_mm", "thickness_mm", "kerf_mm", "cycles_per_minute", "origin"},
      {"sharpness"});
  scenario.blade_name = node.at("name").text(1, title_bytes_max);
  scenario.saw = read_saw(node);
  scenario.blade_origin = read_origin(node);
}

ProofFault read_proof_fault(const JsonNode& node) {
  node.expect_keys({"fault", "items"}, {"gates"});
  ProofFault proof;
  proof.fault = node.at("fault").text(1, 200);
  for (const JsonNode& item : node.at("items").list(0, 64)) proof.items.push_back(item.text(1, 16));
  if (!node.has("gates")) return proof;
  for (const JsonNode& gate : node.at("gates").list(1, 16)) proof.gates.push_back(gate.name());
  return proof;
}

/// Dorsal is up where nothing is said; to an eye that looks straight down, distal.
Vec3 read_up(const JsonNode& node, const Vec3& eye_in_bone) {
  constexpr double straight = 0.999;
  if (!node.has("up_in_bone")) {
    return std::abs(eye_in_bone.y) > straight ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  }
  const Vec3 up = read_direction(node.at("up_in_bone"));
  if (std::abs(glm::dot(up, eye_in_bone)) > straight) {
    node.at("up_in_bone").refuse_value("give a direction that is not the eye's");
  }
  return up;
}

/// A blade's normal is square to its feed: what rounding of the numbers leaves is taken off.
StartingPlace read_start(const JsonNode& node) {
  node.expect_keys(
      {"eye_in_bone", "radius_mm", "tip_from_entry_mm", "feed_in_bone", "normal_in_bone", "origin"},
      {"up_in_bone"});
  StartingPlace start;
  start.eye_in_bone = read_direction(node.at("eye_in_bone"));
  start.up_in_bone = read_up(node, start.eye_in_bone);
  start.radius_mm = node.at("radius_mm").number(5.0, 100.0);
  start.tip_from_entry_mm = node.at("tip_from_entry_mm").vector(-60.0, 60.0);
  start.feed_in_bone = read_direction(node.at("feed_in_bone"));
  const Vec3 normal = read_direction(node.at("normal_in_bone"));
  const double along = glm::dot(normal, start.feed_in_bone);
  if (std::abs(along) > 0.02) {
    node.at("normal_in_bone").refuse_value("give a direction square to feed_in_bone");
  }
  start.normal_in_bone = unit(normal - along * start.feed_in_bone);
  start.origin = read_origin(node);
  return start;
}

void read_head(const JsonNode& node, Scenario& scenario) {
  scenario.name = node.at("name").name();
  scenario.title = read_title(node);
  scenario.version = node.at("version").integer(1, 1'000'000);
  scenario.claims_review = node.at("reviewed").boolean();
  const std::string reviewer = node.at("reviewed_by").text(0, title_bytes_max);
  scenario.indication = node.at("indication").text(1, text_bytes_max);
  scenario.summary = node.at("summary").text(1, text_bytes_max);
  if (scenario.claims_review == reviewer.empty()) {
    node.at("reviewed_by")
        .refuse_value(scenario.claims_review ? "name the surgeon who signed this version"
                                             : "leave it empty until \"reviewed\" is true");
  }
}

void read_places(const JsonNode& node, Scenario& scenario) {
  for (const JsonNode& entry : node.at("danger_zones").list(0, 64)) {
    scenario.danger_zones.push_back(read_danger_zone(entry, scenario.format));
  }
  if (!node.has("joint_surfaces")) return;
  for (const JsonNode& entry : node.at("joint_surfaces").list(1, 16)) {
    scenario.joint_surfaces.push_back(read_joint_surface(entry, scenario.format));
  }
}

/// What format 2 says in other words, as format 1 says it.
void read_format_1(const JsonNode& root, Scenario& scenario, std::span<const FootBone> bones) {
  root.expect_keys(
      {"format", "name", "title", "version", "reviewed", "reviewed_by", "indication", "summary",
       "sources", "patient", "blade", "cuts", "steps", "danger_zones", "rubric"},
      {"hinges", "joint_surfaces", "proof", "start"});
  read_head(root, scenario);
  scenario.patient = read_bone_request(root.at("patient"), bones);
  read_blade(root.at("blade"), scenario);
  for (const JsonNode& entry : root.at("cuts").list(1, 16)) {
    scenario.cuts.push_back(read_cut(entry));
  }
  if (root.has("hinges")) {
    for (const JsonNode& entry : root.at("hinges").list(1, 4)) {
      scenario.hinges.push_back(read_hinge(entry));
    }
  }
  for (const JsonNode& entry : root.at("steps").list(3, 64)) {
    scenario.steps.push_back(read_step(entry));
  }
}

void read_format_2(const JsonNode& root, Scenario& scenario, std::span<const FootBone> bones) {
  root.expect_keys(
      {"format", "name", "title", "version", "reviewed", "reviewed_by", "indication", "summary",
       "sources", "patient", "blades", "cuts", "steps", "danger_zones", "rubric"},
      {"points", "directions", "hinges", "fragments", "shifts", "wires", "screws", "joint_surfaces",
       "proof", "start"});
  read_head(root, scenario);
  read_operation(root, bones, scenario);
}

/// A file of a later program is refused by its format before anything else of it is.
std::int32_t read_format(const JsonNode& root) {
  constexpr std::string_view mend =
      "this program reads formats 1 and 2; update the program, or write one of them";
  if (!root.has("format")) return 1;
  const std::int32_t format = root.at("format").integer(0, 1'000'000);
  if (format != 1 && format != 2) root.at("format").refuse_value(mend);
  return format;
}

}  // namespace

Scenario parse_scenario(std::string_view json, std::string_view name,
                        std::span<const FootBone> bones) {
  const nlohmann::json document = parse_bounded_json(json, name);
  const JsonNode root(document, name);
  Scenario scenario;
  scenario.format = read_format(root);
  if (scenario.format == 1) {
    read_format_1(root, scenario, bones);
  } else {
    read_format_2(root, scenario, bones);
  }
  for (const JsonNode& entry : root.at("sources").list(1, 64)) {
    scenario.sources.push_back(read_source(entry));
  }
  read_places(root, scenario);
  if (root.has("start")) scenario.start = read_start(root.at("start"));
  scenario.rubric = read_rubric(root.at("rubric"));
  if (root.has("proof")) {
    for (const JsonNode& entry : root.at("proof").list(1, 64))
      scenario.proof.push_back(read_proof_fault(entry));
  }
  scenario.text = json;
  check_references(scenario, name);
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw ScenarioError(file.string() + ": there is no such file; name a scenario's JSON file");
  }
  std::ifstream stream(file, std::ios::binary);
  // One byte more than is allowed, so that a longer file is refused without reading all of it.
  std::string text(json_bytes_max + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) {
    throw ScenarioError(file.string() + ": cannot be read; check that you may read it");
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  Scenario scenario = parse_scenario(text, name);
  check_letters(text, name);
  if (scenario.claims_review) {
    throw ScenarioError(
        name +
        ": reviewed: a file cannot review itself; set it to false and leave reviewed_by empty");
  }
  return scenario;
}

Rubric rubric_for(const Rubric& rubric, std::string_view device_class) {
  Rubric made = rubric;
  for (RubricItem& item : made.items) {
    for (const DeviceKnots& each : item.device_knots) {
      if (each.device_class != device_class) continue;
      static_cast<Knots&>(item) = each.knots;
      item.origin = each.origin;
      break;
    }
    item.device_knots.clear();
  }
  return made;
}

bool lies_along_bone(const ReferenceCut& cut) noexcept {
  if (cut.face.kind == FaceKind::Turned) return !cut.depth_landmark.empty();
  return cut.face.kind == FaceKind::AlongAxis;
}

std::string review_label(const Scenario& scenario) {
  return scenario.is_reviewed ? "surgeon-reviewed" : "not surgeon-reviewed";
}

Scenario load_shipped_scenario(std::string_view name) {
  const std::string file = std::string(name) + ".json";
  std::string names;
  for (const EmbeddedText& shipped : shipped_scenarios()) {
    if (shipped.name == file) return parse_scenario(shipped.text, shipped.name);
    names += (names.empty() ? "" : ", ");
    names += shipped.name.substr(0, shipped.name.size() - std::string_view(".json").size());
  }
  throw ScenarioError("there is no scenario \"" + std::string(name) + "\"; use one of: " + names);
}

}  // namespace hallux::scenarios
