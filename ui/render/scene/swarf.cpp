#include "ui/render/scene/swarf.h"

#include <algorithm>

namespace hallux::ui {

namespace {

constexpr double chips_per_mm3 = 22.0;  // by eye: real dust is finer than a pixel
constexpr double life_s = 0.9;
constexpr Vec3 gravity_mm_s2(
    0.0, -420.0, 0.0);  // by eye: a twentieth of what it is, or nothing would be seen of them

}  // namespace

void Swarf::advance(double step_s, const std::optional<SwarfSource>& source) {
  step_s = std::clamp(step_s, 0.0, 0.1);
  std::size_t gone = 0;
  for (std::size_t i = 0; i < chips_.size(); ++i) {
    Flight& flight = flights_[i];
    flight.age_s += step_s;
    flight.velocity_mm_s += step_s * gravity_mm_s2;
    flight.velocity_mm_s *= std::max(0.0, 1.0 - 2.2 * step_s);
    chips_[i].place_mm += step_s * flight.velocity_mm_s;
    const double left = std::clamp((life_s - flight.age_s) / 0.3, 0.0, 1.0);
    chips_[i].size_mm = static_cast<float>(flight.size_mm * left);
    if (flight.age_s >= life_s) gone = i + 1;  // chips stand in the order of their age
  }
  drop_oldest(gone);
  if (!source) return;
  owed_ += std::clamp(chips_per_mm3 * source->removed_mm3_s * step_s, 0.0, 60.0);
  for (; owed_ >= 1.0; owed_ -= 1.0) add_chip(*source);
}

void Swarf::add_chip(const SwarfSource& source) {
  if (chips_.size() >= chips_at_most) drop_oldest(1);
  const double across_mm = source.width_mm * random_.uniform(-0.5, 0.5);
  const double spread = source.is_irrigated ? 0.35 : 1.0;
  // Teeth throw along the tooth line, out of the kerf backwards, and a little off the plane.
  const Vec3 thrown(spread * random_.uniform(-70.0, -20.0),
                    spread * (random_.uniform() < 0.5 ? -1.0 : 1.0) * random_.uniform(15.0, 70.0),
                    spread * random_.normal() * 12.0);
  Chip chip;
  chip.place_mm = transform_point(source.world_from_tool, Vec3(-0.4, across_mm, 0.0));
  const double size_mm = random_.uniform(0.08, 0.24);
  chip.size_mm = static_cast<float>(size_mm);
  chip.wetness = source.is_irrigated ? 0.75F : static_cast<float>(random_.uniform(0.0, 0.35));
  chips_.push_back(chip);
  flights_.push_back({transform_direction(source.world_from_tool, thrown), 0.0, size_mm});
}

void Swarf::drop_oldest(std::size_t count) {
  chips_.erase(chips_.begin(), chips_.begin() + static_cast<std::ptrdiff_t>(count));
  flights_.erase(flights_.begin(), flights_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace hallux::ui
