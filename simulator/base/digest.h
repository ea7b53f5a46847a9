/// BLAKE2b-256 digests: names of stored content, links of the hash chain, golden hashes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hallux {

struct Digest {
  std::array<std::uint8_t, 32> bytes{};

  friend auto operator<=>(const Digest&, const Digest&) = default;
};

/// Digests a stream of values in a fixed byte order (little endian), whatever the machine.
class Digester {
 public:
  Digester() noexcept;
  void add_bytes(std::span<const std::byte> bytes) noexcept;
  /// Its length first, so that "a","bc" differs from "ab","c".
  void add_text(std::string_view text) noexcept;
  void add_int(std::int64_t value) noexcept;
  /// The bits of IEEE 754.
  void add_double(double value) noexcept;
  void add_digest(const Digest& digest) noexcept;
  /// The digest of all that was added; the digester must not be used afterwards.
  Digest finish() noexcept;

 private:
  alignas(64) std::array<std::byte, 384> state_{};
};

Digest digest_of(std::span<const std::byte> bytes) noexcept;
std::string hex_from_digest(const Digest& digest);
/// Nothing where `hex` is not 64 hexadecimal digits.
std::optional<Digest> digest_from_hex(std::string_view hex) noexcept;

}  // namespace hallux
