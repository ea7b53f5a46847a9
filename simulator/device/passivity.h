/// Passivity observer and controller: what is rendered may give back no more energy than the hand
/// has put into it. Inside this corner only.
///
///     E += -F . dx              each tick, F the force that acted meanwhile: what the hand has
///                               paid in
///     wanted >= 0.75 F^2 / 2K   what the spring behind the force still holds, nearly
///     E <= 2 F^2 / 2K           more was sawn, rubbed or damped: it is spent
///     F -= a v                  where E would fall below what is wanted; a at most the device's
///                               greatest damping
///
/// A sampled spring gives back more than it took, the more the later its force comes. Hannaford and
/// Ryu (2002) watch the account and take the surplus out with a damper. Ours differs in three
/// things: it counts the force that really acted (with the delay the device has said) and looks
/// ahead over what is on its way; it begins to act before the account is empty, because the damper
/// has a limit; and it forgets what cannot come back, else a minute's sawing would pay for any
/// limit cycle.
/// source  docs/haptics.md, What an arm is given
#pragma once

#include <array>
#include <cstdint>

#include "simulator/base/vector.h"
#include "simulator/device/device_limits.h"

namespace hallux::simulator {

inline constexpr std::int32_t exchanges_until_sent_at_most = 1;
/// That one line of the loop covers.
inline constexpr std::int32_t line_ticks_at_most = 3;

struct PassivitySettings {
  /// Off: the account is kept, nothing is damped.
  bool is_on = true;
  /// K, on the device's side.
  double spring_newton_per_mm = 1.0;
  /// The greatest that the device renders.
  double damping_newton_s_per_mm = 0;
  /// Between a force's output and the exchange that carries it: 0 where it is sent at once, else 1.
  /// A line may cover several ticks, so these are no ticks.
  std::int32_t exchanges_until_sent = 0;
  /// From sending a force until it acts.
  std::int32_t transport_ticks = 0;
};

struct EnergyAccount {
  double energy_millijoule = 0.0;
  /// What came out, a value a line, the newest first; what the device was told last lies at the
  /// exchanges until sent.
  std::array<Vec3, exchanges_until_sent_at_most + 1> made_newton{};
  /// What the device had been told, a value a tick, the newest first; what acts lies at the
  /// transport.
  std::array<Vec3, transport_ticks_at_most + line_ticks_at_most> told_newton{};
  /// How long nothing was pushing.
  double quiet_s = 0.0;
};

/// How the handle moved since the tick before.
struct HandleMotion {
  Vec3 way_mm{0.0, 0.0, 0.0};
  double duration_s = 0.001;

  Vec3 velocity_mm_s() const noexcept { return way_mm / duration_s; }
  /// Whole ticks of it, from one to three.
  std::size_t ticks() const noexcept;
};

/// Counts the tick that has passed, and returns the force that may follow: `wanted_newton`, or less
/// of it, or damping.
/// needs   0 <= exchanges_until_sent <= 1, 0 <= transport_ticks <= 3, duration_s > 0, all of it
///         finite
/// errors  none: total, allocates nothing
Vec3 kept_passive(EnergyAccount& account, const PassivitySettings& settings,
                  const HandleMotion& motion, const Vec3& wanted_newton) noexcept;

/// What really goes to the device of this tick's force.
void note_made(EnergyAccount& account, const Vec3& made_newton) noexcept;

}  // namespace hallux::simulator
