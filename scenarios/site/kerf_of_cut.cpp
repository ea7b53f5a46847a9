#include "scenarios/site/kerf_of_cut.h"

#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

double misfit(const simulator::KerfPlane& plane, const PlannedCut& cut) noexcept {
  const Vec3 normal = axis_z(plane.bone_from_kerf);
  const double sine = length_of(glm::cross(normal, cut.face.normal));
  const double cosine = std::abs(glm::dot(normal, cut.face.normal));
  const double off_mm =
      glm::dot(cut.face.normal, plane.bone_from_kerf.translation_mm) - cut.face.offset_mm;
  return degree_from_radian(elementary::atan2(sine, cosine)) + std::abs(off_mm);
}

std::size_t nearest_cut(const simulator::KerfPlane& plane, const Plan& plan,
                        std::size_t bone) noexcept {
  std::size_t nearest = plan.cuts.size();
  for (std::size_t cut = 0; cut < plan.cuts.size(); ++cut) {
    if (plan.cuts[cut].bone != bone) continue;
    const bool is_first = nearest == plan.cuts.size();
    if (is_first || misfit(plane, plan.cuts[cut]) < misfit(plane, plan.cuts[nearest]))
      nearest = cut;
  }
  return nearest;
}

}  // namespace hallux::scenarios
