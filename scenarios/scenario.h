/// An operation as data: what is cut, with which blade, towards which faces, and what each
/// deviation costs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/fixation/fixation.h"
#include "scenarios/foot/foot_bones.h"
#include "scenarios/geometry/named_geometry.h"
#include "scenarios/scenario_error.h"
#include "simulator/base/embedded.h"
#include "simulator/base/vector.h"
#include "simulator/tool/saw.h"

namespace hallux::scenarios {

/// Which patient is made for the operation.
struct PatientRequest {
  /// The name of one of foot_bones().
  std::string bone;
  double length_mm = 63.2;
  /// Of a bone on which one grows.
  double eminence_mm = 0.0;
  double edge_mm = 0.3;
  std::string origin;
  /// The force that sawing needs, as a share of usual bone's.
  double bone_quality = 1.0;
};

/// AlongAxis     parallel to an axis between two landmarks, tilted about it, offset from a third
/// Transverse    across the bone: parallel to a line between two landmarks (a joint's) and to
///               dorsal, tilted, offset along the bone from a third
/// ThroughHinge  contains a hinge's line, turned about it from the face of the hinge's first cut
/// Turned        contains a point and a direction, turned about it and rolled: the one kind of
///               format 2, which has no other
enum class FaceKind { AlongAxis, Transverse, ThroughHinge, Turned };

/// A finished bone face relative to landmarks. Works on any patient that has them. What a kind does
/// not use stays empty.
struct LandmarkPlane {
  /// Landmark from which the offset counts. Turned: the point that it contains, or a hinge.
  std::string through;
  /// Without tilts the plane contains this direction.
  std::string axis_from, axis_to;
  /// AlongAxis: along the normal, towards the waste. Transverse: along the bone's x.
  double offset_mm = 0.0;
  /// AlongAxis: about the axis; positive: the plantar end lies further medial.
  double frontal_tilt_rad = 0.0;
  FaceKind kind = FaceKind::AlongAxis;
  /// Transverse, from the joint's line and from dorsal. Positive: the medial, the plantar edge lies
  /// further distal.
  double transverse_tilt_rad = 0.0, sagittal_tilt_rad = 0.0;
  /// ThroughHinge: from the face of the hinge's first cut. Positive: distal of it, open on the side
  /// away from the hinge.
  double wedge_rad = 0.0;
  /// Turned: the direction that it contains, or a hinge, whose line that is.
  std::string contains = {};
  /// Turned: a direction, or an earlier cut: at angle 0 the face contains `contains` and the part
  /// of the direction square to it, or lies in the face of that cut.
  std::string turned_from = {};
  /// Turned, by the right hand: about `contains`, and then about the direction in the face that is
  /// square to it.
  double angle_rad = 0.0, roll_rad = 0.0;
};

/// Where a face ends: only beyond a point along a direction, and between two limits across it.
struct ReferenceWindow {
  std::string beyond, along;
  /// The direction in which the limits are counted from the point: square to `along` in the face,
  /// on this side. Without limits it reaches as far as the bone.
  std::string across = {};
  std::optional<Range> limits = {};
};

struct ReferenceCut {
  std::string name, title;
  LandmarkPlane face;
  /// Where the normal points; the other side is kept. AlongAxis: "medial" or "lateral"; Transverse
  /// and ThroughHinge: "proximal" or "distal"; Turned: empty, see keep.
  std::string waste_side;
  /// The side from which the blade comes: "dorsal", "plantar", "medial" or "lateral"; in format 2 a
  /// direction, from the bone to the handpiece.
  std::string approach;
  /// AlongAxis: where depth is measured. Turned: a point, where the face runs along the bone.
  std::string depth_landmark;
  /// AlongAxis: where the face must run flush into the shaft. Turned: a point, as depth_landmark.
  std::string exit_landmark;
  std::string origin;
  /// Turned: the direction of the side whose finished face lies in the plane.
  std::string keep = {};
  /// Turned: the bone beyond the kerf is kept as well.
  bool keeps_both = false;
  std::optional<ReferenceWindow> window = {};
  /// Empty: the patient's first.
  std::string bone = {};
  /// One of blades; empty: any.
  std::string blade = {};
};

/// It is planned from a landmark of depth and one where it leaves the bone flush; any other lies
/// across the bone.
bool lies_along_bone(const ReferenceCut& cut) noexcept;

/// A bridge of bone that two cuts leave standing, and about which the wedge between them is closed.
/// Its line lies in the face of the first cut, parallel to dorsal, `thickness_mm` inside the cortex
/// on `side`; the second cut's face contains it.
struct ReferenceHinge {
  std::string name, title;
  std::string first_cut, second_cut;
  /// "lateral" or "medial": the cortex that is kept. In format 2 a direction.
  std::string side;
  /// Planned, where the bone reaches furthest to that side.
  double thickness_mm = 1.0;
  double target_low_mm = 0.8, target_high_mm = 2.0;
  /// A thinner bridge breaks when it is closed.
  double breaks_below_mm = 0.3;
  /// A thicker one does not bend.
  double bends_up_to_mm = 2.5;
  std::string origin;
  bool is_provisional = true;
  /// Format 2: the direction to which its line is parallel, as far as the first face lets it;
  /// empty: dorsal.
  std::string along = {};
  /// Format 2: the direction of the half that turns when it is closed; empty: distal.
  std::string moves = {};
};

/// Verify         the case is looked at
/// Cut            a planned face is sawn
/// Remove         a piece or a wedge comes out
/// Close          a wedge is closed on its hinge
/// Finish         all is done
/// Mark           a point is marked on the bone
/// GuideWire      a wire is set that leads the saw
/// Retract        what lies before the bone is held away
/// Complete       a hinge is weakened until it bends
/// Shift          a fragment is brought to its place
/// TemporaryWire  wires hold the fragment until it is fixed
/// Fix            wires or screws hold it for good
/// Trim           an overhang is sawn off along a planned face
/// The last eight are of format 2.
enum class StepKind {
  Verify,
  Cut,
  Remove,
  Close,
  Finish,
  Mark,
  GuideWire,
  Retract,
  Complete,
  Shift,
  TemporaryWire,
  Fix,
  Trim
};

struct OperationStep {
  StepKind kind = StepKind::Verify;
  std::string title, text;
  /// Cut, Trim: which; Remove: the cut whose piece comes out, unless it is a wedge.
  std::string cut;
  /// Remove: the hinge whose wedge comes out; Close, Complete: the hinge.
  std::string hinge;
  /// The rest is of format 2, where steps are no chain.
  std::string id = {};
  /// Ids of steps and names of groups that must be done before.
  std::vector<std::string> after = {};
  /// The group of alternatives of which one suffices; empty: none.
  std::string one_of = {};
  bool is_optional = false;
  /// Mark: which.
  std::string point = {};
  /// Shift: which.
  std::string shift = {};
  /// GuideWire, TemporaryWire, Fix: which.
  std::vector<std::string> implants = {};
};

/// A planned face is sawn in it.
inline bool is_sawn(const OperationStep& step) noexcept {
  return step.kind == StepKind::Cut || step.kind == StepKind::Trim;
}

/// All of the weight up to `full`, none from `zero` on, linear between; where `full` is the greater
/// one, higher is better.
/// A band gives full points inside [full_low, full_high] and none outside (zero_low, zero_high).
struct Knots {
  bool is_band = false;
  double full = 0.0, zero = 0.0;
  double zero_low = 0.0, full_low = 0.0, full_high = 0.0, zero_high = 0.0;

