#include "ui/widgets/ui_map.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace hallux::ui {
namespace {

constexpr double least_interval_s = 0.1;

/// A rectangle in device pixels of the window.
void put_place(nlohmann::ordered_json& entry, const Rect& rect, float scale) {
  const auto device = [&](float value) { return std::lround(value * scale); };
  entry["x"] = device(rect.x);
  entry["y"] = device(rect.y);
  entry["w"] = device(rect.right()) - device(rect.x);
  entry["h"] = device(rect.bottom()) - device(rect.y);
}

nlohmann::ordered_json entry_of(const Widget& widget, float scale) {
  nlohmann::ordered_json entry{{"id", widget.id}, {"label", widget.label}};
  put_place(entry, widget.visible, scale);
  entry["enabled"] = widget.is_enabled;
  if (!widget.is_enabled) entry["reason"] = widget.why_off;
  return entry;
}

}  // namespace

std::string ui_map_json(const FrameContent& content, float scale, std::string_view captured_by) {
  const Layer lowest = reachable_layer(content);
  nlohmann::ordered_json widgets = nlohmann::ordered_json::array();
  for (const Widget& widget : content.widgets) {
    if (widget.visible.is_empty() || widget.layer < lowest || widget.role == Role::Scroll) continue;
    widgets.push_back(entry_of(widget, scale));
  }
  nlohmann::ordered_json read_outs = nlohmann::ordered_json::array();
  for (const ReadOut& read_out : content.read_outs) {
    if (read_out.layer < lowest) continue;
    nlohmann::ordered_json entry{{"id", read_out.id}, {"text", read_out.text}};
    put_place(entry, read_out.rect, scale);
    read_outs.push_back(std::move(entry));
  }
  return nlohmann::ordered_json{{"focus", content.focus},
                                {"captured", captured_by},
                                {"widgets", widgets},
                                {"read_outs", read_outs}}
             .dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

double UiMap::update(const FrameContent& content, float scale, double time_s,
                     std::string_view captured_by) {
  std::string text = ui_map_json(content, scale, captured_by);
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
