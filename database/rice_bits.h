/// Small numbers as few bits: the Rice code of order `k`.
///
///   a number u = (u >> k) zeros, a one, the low k bits of u, lowest first; where u >> k is 32 or more: 32 zeros, a one, all
///   64 bits of u. Bits fill a byte from its lowest; the last byte is filled with zeros.
///
/// source  R. Rice, J. Plaunt, Adaptive variable-length coding (1971); the reader's refill after F. Giesen, Reading bits in
///         far too many ways (2018)
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "database/columns.h"

namespace hallux::database {

inline constexpr unsigned rice_zeros_max = 32;
/// No order is larger: a number of that order still fits what one refill brings.
inline constexpr unsigned rice_order_max = 55;

class RiceWriter {
 public:
  explicit RiceWriter(std::vector<std::byte>& bytes) noexcept : bytes_(&bytes) {}

  void put(std::uint64_t number, unsigned order) {
    const std::uint64_t zeros = number >> order;
    if (zeros >= rice_zeros_max) {
      put_bits(std::uint64_t{1} << rice_zeros_max, rice_zeros_max + 1);
      put_bits(number & 0xFFFFFFFFU, 32);
      put_bits(number >> 32U, 32);
      return;
    }
    put_bits(std::uint64_t{1} << zeros, static_cast<unsigned>(zeros) + 1);
    if (order > 32) {
      put_bits(number & 0xFFFFFFFFU, 32);
      put_bits((number >> 32U) & ((std::uint64_t{1} << (order - 32)) - 1), order - 32);
    } else {
      put_bits(number & ((std::uint64_t{1} << order) - 1), order);
    }
  }
  void finish() {
    for (; count_ > 0; count_ = count_ > 8 ? count_ - 8 : 0) {
      bytes_->push_back(static_cast<std::byte>(window_ & 0xFFU));
      window_ >>= 8U;
    }
  }

 private:
  /// needs   count <= 33 and no bit of `bits` above it
  void put_bits(std::uint64_t bits, unsigned count) {
    window_ |= bits << count_;
    count_ += count;
    for (; count_ >= 8; count_ -= 8) {
      bytes_->push_back(static_cast<std::byte>(window_ & 0xFFU));
      window_ >>= 8U;
    }
  }

  std::vector<std::byte>* bytes_;
  std::uint64_t window_ = 0;
  unsigned count_ = 0;
};

/// Never reads past the end of its bytes.
class RiceReader {
 public:
  explicit RiceReader(std::span<const std::byte> bytes) noexcept : rest_(bytes) {}

  /// needs   order <= rice_order_max
  /// errors  DatabaseError Damaged where the bits end before the number
  std::uint64_t take(unsigned order) {
    refill();
    const auto zeros = static_cast<unsigned>(std::countr_zero(window_));
    if (zeros >= rice_zeros_max) return take_whole(zeros);
    drop(zeros + 1);
    if (order > count_) refill();
    const std::uint64_t low = window_ & ((std::uint64_t{1} << order) - 1);
    drop(order);
    return (static_cast<std::uint64_t>(zeros) << order) | low;
  }
  /// True where nothing is left but the zeros that fill the last byte.
  bool is_at_end() const noexcept {
    return rest_.empty() && count_ < 8 && (window_ & ((std::uint64_t{1} << count_) - 1)) == 0;
  }

 private:
  static_assert(std::endian::native == std::endian::little, "a refill reads eight bytes at once");

  /// At least 56 bits, or all that are left. Bits above count_ are those to come or zero.
  void refill() noexcept {
    if (rest_.size() >= 8) {
      std::uint64_t next = 0;
      std::memcpy(&next, rest_.data(), sizeof(next));
      window_ |= next << count_;
      rest_ = rest_.subspan((63U - count_) >> 3U);
      count_ |= 56U;
      return;
    }
    for (; count_ < 56 && !rest_.empty(); count_ += 8, rest_ = rest_.subspan(1)) {
      window_ |= static_cast<std::uint64_t>(rest_[0]) << count_;
    }
  }
  void drop(unsigned bits) {
    if (bits > count_) fail_damaged("a number is cut short");
    window_ >>= bits;
    count_ -= bits;
  }
  std::uint64_t take_whole(unsigned zeros) {
    if (zeros != rice_zeros_max) fail_damaged("a number is none of its code");
    drop(zeros + 1);
    refill();
    const std::uint64_t low = window_ & 0xFFFFFFFFU;
    drop(32);
    refill();
    const std::uint64_t high = window_ & 0xFFFFFFFFU;
    drop(32);
    return low | (high << 32U);
  }

  std::span<const std::byte> rest_;
  std::uint64_t window_ = 0;
  unsigned count_ = 0;
};

}  // namespace hallux::database
