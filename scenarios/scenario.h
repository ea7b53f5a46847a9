/// An operation as data: what is cut, with which blade, towards which faces, and what each deviation costs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario_error.h"
#include "simulator/base/embedded.h"
#include "simulator/cutting/kerf.h"

namespace hallux::scenarios {

/// A blade with the numbers that its box prints. source  docs/references.md
struct SawBlade {
  std::string name;
  simulator::BladeSize size;
  double cycles_per_minute = 12000.0;
  double thickness_mm = 0.4;  ///< of the steel; the set of the teeth widens it to the kerf
  std::string origin;
};

/// Which patient is made for the operation.
struct PatientRequest {
  std::string bone;  ///< "first_metatarsal"
  double length_mm = 63.2;
  double eminence_mm = 0.0;
  double edge_mm = 0.3;
  std::string origin;
};

/// A finished bone face relative to landmarks: parallel to an axis between two of them, tilted about that axis, offset
/// from a third. Works on any patient that has the landmarks.
struct LandmarkPlane {
  std::string through;             ///< landmark from which the offset counts
  std::string axis_from, axis_to;  ///< the plane contains this direction
  double offset_mm = 0.0;          ///< along the normal, towards the waste
  double frontal_tilt_rad = 0.0;  ///< about the axis; positive: the plantar end lies further medial
};

struct ReferenceCut {
  std::string name, title;
  LandmarkPlane face;
  std::string
      waste_side;        ///< "medial" or "lateral": where the normal points; the other side is kept
  std::string approach;  ///< "dorsal": the side from which the blade comes
  std::string depth_landmark;  ///< where depth is measured
  std::string exit_landmark;   ///< where the face must run flush into the shaft
  std::string origin;
};

enum class StepKind { Verify, Cut, Remove, Finish };

struct OperationStep {
  StepKind kind = StepKind::Verify;
  std::string title, text;
  std::string cut;  ///< for Cut and Remove: the reference cut's name
};

/// Points for one metric: all of the weight up to `full`, none from `zero` on, linear between (lower is better).
/// A band gives full points inside [full_low, full_high] and none outside (zero_low, zero_high).
struct RubricItem {
  std::string id, title, group, metric, cut, unit;
  std::int64_t weight_milli = 0;  ///< rubric points x 1000
  bool is_band = false;
  double full = 0.0, zero = 0.0;
  double zero_low = 0.0, full_low = 0.0, full_high = 0.0, zero_high = 0.0;
  std::string origin;          ///< where the numbers come from
  bool is_provisional = true;  ///< no surgeon and no measured expert stands behind them yet
};

/// Caps the score where a metric exceeds its limit.
struct Gate {
  std::string name, title, metric, cut, unit;
  double limit = 0.0;
  std::int64_t cap_milli = 0;  ///< of 100 000
  std::string origin;
  bool is_provisional = true;
};

struct RubricGroup {
  std::string name, title;
  std::int64_t weight_milli = 0;
  std::string origin;
};

struct Rubric {
  std::int32_t version = 1;
  std::vector<RubricGroup> groups;  ///< weights add up to 100 000
  std::vector<RubricItem> items;    ///< groups without items are not measured yet
  std::vector<Gate> gates;
};

/// A structure that must not be touched: a capsule in the bone frame between two points.
struct DangerZone {
  std::string name, severity;  ///< severity: "critical", "major" or "minor"
  Vec3 from_in_bone_mm{0.0, 0.0, 0.0}, to_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
  std::string title;
  bool is_checked = false;  ///< true once an anatomist or surgeon has confirmed where it lies
  std::string origin;
};

/// A source that the origins of the numbers name by its key.
struct SourceNote {
  std::string key, text;
};

struct Scenario {
  std::int32_t format = 1;
  std::string name, title;
  std::int32_t version = 1;
  bool is_reviewed = false;  ///< false is shown everywhere as "not surgeon-reviewed"
  std::string reviewed_by;
  std::string indication, summary;
  PatientRequest patient;
  SawBlade blade;
  std::vector<ReferenceCut> cuts;
  std::vector<OperationStep> steps;
  std::vector<DangerZone> danger_zones;
  Rubric rubric;
  std::string text;  ///< the JSON it was read from, byte for byte
  std::vector<SourceNote> sources;
};

/// The scenario in a JSON text; `name` stands in the messages.
/// errors  ScenarioError: syntax with line, unknown or missing key with its path, value out of range, weights that do
///         not add up, a reference to a cut or landmark name that does not exist in the file
Scenario parse_scenario(std::string_view json, std::string_view name);
/// The scenario in a file of at most 256 KiB.
/// errors  ScenarioError: as parse_scenario, and where the file cannot be read
Scenario read_scenario(const std::filesystem::path& file);

/// "not surgeon-reviewed", or who reviewed it: shown wherever the scenario is seen.
std::string review_label(const Scenario& scenario);

/// The scenarios that come with the program, by name; and one of them.
std::span<const EmbeddedText> shipped_scenarios() noexcept;
/// errors  ScenarioError naming the shipped ones where there is none of that name
Scenario load_shipped_scenario(std::string_view name);

}  // namespace hallux::scenarios
