/// A report's picture of one face as inline SVG; its colours come from the page's style sheet and
/// follow its theme. Inside this corner only.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// The planned outline and the face's samples, coloured by signed deviation, with a legend in
/// millimetres.
std::string face_svg(const FacePicture& picture);

}  // namespace hallux::ui
