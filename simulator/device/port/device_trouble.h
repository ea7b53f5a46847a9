/// Why a device cannot be used, or no longer: a word for each reason, the same in every answer of
/// the program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hallux::simulator {

enum class DeviceTrouble : std::uint8_t {
  None,
  // Before it is used.
  NoPermission,
  Busy,
  NoFirmware,
  BadFirmware,
  /// The firmware did not arrive as it was sent.
  WrongEcho,
  NotHomed,
  NotCalibrated,
  NoService,
  ServiceVersion,
  WrongModel,
  /// Its maker lets nobody speak with it.
  ClosedProtocol,
  /// The description of its geometry cannot be used.
  BadRecord,
  /// A force would come so late that it could not be rendered.
  TooSlow,
  // While it is used.
  Unplugged,
  /// It says nothing any more.
  Silent,
  /// What it says is none of its packets.
  Garbled,
  ServiceGone,
  /// The system refused for a reason of its own.
  SystemRefused
};

/// `no_permission`, `busy` ...; `none` for None.
std::string_view id_of(DeviceTrouble trouble) noexcept;

/// A trouble with what a sentence about it needs.
struct TroubleReport {
  DeviceTrouble trouble = DeviceTrouble::None;
  /// The node, the file, the version: what the sentence names.
  std::string subject = {};
  /// The system's own word, or where in a file.
  std::string detail = {};

  explicit operator bool() const noexcept { return trouble != DeviceTrouble::None; }
  friend bool operator==(const TroubleReport&, const TroubleReport&) = default;
};

}  // namespace hallux::simulator
