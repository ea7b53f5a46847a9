// What surrounds the screens. Screens are pushed and popped between two frames, so that none ends
// while it draws. A frame: preferences, work that ended, the screen with its navigation, then what
// lies over it, keys last, because a control that has the focus comes first. A locked window draws
// its lock and nothing else; what runs goes on unseen.
#include "ui/window/shell/shell.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/render/scene_painter.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/menu.h"
#include "ui/widgets/shapes.h"
#include "ui/window/shell/help.h"

namespace hallux::ui {
namespace {

constexpr float badge_inset = 0.06F, badge_share = 0.25F, badge_name_most = 220.0F;
constexpr float badge_before_name = 46.0F, badge_after_name = 16.0F;
constexpr float scale_step = 0.1F;
constexpr float largest_display_scale =
    3.0F;  // beyond, the fonts' picture outgrows common textures

}  // namespace

void Shell::push(std::unique_ptr<Screen> screen) {
  requests_.push_back({Change::Push, std::move(screen)});
}
void Shell::pop() { requests_.push_back({Change::Pop, nullptr}); }
void Shell::replace_all(std::unique_ptr<Screen> screen) {
  requests_.push_back({Change::ReplaceAll, std::move(screen)});
}

void Shell::set_visitor(std::optional<Visitor> visitor) {
  visitor_ = std::move(visitor);
  messages_.clear();
  guide_.reset();
}

void Shell::set_badge(std::string_view place, int badge) {
  if (!visitor_) return;
  for (Visitor::Place& each : visitor_->places)
    if (each.id == place) each.badge = badge;
}

bool Shell::may_leave(Ui& ui) {
  if (top() == nullptr || top()->why_not_leave().empty()) return true;
  if (top()->ask_before_leaving(ui)) {
    // What is asked is to be seen.
    close_guide();
    return false;
  }
  say({Meaning::Info, std::string(ui.text("leave.refused")), std::string(top()->why_not_leave())});
  ui.want_frame_in_s(0.0);
  return false;
}

void Shell::navigate(Ui& ui, const std::string& id) {
  if (may_leave(ui) && on_navigate_) on_navigate_(id);
}

void Shell::sign_out(Ui& ui) {
  if (may_leave(ui) && on_sign_out_) on_sign_out_();
}

// What was asked for happens between two frames: no screen ends while it draws.
void Shell::carry_out(Ui& ui) {
  if (requests_.empty()) return;
  for (Request& request : std::exchange(requests_, {})) {
    if (request.change == Change::Pop && screens_.size() < 2) continue;
    if (top() != nullptr) top()->leave(*this);
    if (request.change == Change::Pop) screens_.pop_back();
    if (request.change == Change::ReplaceAll) screens_.clear();
    if (request.screen != nullptr) screens_.push_back(std::move(request.screen));
    top()->enter(*this);
  }
  ui.want_frame_in_s(0.0);
}

void Shell::lock(std::unique_ptr<Screen> screen) {
  if (is_locked()) return;
  lock_ = std::move(screen);
  person_menu_.reset();
  is_help_shown_ = false;
  is_unlocking_ = false;
  if (top() != nullptr) top()->leave(*this);
}

// What ended meanwhile goes on below, unseen.
void Shell::draw_locked(Ui& ui) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  lock_->draw(ui, ui.display(), *this);
  if (!is_unlocking_) return;
  lock_.reset();
  if (top() != nullptr) top()->enter(*this);
  ui.want_frame_in_s(0.0);
}

void Shell::watch_idle(Ui& ui) {
  if (!visitor_ || idle_s_ <= 0.0 || !on_idle_) return;
  const double left_s = idle_s_ - ui.untouched_s();
  if (left_s > 0.0) return ui.want_frame_in_s(left_s);
  on_idle_();
  ui.want_frame_in_s(0.0);
}

void Shell::apply_preferences(Ui& ui) {
  if (ui.theme().name != preferences_.theme) ui.set_theme(preferences_.theme);
  ui.set_reduced_motion(preferences_.is_motion_reduced);
  const float scale =
      std::clamp(preferences_.scale * display_scale_, smallest_scale, largest_display_scale);
  if (std::abs(scale - ui.scale()) < 0.001F) return;
  ui.set_scale(scale);
  ui.want_frame_in_s(0.0);
}