  friend bool operator==(const Knots&, const Knots&) = default;
};

/// The knots of an item for attempts of one class of devices.
struct DeviceKnots {
  /// One of simulator::device_classes.
  std::string device_class;
  Knots knots;
  std::string origin;
};

/// Points for one metric.
struct RubricItem : Knots {
  std::string id, title, group, metric, cut, unit;
  /// Rubric points x 1000.
  std::int64_t weight_milli = 0;
  /// Where the numbers come from.
  std::string origin;
  /// No surgeon and no measured expert stands behind them yet.
  bool is_provisional = true;
  /// What it is about, in place of `cut`. An implant, or a group of alternatives that set some.
  std::string hinge, zone, fragment, implant;
  /// In place of its own knots, for the classes named; the others have its own.
  std::vector<DeviceKnots> device_knots;
};

/// Caps the score where a metric exceeds its limit, or stays below it.
struct Gate {
  std::string name, title, metric, cut, unit;
  double limit = 0.0;
  /// Of 100 000.
  std::int64_t cap_milli = 0;
  std::string origin;
  bool is_provisional = true;
  /// What it is about, in place of `cut`.
  std::string hinge, zone, fragment, implant;
  /// The limit is the least that is asked for.
  bool is_at_least = false;
};

/// The cut, the hinge, the zone, the fragment or the implant that an item, a gate or a step is
/// about; empty where it is about none.
template <typename Part>
const std::string& subject_of(const Part& part) noexcept {
  if constexpr (requires { part.zone; }) {
    for (const std::string* name : {&part.zone, &part.fragment, &part.implant}) {
      if (!name->empty()) return *name;
    }
  }
  return part.hinge.empty() ? part.cut : part.hinge;
}

struct RubricGroup {
  std::string name, title;
  std::int64_t weight_milli = 0;
  std::string origin;
  /// Of the weight, where only some of it has items.
  std::int64_t not_measured_milli = 0;
};

struct Rubric {
  std::int32_t version = 1;
  /// Weights add up to 100 000.
  std::vector<RubricGroup> groups;
  /// Groups without items are not measured yet.
  std::vector<RubricItem> items;
  std::vector<Gate> gates;
};

/// A structure that must not be touched: a capsule between two points. Each is counted along the
/// axes of the bone frame, from its landmark, or from the bone's origin where it names none.
struct DangerZone {
  /// Severity: "critical", "major" or "minor".
  std::string name, severity;
  Vec3 from_in_bone_mm{0.0, 0.0, 0.0}, to_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
  std::string title;
  /// True once an anatomist or surgeon has confirmed where it lies.
  bool is_checked = false;
  std::string origin;
  std::string from_landmark = {}, to_landmark = {};
  /// Empty: the patient's first.
  std::string bone = {};
};

/// A part of the bone's surface that is a joint's: where its outer surface lies within `radius_mm`
/// of a place and looks within an angle of a direction.
struct JointSurface {
  std::string name, title;
  /// The place: a landmark, and from it along the axes of the bone frame.
  std::string around;
  Vec3 offset_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
  /// Along the axes of the bone frame, of unit length.
  Vec3 facing_in_bone{1.0, 0.0, 0.0};
  double within_rad = 0.0;
  /// True once an anatomist or surgeon has confirmed where it lies.
  bool is_checked = false;
  std::string origin;
  /// Empty: the patient's first.
  std::string bone = {};
};

/// A performance that proves the rubric: the perfect hand with one fault, and what that must cost.
struct ProofFault {
  /// As `hallux attempt --fault` takes it: "tilt:proximal_face=8"; several, with spaces between,
  /// are one performance.
  std::string fault;
  /// Ids of rubric items that lose at least half of their points.
  std::vector<std::string> items;
  /// Names of the gates that it triggers; it triggers no others.
  std::vector<std::string> gates;
};

/// Where somebody stands and holds the saw when the operation begins; directions along the axes of
/// the bone frame, of unit length.
struct StartingPlace {
  /// From the site of the first cut towards the eye.
  Vec3 eye_in_bone{0.0, 1.0, 0.0};
  /// Up on the picture, as far as the eye lets it; not along eye_in_bone.
  Vec3 up_in_bone{0.0, 1.0, 0.0};
  /// Around the site, what the picture shows wholly.
  double radius_mm = 30.0;
  /// Of the middle of the tooth line, from the first cut's entry.
  Vec3 tip_from_entry_mm{0.0, 0.0, 0.0};
  /// From handle to teeth, and the blade's normal; square to each other.
  Vec3 feed_in_bone{0.0, -1.0, 0.0}, normal_in_bone{0.0, 0.0, 1.0};
  std::string origin;
};

/// A source that the origins of the numbers name by its key.
struct SourceNote {
  std::string key, text;
};

/// One of the blades that an operation lays out.
struct BladeOffer {
  std::string name, title;
  simulator::Saw saw;
  std::string origin;
};

struct Scenario {
  std::int32_t format = 1;
  std::string name, title;
  std::int32_t version = 1;
  /// A surgeon signed this version in the program, which nobody can yet; false is shown everywhere
  /// as "not surgeon-reviewed".
  bool is_reviewed = false;
  /// What a file of before says of itself; nobody believes it, and new ones are refused.
  bool claims_review = false;
  std::string indication, summary;
  PatientRequest patient;
  /// With the numbers that the blade's box prints. Further tools that an operation lays out come
  /// beside it.
  /// source  docs/references.md
  simulator::Saw saw;
  std::string blade_name, blade_origin;
  std::vector<ReferenceCut> cuts;
  std::vector<OperationStep> steps;
  std::vector<DangerZone> danger_zones;
  Rubric rubric;
  /// The JSON it was read from, byte for byte.
  std::string text;
  std::vector<SourceNote> sources;
  std::vector<ReferenceHinge> hinges;
  /// Nothing in older texts: then the program chooses.
  std::optional<StartingPlace> start = {};
  /// None in older texts.
  std::vector<JointSurface> joint_surfaces = {};
  /// None in older texts.
  std::vector<ProofFault> proof = {};
  /// All that follows is of format 2. Bones beside `patient`, which is the first.
  std::vector<PatientRequest> further_bones = {};
  std::vector<NamedPoint> points = {};
  std::vector<NamedDirection> directions = {};
  std::vector<Fragment> fragments = {};
  std::vector<FragmentShift> shifts = {};
  /// Wires, then screws, each in the order of the file.
  std::vector<Implant> implants = {};
  /// At least one, of which the first is `saw`.
  std::vector<BladeOffer> blades = {};
};

/// The scenario in a JSON text; `name` stands in the messages.
/// bones   the rows that its patient may ask for
/// errors  ScenarioError: syntax with line, unknown or missing key with its path, value out of
///         range, weights that do not add up, a reference to a cut or landmark name that does not
///         exist in the file
Scenario parse_scenario(std::string_view json, std::string_view name,
                        std::span<const FootBone> bones = foot_bones());
/// The scenario in a file of at most 256 KiB that somebody brings.
/// errors  ScenarioError: as parse_scenario, where the file cannot be read, or claims a review
Scenario read_scenario(const std::filesystem::path& file);

/// The rubric as it is for attempts with that class of devices: each item with the knots of it.
Rubric rubric_for(const Rubric& rubric, std::string_view device_class);

/// Whether a surgeon reviewed it, in words: shown wherever the scenario is seen.
std::string review_label(const Scenario& scenario);

/// The scenarios that come with the program, by name; and one of them.
std::span<const EmbeddedText> shipped_scenarios() noexcept;
/// errors  ScenarioError naming the shipped ones where there is none of that name
Scenario load_shipped_scenario(std::string_view name);

}  // namespace hallux::scenarios
