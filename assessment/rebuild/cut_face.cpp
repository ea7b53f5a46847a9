#include "assessment/rebuild/cut_face.h"

#include <algorithm>
#include <cmath>

#include "assessment/rebuild/cut_of_kerf.h"
#include "assessment/rebuild/face_samples.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::PlannedCut;
using simulator::KerfPlane;

Vec3 normal_of(const KerfPlane& plane) noexcept { return axis_z(plane.bone_from_kerf); }

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

/// The wall of the first piece that has one; `piece` becomes its number, or stays 0 where none
/// has.
FaceSamples sample_wall_of_pieces(const RebuiltBone& rebuilt, const simulator::FaceSource& wall,
                                  std::size_t& piece) {
  const KerfPlane& plane = rebuilt.fields.plane(wall.kerf);
  for (std::size_t i = 0; i < rebuilt.pieces.size(); ++i) {
    FaceSamples samples = sample_wall(rebuilt.pieces[i], wall, plane);
    if (samples.points_in_bone_mm.empty()) continue;
    piece = i;
    return samples;
  }
  return {};
}

}  // namespace

CutFace face_of_kerf(const RebuiltBone& rebuilt, std::int32_t index, const scenarios::Plan& plan,
                     std::size_t cut) {
  const RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(index)];
  const KerfPlane& plane = rebuilt.fields.plane(index);
  const std::int32_t side = kept_side(plane, plan.cuts[cut]);
  CutFace face;
  face.kerf = index;
  face.done_fraction = done_fraction_of(rebuilt, index, plan, cut);
  face.is_finished = face.done_fraction == 1.0;
  FaceSamples samples = sample_wall_of_pieces(rebuilt, {index, side}, face.piece);
  face.is_wall = !samples.points_in_bone_mm.empty();
  const bool is_taken_away = kerf.is_finished();  // then a face on no piece is gone with its piece
  if (!face.is_wall && !is_taken_away) {
    samples = sample_opened(kerf, rebuilt.fields.field(index), side);
  }
  face.samples_in_bone_mm = std::move(samples.points_in_bone_mm);
  face.area_mm2 = samples.area_mm2;
  face.step_mm = samples.step_mm;
  face.border_share = samples.border_share;
  const FacePlane exact = wall_plane(plane, side);
  face.plane = fit_plane(face.samples_in_bone_mm, exact.normal).value_or(exact);
  return face;
}

std::vector<CutFace> faces_of_cut(const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                                  std::size_t cut, const StepEvidence& evidence) {
  const std::vector<std::size_t> cuts = cuts_of_kerfs(rebuilt, plan, evidence);
  std::vector<CutFace> faces;
  for (std::int32_t index = 0; index < rebuilt.fields.count(); ++index) {
    if (cuts[static_cast<std::size_t>(index)] != cut) continue;
    faces.push_back(face_of_kerf(rebuilt, index, plan, cut));
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
