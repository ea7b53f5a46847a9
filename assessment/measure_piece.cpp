#include "assessment/measure_piece.h"

#include <algorithm>
#include <string>

#include "assessment/make_measurement.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;
using scenarios::OperationStep;

struct Thickness {
  double mean_mm = 0.0, greatest_mm = 0.0;
  Vec3 thickest_in_bone_mm{0.0, 0.0, 0.0};
};

/// `over_mm` tells what lies over a point of the face.
template <typename Over>
Thickness thickness_over(const CutFace& face, Over&& over_mm) {
  Thickness thickness;
  double sum_mm = 0.0;
  for (const Vec3& sample_mm : face.samples_in_bone_mm) {
    const double thick_mm = std::max(0.0, over_mm(sample_mm));
    sum_mm += thick_mm;
    if (thick_mm <= thickness.greatest_mm) continue;
    thickness.greatest_mm = thick_mm;
    thickness.thickest_in_bone_mm = sample_mm;
  }
  thickness.mean_mm = sum_mm / static_cast<double>(face.samples_in_bone_mm.size());
  return thickness;
}

Thickness slab_thickness(const CutFace& face, const simulator::Bvh& surface) {
  return thickness_over(face, [&](const Vec3& sample_mm) {
    const auto hit = surface.first_hit(sample_mm, face.plane.normal);
    return hit ? hit->distance_mm : 0.0;
  });
}

Thickness wedge_thickness(const CutFace& first, const CutFace& second) {
  return thickness_over(first, [&](const Vec3& sample_mm) {
    return distance_along_mm(second.plane, sample_mm, first.plane.normal);
  });
}

void add_thickness(std::vector<Measurement>& made, const OperationStep& step,
                   const std::vector<const CutFace*>& faces, const Evidence& evidence,
                   const simulator::Bvh& surface) {
  const bool is_there =
      std::none_of(faces.begin(), faces.end(), [](const CutFace* face) { return face == nullptr; });
  const std::size_t begin = made.size();
  if (!is_there) {
    made.push_back(absent(Metric::ThicknessMm, Absence::NotMade, {}));
    made.push_back(absent(Metric::ThicknessMaxMm, Absence::NotMade, {}));
  } else {
    const Thickness thickness = faces.size() == 2 ? wedge_thickness(*faces[0], *faces[1])
                                                  : slab_thickness(*faces[0], surface);
    const RebuiltKerf& kerf = evidence.rebuilt.kerfs[static_cast<std::size_t>(faces.back()->kerf)];
    const Moment moment{kerf.first_cutting_tick, kerf.last_cutting_tick};
    made.push_back(
        measured(Metric::ThicknessMm, thickness.mean_mm, moment, thickness.thickest_in_bone_mm));
    made.push_back(measured(Metric::ThicknessMaxMm, thickness.greatest_mm, moment,
                            thickness.thickest_in_bone_mm));
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

std::vector<Measurement> measure_pieces(const Evidence& evidence, const simulator::Bvh& surface) {
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
    add_thickness(made, step, faces, evidence, surface);
  }
  return made;
}

}  // namespace hallux::assessment
