/// What stays while screens come and go: their stack, who is signed in, messages, running work,
/// help, scale and theme.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/controls/navigation.h"
#include "ui/window/shell/background.h"
#include "ui/window/shell/messages.h"
#include "ui/window/shell/screen.h"

namespace hallux::ui {

class ScenePainter;

/// Who is signed in, and where they may go.
struct Visitor {
  std::string name = {}, role = {}, initials = {};
  int hue = 0;
  struct Place {
    std::string id = {}, label = {};
    Icon icon = Icon::None;
    int badge = 0;
  };
  std::vector<Place> places = {};
};

/// What a person prefers; the window keeps it.
struct Preferences {
  ThemeName theme = ThemeName::Dark;
  /// From smallest_scale to largest_scale, of the person; the screen's own multiplies it.
  float scale = 1.0F;
  bool is_full_screen = false;
  bool is_motion_reduced = false;
  bool is_saw_heard = true;
  /// While somebody operates the mouse is the saw's alone.
  bool captures_pointer = true;
  /// The id of what operates: "mouse", or a device of this station.
  std::string device = "mouse";
  /// Of the other hand, which turns what the first holds, or the view; empty: none.
  std::string second_device = {};
  /// Numbers of the people who were offered the first flight and answered, ascending.
  std::vector<std::int64_t> offered_flight = {};

  friend bool operator==(const Preferences&, const Preferences&) = default;
};
/// How the person who is signed in holds the saw; it is theirs, wherever they sign in.
struct HandPreferences {
  /// Panels that a right hand would cover change sides.
  bool is_left_handed = false;
  /// Millimetres of the saw for one of the hand, and how much of a device's force is felt at most;
  /// none: as it is set for the station.
  std::optional<double> motion_scale = std::nullopt, force_share = std::nullopt;

  friend bool operator==(const HandPreferences&, const HandPreferences&) = default;
};
inline constexpr float smallest_scale = 0.8F, largest_scale = 2.0F;

class Shell {
 public:
  /// `wake` brings the window to draw a frame, from any thread.
  explicit Shell(std::function<void()> wake = {}) : background_(std::move(wake)) {}

  // -- screens; each of these happens after the frame in which it was asked for
  void push(std::unique_ptr<Screen> screen);
  /// Goes back to the screen below; nothing at the lowest.
  void pop();
  /// Leaves every screen for this one.
  void replace_all(std::unique_ptr<Screen> screen);
  /// Whether the screen may be left now, also for the end of the window; where not, a message says
  /// why.
  bool may_leave(Ui& ui);
  std::size_t depth() const noexcept { return screens_.size(); }
  Screen* top() const noexcept { return screens_.empty() ? nullptr : screens_.back().get(); }

  // -- who is there
  /// What was said to somebody else goes.
  void set_visitor(std::optional<Visitor> visitor);
  const std::optional<Visitor>& visitor() const noexcept { return visitor_; }
  /// Where their name stands over the picture of a screen without navigation; empty where nobody
  /// is there.
  Rect badge_place(const Ui& ui) const;
  /// How much waits at a place of the navigation; nothing where it is not there.
  void set_badge(std::string_view place, int badge);
  /// Called when a place of the navigation was chosen, with its id.
  void on_navigate(std::function<void(const std::string&)> action) {
    on_navigate_ = std::move(action);
  }
  /// Called when the person asked to sign out or to change; not while the screen says why it may
  /// not be left.
  void on_sign_out(std::function<void()> action) { on_sign_out_ = std::move(action); }
  /// Called when the person asked for their own account; not while the screen says why it may not
  /// be left.
  void on_account(std::function<void()> action) { on_account_ = std::move(action); }

  // -- the guide: over the screen, which stays as it is below
  /// Makes what shows the guide at a section; it is drawn over the whole window until it asks for
  /// close_guide(). Nobody to make it: F1 has no way to one.
  void on_guide(std::function<std::unique_ptr<Screen>(GuideSection section)> make) {
    make_guide_ = std::move(make);
  }
  /// After the frame in which it was asked for.
  void close_guide() noexcept { is_closing_guide_ = true; }
  bool is_guide_shown() const noexcept { return guide_ != nullptr; }

