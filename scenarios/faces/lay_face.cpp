// Each kind gives a normal that points into the waste, a point of the plane, and the axis that
// pictures and metrics turn about. Two of format 1's kinds and format 2's are the same turn of a
// normal; the formulas of format 1 keep their order of roundings, since attempts are scored by
// these planes for ever.
#include "scenarios/faces/lay_face.h"

#include <cmath>

#include "simulator/base/elementary.h"

namespace hallux::scenarios {
namespace {

constexpr std::string_view other_axis = "name other axis landmarks";

const Vec3 distal{1.0, 0.0, 0.0}, dorsal{0.0, 1.0, 0.0};

/// A normal turned towards a direction square to it.
Vec3 turned(const Vec3& normal, const Vec3& toward, double angle_rad) {
  return elementary::cos(angle_rad) * normal + elementary::sin(angle_rad) * toward;
}

double tangent(double angle_rad) { return elementary::sin(angle_rad) / elementary::cos(angle_rad); }

Vec3 point_of(const AskedCut& asked, const std::string& name) {
  return asked.ground.point(name, asked.bone, asked.path);
}

Vec3 direction_of(const AskedCut& asked, const std::string& name) {
  return asked.ground.direction(name, asked.bone, asked.path);
}

Vec3 landmark_axis(const AskedCut& asked) {
  const LandmarkPlane& face = asked.cut.face;
  return unit_or_refuse(point_of(asked, face.axis_to) - point_of(asked, face.axis_from), asked.path,
                        "the landmarks of its axis coincide", other_axis);
}

/// Towards the waste, square to the axis, then turned about the axis. For an axis that points
/// distally (+x) the turn raises the dorsal component of a medial normal, so the plane runs further
/// medial as it goes plantar.
Vec3 normal_along(const AskedCut& asked, const Vec3& axis) {
  const Vec3 side = direction_of(asked, asked.cut.waste_side);
  const Vec3 square = unit_or_refuse(side - glm::dot(side, axis) * axis, asked.path,
                                     "the axis runs from the kept side to the waste", other_axis);
  return turned(square, glm::cross(axis, square), asked.cut.face.frontal_tilt_rad);
}

/// Of the two directions in a face the one more square to the approach; distal in a face along the
/// bone, dorsal in one across it.
Vec3 axis_square_to(const Vec3& approach, const Vec3& one, const Vec3& other, bool is_along_bone) {
  const bool is_one = std::abs(glm::dot(approach, one)) <= std::abs(glm::dot(approach, other));
  const Vec3& axis = is_one ? one : other;
  return glm::dot(axis, is_along_bone ? distal : dorsal) < 0.0 ? -axis : axis;
}

}  // namespace

LaidFace lay_along_axis(const AskedCut& asked) {
  const LandmarkPlane& face = asked.cut.face;
  const Vec3 axis = landmark_axis(asked);
  LaidFace laid;
  // The axis says distal whichever way round the file names its ends; the tilt is counted about it.
  laid.axis = axis.x < 0.0 ? -axis : axis;
  laid.face.normal = normal_along(asked, laid.axis);
  laid.face.offset_mm = glm::dot(laid.face.normal, point_of(asked, face.through)) + face.offset_mm;
  return laid;
}

LaidFace lay_transverse(const AskedCut& asked) {
  const LandmarkPlane& face = asked.cut.face;
  const Vec3 axis = landmark_axis(asked);
  const Vec3 lateral = axis.z < 0.0 ? -axis : axis;
  const Vec3 along =
      unit_or_refuse(glm::cross(dorsal, lateral), asked.path,
                     "the line between its axis landmarks runs dorsally", other_axis);
  const Vec3 tilted = glm::normalize(along + tangent(face.sagittal_tilt_rad) * dorsal +
                                     tangent(face.transverse_tilt_rad) * glm::cross(along, dorsal));
  LaidFace laid;
  laid.face.normal = asked.cut.waste_side == "distal" ? tilted : -tilted;
  laid.face.offset_mm =
      glm::dot(laid.face.normal, point_of(asked, face.through) + Vec3{face.offset_mm, 0.0, 0.0});
  laid.axis =
      laid_in({tilted, 0.0}, dorsal, asked.path, "its face lies level with the sole", other_axis);
  return laid;
}

LaidFace lay_through_hinge(const AskedCut& asked, const simulator::HingeLine& line,
                           double wedge_rad) {
  const Vec3 first = glm::cross(line.axis, line.outward);
  const Vec3 normal = turned(first.x < 0.0 ? -first : first, line.outward, wedge_rad);
  LaidFace laid;
  laid.face.normal = asked.cut.waste_side == "distal" ? normal : -normal;
  laid.face.offset_mm = glm::dot(laid.face.normal, line.point_in_bone_mm);
  laid.axis = line.axis;
  return laid;
}

LaidFace lay_turned(const AskedCut& asked, const ReferenceFace* from_face) {
  const LandmarkPlane& plane = asked.cut.face;
  const Vec3 contains = direction_of(asked, plane.contains);
  const Vec3 from = from_face != nullptr ? glm::cross(from_face->normal, contains)
                                         : direction_of(asked, plane.turned_from);
  const Vec3 square =
      unit_or_refuse(from - glm::dot(from, contains) * contains, asked.path + ".face.from",
                     "\"" + plane.turned_from + "\" runs along \"" + plane.contains + "\"",
                     "name a direction that parts from face.contains");
  const Vec3 second = turned(square, glm::cross(contains, square), plane.angle_rad);
  const Vec3 flat = glm::cross(contains, second);
  const Vec3 normal = turned(flat, contains, plane.roll_rad);
  const double to_kept = glm::dot(normal, direction_of(asked, asked.cut.keep));
  if (std::abs(to_kept) < direction_length_min) {
    throw ScenarioError(asked.path + ": the side \"" + asked.cut.keep +
                        "\" lies in the face; name a direction that leaves it");
  }
  LaidFace laid;
  laid.face.normal = to_kept > 0.0 ? -normal : normal;
  laid.face.offset_mm = glm::dot(laid.face.normal, point_of(asked, plane.through));
  laid.axis =
      axis_square_to(direction_of(asked, asked.cut.approach),
                     turned(contains, -flat, plane.roll_rad), second, lies_along_bone(asked.cut));
  return laid;
}

std::optional<FaceWindow> lay_window(const AskedCut& asked, const ReferenceFace& face) {
  if (!asked.cut.window) return std::nullopt;
  const ReferenceWindow& said = *asked.cut.window;
  FaceWindow window;
  window.from_in_bone_mm = point_of(asked, said.beyond);
  window.along = laid_in(face, direction_of(asked, said.along), asked.path + ".window.along",
                         "\"" + said.along + "\" is square to the face",
                         "name a direction that lies nearer to it");
  window.across = glm::cross(face.normal, window.along);
  if (!said.limits) return window;
  const double to_side = glm::dot(window.across, direction_of(asked, said.across));
  if (std::abs(to_side) < direction_length_min) {
    throw ScenarioError(asked.path + ".window.across: \"" + said.across +
                        "\" does not run across the window; name a direction square to \"" +
                        said.along + "\" in the face");
  }
  if (to_side < 0.0) window.across = -window.across;
  window.low_mm = said.limits->low_mm;
  window.high_mm = said.limits->high_mm;
  return window;
}

Vec3 laid_in(const ReferenceFace& face, const Vec3& direction, const std::string& path,
             std::string_view what, std::string_view mend) {
  return unit_or_refuse(direction - glm::dot(direction, face.normal) * face.normal, path, what,
                        mend);
}

}  // namespace hallux::scenarios
