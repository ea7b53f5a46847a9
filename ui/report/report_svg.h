/// The pictures of a report as inline SVG; their colours come from the page's style sheet and follow its theme.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// The planned outline and the face's samples, coloured by signed deviation, with a legend in millimetres.
std::string face_svg(const FacePicture& picture);
/// Section of the bone with the planned line (dashed) and the actual one.
std::string frontal_svg(const FrontalPicture& picture);
/// Force over time above advance over time, with the events that mattered.
std::string trace_svg(const Traces& traces);

}  // namespace hallux::ui
