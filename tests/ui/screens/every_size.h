/// A screen in every window it may stand in: what is wrong with it there.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {

/// Faults of the screen (Driver::faults) at 80, 100, 150 and 200 percent, in windows from 1280x720
/// to 3840x2160 device pixels, light and dark, with navigation beside it. `prepare` brings each to
/// the state that is looked at.
std::vector<std::string> faults_at_every_size(
    const std::function<std::unique_ptr<Screen>()>& make,
    const std::function<void(SomeVisitor&)>& prepare = {});

/// Whether `word` stands in a text of the frame as a word of its own: "eve", not "never".
bool shows_word(const Driver& driver, const std::string& word);

/// All texts of the frame behind each other, so that a sentence is found that is broken into lines.
std::string all_text(const Driver& driver);

/// Presses Tab until `id` has the focus, then Enter.
/// errors  fails the test where Tab does not come there
void press_by_keyboard(SomeVisitor& visitor, const std::string& id);

}  // namespace hallux::ui
