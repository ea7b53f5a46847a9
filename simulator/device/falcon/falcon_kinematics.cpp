#include "simulator/device/falcon/falcon_kinematics.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Of the crank, of the shin's long side.
constexpr double crank_mm = 60.0, shin_mm = 102.5;
/// From the grip's middle to a leg's hinge, outwards; what the shin's two hinges add.
constexpr double grip_out_mm = 14.43, hinges_mm = 2.0 * 11.25;
/// Of the shin's foot along the hinge's axis.
constexpr double shin_aside_mm = -25.0;
/// Of the crank's axis from the middle of the base, outwards and along.
constexpr double base_out_mm = 40.0, base_along_mm = -23.09;
constexpr std::array<double, falcon_legs> leg_rad{
    radian_from_degree(105.0), radian_from_degree(-15.0), radian_from_degree(-135.0)};
/// 320 slots with four edges each, a drum of 14.25 mm on a sector of 110 mm.
constexpr double counts_per_turn = 4.0 * 320.0, drum_per_sector = 14.25 / 110.0;
constexpr double rad_per_count = 2.0 * pi / counts_per_turn * drum_per_sector;
constexpr double rad_at_zero = radian_from_degree(35.0);

/// The grip as one leg sees it, from its crank's axis: outwards, along the axis, up to the person.
struct InLeg {
  double out_mm = 0.0, along_mm = 0.0, up_mm = 0.0;
  double cosine = 1.0, sine = 0.0;
};

InLeg in_leg(const Vec3& grip_mm, std::size_t leg) noexcept {
  const double cosine = elementary::cos(leg_rad[leg]), sine = elementary::sin(leg_rad[leg]);
  return {grip_mm.x * cosine + grip_mm.y * sine - base_out_mm,
          -grip_mm.x * sine + grip_mm.y * cosine - base_along_mm, grip_mm.z, cosine, sine};
}

/// The shin as it is seen along the crank's axis; nothing where it does not reach.
struct Shin {
  /// Of its tilt along the axis.
  double cosine = 0.0, sine = 1.0;
  double length_mm = 0.0;
};

std::optional<Shin> shin_of(const InLeg& at) noexcept {
  Shin shin;
  shin.cosine = (at.along_mm + shin_aside_mm) / shin_mm;
  if (!(std::abs(shin.cosine) < 1.0)) return std::nullopt;
  shin.sine = std::sqrt(1.0 - shin.cosine * shin.cosine);
  shin.length_mm = shin_mm * shin.sine + hinges_mm;
  return shin;
}

/// Of the two angles at which crank and shin meet, the one with the knee outside.
std::optional<double> crank_angle(const InLeg& at) noexcept {
  const std::optional<Shin> shin = shin_of(at);
  if (!shin) return std::nullopt;
  const double out_mm = at.out_mm + grip_out_mm;
  const double a = out_mm * out_mm + at.up_mm * at.up_mm + crank_mm * crank_mm -
                   shin->length_mm * shin->length_mm;
  const double b = 2.0 * crank_mm * out_mm, c = 2.0 * crank_mm * at.up_mm;
  // a = b cos t + c sin t.
  const double room = b * b + c * c - a * a;
  if (!(room >= 0.0) || !(b * b + c * c > 0.0)) return std::nullopt;
  return elementary::atan2(c, b) - elementary::atan2(std::sqrt(room), a);
}

/// Less: the legs are stretched or folded.
constexpr double least_volume = 1e-9;

double volume_of(const CrankRates& rates) noexcept {
  return glm::dot(rates[0], glm::cross(rates[1], rates[2]));
}

/// The way on which each crank turns by its part of `turn_rad`.
Vec3 way_for(const CrankRates& rates, const Vec3& turn_rad) noexcept {
  const Vec3 way = turn_rad.x * glm::cross(rates[1], rates[2]) +
                   turn_rad.y * glm::cross(rates[2], rates[0]) +
                   turn_rad.z * glm::cross(rates[0], rates[1]);
  return way / volume_of(rates);
}

}  // namespace

CrankAngles crank_angles_at(const FalconCounts& counts) noexcept {
  CrankAngles angles{};
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    angles[leg] = rad_at_zero + static_cast<double>(counts[leg]) * rad_per_count;
  }
  return angles;
}

std::optional<CrankAngles> crank_angles(const Vec3& grip_mm) noexcept {
  CrankAngles angles{};
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    const std::optional<double> angle = crank_angle(in_leg(grip_mm, leg));
    if (!angle) return std::nullopt;
    angles[leg] = *angle;
  }
  return angles;
}

/// The derivative of (a cos t - U)^2 + (a sin t - w)^2 = L^2, with L of the way along the axis.
CrankRates crank_rates(const Vec3& grip_mm, const CrankAngles& angles) noexcept {
  CrankRates rates{};
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    const InLeg at = in_leg(grip_mm, leg);
    const std::optional<Shin> shin = shin_of(at);
    if (!shin) continue;
    const double cosine = elementary::cos(angles[leg]), sine = elementary::sin(angles[leg]);
    const double out_mm = at.out_mm + grip_out_mm;
    const double lever_mm2 = crank_mm * (out_mm * sine - at.up_mm * cosine);
    const double of_out = (crank_mm * cosine - out_mm) / lever_mm2;
    const double of_along = -shin->length_mm / lever_mm2 * shin->cosine / shin->sine;
    rates[leg] = {of_out * at.cosine - of_along * at.sine, of_out * at.sine + of_along * at.cosine,
                  (crank_mm * sine - at.up_mm) / lever_mm2};
  }
  return rates;
}

std::optional<Vec3> grip_place(const CrankAngles& angles, const Vec3& near_mm) noexcept {
  constexpr int steps_at_most = 12;
  constexpr double step_mm = 20.0, found_mm = 1e-7;
  Vec3 grip_mm = near_mm;
  for (int step = 0; step < steps_at_most; ++step) {
    const std::optional<CrankAngles> here = crank_angles(grip_mm);
    if (!here) return std::nullopt;
    const Vec3 missing_rad{angles[0] - (*here)[0], angles[1] - (*here)[1], angles[2] - (*here)[2]};
    const CrankRates rates = crank_rates(grip_mm, *here);
    if (!(std::abs(volume_of(rates)) > least_volume)) return std::nullopt;
    const Vec3 way_mm = shortened(way_for(rates, missing_rad), step_mm);
    grip_mm += way_mm;
    if (!is_finite(grip_mm)) return std::nullopt;
    if (length_of(way_mm) < found_mm) return grip_mm;
  }
  return std::nullopt;
}

/// Work done is the same at grip and cranks: force . way = torques . (rates . way).
Vec3 crank_torques(const CrankRates& rates, const Vec3& force_newton) noexcept {
  const double volume = volume_of(rates);
  if (!(std::abs(volume) > least_volume)) return {0.0, 0.0, 0.0};
  return Vec3(glm::dot(force_newton, glm::cross(rates[1], rates[2])),
              glm::dot(force_newton, glm::cross(rates[2], rates[0])),
              glm::dot(force_newton, glm::cross(rates[0], rates[1]))) /
         volume;
}

}  // namespace hallux::simulator
