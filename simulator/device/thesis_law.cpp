#include "simulator/device/thesis_law.h"

#include <algorithm>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

constexpr double m_per_mm = 0.001;

/// What reaches into the surface, as a vector; nothing where it leads away.
Vec3 part_into(const Vec3& vector, const Vec3& normal) noexcept {
  return std::min(0.0, glm::dot(vector, normal)) * normal;
}

}  // namespace

Vec3 thesis_law_force(ThesisLawState& state, const ThesisLawSettings& settings,
                      const Vec3& handle_mm, const std::optional<Vec3>& normal,
                      std::int64_t ticks) noexcept {
  state.frame_ticks += ticks;
  if (state.frames > 0 && state.frame_ticks < settings.frame_ticks) return state.force_newton;
  const double frame_s = second_from_tick(std::max<std::int64_t>(1, state.frame_ticks));
  const Vec3 velocity_mm_s =
      state.frames > 0 ? (handle_mm - state.handle_mm) / frame_s : Vec3(0.0, 0.0, 0.0);
  Vec3 force_newton(0.0, 0.0, 0.0);
  if (normal && state.frames > 1) {
    const double newton_per_mm_s = settings.mass_kg * m_per_mm / frame_s;
    // m (R - V) / t with R - V = -2 (V . N) N.
    force_newton = -2.0 * newton_per_mm_s * part_into(velocity_mm_s, *normal);
    const Vec3 total_newton = newton_per_mm_s * (velocity_mm_s - state.velocity_mm_s);
    force_newton -= part_into(total_newton - state.force_newton, *normal);
  }
  state = {handle_mm, velocity_mm_s, shortened(force_newton, settings.force_limit_newton), 0,
           std::min(2, state.frames + 1)};
  return state.force_newton;
}

}  // namespace hallux::simulator
