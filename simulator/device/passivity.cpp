#include "simulator/device/passivity.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

constexpr double reserve_share = 0.75;
constexpr double store_share = 2.0;
/// Slower than that nothing is damped: a velocity of encoder steps has no direction.
constexpr double least_speed_mm_s = 1.0;
/// A debt is forgotten when nothing was pushing for so long: the contact is over.
constexpr double forgotten_s = 0.2;

template <std::size_t Count>
void put_first(std::array<Vec3, Count>& values, const Vec3& value) noexcept {
  std::copy_backward(values.begin(), values.end() - 1, values.end());
  values.front() = value;
}

/// The mean of what acted on the motors in the ticks that have passed: what the device was told
/// before them, as late as it comes.
Vec3 acted_newton(EnergyAccount& account, const PassivitySettings& settings,
                  std::size_t ticks) noexcept {
  const Vec3 told_newton =
      account.made_newton[static_cast<std::size_t>(settings.exchanges_until_sent)];
  for (std::size_t i = 0; i < ticks; ++i) put_first(account.told_newton, told_newton);
  Vec3 sum_newton{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < ticks; ++i) {
    sum_newton += account.told_newton[static_cast<std::size_t>(settings.transport_ticks) + i];
  }
  return sum_newton / static_cast<double>(ticks);
}

/// The force now wanted and all that are on their way, over the handle's next way, should it go on
/// as it does.
double coming_millijoule(const EnergyAccount& account, const PassivitySettings& settings,
                         const HandleMotion& motion, const Vec3& wanted_newton) noexcept {
  Vec3 of_lines_newton = wanted_newton, of_ticks_newton{0.0, 0.0, 0.0};
  for (std::int32_t i = 0; i < settings.exchanges_until_sent; ++i) {
    of_lines_newton += account.made_newton[static_cast<std::size_t>(i)];
  }
  for (std::int32_t i = 0; i < settings.transport_ticks; ++i) {
    of_ticks_newton += account.told_newton[static_cast<std::size_t>(i)];
  }
  of_lines_newton += of_ticks_newton / static_cast<double>(motion.ticks());
  return -glm::dot(of_lines_newton, motion.way_mm);
}

/// The account after the line that has passed, without what cannot come back.
void count(EnergyAccount& account, const PassivitySettings& settings, const HandleMotion& motion,
           double stored_millijoule) noexcept {
  account.energy_millijoule -=
      glm::dot(acted_newton(account, settings, motion.ticks()), motion.way_mm);
  account.energy_millijoule = std::min(account.energy_millijoule, store_share * stored_millijoule);
  account.quiet_s = stored_millijoule > 0.0 ? 0.0 : account.quiet_s + motion.duration_s;
  if (account.quiet_s > forgotten_s) account.energy_millijoule = 0.0;
}

}  // namespace

std::size_t HandleMotion::ticks() const noexcept {
  const double ticks = std::floor(duration_s / step_s + 0.5);
  return static_cast<std::size_t>(std::clamp(ticks, 1.0, double{line_ticks_at_most}));
}

Vec3 kept_passive(EnergyAccount& account, const PassivitySettings& settings,
                  const HandleMotion& motion, const Vec3& wanted_newton) noexcept {
  const double stored_millijoule =
      0.5 * glm::dot(wanted_newton, wanted_newton) / settings.spring_newton_per_mm;
  count(account, settings, motion, stored_millijoule);
  const Vec3 velocity_mm_s = motion.velocity_mm_s();
  const double speed2 = glm::dot(velocity_mm_s, velocity_mm_s);
  if (!settings.is_on || speed2 <= least_speed_mm_s * least_speed_mm_s) return wanted_newton;
  const double ahead_millijoule =
      account.energy_millijoule + coming_millijoule(account, settings, motion, wanted_newton);
  const double missing_millijoule = reserve_share * stored_millijoule - ahead_millijoule;
  if (missing_millijoule <= 0.0) return wanted_newton;
  const double damping_newton_s_per_mm =
      std::min(missing_millijoule / (motion.duration_s * speed2), settings.damping_newton_s_per_mm);
  return wanted_newton - damping_newton_s_per_mm * velocity_mm_s;
}

void note_made(EnergyAccount& account, const Vec3& made_newton) noexcept {
  put_first(account.made_newton, made_newton);
}

}  // namespace hallux::simulator
