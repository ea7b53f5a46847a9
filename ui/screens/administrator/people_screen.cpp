// People, one of them chosen beside the list, and what may be done with them. A button that cannot
// be pressed says why: the last administrator stays one, nobody disables or erases themselves. What
// cannot be taken back is asked once more; a code is shown once and never written into the list.
#include "ui/screens/administrator/people_screen.h"

#include <algorithm>
#include <array>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/person_cell.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

namespace {

using database::Person;

/// The card of a person: its place on the page, and its parts.
namespace person_card {
constexpr float width = 312.0F, least_height = 320.0F, above = 100.0F;
constexpr float head = 40.0F, below_head = 12.0F, fact = 28.0F, below_button = 8.0F,
                below_reason = 12.0F;
constexpr float fact_count = 6.0F, button_count = 6.0F;
}  // namespace person_card
constexpr float search_width = 220.0F, roomy_from = 700.0F;

bool can_administer(const Person& person) noexcept {
  return person.is_administrator && !person.is_disabled && person.has_password;
}

std::string_view admission_id(Admission admission) noexcept {
  constexpr std::array<std::string_view, 4> ids{"people.active", "people.invited",
                                                "people.needs_code", "people.disabled"};
  return ids[static_cast<std::size_t>(admission)];
}

Meaning meaning_of(Admission admission) noexcept {
  constexpr std::array<Meaning, 4> meanings{Meaning::Good, Meaning::Info, Meaning::Warn,
                                            Meaning::Neutral};
  return meanings[static_cast<std::size_t>(admission)];
}

bool is_in_tab(Admission admission, int tab) noexcept {
  if (tab == 0) return true;
  if (tab == 1) return admission == Admission::Active;
  if (tab == 2) return admission == Admission::Invited || admission == Admission::NeedsCode;
  return admission == Admission::Disabled;
}

}  // namespace

Admission admission_of(const Person& person, std::string_view now_utc) noexcept {
  if (person.is_disabled) return Admission::Disabled;
  if (person.has_password) return Admission::Active;
  return person.code_expires_utc > now_utc ? Admission::Invited : Admission::NeedsCode;
}

PeopleScreen::List PeopleScreen::read(database::Session& session) {
  database::AdministratorDesk desk = administrator_of(session);
  const std::string now = utc_now_text();
  List list;
  for (const Person& person : desk.people()) {
    // Who has no login was erased, or came with an import: a number in the statistics, nobody to be
    // managed.
    if (!person.login.empty()) {
      list.push_back({person, {}, false, false, admission_of(person, now)});
    }
  }
  for (const database::Cohort& cohort : desk.cohorts()) {
    for (const database::CohortMember& member : desk.members(cohort.id)) {
      const auto listed = std::find_if(list.begin(), list.end(), [&](const Listed& each) {
        return each.person.id == member.id;
      });
      if (listed == list.end()) continue;
      listed->cohorts += (listed->cohorts.empty() ? "" : ", ") + cohort.name;
      const bool teaches = member.role == database::CohortRole::Instructor;
      (teaches ? listed->is_instructor : listed->is_trainee) = true;
    }
  }
  return list;
}

std::string_view PeopleScreen::role_id(const Listed& listed) noexcept {
  if (listed.person.is_administrator) return "role.administrator";
  if (listed.is_instructor) return "role.instructor";
  return listed.is_trainee ? "role.trainee" : "people.no_role";
}

std::string PeopleScreen::name_of(const Listed& listed) {
  return shown_name_of(listed.person.login, listed.person.display_name);
}

std::vector<RowColumn<PeopleScreen::Listed>> PeopleScreen::columns_of(const Ui& ui) const {
  return {
      {{ui.text("people.name"), 0.0F, 1.7F},
       [](Ui& own, const Listed& listed, const Rect& cell) {
         draw_person_cell(own, cell, name_of(listed), listed.person.id);
       },
       {},
       by(name_of)},
      {{ui.text("people.login")}, login_of, plain_cell, by(login_of)},
      {{ui.text("people.role"), 96.0F, 1.0F, Align::Left, roomy_from},
       [&ui](const Listed& listed) { return std::string(ui.text(role_id(listed))); },
       plain_cell,
       by(role_id)},
      {{ui.text("people.cohorts"), 0.0F, 1.0F, Align::Left, roomy_from},
       &Listed::cohorts,
       plain_cell,
       by(&Listed::cohorts)},
      {{ui.text("people.state"), 112.0F},
       [](Ui& own, const Listed& listed, const Rect& cell) {
         pill(own, {cell.x, cell.mid_y()}, own.text(admission_id(listed.admission)),
              meaning_of(listed.admission));
       },
       {},
       by(&Listed::admission)},
      {{ui.text("people.seen"), 88.0F, 1.0F, Align::Left, roomy_from},
       [&ui, this](const Listed& listed) {
         return ago_text(ui.texts(), listed.person.last_sign_in_utc, now_utc_);
       },
       plain_cell,
       by([](const Listed& listed) { return listed.person.last_sign_in_utc; })},
  };
}

