/// What the service of an Inverse3 says and is told: JSON. Inside this corner only.
///
///     {"session_id": 7,
///      "inverse3": [{"device_id": "049D", "config": {"type": "inverse3"},
///                    "state": {"cursor_position": {"x", "y", "z"}, "current_cursor_force": {...}},
///                    "status": {"calibrated": true}}],
///      "wireless_verse_grip": [{"device_id": "61576",
///                               "state": {"orientation": {"w", "x", "y", "z"},
///                                         "buttons": {"a", "b", "c"}}}]}
///
/// Its frame: x right, y away from the person, z up; metres and newtons. Each part may be absent.
/// source  docs/haptics.md, Devices
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "simulator/base/vector.h"

namespace hallux::simulator {

/// Of what is taken of a message; more is none of theirs.
inline constexpr std::size_t inverse_arms_most = 8, inverse_grips_most = 8, inverse_depth_most = 16;

/// One arm of a message; what was absent is none. Frame of the service.
struct InverseArm {
  /// Of letters and digits.
  std::string id, type;
  std::optional<Vec3> cursor_m, force_newton;
  std::optional<bool> is_calibrated;
};

/// A grip that measures how it is turned.
struct InverseGrip {
  std::optional<Quat> rotation;
  /// Bit 0 is the first button.
  std::optional<std::uint32_t> buttons;
};

struct InverseMessage {
  std::array<InverseArm, inverse_arms_most> arms;
  std::array<InverseGrip, inverse_grips_most> grips;
  std::size_t arm_count = 0, grip_count = 0;
  /// Its arms stand under their names, as before protocol 3.1.
  bool is_older_form = false;

  /// Nullptr where none has that id.
  const InverseArm* arm_with(std::string_view id) const noexcept;
};

/// Nothing where it is no JSON of theirs: too deep, a number that none can be, a wrong kind.
std::optional<InverseMessage> inverse_message(std::string_view text);

/// Under which word a force is told: 3.5's pages say one, older programs the other.
enum class InverseForceKey : std::uint8_t { Vector, Values };

/// Tells an arm a force [N, frame of the service].
std::string inverse_force(const std::string& id, InverseForceKey key, const Vec3& force_newton);
/// Asks for everything that the service knows.
std::string inverse_inventory();

struct InverseVersion {
  int major = 0, minor = 0;

  friend bool operator==(const InverseVersion&, const InverseVersion&) = default;
  bool is_before(const InverseVersion& other) const noexcept {
    return major != other.major ? major < other.major : minor < other.minor;
  }
};

/// Of the service's page about itself; nothing where it says none.
std::optional<InverseVersion> inverse_version(std::string_view page);

}  // namespace hallux::simulator
