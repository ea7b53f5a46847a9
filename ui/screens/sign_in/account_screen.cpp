// One's own account. What a person may not change is a line; what they may is a button that opens a
// dialog. Passwords leave the screen only as secrets that are wiped, and what was typed stays where
// it is refused.
#include "ui/screens/sign_in/account_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/choice.h"

namespace hallux::ui {

namespace {

constexpr float side_width = 440.0F, person_height = 412.0F, row_height = 44.0F;
constexpr std::array<std::int32_t, 5> lock_choices_min{5, 10, 20, 30, 60};

/// The longest that is not longer than what is set: somebody may have set another by hand.
int lock_choice_of(std::int32_t minutes) {
  int choice = 0;
  for (std::size_t i = 0; i < lock_choices_min.size(); ++i) {
    if (lock_choices_min[i] <= minutes) choice = static_cast<int>(i);
  }
  return choice;
}

}  // namespace

void AccountScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  const auto rows = static_cast<float>(std::max<std::size_t>(signed_in_->memberships().size(), 3));
  const float cohorts_height = 80.0F + row_height * rows;
  const Page scrolled(ui, "account", ui.text("account.title"), content,
                      140.0F + person_height + space::between_cards + cohorts_height);
  Rect page = scrolled.rect();
  PageHead head =
      course_head(ui, *signed_in_, ui.text("account.title"), ui.text("account.sentence"));
  head.has_back = true;
  if (page_head(ui, "account", page, head).is_back_pressed) shell.pop();
  Panes panes = panes_of(page, side_width, cohorts_height);
  if (are_panes_stacked(page.w)) {
    panes.side.y = panes.main.y + person_height + space::between_cards;
  }
  panes.main.h = person_height;
  panes.side.h = cohorts_height;
  draw_person(ui, card(ui, panes.main, ui.text("account.person")), shell);
  draw_cohorts(ui, card(ui, panes.side, ui.text("account.cohorts"), space::side_card));
  if (exporting_.is_open()) draw_export(ui, shell);
  if (!typed_) return;
  const Answer answer =
      draw_password_dialog(ui, *typed_, changing_.fault(), changing_.is_running());
  if (answer == Answer::Keep) typed_.reset();
  if (answer == Answer::Act) change_password(ui, shell);
}

void AccountScreen::draw_lock(Ui& ui, Rect& rest, Shell& shell) {
  const auto minutes = static_cast<std::int32_t>(std::lround(signed_in_->idle_lock_s() / 60.0));
  if (!signed_in_->person().is_administrator) {
    return fact_line(ui, rest, ui.text("account.lock"),
                     ui.texts().say("account.lock.minutes", {{"count", std::to_string(minutes)}}));
  }
  std::array<std::string, lock_choices_min.size()> words;
  std::array<std::string_view, lock_choices_min.size()> labels;
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = std::to_string(lock_choices_min[i]);
    labels[i] = words[i] = ui.texts().say("account.lock.minutes", {{"count", words[i]}});
  }
  Rect line = take_top(rest, segmented_height, 10.0F);
  const Rect track = take_right(line, std::min(segmented_width(ui, labels), 0.7F * line.w));
  ui.canvas().text_in(line, {Type::Small, ui.theme().text_secondary}, ui.text("account.lock"),
                      true);
  int chosen = lock_choice_ >= 0 ? lock_choice_ : lock_choice_of(minutes);
  if (segmented(ui, "account.lock", track, labels, chosen) && !setting_.is_running()) {
    lock_choice_ = chosen;
    set_lock(ui, shell, lock_choices_min[static_cast<std::size_t>(chosen)]);
  }
}

void AccountScreen::draw_hand(Ui& ui, Rect& rest, HandPreferences& hand) {
  const std::array<std::string_view, 2> labels{ui.text("account.hand.right"),
                                               ui.text("account.hand.left")};
  Rect line = take_top(rest, segmented_height, 10.0F);
  const Rect track = take_right(line, std::min(segmented_width(ui, labels), 0.7F * line.w));
  ui.canvas().text_in(line, {Type::Small, ui.theme().text_secondary}, ui.text("account.hand"));
  int chosen = hand.is_left_handed ? 1 : 0;
  if (segmented(ui, "account.hand", track, labels, chosen)) hand.is_left_handed = chosen == 1;
}

