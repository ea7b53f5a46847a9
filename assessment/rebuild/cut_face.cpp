#include "assessment/rebuild/cut_face.h"

#include <algorithm>
#include <cmath>

#include "assessment/rebuild/face_samples.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::PlannedCut;
using simulator::KerfPlane;

Vec3 normal_of(const KerfPlane& plane) noexcept {
  return transform_direction(plane.bone_from_kerf, Vec3{0.0, 0.0, 1.0});
}

/// A tilt of one degree counts as much as a millimetre: over a section of 20 mm they move the face by as much.
double misfit(const KerfPlane& plane, const PlannedCut& cut) noexcept {
  const FacePlane planned{cut.face.normal, cut.face.offset_mm};
  const double angle_rad = angle_between_rad(normal_of(plane), planned.normal);
  const double tilt_deg = degree_from_radian(std::min(angle_rad, pi - angle_rad));
  return tilt_deg + std::abs(signed_distance_mm(planned, plane.bone_from_kerf.translation_mm));
}

std::size_t nearest_cut(const KerfPlane& plane, const scenarios::Plan& plan) noexcept {
  std::size_t nearest = 0;
  for (std::size_t cut = 1; cut < plan.cuts.size(); ++cut) {
    if (misfit(plane, plan.cuts[cut]) < misfit(plane, plan.cuts[nearest])) nearest = cut;
  }
  return nearest;
}

/// The wall that stays on the kept bone: below the kerf where its z looks to the waste, else above.
std::int32_t kept_side(const KerfPlane& plane, const PlannedCut& cut) noexcept {
  return glm::dot(normal_of(plane), cut.face.normal) >= 0.0 ? -1 : 1;
}

/// Exact by the kerf's pose; used where the samples are too few to say.
FacePlane wall_plane(const KerfPlane& plane, std::int32_t side) noexcept {
  const Vec3 normal = -static_cast<double>(side) * normal_of(plane);
  const Vec3 local{0.0, 0.0, 0.5 * plane.thickness_mm * side};
  return {normal, glm::dot(normal, transform_point(plane.bone_from_kerf, local))};
}

CutFace face_of_kerf(const RebuiltBone& rebuilt, std::int32_t index, const PlannedCut& cut) {
  const RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(index)];
  const KerfPlane& plane = rebuilt.fields.plane(index);
  const std::int32_t side = kept_side(plane, cut);
  CutFace face;
  face.kerf = index;
  face.is_finished = kerf.is_finished();
  face.done_fraction = kerf.done_fraction();
  FaceSamples samples;
  while (face.is_finished && face.piece < rebuilt.pieces.size()) {
    samples = sample_wall(rebuilt.pieces[face.piece], {index, side}, plane);
    if (!samples.points_in_bone_mm.empty()) break;
    ++face.piece;
  }
  if (!face.is_finished) samples = sample_opened(kerf, rebuilt.fields.field(index), side);
  face.samples_in_bone_mm = std::move(samples.points_in_bone_mm);
  face.area_mm2 = samples.area_mm2;
  const FacePlane exact = wall_plane(plane, side);
  face.plane = fit_plane(face.samples_in_bone_mm, exact.normal).value_or(exact);
  return face;
}

}  // namespace

std::vector<CutFace> faces_of_cut(const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                                  std::size_t cut) {
  std::vector<CutFace> faces;
  for (std::int32_t index = 0; index < rebuilt.fields.count(); ++index) {
    if (nearest_cut(rebuilt.fields.plane(index), plan) != cut) continue;
    faces.push_back(face_of_kerf(rebuilt, index, plan.cuts[cut]));
  }
  std::stable_sort(faces.begin(), faces.end(), [](const CutFace& a, const CutFace& b) {
    const bool a_stands = a.is_finished && a.area_mm2 > 0.0;
    const bool b_stands = b.is_finished && b.area_mm2 > 0.0;
    if (a_stands != b_stands) return a_stands;
    return a.piece != b.piece ? a.piece < b.piece : a.area_mm2 > b.area_mm2;
  });
  return faces;
}

bool is_opened_at(const CutFace& face, const RebuiltBone& rebuilt, const Vec3& point_in_bone_mm) {
  const KerfPlane& plane = rebuilt.fields.plane(face.kerf);
  const Vec3 local = transform_point(inverse(plane.bone_from_kerf), point_in_bone_mm);
  return rebuilt.fields.field(face.kerf).is_open(Vec2{local.x, local.y});
}

}  // namespace hallux::assessment
