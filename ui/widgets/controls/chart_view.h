/// Charts on the screen: drawn with the canvas, pointed at with the mouse, walked along with the
/// arrows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ui/widgets/charts/line_chart.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What a tooltip says about a point: the value, and attempt, date and the like below it.
using PointWords = std::function<std::pair<std::string, std::string>(std::size_t point)>;

/// Shows the chart; the point under the pointer, or the one the arrows walked to, is drawn large
/// with a tooltip. Each point is a control `id.0`, `id.1` ... Returns the point that was pressed.
std::optional<std::size_t> line_chart(Ui& ui, std::string_view id, const Rect& rect,
                                      LineChart chart, const PointWords& words);

}  // namespace hallux::ui
