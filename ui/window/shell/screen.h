/// One screen of the window: it fills it, one after the other, as in a game.
/// Inside this corner only.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"
#include "ui/window/shell/guide_section.h"

namespace hallux::ui {

class Shell;

/// What the shell draws around a screen.
enum class WindowChrome {
  /// Sign-in: nobody is known yet.
  Nothing,
  /// The way to the other screens, and the person at its foot.
  Navigation,
  /// The same as icons, for screens that need the width.
  Rail,
  /// Only the person, in a corner; the screen draws its own ground, a scene behind.
  Badge,
};

class Screen {
 public:
  virtual ~Screen() = default;

  /// The navigation item it belongs to, "nav.history"; "" for that of the screen it was opened
  /// from.
  virtual std::string_view navigation_id() const { return {}; }
  /// Where the guide opens that is asked for here.
  virtual GuideSection guide_section() const = 0;
  virtual WindowChrome surround() const { return WindowChrome::Navigation; }
  /// Why it may not be left now, as a sentence for people ("The attempt is still being recorded.
  /// Finish or abandon it."); "" where it may.
  virtual std::string_view why_not_leave() const { return {}; }
  /// Asked to be left while it may not be: true where it asks the person itself what to do, else
  /// why_not_leave() is said.
  virtual bool ask_before_leaving(Ui&) { return false; }
  /// Called when it becomes the screen that is shown: for the first time, and when the one above it
  /// went.
  virtual void enter(Shell&) {}
  /// Called when another screen takes its place or lies above it.
  virtual void leave(Shell&) {}
  /// Called when the guide is opened over it: it goes on being drawn, but nobody looks at it.
  virtual void be_covered() {}
  /// Draws one frame into `content`. What it asks of the shell happens after the frame.
  virtual void draw(Ui& ui, const Rect& content, Shell& shell) = 0;
};

}  // namespace hallux::ui
