#include "scenarios/read_cuts.h"

#include "scenarios/read_parts.h"
#include "simulator/base/check.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {
namespace {

double read_tilt_rad(const JsonNode& node) { return radian_from_degree(node.number(-45.0, 45.0)); }

/// Along the bone is what a face without a kind means: the first scenarios knew no other. Turned
/// ones are of format 2 (format_2/read_operation.h).
FaceKind read_face_kind(const JsonNode& node) {
  if (!node.has("kind")) return FaceKind::AlongAxis;
  const std::string kind = node.at("kind").one_of({"along_axis", "transverse", "through_hinge"});
  if (kind == "along_axis") return FaceKind::AlongAxis;
  return kind == "transverse" ? FaceKind::Transverse : FaceKind::ThroughHinge;
}

void read_axis(const JsonNode& node, LandmarkPlane& face) {
  face.through = node.at("through").name();
  face.axis_from = node.at("axis_from").name();
  face.axis_to = node.at("axis_to").name();
  face.offset_mm = node.at("offset_mm").number(-30.0, 30.0);
  if (face.axis_from == face.axis_to) {
    node.at("axis_to").refuse_value("give another landmark than axis_from");
  }
}

LandmarkPlane read_face(const JsonNode& node) {
  LandmarkPlane face;
  face.kind = read_face_kind(node);
  switch (face.kind) {
    case FaceKind::AlongAxis:
      node.expect_keys({"through", "axis_from", "axis_to", "offset_mm", "frontal_tilt_deg"},
                       {"kind"});
      read_axis(node, face);
      face.frontal_tilt_rad = read_tilt_rad(node.at("frontal_tilt_deg"));
      break;
    case FaceKind::Transverse:
      node.expect_keys({"kind", "through", "axis_from", "axis_to", "offset_mm",
                        "transverse_tilt_deg", "sagittal_tilt_deg"});
      read_axis(node, face);
      face.transverse_tilt_rad = read_tilt_rad(node.at("transverse_tilt_deg"));
      face.sagittal_tilt_rad = read_tilt_rad(node.at("sagittal_tilt_deg"));
      break;
    case FaceKind::Turned:
      CHECK(false);
      break;
    case FaceKind::ThroughHinge:
      node.expect_keys({"kind", "through", "wedge_deg"});
      face.through = node.at("through").name();
      face.wedge_rad = radian_from_degree(node.at("wedge_deg").number(1.0, 30.0));
      break;
  }
  return face;
}

StepKind read_step_kind(const JsonNode& node) {
  const std::string kind = node.one_of({"verify", "cut", "remove", "close", "finish"});
  if (kind == "verify") return StepKind::Verify;
  if (kind == "cut") return StepKind::Cut;
  if (kind == "remove") return StepKind::Remove;
  if (kind == "close") return StepKind::Close;
  return StepKind::Finish;
}

/// The thickness that is planned is one that scores in full, and one that bends when the wedge is
/// closed.
void check_thickness(const JsonNode& node, const ReferenceHinge& hinge) {
  if (!(hinge.breaks_below_mm < hinge.target_low_mm && hinge.target_low_mm < hinge.target_high_mm &&
        hinge.target_high_mm < hinge.bends_up_to_mm)) {
    node.refuse_value("let breaks_below_mm, the two of target_mm and bends_up_to_mm rise");
  }
  if (!(hinge.target_low_mm <= hinge.thickness_mm && hinge.thickness_mm <= hinge.target_high_mm)) {
    node.at("thickness_mm").refuse_value("give a number within target_mm");
  }
}

}  // namespace

ReferenceCut read_cut(const JsonNode& node) {
  node.expect_keys({"name", "title", "face", "waste_side", "approach", "origin"},
                   {"depth_landmark", "exit_landmark"});
  ReferenceCut cut;
  cut.name = node.at("name").name();
  cut.title = node.at("title").text(1, title_bytes_max);
  cut.face = read_face(node.at("face"));
  const bool is_along = cut.face.kind == FaceKind::AlongAxis;
  cut.waste_side = is_along ? node.at("waste_side").one_of({"medial", "lateral"})
                            : node.at("waste_side").one_of({"proximal", "distal"});
  cut.approach = is_along ? node.at("approach").one_of({"dorsal", "plantar"})
                          : node.at("approach").one_of({"medial", "lateral", "dorsal", "plantar"});
  if (node.has("depth_landmark") != is_along || node.has("exit_landmark") != is_along) {
    node.refuse_value(is_along
                          ? "give \"depth_landmark\" and \"exit_landmark\""
                          : "remove \"depth_landmark\" and \"exit_landmark\": they belong to a "
                            "face along the bone");
  }
  cut.depth_landmark = node.name_where_given("depth_landmark");
  cut.exit_landmark = node.name_where_given("exit_landmark");
  cut.origin = node.at("origin").text(1, origin_bytes_max);
  return cut;
}

ReferenceHinge read_hinge(const JsonNode& node) {
  node.expect_keys({"name", "title", "first_cut", "second_cut", "side", "thickness_mm", "target_mm",
                    "breaks_below_mm", "bends_up_to_mm", "origin", "provisional"});
  ReferenceHinge hinge;
  hinge.name = node.at("name").name();
  hinge.title = node.at("title").text(1, title_bytes_max);
  hinge.first_cut = node.at("first_cut").name();
  hinge.second_cut = node.at("second_cut").name();
  hinge.side = node.at("side").one_of({"lateral", "medial"});
  hinge.origin = node.at("origin").text(1, origin_bytes_max);
  read_bridge(node, hinge);
  return hinge;
}

void read_bridge(const JsonNode& node, ReferenceHinge& hinge) {
  hinge.thickness_mm = node.at("thickness_mm").number(0.1, 5.0);
  const std::vector<JsonNode> target = node.at("target_mm").list(2, 2);
  hinge.target_low_mm = target[0].number(0.1, 5.0);
  hinge.target_high_mm = target[1].number(0.1, 5.0);
  hinge.breaks_below_mm = node.at("breaks_below_mm").number(0.0, 5.0);
  hinge.bends_up_to_mm = node.at("bends_up_to_mm").number(0.1, 10.0);
  hinge.is_provisional = node.at("provisional").boolean();
  check_thickness(node, hinge);
}

OperationStep read_step(const JsonNode& node) {
  node.expect_keys({"kind", "title", "text"}, {"cut", "hinge"});
  return {.kind = read_step_kind(node.at("kind")),
          .title = node.at("title").text(1, title_bytes_max),
          .text = node.at("text").text(1, text_bytes_max),
          .cut = node.name_where_given("cut"),
          .hinge = node.name_where_given("hinge")};
}

}  // namespace hallux::scenarios
