/// How long work says how far it is, and how it is stopped.
#pragma once

#include <functional>
#include <stdexcept>

namespace hallux::assessment {

/// Called with the fraction done [0, 1]; returning false cancels. May be empty.
using Progress = std::function<bool(double)>;

/// Thrown where progress said to stop; nothing was changed.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// errors  Cancelled
inline void report(const Progress& progress, double fraction) {
  if (progress && !progress(fraction)) throw Cancelled();
}

}  // namespace hallux::assessment
