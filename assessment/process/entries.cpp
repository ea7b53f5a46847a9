#include "assessment/process/entries.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/process/tools_used.h"
#include "scenarios/site/planned_passes.h"

namespace hallux::assessment {

namespace {

using simulator::ToolSample;

constexpr double away_mm = 3.0;
Vec3 place_of(const ToolSample& sample) noexcept {
  return transform_from(sample.world_from_tool).translation_mm;
}

struct Entry {
  std::int32_t kerf = -1;
  std::int64_t tick = 0;
};

std::vector<Entry> entries_of(const simulator::Recording& recording) {
  std::vector<Entry> entries;
  std::int32_t last_kerf = -1;
  Vec3 left_mm{0.0, 0.0, 0.0};
  double furthest_mm = 0.0;
  for (const ToolSample& sample : recording.samples) {
    if (sample.kerf < 0) {
      furthest_mm = std::max(furthest_mm, length_of(place_of(sample) - left_mm));
      continue;
    }
    if (sample.kerf != last_kerf || furthest_mm > away_mm)
      entries.push_back({sample.kerf, sample.tick});
    last_kerf = sample.kerf;
    left_mm = place_of(sample);
    furthest_mm = 0.0;
  }
  return entries;
}

/// The passes that the section needs which the kerf's blade touched.
std::int64_t needed_in(const RebuiltKerf& kerf, double width_mm) {
  double low_mm = INFINITY, high_mm = -INFINITY;
  for (std::size_t index = 0; index < kerf.section.regions.size(); ++index) {
    if (kerf.is_touched[index] == 0) continue;
    low_mm = std::min(low_mm, kerf.section.regions[index].min_mm.y);
    high_mm = std::max(high_mm, kerf.section.regions[index].max_mm.y);
  }
  return high_mm > low_mm ? scenarios::passes_needed(high_mm - low_mm, width_mm) : 1;
}

/// Of the face that counts; none where the cut was not made.
std::int64_t needed_of(const std::vector<CutFace>& faces, const Evidence& evidence) {
  if (faces.empty()) return 0;
  const std::int32_t kerf = faces.front().kerf;
  const simulator::Blade& blade = blade_of_kerf(evidence.recording, evidence.rebuilt, kerf);
  return needed_in(evidence.rebuilt.kerfs[static_cast<std::size_t>(kerf)], blade.width_mm);
}

}  // namespace

Finding measure_restarts(const Evidence& evidence) {
  const std::vector<Entry> entries = entries_of(evidence.recording);
  std::int64_t restarts = 0;
  for (const std::vector<CutFace>& faces : evidence.faces) {
    const auto is_of_cut = [&](const Entry& entry) {
      return std::any_of(faces.begin(), faces.end(),
                         [&](const CutFace& face) { return face.kerf == entry.kerf; });
    };
    const auto made = std::count_if(entries.begin(), entries.end(), is_of_cut);
    restarts += std::max<std::int64_t>(0, made - needed_of(faces, evidence));
  }
  const std::int64_t tick = entries.empty() ? 0 : entries.back().tick;
  return {static_cast<double>(restarts), tick, tick};
}

}  // namespace hallux::assessment
