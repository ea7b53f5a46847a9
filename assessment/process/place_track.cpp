#include "assessment/process/place_track.h"

#include <utility>

#include "assessment/metrics/low_pass.h"

namespace hallux::assessment {

namespace {

using simulator::TapeLine;

void add_place(PlaceStretch& stretch, const Vec3& place_mm, std::uint32_t status) {
  for (std::size_t axis = 0; axis < stretch.axes_mm.size(); ++axis)
    stretch.axes_mm[axis].push_back(place_mm[static_cast<glm::length_t>(axis)]);
  stretch.status.push_back(status);
}

/// Lines that count as one.
struct LineSum {
  std::int64_t first_tick = 0, ticks = 0;
  std::size_t count = 0;

  void add(const TapeLine& line) noexcept {
    if (count++ == 0) first_tick = line.tick;
    ticks += line.ticks;
  }
};

/// The ticks that lines cover, the thing moving evenly to where the last of them has it.
void add_lines(PlaceStretch& stretch, const LineSum& lines, const Vec3& place_mm,
               std::uint32_t status) {
  if (stretch.count() == 0) stretch.first_tick = lines.first_tick;
  const Vec3 from_mm = stretch.count() == 0 ? place_mm : stretch.at_mm(stretch.count() - 1);
  for (std::int64_t tick = 1; tick <= lines.ticks; ++tick) {
    const double share = static_cast<double>(tick) / static_cast<double>(lines.ticks);
    add_place(stretch, from_mm + share * (place_mm - from_mm), status);
  }
}

}  // namespace

std::vector<PlaceStretch> followed_places(const simulator::Recorded& recorded,
                                          const PlaceAt& place_at, std::size_t together) {
  std::vector<PlaceStretch> stretches;
  PlaceStretch stretch;
  LineSum lines;
  const auto end_stretch = [&] {
    lines = {};
    if (stretch.count() == 0) return;
    for (std::vector<double>& axis_mm : stretch.axes_mm) low_pass(axis_mm, {});
    stretches.push_back(std::exchange(stretch, {}));
  };
  const std::vector<simulator::ToolSample>& samples = recorded.outputs.samples;
  auto sample = samples.begin();
  std::int64_t next_tick = 0;
  recorded.tape.visit([&](const TapeLine& line) {
    const std::int64_t last_tick = line.tick + line.ticks - 1;
    while (sample != samples.end() && sample->tick < last_tick) ++sample;
    const bool is_told = sample != samples.end() && sample->tick == last_tick;
    const bool runs = is_told && has(sample->status, simulator::ToolStatus::Running);
    const std::optional<Vec3> place_mm = runs ? place_at(line, *sample) : std::nullopt;
    if (!place_mm || line.tick != next_tick) end_stretch();
    next_tick = last_tick + 1;
    if (!place_mm) return;
    lines.add(line);
    if (lines.count < together) return;
    add_lines(stretch, std::exchange(lines, {}), *place_mm, sample->status);
  });
  end_stretch();
  return stretches;
}

}  // namespace hallux::assessment
