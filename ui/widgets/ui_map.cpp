#include "ui/widgets/ui_map.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace hallux::ui {
namespace {

constexpr double least_interval_s = 0.1;

}  // namespace

std::string ui_map_json(const FrameContent& content, float scale) {
  const Layer lowest = reachable_layer(content);
  nlohmann::ordered_json widgets = nlohmann::ordered_json::array();
  for (const Widget& widget : content.widgets) {
    if (widget.visible.is_empty() || widget.layer < lowest || widget.role == Role::Scroll) continue;
    const auto device = [&](float value) { return std::lround(value * scale); };
    const long x = device(widget.visible.x), y = device(widget.visible.y);
    widgets.push_back({{"id", widget.id},
                       {"label", widget.label},
                       {"x", x},
                       {"y", y},
                       {"w", device(widget.visible.right()) - x},
                       {"h", device(widget.visible.bottom()) - y},
                       {"enabled", widget.is_enabled}});
  }
  return nlohmann::ordered_json{{"focus", content.focus}, {"widgets", widgets}}.dump(
             1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

double UiMap::update(const FrameContent& content, float scale, double time_s) {
  std::string text = ui_map_json(content, scale);
  if (has_written_ && text == written_) return std::numeric_limits<double>::infinity();
  const double wait_s = written_at_s_ + least_interval_s - time_s;
  if (has_written_ && wait_s > 0.0) return wait_s;
  write_(text);
  written_ = std::move(text);
  written_at_s_ = time_s;
  has_written_ = true;
  return std::numeric_limits<double>::infinity();
}

}  // namespace hallux::ui