  // -- the lock: one screen instead of all others, which stay as they are
  /// Called once nobody touched anything for so long while somebody is signed in; 0: never.
  void on_idle(double idle_s, std::function<void()> action) {
    idle_s_ = idle_s;
    on_idle_ = std::move(action);
  }
  /// Until unlock(), this screen alone is drawn and heard. The one below is told to leave(), as if
  /// it lay above it.
  void lock(std::unique_ptr<Screen> screen);
  /// After the frame in which it was asked for.
  void unlock() noexcept { is_unlocking_ = true; }
  bool is_locked() const noexcept { return lock_ != nullptr; }

  // -- messages and work
  void say(Message message) { messages_.say(std::move(message)); }
  Background& background() noexcept { return background_; }

  Preferences& preferences() noexcept { return preferences_; }
  /// What was chosen before: no change to be told of.
  void set_preferences(const Preferences& preferences) noexcept {
    preferences_ = told_preferences_ = preferences;
  }
  /// Called after the frame in which somebody chose otherwise.
  void on_preferences(std::function<void(const Preferences&)> action) {
    on_preferences_ = std::move(action);
  }
  HandPreferences& hand() noexcept { return hand_; }
  /// What this person chose before: no change to be told of.
  void set_hand(const HandPreferences& hand) noexcept { hand_ = told_hand_ = hand; }
  /// Called after the frame in which somebody chose otherwise.
  void on_hand(std::function<void(const HandPreferences&)> action) { on_hand_ = std::move(action); }
  /// The content scale that the desktop asks for on this display; the person's multiplies it.
  void set_display_scale(float scale) noexcept { display_scale_ = scale; }

  /// Draws the top screen with what surrounds it, and does what was asked for.
  void draw(Ui& ui, ScenePainter& scenes);
  /// The same where there are no graphics.
  void draw(Ui& ui);
  /// What draws bones.
  /// needs   inside Screen::draw
  ScenePainter& scenes() noexcept { return *scenes_; }

 private:
  enum class Change { Push, Pop, ReplaceAll };
  struct Request {
    Change change;
    std::unique_ptr<Screen> screen;
  };

  bool has_navigation() const noexcept;
  MessageRoom message_room(const Ui& ui) const;
  Rect draw_surround(Ui& ui);
  std::string_view chosen_place() const noexcept;
  Rect draw_navigation(Ui& ui, const Screen& screen);
  void draw_badge(Ui& ui);
  void draw_person_menu(Ui& ui);
  void draw_guide(Ui& ui, float strip);
  void draw_help(Ui& ui);
  void hear_shortcuts(Ui& ui);
  void hear_window_keys(Ui& ui);
  void navigate(Ui& ui, const std::string& id);
  void sign_out(Ui& ui);
  void apply_preferences(Ui& ui);
  void tell_preferences();
  void carry_out(Ui& ui);
  void draw_locked(Ui& ui);
  void watch_idle(Ui& ui);

  std::vector<std::unique_ptr<Screen>> screens_;
  std::vector<Request> requests_;
  std::optional<Visitor> visitor_;
  std::function<void(const std::string&)> on_navigate_;
  std::function<void()> on_sign_out_, on_account_, on_idle_;
  double idle_s_ = 0.0;
  std::unique_ptr<Screen> lock_;
  bool is_unlocking_ = false;
  std::function<std::unique_ptr<Screen>(GuideSection section)> make_guide_;
  std::unique_ptr<Screen> guide_;
  bool is_closing_guide_ = false;
  Messages messages_;
  Preferences preferences_, told_preferences_;
  std::function<void(const Preferences&)> on_preferences_;
  HandPreferences hand_, told_hand_;
  std::function<void(const HandPreferences&)> on_hand_;
  float display_scale_ = 1.0F;
  std::optional<Rect> person_menu_;
  bool is_help_shown_ = false;
  /// Of the frame that is being drawn.
  ScenePainter* scenes_ = nullptr;
  Background background_;
};

}  // namespace hallux::ui
