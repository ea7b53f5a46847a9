#include "simulator/contact/proxy.h"

#include <algorithm>
#include <cmath>

/// Projected Gauss-Seidel: contact by contact, the push that its gap asks for and the hold that
/// stops it, until nothing changes any more. Begun with the loads of the tick before, a blade at
/// rest needs a sweep or two.
namespace hallux::simulator {

namespace {

constexpr int sweep_limit = 30;
/// Changes of a load below this end the search [mm].
constexpr double settled_mm = 1.0e-7;
/// A face may be in bone by this before it is led out: curved bone is met by its planes.
constexpr double slack_mm = 0.002;
/// Sliding begins where the holds together are this share of what they could be, and is over below
/// the second.
constexpr double slip_share = 0.999, rest_share = 0.95;

double allowed_gap_mm(const BladeContact& contact) noexcept {
  if (contact.gap_mm >= 0.0) return contact.gap_mm;
  return contact.is_tooth ? 0.0 : std::min(0.0, contact.gap_mm + slack_mm);
}

/// One search: the motion so far, and how a load at a contact changes it.
struct Search {
  ProxyMotion motion;
  double grip2_mm2;

  void push(const BladeContact& contact, const Vec3& by_mm) noexcept {
    motion.translation_mm += by_mm;
    motion.rotation_rad += glm::cross(contact.arm_mm, by_mm) / grip2_mm2;
  }
  Vec3 motion_at(const BladeContact& contact) const noexcept {
    return motion.translation_mm + glm::cross(motion.rotation_rad, contact.arm_mm);
  }
  /// How far the contact moves for a load of one along the unit direction.
  double compliance(const BladeContact& contact, const Vec3& direction) const noexcept {
    const Vec3 lever = glm::cross(contact.arm_mm, direction);
    return 1.0 + glm::dot(lever, lever) / grip2_mm2;
  }
};

/// One contact's turn; how much its loads changed.
double relax(Search& search, const BladeContact& contact, double friction,
             ProxyLoad& load) noexcept {
  double& normal_mm = load.normal_mm[contact.point];
  Vec3& tangential_mm = load.tangential_mm[contact.point];
  const double short_mm =
      -allowed_gap_mm(contact) - glm::dot(contact.normal, search.motion_at(contact));
  const double wanted_mm =
      std::max(0.0, normal_mm + short_mm / search.compliance(contact, contact.normal));
  const double pushed_mm = wanted_mm - normal_mm;
  normal_mm = wanted_mm;
  search.push(contact, pushed_mm * contact.normal);

  const Vec3 motion = search.motion_at(contact);
  const Vec3 across = motion - glm::dot(motion, contact.normal) * contact.normal;
  const double arm2_mm2 = glm::dot(contact.arm_mm, contact.arm_mm);
  Vec3 held = tangential_mm - across / (1.0 + arm2_mm2 / search.grip2_mm2);
  held -= glm::dot(held, contact.normal) * contact.normal;
  const double most_mm = friction * normal_mm, length = length_of(held);
  if (length > most_mm) held *= length > 0.0 ? most_mm / length : 0.0;
  const Vec3 more_mm = held - tangential_mm;
  tangential_mm = held;
  search.push(contact, more_mm);
  return std::abs(pushed_mm) + length_of(more_mm);
}

/// Points that touch nothing bear nothing.
void forget_others(ProxyLoad& load, std::span<const BladeContact> contacts) noexcept {
  std::array<bool, contact_limit> is_near{};
  for (const BladeContact& contact : contacts) is_near[contact.point] = true;
  for (std::size_t point = 0; point < contact_limit; ++point) {
    if (!is_near[point]) load.forget(point);
  }
}

}  // namespace

ProxyMotion motion_between(const RigidTransform& from, const RigidTransform& to) noexcept {
  Quat turn = to.rotation * glm::conjugate(from.rotation);
  if (turn.w < 0.0) turn = -turn;
  return {to.translation_mm - from.translation_mm, 2.0 * Vec3{turn.x, turn.y, turn.z}};
}

RigidTransform moved_by(const RigidTransform& pose, const ProxyMotion& motion) noexcept {
  const Vec3 half = 0.5 * motion.rotation_rad;
  const Quat turn = normalised(Quat{1.0, half.x, half.y, half.z});
  return {normalised(turn * pose.rotation), pose.translation_mm + motion.translation_mm};
}

ProxyResult solve_proxy(const ProxyMotion& wanted, std::span<const BladeContact> contacts,
                        double grip_mm, const ProxyFriction& friction, ProxyLoad& load) noexcept {
  forget_others(load, contacts);
  Search search{wanted, grip_mm * grip_mm};
  for (const BladeContact& contact : contacts) {
    search.push(contact,
                load.normal_mm[contact.point] * contact.normal + load.tangential_mm[contact.point]);
  }
  const double share = load.slides ? friction.kinetic_ratio : 1.0;
  for (int sweep = 0; sweep < sweep_limit; ++sweep) {
    double changed_mm = 0.0;
    for (const BladeContact& contact : contacts) {
      const double most =
          share * (contact.is_tooth ? friction.tooth_friction : friction.static_friction);
      changed_mm = std::max(changed_mm, relax(search, contact, most, load));
    }
    if (changed_mm < settled_mm) break;
  }
  ProxyResult result{search.motion};
  double most_mm = 0.0;
  Vec3 held_mm{0.0, 0.0, 0.0};
  for (const BladeContact& contact : contacts) {
    const double normal_mm = load.normal_mm[contact.point];
    const Vec3 tangential_mm = load.tangential_mm[contact.point];
    result.normal_mm += normal_mm;
    held_mm += tangential_mm;
    most_mm +=
        share * (contact.is_tooth ? friction.tooth_friction : friction.static_friction) * normal_mm;
    if (contact.is_tooth) result.tooth_mm += normal_mm * contact.normal + tangential_mm;
  }
  const double limit = load.slides ? rest_share : slip_share;
  load.slides = result.normal_mm > 0.0 && length_of(held_mm) >= limit * most_mm;
  return result;
}

}  // namespace hallux::simulator
