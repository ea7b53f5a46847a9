/// A report's section of the bone as inline SVG; its colours come from the page's style sheet and
/// follow its theme. Inside this corner only.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// Section of the bone with the planned line (dashed) and the actual one.
std::string frontal_svg(const FrontalPicture& picture);

}  // namespace hallux::ui
