/// Why a device cannot be used, as a sentence, and the line that mends it: the same on the terminal
/// and on the screen.
#pragma once

#include <string>
#include <string_view>

#include "simulator/device/port/device_trouble.h"
#include "simulator/device/station/device_kind.h"

namespace hallux::ui {

/// Empty where there is no trouble.
std::string sentence_of(const simulator::TroubleReport& trouble, const simulator::KindFacts& kind);
/// What to do or to paste; empty where nothing can be done.
std::string mend_of(const simulator::TroubleReport& trouble, const simulator::KindFacts& kind,
                    const std::string& id);

/// Both, as one sentence without its full stop.
std::string trouble_words(const simulator::TroubleReport& trouble, const simulator::KindFacts& kind,
                          const std::string& id);
/// How its grip is brought home when it is opened; empty where there is nothing to do.
std::string home_sentence(const simulator::KindFacts& kind);

/// Of the id of a device, which begins with its kind's; nullptr where none has it.
const simulator::KindFacts* kind_of_device(std::string_view id) noexcept;

}  // namespace hallux::ui
