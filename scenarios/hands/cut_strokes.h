/// The strokes of one cut as a hand of a skill lays them into what it aimed at.
/// Inside this corner only.
#pragma once

#include <vector>

#include "scenarios/hands/hand_aim.h"
#include "scenarios/hands/stroke_plan.h"

namespace hallux::scenarios {

/// In the order in which they are sawn; none where the hand means to stop before the bone.
std::vector<Stroke> cut_strokes(const AimedCut& aimed, const simulator::Blade& blade,
                                const HandSkill& skill);

}  // namespace hallux::scenarios
