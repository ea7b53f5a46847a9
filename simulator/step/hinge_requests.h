/// The hinge: wanted by the operator, asked of a job, closed or refused. Inside this corner only.
#pragma once

namespace hallux::simulator {

class HingeRequests {
 public:
  bool is_wanted() const noexcept { return is_wanted_; }
  bool is_closed() const noexcept { return is_closed_; }

  void want() noexcept { is_wanted_ = true; }
  /// Grants or drops the wish; true where a job is to be asked now. It is dropped while a job is
  /// under way, after the closing, and while the kerf grows: the blade stands in one that it opened
  /// since the pieces were last asked for.
  bool ask(bool is_kerf_growing) noexcept {
    is_wanted_ = false;
    if (is_kerf_growing || is_asked_ || is_closed_) return false;
    is_asked_ = true;
    return true;
  }
  /// The job's answer.
  void apply(bool has_closed) noexcept {
    is_asked_ = false;
    is_closed_ = is_closed_ || has_closed;
  }

 private:
  bool is_wanted_ = false;
  /// The job's result was not applied yet.
  bool is_asked_ = false;
  bool is_closed_ = false;
};

}  // namespace hallux::simulator
