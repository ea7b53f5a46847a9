#include "scenarios/hands/cut_strokes.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

/// On purpose farther than the last bone under its teeth, or not as far. A stroke without bone up
/// to there is left out.
std::vector<Stroke> run_on(std::vector<Stroke> strokes, double run_on_mm) {
  for (Stroke& stroke : strokes) {
    stroke.end_mm += run_on_mm;
    if (run_on_mm >= 0.0) continue;
    stroke.last_mm += run_on_mm;
    stroke.end_mm = stroke.last_mm;
    stroke.stops_in_bone = true;
  }
  strokes.erase(
      std::remove_if(strokes.begin(), strokes.end(),
                     [](const Stroke& stroke) { return stroke.last_mm <= stroke.first_mm; }),
      strokes.end());
  return strokes;
}

}  // namespace

std::vector<Stroke> cut_strokes(const AimedCut& aimed, const simulator::Blade& blade,
                                const HandSkill& skill) {
  const std::vector<Stroke> strokes = plan_strokes(aimed.region, {.blade_width_mm = blade.width_mm,
                                                                  .margin_mm = skill.edge_margin_mm,
                                                                  .beyond_mm = skill.beyond_mm});
  if (aimed.stop_mm) return stopped(strokes, *aimed.stop_mm);
  return aimed.run_on_mm == 0.0 ? strokes : run_on(strokes, aimed.run_on_mm);
}

}  // namespace hallux::scenarios
