/// Health of machine, recording and arm while somebody operates.
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
  /// Its newtons per simulated newton.
  double force_scale = 1.0;
  double force_newton = 0.0;
  /// Bits of simulator::ForceLimit that held it back lately.
  std::uint32_t limits = 0;
};

struct OperatingHealth {
  /// Between two pictures, the slower of the last.
  double frame_ms = 0.0;
  /// Of the loop, the most of the last second.
  double late_us = 0.0;
  long missed_ticks = 0, pauses = 0;
  double ring_share = 0.0;
  long triangles = 0;
  /// Of the database's log, which holds what was committed last.
  std::uintmax_t log_bytes = 0;
  bool has_priority = true, has_locked_memory = true;
  /// Nothing where nobody is pushed back.
  std::optional<ArmHealth> arm = {};
  /// A sentence of the catalogue; empty: all is well.
  std::string trouble = {};
};

/// What loop and arm say of themselves; pictures and trouble are the screen's. `force_scale` is
/// nothing where nobody is pushed back; `recent_limits` held the arm's force back lately.
OperatingHealth health_of(const simulator::LoopView& view, std::optional<double> force_scale,
                          std::uint32_t recent_limits);

/// The sentence about what people are to know, as an id, the gravest first; empty: all is well.
/// has_lost_picture  the bone's picture stands still
std::string_view trouble_of(const simulator::LoopView& view, bool has_lost_picture) noexcept;

/// What occurred in the last second or two: limits come and go a thousand times a second, and are
/// to be read.
class RecentLimits {
 public:
  /// Takes what holds the force back now. Times only grow.
  void observe(std::uint32_t limits, double now_s) noexcept;
  std::uint32_t bits() const noexcept { return before_ | now_; }

 private:
  std::uint32_t before_ = 0, now_ = 0;
  double since_s_ = 0.0;
};

/// The ids of the words for these limits, the ones that take all force first.
std::vector<std::string_view> limit_text_ids(std::uint32_t limits);

}  // namespace hallux::ui