std::vector<const PeopleScreen::Listed*> PeopleScreen::found() const {
  std::vector<const Listed*> found;
  for (const Listed& listed : people_.value()) {
    const bool is_found = contains_text(listed.person.login, search_) ||
                          contains_text(listed.person.display_name, search_);
    if (is_found && is_in_tab(listed.admission, tab_)) found.push_back(&listed);
  }
  return found;
}

const PeopleScreen::Listed* PeopleScreen::chosen() const {
  for (const Listed& listed : people_.value())
    if (listed.person.login == chosen_) return &listed;
  return nullptr;
}

bool PeopleScreen::is_last_administrator(const Person& person) const {
  const List& list = people_.value();
  return can_administer(person) &&
         std::count_if(list.begin(), list.end(),
                       [](const Listed& listed) { return can_administer(listed.person); }) == 1;
}

void PeopleScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (people_.is_new()) now_utc_ = utc_now_text();
  people_.read(ui, shell, ui.text("people.reading"), signed_in_, read);
  draw_page(ui, content, shell);
  draw_dialogs(ui, shell);
  draw_question(ui, shell);
}

void PeopleScreen::draw_page(Ui& ui, const Rect& content, Shell& shell) {
  const ButtonSpec add{ui.text("people.add"), ButtonLook::Primary, Icon::Add};
  PageHead head = course_head(ui, *signed_in_, ui.text("people.title"), ui.text("people.sentence"));
  head.buttons_width = search_width + 12.0F + button_width(ui, add);
  const Listed* const listed = people_.has_value() ? chosen() : nullptr;
  ListPageSpec spec{person_card::width, 1.0F, person_card::least_height, 480.0F};
  if (listed != nullptr)
    spec.side_height = std::max(person_card::least_height, person_height(ui, *listed));
  spec.least_height = std::max(spec.least_height, person_card::above + spec.side_height);
  const ListPage page(ui, "people", head, content, spec);
  draw_head_buttons(ui, page.buttons(), add);
  if (!people_.draw_until_ready(ui, "people.failed", page.list(), 8)) {
    card(ui, page.side(), {});
    return;
  }
  draw_list(ui, page.list());
  draw_person(ui, page.side(), shell);
}

void PeopleScreen::draw_head_buttons(Ui& ui, Rect buttons, const ButtonSpec& add) {
  if (button(ui, "people.add", take_right(buttons, button_width(ui, add), 12.0F), add))
    added_.emplace(), adding_.forget_fault();
  search_field(ui, "people.search", buttons, search_, ui.text("people.search"));
  if (ui.shortcut({Key::Slash}, ui.text("people.search"))) ui.focus("people.search");
}

void PeopleScreen::draw_list(Ui& ui, const Rect& content) {
  Rect rest = content;
  std::array<long, 4> counts{};
  for (const Listed& listed : people_.value())
    for (int tab = 0; tab < 4; ++tab)
      counts[static_cast<std::size_t>(tab)] += is_in_tab(listed.admission, tab) ? 1 : 0;
  const auto label = [&](std::string_view id, std::size_t tab) {
    return ui.texts().say(id, {{"count", grouped(counts[tab])}});
  };
  const std::array<std::string, 4> words{label("people.tab.all", 0), label("people.tab.active", 1),
                                         label("people.tab.invited", 2),
                                         label("people.tab.disabled", 3)};
  const std::array<std::string_view, 4> labels{words[0], words[1], words[2], words[3]};
  tabs(ui, "people.tab", take_top(rest, tabs_height, 4.0F), labels, tab_);
  std::vector<const Listed*> shown = found();
  if (!shown.empty()) return draw_table(ui, rest, std::move(shown));
  empty_card(ui, "people.none", rest,
             {Icon::People, ui.text("people.none"), ui.text("people.none.sentence")});
}

void PeopleScreen::draw_table(Ui& ui, const Rect& content, std::vector<const Listed*> shown) {
  const RowTable<Listed> people{ui.text("people.title"), login_of, name_of, columns_of(ui)};
  sort_rows(shown, people.columns, table_.sort, 0);
  table_.chosen = {chosen_};
  const TableResponse response = table(ui, "people.row", content, people, shown, table_);
  if (response.opened) chosen_ = shown[static_cast<std::size_t>(*response.opened)]->person.login;
}

