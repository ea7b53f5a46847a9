/// What the window tells in passing, and the work that runs: where it stands and how long it stays.
/// Inside this corner only.
///
///     +-------+----------------------+
///     | places| page                 |
///     |  gap  |                      |
///     | person| strip                |
///     +-------+----------------------+
///
/// With a navigation it stands in the gap under its places. What finds no room there has a strip at
/// the foot, which the page leaves free for it. Without one, or below a menu or a question, it
/// looks for a place where nothing else is. So nothing that is told covers a control or a read-out.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/ui.h"
#include "ui/window/shell/background.h"

namespace hallux::ui {

/// A message. It goes after six seconds; with Bad or Warn it stays until it is closed.
struct Message {
  Meaning meaning = Meaning::Good;
  std::string title = {}, detail = {}, action = {};
  std::function<void()> on_action = {};
};

/// Where messages may stand in a frame.
struct MessageRoom {
  /// Of the navigation; empty: there is none, or a rail.
  Rect gap = {};
  /// Of the page that may leave a strip free; empty: the screen draws over the whole display.
  Rect page = {};
};

struct Obstacles;

class Messages {
 public:
  /// What is said again takes the place of what it repeats.
  void say(Message message);
  void clear() noexcept { messages_.clear(); }

  /// Gives everything that is told in this frame its place, newest first; what finds none waits.
  /// Returns the height of the strip that the page leaves free.
  float plan(Ui& ui, const Background& background, const MessageRoom& room);
  /// Draws what was planned, and does what was answered.
  void draw(Ui& ui, Background& background);

 private:
  struct Shown {
    Message message;
    std::string id;
    /// Frame time; below 0: not seen yet.
    double since_s = -1.0;
  };
  /// A message, or work that runs, as it is told in this frame.
  struct Told {
    std::string id;
    /// Nothing: a message.
    std::optional<Background::Running> work = {};
    std::string time_left = {};
    /// Empty: it waits for room.
    Rect rect = {};
    /// Of the frame that was seen when it was planned.
    float covered = 0.0F;
  };

  Shown* find(const std::string& id) noexcept;
  void gather(Ui& ui, const Background& background);
  float height_of(const Ui& ui, const Told& told, float width);
  float plan_on_page(const Ui& ui, const MessageRoom& room);
  Rect free_place_of(const Ui& ui, const Told& told, const Obstacles& obstacles);
  void plan_freely(const Ui& ui);
  bool covers_what_lies_above(const Ui& ui) const;
  void watch_what_is_covered(Ui& ui) const;
  /// What it wants done; true where it is over.
  bool draw_message(Ui& ui, const Rect& rect, Shown& shown, std::function<void()>& act);

  std::vector<Shown> messages_;
  int next_message_ = 0;
  std::vector<Told> told_;
};

}  // namespace hallux::ui
