/// How far what faces and bridges tell may be from exact. Inside this room only.
#pragma once

#include <optional>
#include <string>

#include "assessment/rebuild/evidence.h"
#include "scenarios/metric_names.h"

namespace hallux::assessment {

/// How far a value that is linear over a face, with this slope along it, may rise beyond its
/// greatest at the samples (see reach_steps). Of an unfinished face the border is the blade's,
/// known as far as the field tells.
double reach_bound_mm(const CutFace& face, double slope) noexcept;

/// Of the face's area, how much the samples may misjudge: a border that runs along the grid lies up
/// to half a step from where they tell, one across it further, past as many more of them: half of
/// what the samples at the border stand for.
double area_bound(const CutFace& face) noexcept;

/// Of a metric of a cut's face, or of a hinge's wedge and bridge, beside the rounding of its value;
/// nothing where neither tells it.
/// needs   the metric has a value
std::optional<double> bound_of_cut(scenarios::Metric metric, const std::string& cut,
                                   const Evidence& evidence);
std::optional<double> bound_of_hinge(scenarios::Metric metric, const std::string& hinge,
                                     const Evidence& evidence);

}  // namespace hallux::assessment
