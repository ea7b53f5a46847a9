#include "simulator/contact/contact_walk.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// Teeth further away than this end a touch.
constexpr double leave_mm = 0.1;
/// A tooth nearer than this to the surface is on it.
constexpr double on_surface_mm = 0.01;

Vec3 motion_at(const ProxyMotion& motion, const BladeContact& contact) noexcept {
  return motion.translation_mm + glm::cross(motion.rotation_rad, contact.arm_mm);
}

}  // namespace

double reach_of(const ProxyMotion& motion, double lever_mm) noexcept {
  return length_of(motion.translation_mm) + lever_mm * length_of(motion.rotation_rad);
}

ProxyMotion scaled(const ProxyMotion& motion, double share) noexcept {
  return {share * motion.translation_mm, share * motion.rotation_rad};
}

double lifted_mm(const BladeContacts& contacts, const ProxyMotion& motion) noexcept {
  double least_mm = 1.0e6;
  for (const BladeContact& contact : contacts.all()) {
    if (!contact.is_tooth || contact.gap_mm > on_surface_mm) continue;
    least_mm = std::min(least_mm, glm::dot(contact.normal, motion_at(motion, contact)));
  }
  return least_mm < 1.0e6 ? std::max(0.0, least_mm) : 0.0;
}

void move_contacts(BladeContacts& contacts, const ProxyMotion& motion) noexcept {
  for (std::size_t i = 0; i < contacts.count; ++i) {
    BladeContact& contact = contacts.list[i];
    contact.gap_mm += glm::dot(contact.normal, motion_at(motion, contact));
  }
}

double room_ahead_mm(const BladeContacts& contacts, const Vec3& ahead, double wanted_mm) noexcept {
  double room_mm = wanted_mm;
  for (const BladeContact& contact : contacts.all()) {
    const double toward = -glm::dot(contact.normal, ahead);
    if (contact.is_tooth || !(toward > 0.0)) continue;
    room_mm = std::min(room_mm, std::max(0.0, contact.gap_mm) / toward);
  }
  return room_mm;
}

bool teeth_are_clear(const BladeContacts& contacts) noexcept {
  return std::none_of(
      contacts.all().begin(), contacts.all().end(),
      [](const BladeContact& contact) { return contact.is_tooth && contact.gap_mm <= leave_mm; });
}

}  // namespace hallux::simulator
