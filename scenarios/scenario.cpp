/// One function reads one kind of thing and bounds every number in the field's own terms; what
/// binds several of them together is checked afterwards (check_references.h). Text and JSON of a
/// scenario are kept as they came, since their digest is the scenario's name in the records.
#include "scenarios/scenario.h"

#include <cmath>
#include <fstream>

#include "scenarios/check_references.h"
#include "scenarios/hidden_letters.h"
#include "scenarios/json_node.h"
#include "scenarios/read_cuts.h"
#include "scenarios/read_rubric.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

constexpr std::size_t title_bytes_max = 120;
constexpr std::size_t text_bytes_max = 4000;
constexpr std::size_t origin_bytes_max = 1000;

std::string read_origin(const JsonNode& node) {
  return node.at("origin").text(1, origin_bytes_max);
}

std::string read_title(const JsonNode& node) { return node.at("title").text(1, title_bytes_max); }

SourceNote read_source(const JsonNode& node) {
  node.expect_keys({"key", "text"});
  return {.key = node.at("key").text(1, 64), .text = node.at("text").text(1, origin_bytes_max)};
}

/// Nothing was found on how much harder or softer living bone is to saw: half and half as much
/// again are ours.
PatientRequest read_patient(const JsonNode& node, std::span<const FootBone> bones) {
  PatientRequest patient;
  node.expect_keys({"bone", "length_mm", "edge_mm", "origin"}, {"eminence_mm", "bone_quality"});
  patient.bone = node.at("bone").name();
  const FootBone* const bone = find_foot_bone(patient.bone, bones);
  if (bone == nullptr) node.at("bone").refuse_value("use one of: " + names_of(bones));
  if (node.has("eminence_mm") != bone->has_eminence) {
    node.refuse_value(bone->has_eminence ? "give \"eminence_mm\""
                                         : "remove \"eminence_mm\": the " +
                                               std::string(bone->title) + " has none");
  }
  patient.length_mm = node.at("length_mm").number(bone->length_low_mm, bone->length_high_mm);
  if (bone->has_eminence) patient.eminence_mm = node.at("eminence_mm").number(0.0, 8.0);
  patient.edge_mm = node.at("edge_mm").number(0.2, 2.0);
  if (node.has("bone_quality")) patient.bone_quality = node.at("bone_quality").number(0.5, 1.5);
  patient.origin = read_origin(node);
  return patient;
}

/// The widest blades of the forefoot and hindfoot saws bound the ranges. Nobody would saw on with a
/// blade that takes less than a fifth, and none is sharper than a new one.
void read_blade(const JsonNode& node, Scenario& scenario) {
  node.expect_keys(
      {"name", "width_mm", "depth_mm", "thickness_mm", "kerf_mm", "cycles_per_minute", "origin"},
      {"sharpness"});
  scenario.blade_name = node.at("name").text(1, title_bytes_max);
  simulator::Saw& saw = scenario.saw;
  saw.blade.width_mm = node.at("width_mm").number(2.0, 30.0);
  saw.blade.depth_mm = node.at("depth_mm").number(5.0, 90.0);
  saw.blade.kerf_mm = node.at("kerf_mm").number(0.1, 2.0);
  saw.cycles_per_minute = node.at("cycles_per_minute").number(1000.0, 30000.0);
  saw.blade.thickness_mm = node.at("thickness_mm").number(0.1, 2.0);
  scenario.blade_origin = read_origin(node);
  if (node.has("sharpness")) saw.sharpness = node.at("sharpness").number(0.2, 1.0);
  if (saw.blade.thickness_mm > saw.blade.kerf_mm) {
    node.at("kerf_mm").refuse_value("give at least the blade's thickness_mm");
  }
}