void Shell::tell_preferences() {
  const auto tell = [](const auto& now, auto& told, const auto& listener) {
    if (now == told) return;
    told = now;
    if (listener) listener(now);
  };
  tell(preferences_, told_preferences_, on_preferences_);
  tell(hand_, told_hand_, on_hand_);
}

void Shell::draw(Ui& ui, ScenePainter& scenes) {
  scenes_ = &scenes;
  apply_preferences(ui);
  background_.collect();
  carry_out(ui);
  if (is_locked()) {
    draw_locked(ui);
    carry_out(ui);
    scenes_ = nullptr;
    return;
  }
  if (top() == nullptr || top()->surround() != WindowChrome::Badge)
    ui.canvas().fill(ui.display(), ui.theme().page);
  const float strip = messages_.plan(ui, background_, message_room(ui));
  if (top() != nullptr) {
    Rect content = draw_surround(ui);
    content.h -= strip;
    top()->draw(ui, content, *this);
    if (top()->surround() == WindowChrome::Badge) draw_badge(ui);
  }
  draw_person_menu(ui);
  draw_guide(ui, strip);
  draw_help(ui);
  messages_.draw(ui, background_);
  if (const std::optional<std::string> dropped = ui.take_dropped())
    say({Meaning::Info, std::string(ui.text("drop.refused")), *dropped});
  hear_shortcuts(ui);
  watch_idle(ui);
  tell_preferences();
  carry_out(ui);
  scenes_ = nullptr;
}

void Shell::draw(Ui& ui) {
  NoScenePainter no_scenes;
  draw(ui, no_scenes);
}

bool Shell::has_navigation() const noexcept {
  if (top() == nullptr || !visitor_) return false;
  return top()->surround() == WindowChrome::Navigation || top()->surround() == WindowChrome::Rail;
}

MessageRoom Shell::message_room(const Ui& ui) const {
  if (guide_ != nullptr) return {{}, ui.display()};
  if (!has_navigation()) return {};
  const bool is_rail = top()->surround() == WindowChrome::Rail;
  const float width = navigation_width(ui, is_rail);
  return {navigation_gap(ui, visitor_->places.size(), is_rail),
          {width, 0.0F, ui.display().w - width, ui.display().h}};
}

Rect Shell::draw_surround(Ui& ui) {
  return has_navigation() ? draw_navigation(ui, *top()) : ui.display();
}

// Where a screen belongs nowhere by itself, it belongs where it was opened from.
std::string_view Shell::chosen_place() const noexcept {
  for (auto screen = screens_.rbegin(); screen != screens_.rend(); ++screen)
    if (!(*screen)->navigation_id().empty()) return (*screen)->navigation_id();
  return {};
}

Rect Shell::draw_navigation(Ui& ui, const Screen& screen) {
  std::vector<NavigationItem> items;
  NavigationSpec spec;
  for (const Visitor::Place& place : visitor_->places) {
    if (place.id == chosen_place()) spec.chosen = static_cast<int>(items.size());
    items.push_back({place.id, place.label, place.icon, place.badge});
  }
  spec.items = items;
  spec.who = {visitor_->name, visitor_->role, visitor_->initials, visitor_->hue};
  spec.is_rail = screen.surround() == WindowChrome::Rail;
  const NavigationResponse response = side_navigation(ui, spec);
  if (response.action == NavigationAction::Help) is_help_shown_ = true;
  if (response.action == NavigationAction::Person) person_menu_ = response.person;
  if (response.action == NavigationAction::Item)
    navigate(ui, visitor_->places[static_cast<std::size_t>(response.item)].id);
  const float width = navigation_width(ui, spec.is_rail);
  return {width, 0.0F, ui.display().w - width, ui.display().h};
}

// Inside the part of the picture that both eyes see whole.
Rect Shell::badge_place(const Ui& ui) const {
  if (!visitor_) return {};
  const Rect display = ui.display();
  const float name = std::min({std::ceil(ui.width_of(Type::Small, visitor_->name)) + 1.0F,
                               badge_name_most, badge_share * display.w});
  return {display.w * badge_inset, display.h * badge_inset + 56.0F,
          badge_before_name + name + badge_after_name, 36.0F};
}

