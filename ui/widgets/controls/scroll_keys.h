/// Reading on by keys: Up and Down by lines, Page up and Page down by what is seen, Home and End.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Scrolls the region `id`, of which `seen` logical pixels are seen, by what was pressed. Where a
/// group of controls has the focus, arrows, Home and End are the group's.
void scroll_by_keys(Ui& ui, std::string_view id, float seen);

}  // namespace hallux::ui