DangerZone read_danger_zone(const JsonNode& node) {
  node.expect_keys({"name", "title", "severity", "from_in_bone_mm", "to_in_bone_mm", "radius_mm",
                    "checked", "origin"},
                   {"from_landmark", "to_landmark"});
  DangerZone zone{.name = node.at("name").name(),
                  .severity = node.at("severity").one_of({"critical", "major", "minor"}),
                  .from_in_bone_mm = node.at("from_in_bone_mm").vector(-200.0, 200.0),
                  .to_in_bone_mm = node.at("to_in_bone_mm").vector(-200.0, 200.0),
                  .radius_mm = node.at("radius_mm").number(0.1, 20.0),
                  .title = read_title(node),
                  .is_checked = node.at("checked").boolean(),
                  .origin = read_origin(node)};
  zone.from_landmark = node.name_where_given("from_landmark");
  zone.to_landmark = node.name_where_given("to_landmark");
  if (zone.from_in_bone_mm == zone.to_in_bone_mm && zone.from_landmark == zone.to_landmark) {
    node.at("to_in_bone_mm").refuse_value("give the other end of the structure");
  }
  return zone;
}

Vec3 read_direction(const JsonNode& node) {
  const Vec3 direction = node.vector(-1.0, 1.0);
  const double length = length_of(direction);
  if (length < 0.1) node.refuse_value("give the parts of a direction, the largest near 1");
  return direction / length;
}

JointSurface read_joint_surface(const JsonNode& node) {
  node.expect_keys(
      {"name", "title", "around", "radius_mm", "facing_in_bone", "within_deg", "checked", "origin"},
      {"offset_in_bone_mm"});
  return {.name = node.at("name").name(),
          .title = read_title(node),
          .around = node.at("around").name(),
          .offset_in_bone_mm = node.has("offset_in_bone_mm")
                                   ? node.at("offset_in_bone_mm").vector(-60.0, 60.0)
                                   : Vec3{0.0, 0.0, 0.0},
          .radius_mm = node.at("radius_mm").number(0.5, 40.0),
          .facing_in_bone = read_direction(node.at("facing_in_bone")),
          .within_rad = radian_from_degree(node.at("within_deg").number(1.0, 180.0)),
          .is_checked = node.at("checked").boolean(),
          .origin = read_origin(node)};
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
  scenario.format = node.at("format").integer(1, 1);
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

void read_lists(const JsonNode& node, Scenario& scenario) {
  for (const JsonNode& entry : node.at("sources").list(1, 64)) {
    scenario.sources.push_back(read_source(entry));
  }
  for (const JsonNode& entry : node.at("cuts").list(1, 16)) {
    scenario.cuts.push_back(read_cut(entry));
  }
  if (node.has("hinges")) {
    for (const JsonNode& entry : node.at("hinges").list(1, 4)) {
      scenario.hinges.push_back(read_hinge(entry));
    }
  }
  for (const JsonNode& entry : node.at("steps").list(3, 64)) {
    scenario.steps.push_back(read_step(entry));
  }
  for (const JsonNode& entry : node.at("danger_zones").list(0, 64)) {
    scenario.danger_zones.push_back(read_danger_zone(entry));
  }
  if (node.has("joint_surfaces")) {
    for (const JsonNode& entry : node.at("joint_surfaces").list(1, 16)) {
      scenario.joint_surfaces.push_back(read_joint_surface(entry));
    }
  }
}

}  // namespace

Scenario parse_scenario(std::string_view json, std::string_view name,
                        std::span<const FootBone> bones) {
  const nlohmann::json document = parse_bounded_json(json, name);
  const JsonNode root(document, name);
  root.expect_keys(
      {"format", "name", "title", "version", "reviewed", "reviewed_by", "indication", "summary",
       "sources", "patient", "blade", "cuts", "steps", "danger_zones", "rubric"},
      {"hinges", "joint_surfaces", "proof", "start"});
  Scenario scenario;
  read_head(root, scenario);
  scenario.patient = read_patient(root.at("patient"), bones);
  read_blade(root.at("blade"), scenario);
  read_lists(root, scenario);
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
