/// Where the keyboard goes next: Tab through all controls, arrows inside a group.
#pragma once

#include <string>

#include "ui/widgets/input/input_event.h"
#include "ui/widgets/input/widget.h"

namespace hallux::ui {

/// The id after (or before) `focus` in Tab order; the first (or last) where `focus` is nowhere, ""
/// where nothing can have the focus. A group is visited once, at its chosen widget; those that come
/// late come behind all others.
std::string next_in_tab_order(const FrameContent& content, const std::string& focus,
                              bool is_backwards);

/// The widget of the same group that lies nearest in the direction of the arrow, Home or End;
/// `focus` itself where there is none.
std::string next_by_arrow(const FrameContent& content, const std::string& focus, Key arrow);

/// True where `widget` may have the focus now. One that is off may, so that its reason can be read
/// by keyboard; without a reason there is nothing to read.
bool can_have_focus(const FrameContent& content, const Widget& widget) noexcept;
/// True where a press on it does something, by key or pointer.
bool can_be_pressed(const FrameContent& content, const Widget& widget) noexcept;

}  // namespace hallux::ui