void PeopleScreen::draw_person(Ui& ui, const Rect& content, Shell& shell) {
  const Rect inside = card(ui, content, {}, space::side_card);
  const Listed* listed = chosen();
  if (listed == nullptr) {
    empty_card(ui, "people.nobody", inside,
               {Icon::People, ui.text("people.nobody"), ui.text("people.nobody.sentence")});
    return;
  }
  Rect rest = inside;
  const std::string name = shown_name_of(listed->person.login, listed->person.display_name);
  Rect head = take_top(rest, person_card::head, person_card::below_head);
  person_avatar(ui, {head.x + 20.0F, head.mid_y()}, 20.0F, name, listed->person.id);
  ui.canvas().text_in({head.x + 54.0F, head.y, head.w - 54.0F, head.h},
                      {Type::CardTitle, ui.theme().text}, name, true);
  draw_facts(ui, rest, *listed);
  take_top(rest, person_card::below_head);
  draw_rename_button(ui, rest, *listed);
  draw_code_button(ui, rest, *listed);
  draw_role_button(ui, rest, *listed, shell);
  draw_disable_button(ui, rest, *listed, shell);
  draw_export_button(ui, rest, *listed);
  draw_erase_button(ui, rest, *listed);
}

PeopleScreen::WhyNot PeopleScreen::why_not(const Ui& ui, const Listed& listed) const {
  const bool is_self = listed.person.id == signed_in_->person().id;
  const bool is_last = is_last_administrator(listed.person);
  WhyNot why;
  if (is_self) why.code = ui.text("people.reset.own");
  if (is_last) why.role = ui.text("people.last_administrator.role");
  if (!listed.person.is_disabled && (is_last || is_self))
    why.disable = ui.text(is_last ? "people.last_administrator" : "people.disable.own");
  if (is_self) why.erase = ui.text("people.erase.own");
  return why;
}

float PeopleScreen::person_height(const Ui& ui, const Listed& listed) const {
  const float facts =
      person_card::fact_count + (listed.admission == Admission::Invited ? 1.0F : 0.0F);
  float height = 2.0F * space::side_card + person_card::head + 2.0F * person_card::below_head +
                 facts * person_card::fact +
                 person_card::button_count * (button_height + person_card::below_button);
  const WhyNot why = why_not(ui, listed);
  for (const std::string_view words : {why.code, why.role, why.disable, why.erase}) {
    if (words.empty()) continue;
    height +=
        ui.paragraph_height(Type::Small, words, person_card::width - 2.0F * space::side_card) +
        person_card::below_reason;
  }
  return height;
}

void PeopleScreen::draw_facts(Ui& ui, Rect& rest, const Listed& listed) const {
  const Person& person = listed.person;
  fact_line(ui, rest, ui.text("people.login"), person.login);
  fact_line(ui, rest, ui.text("people.role"), ui.text(role_id(listed)));
  fact_line(
      ui, rest, ui.text("people.cohorts"),
      listed.cohorts.empty() ? ui.text("people.no_cohort") : std::string_view(listed.cohorts));
  fact_line(ui, rest, ui.text("people.state"), ui.text(admission_id(listed.admission)));
  if (listed.admission == Admission::Invited)
    fact_moment(ui, rest, ui.text("people.code_until"), person.code_expires_utc);
  fact_line(ui, rest, ui.text("people.seen"),
            ago_text(ui.texts(), person.last_sign_in_utc, now_utc_));
  fact_moment(ui, rest, ui.text("people.added"), person.created_utc);
}

namespace {

/// A button over the width of the card, and why it cannot be pressed where that is so.
bool wide_button(Ui& ui, std::string_view id, Rect& rest, ButtonSpec spec,
                 std::string_view why_not) {
  spec.why_off = why_not;
  const bool is_pressed =
      button(ui, id, take_top(rest, button_height, person_card::below_button), spec);
  if (!why_not.empty())
    text_line(ui, rest, Type::Small, ui.theme().text_caption, why_not, person_card::below_reason);
  return is_pressed;
}

}  // namespace

void PeopleScreen::draw_rename_button(Ui& ui, Rect& rest, const Listed& listed) {
  const std::string& name = listed.person.display_name;
  if (!wide_button(ui, "people.rename", rest, {ui.text("people.rename")}, {})) return;
  renamed_ = NameForm{listed.person.login, name, name};
  renaming_.forget_fault();
}

