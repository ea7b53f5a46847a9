#include "tests/screenshots/sawn_bones.h"

#include <algorithm>

#include "simulator/base/check.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"

namespace hallux::tests {

using namespace simulator;

namespace {

/// Crossings lie on the planes to the rounding of a millimetre; mesh points that close to them are
/// none of ours.
constexpr double on_plane_mm = 1.0e-9;

Paint paint_of_wall(const FaceSource& source) {
  if (source.side == 0) return Paint::Front;
  return source.side > 0 ? Paint::UpperWall : Paint::LowerWall;
}

}  // namespace

PlannedBone akin_phalanx(double edge_mm) {
  PlannedBone result;
  result.scenario = scenarios_test::format_1("akin");
  result.scenario.patient.edge_mm = edge_mm;
  result.bone = make_patient_bones(result.scenario).front();
  result.plan = plan_on(result.scenario, result.bone);
  result.solid = uncut_solid(solid_of(result.bone));
  return result;
}

KerfPlane planned_kerf(const PlannedBone& bone, std::size_t cut, double kerf_mm) {
  const scenarios::PlannedCut& planned = bone.plan.cuts.at(cut);
  const HingeLine& line = bone.plan.hinges.at(0).bridge.line;
  const Vec3 normal = planned.face.normal;
  const Vec3 side = line.axis;
  Vec3 feed = glm::cross(side, normal);
  const Vec3 inward = planned.exit_point_in_bone_mm - planned.entry_point_in_bone_mm;
  if (glm::dot(feed, inward) < 0.0) feed = -feed;
  return {{rotation_from_axes(feed, side), line.point_in_bone_mm + 0.5 * kerf_mm * normal},
          kerf_mm};
}

HingeLine planned_hinge_line(const PlannedBone& bone) { return bone.plan.hinges.at(0).bridge.line; }

Vec3 point_in_bone_mm(const KerfPlane& plane, const Vec2& place, double height) {
  return transform_point(plane.bone_from_kerf, Vec3(place.x, place.y, height));
}

KerfPlane moved_in_plane(const KerfPlane& plane, const Vec2& origin_mm) {
  KerfPlane moved = plane;
  moved.bone_from_kerf.translation_mm = point_in_bone_mm(plane, origin_mm);
  return moved;
}

FieldGrid wide_grid() { return {Vec2(-24.0, -24.0), 0.05, 961, 961}; }

void saw(KerfField& field, const Blade& blade, const std::vector<PlanarPose>& poses) {
  FieldWindow changed;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    field.stamp(blade, poses[i == 0 ? 0 : i - 1], poses[i], changed);
  }
}

SawnFrame frame_of(const CutSolid& solid, const KerfPlane& plane, const KerfField& field,
                   std::int32_t kerf) {
  SawnFrame frame;
  frame.contact = slice_slab(solid, Bvh(solid.mesh), plane, kerf, field.grid());
  frame.region = outline_of(field);
  CHECK(PatchBuilder(frame.contact).build(frame.region, frame.patch));
  return frame;
}

int level_of(const KerfPlane& plane, const IndexedMesh& mesh, const Triangle& corners) {
  const KerfAxes axes = axes_of(plane);
  const double half_mm = 0.5 * plane.thickness_mm + on_plane_mm;
  for (const std::uint32_t corner : corners) {
    const double at_mm = height_mm(axes, mesh.points_mm[corner]);
    if (at_mm > half_mm) return 1;
    if (at_mm < -half_mm) return -1;
  }
  return 0;
}

std::vector<Paint> paints_of(const CutSolid& solid, const SawnFrame& frame) {
  const IndexedMesh shown = shown_mesh(solid, frame.patch);
  const std::size_t standing = shown.triangles.size() - frame.patch.triangles.size();
  std::vector<Paint> paints;
  for (std::size_t i = 0; i < frame.patch.triangles.size(); ++i) {
    const FaceSource& source = frame.patch.sources[i];
    if (source.kerf == frame.contact.kerf) {
      paints.push_back(paint_of_wall(source));
    } else {
      const int level = level_of(frame.contact.plane, shown, shown.triangles[standing + i]);
      paints.push_back(level == 0 ? Paint::Strip : Paint::OuterPart);
    }
  }
  return paints;
}

Scene shown_scene(const CutSolid& solid, const SawnFrame& frame) {
  const IndexedMesh shown = shown_mesh(solid, frame.patch);
  const std::vector<Paint> patch = paints_of(solid, frame);
  std::vector<Paint> paints(shown.triangles.size() - patch.size(), Paint::Skin);
  paints.insert(paints.end(), patch.begin(), patch.end());
  Scene scene;
  scene.add(shown, paints);
  return scene;
}

std::vector<Paint> paints_of(const CutSolid& solid, bool has_earlier) {
  std::vector<Paint> paints;
  for (const FaceSource& source : solid.sources) {
    if (source.kerf == -1) {
      paints.push_back(Paint::Skin);
    } else if (source.kerf < 0) {
      paints.push_back(Paint::Division);
    } else if (has_earlier && source.kerf == 0) {
      paints.push_back(source.side == 0 ? Paint::Front : Paint::OtherWall);
    } else {
      paints.push_back(paint_of_wall(source));
    }
  }
  return paints;
}

}  // namespace hallux::tests
