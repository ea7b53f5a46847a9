/// A report's traces over time as inline SVG; its colours come from the page's style sheet and
/// follow its theme. Inside this corner only.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// Force over time above advance over time, with the events that mattered.
std::string trace_svg(const Traces& traces);

}  // namespace hallux::ui
