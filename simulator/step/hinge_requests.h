/// Hinges: wanted by the operator, asked of a job, closed or refused. Inside this corner only.
#pragma once

#include <cstdint>

namespace hallux::simulator {

class HingeRequests {
 public:
  bool is_wanted() const noexcept { return wanted_ >= 0; }
  /// The job's result was not applied yet.
  bool is_asked() const noexcept { return asked_ >= 0; }
  /// The hinge that is asked for; -1: none.
  std::int32_t asked() const noexcept { return asked_; }

  /// hinge   of the operation; a negative one is none
  void want(std::int32_t hinge) noexcept { wanted_ = hinge; }
  bool is_closed(std::int32_t hinge) const noexcept {
    return hinge < hinge_limit && (closed_ & bit_of(hinge)) != 0;
  }
  /// Grants or drops the wish; true where a job is to be asked now. It is dropped while a job is
  /// under way, after that hinge's closing, and while the kerf grows: the blade stands in one that
  /// it opened since the pieces were last asked for.
  bool ask(bool is_kerf_growing) noexcept {
    const std::int32_t hinge = wanted_;
    wanted_ = -1;
    if (hinge < 0 || is_kerf_growing || is_asked() || is_closed(hinge)) return false;
    asked_ = hinge;
    return true;
  }
  /// The job's answer.
  void apply(bool has_closed) noexcept {
    if (has_closed && asked_ >= 0 && asked_ < hinge_limit) closed_ |= bit_of(asked_);
    asked_ = -1;
  }

 private:
  static constexpr std::int32_t hinge_limit = 32;
  static std::uint32_t bit_of(std::int32_t hinge) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(hinge);
  }

  std::int32_t wanted_ = -1, asked_ = -1;
  std::uint32_t closed_ = 0;
};

}  // namespace hallux::simulator
