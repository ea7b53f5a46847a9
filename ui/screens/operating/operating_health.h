/// How machine, recording and arm are while one operates.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/loop/attempt_watch.h"

namespace hallux::ui {

/// What an arm is given of the simulated force.
struct ArmHealth {
  double force_scale = 1.0;  ///< its newtons per simulated newton
  double force_newton = 0.0;
  std::uint32_t limits = 0;  ///< bits of simulator::ForceLimit that held it back lately
};

struct OperatingHealth {
  double frame_ms = 0.0;  ///< between two pictures, the slower of the last
  double late_us = 0.0;   ///< of the loop, the most of the last second
  long missed_ticks = 0, pauses = 0;
  double ring_share = 0.0;
  long triangles = 0;
  std::uintmax_t log_bytes = 0;  ///< of the database's log, which holds what was committed last
  bool has_priority = true, has_locked_memory = true;
  std::optional<ArmHealth> arm = {};  ///< nothing where nobody is pushed back
  std::string trouble = {};           ///< a sentence of the catalogue; empty: all is well
};

/// What loop and arm say of themselves; pictures and trouble are the screen's.
/// `force_scale` is nothing where nobody is pushed back; `recent_limits` held the arm's force back lately.
OperatingHealth health_of(const simulator::LoopView& view, std::optional<double> force_scale,
                          std::uint32_t recent_limits);

/// What occurred in the last second or two: limits come and go a thousand times a second, and are to be read.
class RecentLimits {
 public:
  /// Takes what holds the force back now. Times only grow.
  void see(std::uint32_t limits, double now_s) noexcept;
  std::uint32_t bits() const noexcept { return before_ | now_; }

 private:
  std::uint32_t before_ = 0, now_ = 0;
  double since_s_ = 0.0;
};

/// The ids of the words for these limits, the ones that take all force first.
std::vector<std::string_view> words_of_limits(std::uint32_t limits);

}  // namespace hallux::ui