void AccountScreen::set_lock(Ui& ui, Shell& shell, std::int32_t minutes) {
  setting_.change(
      shell, signed_in_,
      {std::string(ui.text("account.lock.changing")), std::string(ui.text("account.lock.failed"))},
      [minutes](database::Session& session) {
        administrator_of(session).set_idle_lock_min(minutes);
      },
      [&shell,
       said = ui.texts().say("account.lock.changed", {{"count", std::to_string(minutes)}})] {
        shell.say({Meaning::Good, said});
      });
}

void AccountScreen::draw_person(Ui& ui, Rect rest, Shell& shell) {
  const database::Person& person = signed_in_->person();
  fact_line(ui, rest, ui.text("people.login"), person.login);
  fact_line(ui, rest, ui.text("account.name"),
            person.display_name.empty() ? person.login : person.display_name);
  fact_line(ui, rest, ui.text("account.role"),
            ui.text(person.is_administrator ? "role.administrator" : "account.member"));
  fact_moment(ui, rest, ui.text("account.since"), person.created_utc);
  if (const std::optional<LocalTime> now = local_time(utc_now_text()))
    fact_line(ui, rest, ui.text("account.times"),
              ui.texts().say("account.times.value", {{"offset", offset_text(now->offset_min)}}));
  draw_lock(ui, rest, shell);
  draw_hand(ui, rest, shell.hand());
  const ButtonSpec take{ui.text("account.export"), ButtonLook::Secondary};
  if (button_in_line(ui, "account.export", take_bottom(rest, button_height, 12.0F), take))
    exporting_.open();
  const ButtonSpec change{ui.text("account.password.act"), ButtonLook::Secondary, Icon::Lock};
  if (!button_in_line(ui, "account.change_password", take_bottom(rest, button_height), change))
    return;
  typed_.emplace();
  changing_.forget_fault();
}

void AccountScreen::draw_cohorts(Ui& ui, Rect rest) const {
  if (signed_in_->memberships().empty()) {
    text_line(ui, rest, Type::Small, ui.theme().text_secondary, ui.text("account.no_cohorts"));
    return;
  }
  for (const database::Membership& each : signed_in_->memberships()) {
    Rect line = take_top(rest, row_height);
    const std::string_view role =
        ui.text(each.role == database::CohortRole::Instructor ? "role.instructor" : "role.trainee");
    const Rect place = take_right(line, ui.width_of(Type::Small, role) + 2.0F, 12.0F);
    ui.canvas().text_in(place, {Type::Small, ui.theme().text_secondary, Align::Right}, role);
    ui.canvas().text_in(line, {Type::BodyMedium, ui.theme().text}, each.cohort_name, true);
  }
}

/// What was typed stays where it is refused, so that only what is wrong is typed again.
void AccountScreen::change_password(Ui& ui, Shell& shell) {
  struct Secrets {
    database::SecretText old_password, new_password;
  };
  if (changing_.is_running()) return;
  std::string old_password = typed_->old_password, new_password = typed_->new_password;
  const auto secrets = std::make_shared<Secrets>(
      Secrets{database::SecretText::take(old_password), database::SecretText::take(new_password)});
  changing_.change(
      shell, signed_in_, {std::string(ui.text("account.password.changing")), {}},
      [secrets, cost = cost_](database::Session& session) {
        session.change_password(secrets->old_password, secrets->new_password, cost);
      },
      [this, &shell, said = std::string(ui.text("account.password.changed"))] {
        typed_.reset();
        shell.say({Meaning::Good, said});
      });
}

void AccountScreen::draw_export(Ui& ui, Shell& shell) {
  exporting_.draw(
      ui, shell, signed_in_,
      {"account.export", ui.text("account.export.title"), ui.text("account.export.sentence")},
      [](database::Session& session, const std::filesystem::path& folder,
         const Progress& progress) { return trainee_of(session).export_own(folder, progress); });
}

}  // namespace hallux::ui
