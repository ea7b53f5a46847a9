/// `hallux` without a verb: the window on a data directory.
#pragma once

#include <filesystem>
#include <optional>

#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// Shows the window until it is closed. `ui_map` names the file that tells what is on the screen
/// (ui/widgets/ui_map.h).
/// errors  VerbError NoDisplay where there is no display, or none with OpenGL 3.3
ExitCode open_window(const VerbContext& context,
                     const std::optional<std::filesystem::path>& ui_map);

}  // namespace hallux::ui
