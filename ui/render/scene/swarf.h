/// Chips that fly from the teeth, for the eye only: nothing of the simulation depends on them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/base/random.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Teeth at work.
struct SwarfSource {
  RigidTransform world_from_tool;
  /// Of the tooth line.
  double width_mm = 10.0;
  /// Bone that the teeth take in a second.
  double removed_mm3_s = 0.0;
  /// Wet chips are dark and do not fly far.
  bool is_irrigated = false;
};

class Swarf {
 public:
  /// At most this many chips at once; the oldest go first.
  static constexpr std::size_t chips_at_most = 400;

  explicit Swarf(std::uint64_t seed) : random_(seed) {}

  /// Lets time pass. Longer steps than 0.1 s are cut to that.
  /// ensures the same calls on the same seed give the same chips
  void advance(double step_s, const std::optional<SwarfSource>& source);
  const std::vector<Chip>& chips() const noexcept { return chips_; }

 private:
  struct Flight {
    Vec3 velocity_mm_s{0.0, 0.0, 0.0};
    double age_s = 0.0, size_mm = 0.1;
  };

  void add_chip(const SwarfSource& source);
  void drop_oldest(std::size_t count);

  Random random_;
  /// Chips that are not yet whole.
  double owed_ = 0.0;
  std::vector<Chip> chips_;
  std::vector<Flight> flights_;
};

}  // namespace hallux::ui
