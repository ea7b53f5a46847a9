/// The three legs of a Novint Falcon: where the grip is for the angles of its cranks, and what the
/// motors must do for a force at the grip. Inside this corner only.
///
///     base -- crank (60 mm, angle from an encoder) -- shin (a parallelogram, 102.5 mm) -- grip
///
/// Frame of the device: x right, y up, z out of the device to the person, its origin in the middle
/// of the base; the grip's usual middle lies at z = 120 mm. Nothing of the force's way is taken
/// from elsewhere: the Jacobian is the derivative of the same geometry.
/// source  docs/haptics.md, Devices
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "simulator/base/vector.h"

namespace hallux::simulator {

inline constexpr std::size_t falcon_legs = 3;
inline constexpr Vec3 falcon_middle_mm{0.0, 0.0, 120.0};

/// Of the encoders, a leg each.
using FalconCounts = std::array<std::int32_t, falcon_legs>;
/// Of the cranks [rad], a leg each.
using CrankAngles = std::array<double, falcon_legs>;

CrankAngles crank_angles_at(const FalconCounts& counts) noexcept;

/// The cranks' angles where the grip is there; nothing where it cannot be.
/// frame   the device's [mm]
std::optional<CrankAngles> crank_angles(const Vec3& grip_mm) noexcept;

/// How the cranks turn as the grip moves, a row each leg [rad/mm].
using CrankRates = std::array<Vec3, falcon_legs>;
/// needs   `angles` = crank_angles(grip_mm)
CrankRates crank_rates(const Vec3& grip_mm, const CrankAngles& angles) noexcept;

/// Where the grip is for these angles, searched from `near_mm`; nothing where no place is found.
/// frame   the device's [mm]
std::optional<Vec3> grip_place(const CrankAngles& angles, const Vec3& near_mm) noexcept;

/// The torques [N mm] at the cranks that push the grip with that force [N]; zero where the legs
/// stand so that they cannot push.
Vec3 crank_torques(const CrankRates& rates, const Vec3& force_newton) noexcept;

}  // namespace hallux::simulator
