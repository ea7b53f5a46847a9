#include "simulator/device/passivity.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

constexpr double reserve_share = 0.75;
constexpr double store_share = 2.0;
/// Slower than that nothing is damped: a velocity of encoder steps has no direction.
constexpr double least_speed_mm_s = 1.0;
/// A debt is forgotten when nothing was pushing for so long: the contact is over.
constexpr double forgotten_s = 0.2;

/// The account after the tick that has passed, without what cannot come back.
void count(EnergyAccount& account, const PassivitySettings& settings, const HandleMotion& motion,
           double stored_millijoule) noexcept {
  const Vec3& acted_newton = account.sent_newton[static_cast<std::size_t>(settings.delay_ticks)];
  account.energy_millijoule -= glm::dot(acted_newton, motion.way_mm);
  account.energy_millijoule = std::min(account.energy_millijoule, store_share * stored_millijoule);
  account.quiet_s = stored_millijoule > 0.0 ? 0.0 : account.quiet_s + motion.duration_s;
  if (account.quiet_s > forgotten_s) account.energy_millijoule = 0.0;
}

}  // namespace

Vec3 kept_passive(EnergyAccount& account, const PassivitySettings& settings,
                  const HandleMotion& motion, const Vec3& wanted_newton) noexcept {
  const double stored_millijoule =
      0.5 * glm::dot(wanted_newton, wanted_newton) / settings.spring_newton_per_mm;
  count(account, settings, motion, stored_millijoule);
  const Vec3 velocity_mm_s = motion.velocity_mm_s();
  const double speed2 = glm::dot(velocity_mm_s, velocity_mm_s);
  if (!settings.is_on || speed2 <= least_speed_mm_s * least_speed_mm_s) return wanted_newton;
  // Ahead: this force and all that are on their way, should the handle go on as it does.
  Vec3 coming_newton = wanted_newton;
  for (std::int32_t i = 0; i < settings.delay_ticks; ++i) {
    coming_newton += account.sent_newton[static_cast<std::size_t>(i)];
  }
  const double ahead_millijoule =
      account.energy_millijoule - glm::dot(coming_newton, motion.way_mm);
  const double missing_millijoule = reserve_share * stored_millijoule - ahead_millijoule;
  if (missing_millijoule <= 0.0) return wanted_newton;
  const double damping_newton_s_per_mm =
      std::min(missing_millijoule / (motion.duration_s * speed2), settings.damping_newton_s_per_mm);
  return wanted_newton - damping_newton_s_per_mm * velocity_mm_s;
}

void note_sent(EnergyAccount& account, const Vec3& sent_newton) noexcept {
  for (std::size_t i = account.sent_newton.size(); i-- > 1;) {
    account.sent_newton[i] = account.sent_newton[i - 1];
  }
  account.sent_newton[0] = sent_newton;
}

}  // namespace hallux::simulator