void PeopleScreen::draw_code_button(Ui& ui, Rect& rest, const Listed& listed) {
  const ButtonSpec spec{ui.text("people.reset"), ButtonLook::Secondary, Icon::Lock};
  if (!wide_button(ui, "people.reset", rest, spec, why_not(ui, listed).code)) return;
  asked_ = Asked{Asked::Deed::Reset, listed.person.login};
}

void PeopleScreen::draw_role_button(Ui& ui, Rect& rest, const Listed& listed, Shell& shell) {
  const std::string& login = listed.person.login;
  const bool is_administrator = listed.person.is_administrator;
  const ButtonSpec spec{
      ui.text(is_administrator ? "people.unmake_administrator" : "people.make_administrator")};
  if (!wide_button(ui, "people.administrator", rest, spec, why_not(ui, listed).role)) return;
  if (is_administrator) {
    asked_ = Asked{Asked::Deed::TakeRole, login};
    return;
  }
  change(ui, shell, ui.texts().say("people.made_administrator", {{"login", login}}),
         [login](database::AdministratorDesk& desk) { desk.set_administrator(login, true); });
}

void PeopleScreen::draw_disable_button(Ui& ui, Rect& rest, const Listed& listed, Shell& shell) {
  const std::string& login = listed.person.login;
  if (listed.person.is_disabled) {
    if (wide_button(ui, "people.enable", rest, {ui.text("people.enable")}, {}))
      change(ui, shell, ui.texts().say("people.enabled", {{"login", login}}),
             [login](database::AdministratorDesk& desk) { desk.set_disabled(login, false); });
    return;
  }
  if (wide_button(ui, "people.disable", rest, {ui.text("people.disable"), ButtonLook::Danger},
                  why_not(ui, listed).disable))
    asked_ = Asked{Asked::Deed::Disable, login};
}

void PeopleScreen::draw_export_button(Ui& ui, Rect& rest, const Listed& listed) {
  if (!wide_button(ui, "people.export", rest, {ui.text("people.export")}, {})) return;
  exported_ = listed.person.login;
  exporting_.open();
}

void PeopleScreen::draw_export(Ui& ui, Shell& shell) {
  const std::string title = ui.texts().say("people.export.title", {{"login", exported_}});
  exporting_.draw(
      ui, shell, signed_in_, {"people.export", title, ui.text("people.export.sentence")},
      [login = exported_](database::Session& session, const std::filesystem::path& folder,
                          const Progress& progress) {
        return administrator_of(session).export_person(login, folder, progress);
      });
}

void PeopleScreen::draw_erase_button(Ui& ui, Rect& rest, const Listed& listed) {
  if (!wide_button(ui, "people.erase", rest, {ui.text("people.erase"), ButtonLook::Danger},
                   why_not(ui, listed).erase))
    return;
  erased_.emplace(listed.person.login);
  erasing_.forget_fault();
}

void PeopleScreen::draw_dialogs(Ui& ui, Shell& shell) {
  if (exporting_.is_open()) return draw_export(ui, shell);
  if (erased_) {
    const Answer answer = draw_erase_dialog(ui, *erased_, erasing_.fault(), erasing_.is_running());
    if (answer == Answer::Act) erase(ui, shell);
    if (answer == Answer::Keep) erased_.reset();
    return;
  }
  if (code_) {
    const CodeAnswer answer = draw_code_dialog(ui, *code_);
    if (answer == CodeAnswer::Copied)
      shell.say({Meaning::Good, std::string(ui.text("people.code.copied")),
                 std::string(ui.text("people.code.copied.sentence"))});
    if (answer == CodeAnswer::Done) code_.reset();
    if (answer != CodeAnswer::Waiting) ui.want_frame_in_s(0.0);
    return;
  }
  if (renamed_) {
    const Answer answer =
        draw_name_dialog(ui, *renamed_, renaming_.fault(), renaming_.is_running());
    if (answer == Answer::Act) rename(ui, shell);
    if (answer == Answer::Keep) renamed_.reset();
    return;
  }
  if (!added_) return;
  const Answer answer = draw_add_dialog(ui, *added_, adding_.fault(), adding_.is_running());
  if (answer == Answer::Act) add(ui, shell);
  if (answer == Answer::Keep) added_.reset();
}

