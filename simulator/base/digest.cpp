#include "simulator/base/digest.h"

#include <sodium.h>

#include <bit>

#include "simulator/base/check.h"

namespace hallux {

namespace {

crypto_generichash_state* as_state(std::array<std::byte, 384>& bytes) noexcept {
  static_assert(sizeof(crypto_generichash_state) <= 384);
  return reinterpret_cast<crypto_generichash_state*>(bytes.data());
}

}  // namespace

Digester::Digester() noexcept {
  // Until it has looked at the processor the library hashes with its slower code.
  static const bool is_ready = sodium_init() >= 0;
  CHECK(is_ready);
  CHECK(crypto_generichash_init(as_state(state_), nullptr, 0, 32) == 0);
}

void Digester::add_bytes(std::span<const std::byte> bytes) noexcept {
  crypto_generichash_update(as_state(state_), reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size());
}

void Digester::add_text(std::string_view text) noexcept {
  add_int(static_cast<std::int64_t>(text.size()));
  add_bytes(std::as_bytes(std::span{text.data(), text.size()}));
}

void Digester::add_int(std::int64_t value) noexcept {
  std::array<std::byte, 8> bytes{};
  auto rest = static_cast<std::uint64_t>(value);
  for (std::byte& byte : bytes) {
    byte = static_cast<std::byte>(rest & 0xFFU);
    rest >>= 8U;
  }
  add_bytes(bytes);
}

void Digester::add_double(double value) noexcept { add_int(std::bit_cast<std::int64_t>(value)); }

void Digester::add_digest(const Digest& digest) noexcept {
  add_bytes(std::as_bytes(std::span{digest.bytes}));
}

Digest Digester::finish() noexcept {
  Digest digest;
  crypto_generichash_final(as_state(state_), digest.bytes.data(), digest.bytes.size());
  return digest;
}

Digest digest_of(std::span<const std::byte> bytes) noexcept {
  Digester digester;
  digester.add_bytes(bytes);
  return digester.finish();
}

std::string hex_from_digest(const Digest& digest) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex;
  hex.reserve(64);
  for (const std::uint8_t byte : digest.bytes) {
    hex.push_back(digits[byte >> 4U]);
    hex.push_back(digits[byte & 15U]);
  }
  return hex;
}

std::optional<Digest> digest_from_hex(std::string_view hex) noexcept {
  if (hex.size() != 64) return std::nullopt;
  Digest digest;
  for (std::size_t i = 0; i < hex.size(); ++i) {
    const std::size_t digit = std::string_view{"0123456789abcdef"}.find(hex[i]);
    if (digit == std::string_view::npos) return std::nullopt;
    auto& byte = digest.bytes.at(i / 2);
    byte = static_cast<std::uint8_t>((static_cast<std::size_t>(byte) << 4U) | digit);
  }
  return digest;
}

}  // namespace hallux
