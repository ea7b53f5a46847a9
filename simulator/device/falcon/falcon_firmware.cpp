#include "simulator/device/falcon/falcon_firmware.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace hallux::simulator {

namespace {

constexpr std::size_t key_bytes = 2, reserved_bytes = 16, entry_bytes = 4;
constexpr std::size_t head_bytes = key_bytes + reserved_bytes + entry_bytes;
constexpr std::size_t size_bytes = 2, address_bytes = 4, word_bytes = 2;

std::size_t word_at(std::span<const std::uint8_t> image, std::size_t at) noexcept {
  return static_cast<std::size_t>(image[at]) | static_cast<std::size_t>(image[at + 1]) << 8U;
}

}  // namespace

std::optional<FirmwareFault> fault_in(std::span<const std::uint8_t> image) {
  if (image.size() < key_bytes || image[0] != 0xAA || image[1] != 0x08) {
    return FirmwareFault{0, "no boot stream begins here: AA 08 is expected"};
  }
  if (image.size() < head_bytes) return FirmwareFault{image.size(), "it ends within its head"};
  std::size_t at = head_bytes;
  while (true) {
    if (image.size() < at + size_bytes) return FirmwareFault{at, "it ends without its last block"};
    const std::size_t words = word_at(image, at);
    if (words == 0) break;
    const std::size_t next = at + size_bytes + address_bytes + word_bytes * words;
    if (image.size() < next) {
      return FirmwareFault{at,
                           "a block of " + std::to_string(words) + " words ends behind the file"};
    }
    at = next;
  }
  at += size_bytes;
  if (at == head_bytes + size_bytes) return FirmwareFault{head_bytes, "it has no block"};
  if (at < image.size()) return FirmwareFault{at, "something follows the last block"};
  return std::nullopt;
}

FalconFirmware read_falcon_firmware(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  FalconFirmware firmware;
  if (!in) {
    firmware.fault = FirmwareFault{0, std::strerror(errno)};
    return firmware;
  }
  // One more than is allowed: a file without an end is read no further.
  firmware.image.resize(falcon_firmware_bytes_most + 1);
  in.read(reinterpret_cast<char*>(firmware.image.data()),
          static_cast<std::streamsize>(firmware.image.size()));
  if (in.bad()) {
    firmware.fault = FirmwareFault{0, std::strerror(errno)};
  } else if (in.gcount() > static_cast<std::streamsize>(falcon_firmware_bytes_most)) {
    firmware.fault = FirmwareFault{
        falcon_firmware_bytes_most,
        "larger than any image: " + std::to_string(falcon_firmware_bytes_most) + " bytes at most"};
  } else {
    firmware.image.resize(static_cast<std::size_t>(in.gcount()));
    firmware.fault = fault_in(firmware.image);
  }
  if (firmware.fault) firmware.image.clear();
  return firmware;
}

}  // namespace hallux::simulator
