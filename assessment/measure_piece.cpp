#include "assessment/measure_piece.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "assessment/make_measurement.h"
#include "assessment/rebuild/bound.h"
#include "assessment/rebuild/geometry_bounds.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::OperationStep;

/// A surface that stands steeper over the face says nothing of what lies beside.
constexpr double steepest_rad = radian_from_degree(89.0);

struct Thickness {
  double mean_mm = 0.0, greatest_mm = 0.0;
  Vec3 thickest_in_bone_mm{0.0, 0.0, 0.0};
  double mean_bound_mm = 0.0, greatest_bound_mm = 0.0;
};

/// What lies over a point of the face, and how steeply it changes along the face there.
struct Over {
  double thick_mm = 0.0, slope = 0.0;
};

/// The mean way from a square's middle to its points, as a share of its side.
constexpr double mean_reach = 0.383;

/// Between samples the thickness goes on as steeply as it does at them, but never further than its
/// whole range.
void bound_thickness(Thickness& thickness, const CutFace& face, const std::vector<Over>& all) {
  double least_mm = thickness.greatest_mm, sum_mm = 0.0, highest_mm = 0.0;
  for (const Over& over : all) least_mm = std::min(least_mm, over.thick_mm);
  const double range_mm = thickness.greatest_mm - least_mm;
  for (const Over& over : all) {
    sum_mm += std::min(range_mm, mean_reach * over.slope * face.step_mm);
    const double rise_mm = std::min(range_mm, reach_bound_mm(face, over.slope));
    highest_mm = std::max(highest_mm, over.thick_mm + rise_mm);
  }
  thickness.mean_bound_mm = sum_mm / static_cast<double>(all.size()) +
                            area_bound(face) * std::max(thickness.greatest_mm - thickness.mean_mm,
                                                        thickness.mean_mm - least_mm) +
                            plane_bound_mm;
  thickness.greatest_bound_mm = highest_mm - thickness.greatest_mm + plane_bound_mm;
}

/// `over` tells what lies over a point of the face.
template <typename OverFace>
Thickness thickness_over(const CutFace& face, OverFace&& over_face) {
  Thickness thickness;
  std::vector<Over> all;
  all.reserve(face.samples_in_bone_mm.size());
  double sum_mm = 0.0;
  for (const Vec3& sample_mm : face.samples_in_bone_mm) {
    Over over = over_face(sample_mm);
    over.thick_mm = std::max(0.0, over.thick_mm);
    all.push_back(over);
    sum_mm += over.thick_mm;
    if (over.thick_mm <= thickness.greatest_mm) continue;
    thickness.greatest_mm = over.thick_mm;
    thickness.thickest_in_bone_mm = sample_mm;
  }
  thickness.mean_mm = sum_mm / static_cast<double>(face.samples_in_bone_mm.size());
  bound_thickness(thickness, face, all);
  return thickness;
}

/// Of the height of a plane over another one: the tangent of the angle between their normals.
double slope_between(const Vec3& normal, const Vec3& over_normal) noexcept {
  return std::tan(std::min(angle_between_rad(normal, over_normal), steepest_rad));
}

Thickness slab_thickness(const CutFace& face, const simulator::IndexedMesh& outer,
                         const simulator::Bvh& surface) {
  return thickness_over(face, [&](const Vec3& sample_mm) -> Over {
    const auto hit = surface.first_hit(sample_mm, face.plane.normal);
    if (!hit) return {};
    const auto [a, b, c] = corners_of(outer, hit->triangle);
    const Vec3 normal = glm::cross(b - a, c - a);
    return {hit->distance_mm, slope_between(face.plane.normal, normal / length_of(normal))};
  });
}

Thickness wedge_thickness(const CutFace& first, const CutFace& second) {
  const Vec3& normal = second.plane.normal;
  const bool looks_alike = glm::dot(first.plane.normal, normal) > 0.0;
  const double slope = slope_between(first.plane.normal, looks_alike ? normal : -normal);
  return thickness_over(first, [&](const Vec3& sample_mm) -> Over {
    return {distance_along_mm(second.plane, sample_mm, first.plane.normal), slope};
  });
}

void add_thickness(std::vector<Measurement>& made, const OperationStep& step,
                   const std::vector<const CutFace*>& faces, const Evidence& evidence,
                   const BoneSurfaces& surfaces) {
  const bool is_there =
      std::none_of(faces.begin(), faces.end(), [](const CutFace* face) { return face == nullptr; });
  const std::size_t begin = made.size();
  if (!is_there) {
    made.push_back(absent(Metric::ThicknessMm, Absence::NotMade, {}));
    made.push_back(absent(Metric::ThicknessMaxMm, Absence::NotMade, {}));
  } else {
    const std::size_t bone = bone_of(evidence.rebuilt, faces[0]->kerf);
    const Thickness thickness =
        faces.size() == 2 ? wedge_thickness(*faces[0], *faces[1])
                          : slab_thickness(*faces[0], evidence.bones[bone].outer, surfaces[bone]);
    const RebuiltKerf& kerf = evidence.rebuilt.kerfs[static_cast<std::size_t>(faces.back()->kerf)];
    const Moment moment{kerf.first_cutting_tick, kerf.last_cutting_tick};
    made.push_back(
        measured(Metric::ThicknessMm, thickness.mean_mm, moment, thickness.thickest_in_bone_mm));
    made.back().bound += thickness.mean_bound_mm;
    made.push_back(measured(Metric::ThicknessMaxMm, thickness.greatest_mm, moment,
                            thickness.thickest_in_bone_mm));
    made.back().bound += thickness.greatest_bound_mm;
  }
  double done = 1.0;
  for (const CutFace* face : faces)
    done = std::min(done, face == nullptr ? 0.0 : face->done_fraction);
  for (std::size_t index = begin; index < made.size(); ++index) {
    made[index].cut = step.cut;
    made[index].hinge = step.hinge;
    made[index].done_fraction = done;
  }
}

}  // namespace

std::vector<Measurement> measure_pieces(const Evidence& evidence, const BoneSurfaces& surfaces) {
  std::vector<Measurement> made;
  for (const OperationStep& step : evidence.scenario.steps) {
    if (step.kind != scenarios::StepKind::Remove) continue;
    const scenarios::PlannedHinge* hinge = find_hinge(evidence.plan, step.hinge);
    std::vector<const CutFace*> faces;
    if (hinge == nullptr) {
      faces = {counting_face(evidence, step.cut)};
    } else {
      faces = {counting_face(evidence, hinge->first_cut),
               counting_face(evidence, hinge->second_cut)};
    }
    add_thickness(made, step, faces, evidence, surfaces);
  }
  return made;
}

}  // namespace hallux::assessment
