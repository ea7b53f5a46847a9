/// Rice code of order `k`: small numbers as few bits. Inside this corner only.
///
///   a number u = (u >> k) zeros, a one, the low k bits of u, lowest first
///   u >> k is 32 or more: 32 zeros, a one, all 64 bits of u
///
/// Bits fill a byte from its lowest; the last byte is filled with zeros.
///
/// source  R. Rice, J. Plaunt, Adaptive variable-length coding (1971); the reader's refill after F.
///         Giesen, Reading bits in far too many ways (2018)
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "database/recording/columns.h"

namespace hallux::database {

inline constexpr unsigned rice_zeros_max = 32;
/// No order is larger: a number of that order still fits what one refill brings.
inline constexpr unsigned rice_order_max = 55;

class RiceWriter {
 public:
  /// Appends to `bytes`; `bits_max` is what will be put at most.
  RiceWriter(std::vector<std::byte>& bytes, std::uint64_t bits_max)
      : bytes_(&bytes), at_(bytes.size()) {
    bytes.resize(at_ + bits_max / 8 + sizeof(window_) + 1);
  }

  void put(std::uint64_t number, unsigned order) {
    const std::uint64_t zeros = number >> order;
    if (zeros >= rice_zeros_max) {
      put_bits(std::uint64_t{1} << rice_zeros_max, rice_zeros_max + 1);
      put_bits(number & 0xFFFFFFFFU, 32);
      put_bits(number >> 32U, 32);
      return;
    }
    const auto head_bits = static_cast<unsigned>(zeros) + 1;
    const std::uint64_t low = number & ((std::uint64_t{1} << order) - 1);
    if (head_bits + order <= 32) {
      put_bits((low << head_bits) | (std::uint64_t{1} << zeros), head_bits + order);
      return;
    }
    put_bits(std::uint64_t{1} << zeros, head_bits);
    put_bits(low & 0xFFFFFFFFU, std::min(order, 32U));
    if (order > 32) put_bits(low >> 32U, order - 32);
  }
  /// Cuts the bytes off behind the last bit.
  void finish() {
    std::memcpy(bytes_->data() + at_, &window_, sizeof(window_));
    bytes_->resize(at_ + (count_ + 7) / 8);
  }

 private:
  static_assert(std::endian::native == std::endian::little, "eight bytes are written at once");

  /// needs   count <= 33 and no bit of `bits` above it
  void put_bits(std::uint64_t bits, unsigned count) noexcept {
    window_ |= bits << count_;
    count_ += count;
    std::memcpy(bytes_->data() + at_, &window_, sizeof(window_));
    const unsigned whole_bytes = count_ / 8;
    at_ += whole_bytes;
    window_ >>= whole_bytes * 8;  // at most 40: seven bits were left and 33 came
    count_ %= 8;
  }

  std::vector<std::byte>* bytes_;
  std::size_t at_;
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
  /// As many as there is room for. Far from the end nothing needs a look at how much is left.
  void take_all(unsigned order, std::span<std::int64_t> numbers) {
    RiceReader local = *this;
    const std::uint64_t mask = (std::uint64_t{1} << order) - 1;
    for (std::int64_t& number : numbers) {
      local.refill();
      const auto zeros = static_cast<unsigned>(std::countr_zero(local.window_));
      if (zeros >= rice_zeros_max || zeros + 1 + order > local.count_) {
        number = static_cast<std::int64_t>(local.take(order));
        continue;
      }
      const std::uint64_t rest = local.window_ >> zeros >> 1U;
      number =
          static_cast<std::int64_t>((static_cast<std::uint64_t>(zeros) << order) | (rest & mask));
      local.window_ = rest >> order;
      local.count_ -= zeros + 1 + order;
    }
    *this = local;
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
