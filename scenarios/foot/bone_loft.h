/// The smooth body of a bone: sections along x, closed by two quadric caps with rounded rims.
/// Inside this corner only.
#pragma once

#include <array>
#include <vector>

#include "scenarios/foot/bone_table.h"
#include "scenarios/foot/dual.h"

namespace hallux::scenarios {

/// How far a point lies outside each part [mm]; below zero inside.
struct LoftDistances {
  Dual side;
  Dual base;
  Dual head;
};

class BoneLoft {
 public:
  explicit BoneLoft(const BoneTable& table);

  /// The parts near a point in the table's own millimetres; sizes are true distances only near each
  /// part's surface.
  LoftDistances parts_at(const Vec3& point_mm) const noexcept;
  /// The parts joined into one field.
  Dual joined(const LoftDistances& parts) const noexcept;

 private:
  static constexpr std::size_t channel_count = 9;
  using Channels = std::array<double, channel_count>;
  struct Knot {
    double x_mm = 0.0;
    Channels value{};
    Channels slope_per_mm{};
  };

  void set_slopes(std::size_t channel);
  std::array<Dual, channel_count> section_past(const Knot& end, double x_mm) const noexcept;
  std::array<Dual, channel_count> section_at(double x_mm) const noexcept;

  double length_mm_;
  EndCap base_;
  EndCap head_;
  std::vector<Knot> knots_;
};

}  // namespace hallux::scenarios
