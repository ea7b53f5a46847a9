/// Which strokes a blade needs to cover a section: side by side with an overlap, from the middle
/// outwards, through the bone or down to a line in it. Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/slice/section.h"

namespace hallux::scenarios {

/// In the blade's plane: x along the feed, y along the tooth line [mm].
struct Stroke {
  /// Middle of the tooth line.
  double along_mm = 0.0;
  /// Feed at which bone begins under the tooth line.
  double first_mm = 0.0;
  /// Feed at which it ends, or where the stroke is to stop in it.
  double last_mm = 0.0;
  /// Feed to which the hand goes: beyond the last bone where it saws through.
  double end_mm = 0.0;
  bool stops_in_bone = false;
  /// How often the blade is drawn wholly out of the kerf and enters it again, on purpose.
  std::int32_t restarts = 0;
};

struct StrokeLayout {
  double blade_width_mm = 12.0;
  double overlap_mm = 3.0;
  /// By which the outermost strokes reach beyond the sides of the section.
  double margin_mm = 1.5;
  /// By which a hand goes on after the last bone that it expects.
  double beyond_mm = 1.5;
};

/// needs   0 < overlap < blade width
std::vector<Stroke> plan_strokes(const simulator::SectionRegion& region,
                                 const StrokeLayout& layout);

/// The strokes, ended at a line across the feed. A stroke whose bone begins beyond the line is left
/// out.
std::vector<Stroke> stopped(const std::vector<Stroke>& strokes, double stop_mm);

}  // namespace hallux::scenarios
