/// One self-contained page about one attempt.
#pragma once

#include <string>

#include "ui/report/report_material.h"

namespace hallux::ui {

/// The page as UTF-8: no script, nothing loaded from elsewhere, all text escaped; light and dark
/// follow the reader's choice, and it prints on A4.
/// ensures the same material gives the same bytes
std::string html_report(const ReportMaterial& material);

}  // namespace hallux::ui
