/// A Falcon's firmware, read from a file that the person names: it has none of its own when it is
/// switched on, and its maker's licence lets nobody else hand it on.
///
/// An image is a boot stream of Texas Instruments' C28x, eight bits wide:
///
///     AA 08 | 16 reserved | entry, 4 | { words, 2 | address, 4 | 2 x words }... | 00 00
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hallux::simulator {

/// Known images have 7.3 to 8.5 kB.
inline constexpr std::size_t falcon_firmware_bytes_most = 65'536;

/// Where an image is no boot stream, and why.
struct FirmwareFault {
  std::size_t byte = 0;
  std::string what;
};

/// The first; nothing where it is a whole boot stream with nothing after it.
std::optional<FirmwareFault> fault_in(std::span<const std::uint8_t> image);

struct FalconFirmware {
  std::vector<std::uint8_t> image;
  /// Where set, `image` is empty.
  std::optional<FirmwareFault> fault;
};

/// Reads and checks it. A file that cannot be read, or is larger than any image, has its fault at
/// byte 0.
FalconFirmware read_falcon_firmware(const std::filesystem::path& file);

}  // namespace hallux::simulator
