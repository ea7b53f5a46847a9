/// Tells accessibility tools and tests, in a file, which widgets are on the screen and where.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "ui/widgets/input/widget.h"

namespace hallux::ui {

/// One JSON value: {"focus": "id of the widget that keys go to, or empty", "captured": "id of the
/// area that has the pointer, or empty", "widgets": [{"id", "label", "x", "y", "w", "h", "enabled",
/// "reason"}, ...], "read_outs": [{"id", "text", "x", "y", "w", "h"}, ...]} in device pixels of the
/// window. `reason` is there for what is not enabled. Only what can be seen and reached; never what
/// a field holds.
std::string ui_map_json(const FrameContent& content, float scale,
                        std::string_view captured_by = {});

/// Keeps the file up to date, at most ten times a second.
class UiMap {
 public:
  /// Puts the new content in the file's place, as a whole: no reader sees half of it.
  using Write = std::function<void(const std::string& json)>;
  explicit UiMap(Write write) : write_(std::move(write)) {}

  /// Writes where the content has changed and the last writing is 0.1 s ago. Returns the seconds
  /// until it wants to be called again; infinity where the file says what is shown.
  /// errors  those of the writing
  double update(const FrameContent& content, float scale, double time_s,
                std::string_view captured_by = {});

 private:
  Write write_;
  std::string written_;
  double written_at_s_ = -1.0;
  bool has_written_ = false;
};

}  // namespace hallux::ui
