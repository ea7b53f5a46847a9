/// What a notice says to people.
#pragma once

#include <string>

#include "database/records/notice.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// One sentence. Somebody whose name was erased is "somebody".
std::string notice_text(const Texts& texts, const database::Notice& notice);

}  // namespace hallux::ui
