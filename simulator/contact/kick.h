/// The kick of a saw whose teeth catch in bone: what it does to the hand. Inside this corner only.
///
///     started while the teeth stand in bone,
///     or met bone with less than 2 mm of tooth line at an end of it
///         --> a push along the tooth line, away from the bone that caught it:
///             0 -> 6 N -> 0 within 20 ms
///
/// The teeth throw the handpiece, and the tool follows the hand by its coupling: a kick moves
/// nothing by itself and opens nothing. One follows no sooner than a fifth of a second after the
/// one before.
/// source  docs/haptics.md, Where the tool is; the two causes are quoted there, every number but
///         the 2 mm is ours and not surgeon-reviewed
#pragma once

#include <cstdint>
#include <span>

#include "simulator/contact/tissue.h"

namespace hallux::simulator {

inline constexpr double kick_corner_mm = 2.0;
inline constexpr double kick_peak_newton = 6.0;
inline constexpr double kick_duration_s = 0.02;
/// From the beginning of one to the next, at least.
inline constexpr double kick_rest_s = 0.2;
/// Of the whole parabola.
inline constexpr double kick_impulse_newton_s = 2.0 / 3.0 * kick_peak_newton * kick_duration_s;

enum class KickCause : std::int32_t {
  None = 0,
  /// The saw was started while teeth stood in bone.
  StartedInBone = 1,
  /// Running teeth met bone with a corner of the blade alone.
  Corner = 2
};

struct KickState {
  /// To which it throws the hand along the tooth line.
  double side = 1.0;
  /// Since the last one began.
  double age_s = 1.0;
  /// In the tick before.
  bool saw_ran = false;
};

/// The side (+1 or -1 along the tooth line) away from the teeth in bone.
double side_away_from(std::span<const Tissue> teeth) noexcept;

/// Whether the teeth in bone are those at one end of the tooth line, over less than kick_corner_mm
/// of it; `tooth_mm` is the width of each.
bool is_corner(std::span<const Tissue> teeth, double tooth_mm) noexcept;

/// A kick towards `side` from now on; false where one is too recent.
bool begin_kick(KickState& kick, double side) noexcept;

/// The mean force along the tooth line over the next `duration_s`, at most kick_peak_newton to
/// either side: however the time is divided, a whole kick is kick_impulse_newton_s [N].
/// needs   duration_s > 0
/// errors  none: total, allocates nothing
/// thread  haptic
double kick_newton(KickState& kick, double duration_s) noexcept;

}  // namespace hallux::simulator
