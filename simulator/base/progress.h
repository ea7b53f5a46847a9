/// Progress of long work and its cancellation: one type and one exception for every room.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace hallux {

/// Called with the fraction done [0, 1]; returning false cancels. May be empty.
using Progress = std::function<bool(double)>;

/// Work that was cancelled by its caller; the sentence says what was kept and what was not.
class Cancelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Cancelled() : std::runtime_error("cancelled") {}
};

/// errors  Cancelled
inline void report(const Progress& progress, double fraction) {
  if (progress && !progress(fraction)) throw Cancelled();
}

/// Progress of one stage of a larger work: its fractions become those from `from` to `to` of the
/// whole, each in [0, 1].
inline Progress part_of(Progress whole, double from, double to) {
  if (!whole) return {};
  return [whole = std::move(whole), from, to](double fraction) {
    return whole(from + (to - from) * fraction);
  };
}

/// Carries out `work`; a cancellation inside it comes out with `sentence`, said in the words of the
/// caller.
/// errors  Cancelled; whatever else `work` throws
template <typename Work>
decltype(auto) cancelled_as(const std::string& sentence, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const Cancelled&) {
    throw Cancelled(sentence);
  }
}

}  // namespace hallux
