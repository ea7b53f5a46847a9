#include "scenarios/hands/cut_strokes.h"

namespace hallux::scenarios {

std::vector<Stroke> cut_strokes(const AimedCut& aimed, const simulator::Blade& blade,
                                const HandSkill& skill) {
  const std::vector<Stroke> strokes = plan_strokes(aimed.region, {.blade_width_mm = blade.width_mm,
                                                                  .margin_mm = skill.edge_margin_mm,
                                                                  .beyond_mm = skill.beyond_mm});
  return aimed.stop_mm ? stopped(strokes, *aimed.stop_mm) : strokes;
}

}  // namespace hallux::scenarios