void Shell::draw_badge(Ui& ui) {
  if (!visitor_) return;
  const Rect badge = badge_place(ui);
  draw_hud_panel(ui.canvas(), ui.theme(), badge, 18.0F);
  avatar(ui, {badge.x + 22.0F, badge.mid_y()}, 12.0F, visitor_->initials, visitor_->hue);
  const float name = badge.w - badge_before_name - badge_after_name;
  ui.canvas().text_in({badge.x + 42.0F, badge.y, name, badge.h}, {Type::Small, ui.theme().text},
                      visitor_->name, true);
}

void Shell::draw_person_menu(Ui& ui) {
  if (!person_menu_) return;
  const bool is_dark = preferences_.theme == ThemeName::Dark;
  const std::array<MenuItem, 5> items{{
      {ui.text(is_dark ? "person.light" : "person.dark"), is_dark ? Icon::Light : Icon::Dark},
      {ui.text("person.help"), Icon::Help, "F1"},
      {ui.text("person.account"), Icon::People},
      {ui.text("person.sign_out"), Icon::SignOut},
      {ui.text("person.lock"), Icon::Lock},
  }};
  const float height = menu_height(items);
  const int chosen = menu(ui, "person", {person_menu_->x, person_menu_->y - height - 8.0F}, items);
  if (chosen == menu_open) return;
  person_menu_.reset();
  if (chosen == 0) preferences_.theme = is_dark ? ThemeName::Light : ThemeName::Dark;
  if (chosen == 1) is_help_shown_ = true;
  if (chosen == 2 && may_leave(ui) && on_account_) on_account_();
  if (chosen == 3) sign_out(ui);
  if (chosen == 4 && on_idle_) on_idle_();
}

// The screen below is drawn and hears nothing, as below a question: an operation pauses.
void Shell::draw_guide(Ui& ui, float strip) {
  if (guide_ == nullptr) return;
  const LayerScope layer(ui.canvas(), Layer::Popup);
  Rect content = ui.display();
  ui.canvas().fill(content, ui.theme().page);
  content.h -= strip;
  guide_->draw(ui, content, *this);
  hear_window_keys(ui);
  if (!std::exchange(is_closing_guide_, false)) return;
  guide_.reset();
  ui.want_frame_in_s(0.0);
}

void Shell::draw_help(Ui& ui) {
  if (!is_help_shown_) return;
  const bool has_guide = make_guide_ && guide_ == nullptr && top() != nullptr;
  const HelpAnswer answer = draw_shortcut_list(ui, has_guide);
  is_help_shown_ = answer == HelpAnswer::Waiting;
  if (answer != HelpAnswer::Guide) return;
  guide_ = make_guide_(top()->guide_section());
  top()->be_covered();
}

void Shell::hear_shortcuts(Ui& ui) {
  const bool may_go = top() != nullptr && top()->why_not_leave().empty();
  if (visitor_ && may_go && top()->surround() != WindowChrome::Nothing)
    for (std::size_t number = 0; number < std::min<std::size_t>(visitor_->places.size(), 6);
         ++number) {
      const Key key = static_cast<Key>(static_cast<int>(Key::Digit1) + static_cast<int>(number));
      if (ui.shortcut(with_control(key), visitor_->places[number].label))
        navigate(ui, visitor_->places[number].id);
    }
  hear_window_keys(ui);
  if (screens_.size() > 1 && ui.shortcut({Key::Escape}, ui.text("shortcut.back")) && may_leave(ui))
    pop();
}

// Wherever one is, in the guide too.
void Shell::hear_window_keys(Ui& ui) {
  if (ui.shortcut({Key::F1}, ui.text("shortcut.help"))) is_help_shown_ = true;
  if (ui.shortcut({Key::F11}, ui.text("shortcut.full_screen")))
    preferences_.is_full_screen = !preferences_.is_full_screen;
  float step = 0.0F;
  if (ui.shortcut(with_control(Key::Plus), ui.text("shortcut.larger"))) step = scale_step;
  if (ui.shortcut(with_control(Key::Minus), ui.text("shortcut.smaller"))) step = -scale_step;
  preferences_.scale = std::clamp(std::round((preferences_.scale + step) * 10.0F) / 10.0F,
                                  smallest_scale, largest_scale);
}

}  // namespace hallux::ui
