#include "ui/render/rest.h"

namespace hallux::ui {

Drawing Rest::next(bool is_same, bool is_touched) noexcept {
  if (!is_same) {
    waited_ = samples_ = 0;
    return Drawing::Moving;
  }
  if (is_touched) waited_ = 0;
  const bool waits = is_touched || waited_ < plan_.waits;
  if (!is_touched && waits) ++waited_;
  if (waits) return samples_ == 0 ? Drawing::Moving : Drawing::Kept;
  if (is_finished()) return Drawing::Kept;
  return samples_++ == 0 ? Drawing::First : Drawing::Sample;
}

}  // namespace hallux::ui
