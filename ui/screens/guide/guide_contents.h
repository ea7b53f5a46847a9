/// What stands beside a page of the guide: all pages with the headings of the one that is read, or
/// what was found. Inside this corner only.
#pragma once

#include <optional>
#include <span>

#include "ui/screens/guide/guides.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The pages, and below the one that is read its headings; `reading` is the heading in sight.
/// Returns the place that was chosen.
std::optional<GuidePlace> draw_guide_contents(Ui& ui, const Rect& rect, const Guides& guides,
                                              GuidePlace reading);

/// How often the words were found, and where.
std::optional<GuidePlace> draw_guide_hits(Ui& ui, const Rect& rect, const Guides& guides,
                                          std::span<const GuideHit> hits);

}  // namespace hallux::ui
