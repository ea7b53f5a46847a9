/// What goes wrong with graphics outside our hands: no driver, no context, a shader that this
/// driver refuses.
#pragma once

#include <stdexcept>

namespace hallux::ui {

/// One sentence: what was tried, what the driver said, what to do. The command answers it with exit
/// code 7 (design: needs a display or device that is not there).
class GraphicsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace hallux::ui