void PeopleScreen::draw_question(Ui& ui, Shell& shell) {
  if (!asked_) return;
  const TextValues who{{"login", asked_->login}};
  const auto ask = [&](std::string_view title, std::string_view consequence, std::string_view act) {
    return question(ui, "people.question",
                    {ui.texts().say(title, who), ui.texts().say(consequence, who), ui.text(act),
                     ui.text("people.keep")});
  };
  Answer answer = Answer::Waiting;
  if (asked_->deed == Asked::Deed::Reset)
    answer = ask("people.ask_reset", "people.ask_reset.sentence", "people.ask_reset.act");
  if (asked_->deed == Asked::Deed::Disable)
    answer = ask("people.ask_disable", "people.ask_disable.sentence", "people.disable");
  if (asked_->deed == Asked::Deed::TakeRole)
    answer = ask("people.ask_unmake", "people.ask_unmake.sentence", "people.unmake_administrator");
  if (answer == Answer::Waiting) return;
  const Asked asked = *std::exchange(asked_, std::nullopt);
  if (answer == Answer::Keep) return;
  const std::string& login = asked.login;
  if (asked.deed == Asked::Deed::Reset) reset(ui, shell, login);
  if (asked.deed == Asked::Deed::Disable)
    change(ui, shell, ui.texts().say("people.was_disabled", {{"login", login}}),
           [login](database::AdministratorDesk& desk) { desk.set_disabled(login, true); });
  if (asked.deed == Asked::Deed::TakeRole)
    change(ui, shell, ui.texts().say("people.unmade_administrator", {{"login", login}}),
           [login](database::AdministratorDesk& desk) { desk.set_administrator(login, false); });
}

void PeopleScreen::add(Ui& ui, Shell& shell) {
  const database::NewPerson person{added_->login, added_->display_name, added_->is_administrator};
  adding_.start<database::IssuedCode>(
      shell, signed_in_, {std::string(ui.text("people.adding")), {}},
      [person, cost = cost_](database::Session& session, WorkReport&) {
        return administrator_of(session).add_person_with_code(person, cost).issued;
      },
      [this, login = person.login](database::IssuedCode& issued) {
        added_.reset();
        chosen_ = login;
        code_.emplace(ShownCode{login, std::move(issued)});
        people_.read_again();
      });
}

void PeopleScreen::reset(Ui& ui, Shell& shell, const std::string& login) {
  work_.start<database::IssuedCode>(
      shell, signed_in_,
      {std::string(ui.text("people.changing")), std::string(ui.text("people.not_changed"))},
      [login, cost = cost_](database::Session& session, WorkReport&) {
        return administrator_of(session).reset(login, cost);
      },
      [this, login](database::IssuedCode& issued) {
        code_.emplace(ShownCode{login, std::move(issued)});
        people_.read_again();
      });
}

void PeopleScreen::rename(Ui& ui, Shell& shell) {
  if (renaming_.is_running()) return;
  renaming_.change(
      shell, signed_in_, {std::string(ui.text("people.changing")), {}},
      [form = *renamed_](database::Session& session) {
        administrator_of(session).correct_name(form.login, form.name);
      },
      [this, &shell,
       said = ui.texts().say("people.renamed",
                             {{"login", renamed_->login}, {"name", renamed_->name}})] {
        renamed_.reset();
        shell.say({Meaning::Good, said});
        people_.read_again();
      });
}

void PeopleScreen::erase(Ui& ui, Shell& shell) {
  if (erasing_.is_running()) return;
  std::string typed = erased_->password;
  const auto secret = std::make_shared<database::SecretText>(database::SecretText::take(typed));
  const database::EraseRequest request{erased_->login, erased_->reason, erased_->with_recordings};
  erasing_.start<database::ErasedPieces>(
      shell, signed_in_, {std::string(ui.text("people.erase.running")), {}},
      [secret, request, cost = cost_](database::Session& session, WorkReport& report) {
        const database::PasswordProof proof = session.prove(*secret, cost);
        return administrator_of(session).erase_person(
            request, proof, [&report](double share) { return report.reached(share); });
      },
      [this, &shell, said = std::string(ui.text("people.erase.done")),
       whole = std::string(ui.text("people.erase.done.sentence")),
       held = std::string(ui.text("people.erase.log"))](database::ErasedPieces& erased) {
        erased_.reset();
        chosen_.clear();
        shell.say({Meaning::Good, said, erased.is_log_cleared ? whole : held});
        people_.read_again();
      });
}

void PeopleScreen::change(Ui& ui, Shell& shell, std::string done,
                          std::function<void(database::AdministratorDesk&)> change) {
  work_.change_course(ui, shell, signed_in_,
                      {std::move(change), std::move(done), [this] { people_.read_again(); }});
}

}  // namespace hallux::ui
