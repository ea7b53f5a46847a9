/// Numbers as people read them, with a point whatever the locale.
#pragma once

#include <string>

namespace hallux::ui {

/// With that many decimals: "4.20"; a dash for what is no number.
std::string fixed_text(double value, int decimals);

/// Three digits at most, without needless zeros: "0.5", "12".
std::string short_text(double value);

}  // namespace hallux::ui
