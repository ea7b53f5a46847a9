// Cohorts, members, and dialogs over them. All is read together, so that a name and its cohort
// never come from two moments; after each change all is read again. Enrolling takes many people at
// once, in one change at the desk. What is refused in a dialog is said there, all else in a
// message.
#include "ui/screens/administrator/cohorts_screen.h"

#include <algorithm>
#include <array>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/person_cell.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

namespace {

using database::CohortMember;
using database::CohortRole;

constexpr ListPageSpec page_spec{600.0F, 0.56F, 460.0F};
constexpr float since_from = 460.0F;
constexpr float list_height = 260.0F, gap = 14.0F;

std::string_view role_id(CohortRole role) noexcept {
  return role == CohortRole::Trainee ? "role.trainee" : "role.instructor";
}

std::string member_name(const CohortMember& member) {
  return shown_name_of(member.login, member.display_name);
}

}  // namespace

CohortsScreen::Everybody CohortsScreen::read(database::Session& session) {
  database::AdministratorDesk desk = administrator_of(session);
  Everybody everybody;
  for (database::Cohort& cohort : desk.cohorts()) {
    std::vector<CohortMember> members = desk.members(cohort.id);
    // Who was erased stays a number in the statistics; there is nobody to be enrolled elsewhere.
    std::erase_if(members, [](const CohortMember& member) { return member.login.empty(); });
    std::vector<database::AttemptLimit> limits = desk.limits(cohort.id);
    everybody.cohorts.push_back({std::move(cohort), std::move(members), std::move(limits)});
  }
  everybody.people = desk.people();
  std::erase_if(everybody.people, [](const auto& person) { return person.login.empty(); });
  for (const database::ScenarioVersion& version : desk.scenarios())  // by name
    if (everybody.operations.empty() || everybody.operations.back() != version.name)
      everybody.operations.push_back(version.name);
  return everybody;
}

const CohortsScreen::Listed* CohortsScreen::chosen() const {
  for (const Listed& listed : everybody_.value().cohorts)
    if (listed.cohort.id == chosen_) return &listed;
  return nullptr;
}

void CohortsScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  everybody_.read(ui, shell, ui.text("cohorts.reading"), signed_in_, read);
  draw_page(ui, content, shell);
  draw_add_dialog(ui, shell);
  draw_enrol_dialog(ui, shell);
  draw_question(ui, shell);
  draw_limits(ui, shell);
}

void CohortsScreen::draw_page(Ui& ui, const Rect& content, Shell& shell) {
  const ButtonSpec add{ui.text("cohorts.add"), ButtonLook::Primary, Icon::Add};
  PageHead head =
      course_head(ui, *signed_in_, ui.text("cohorts.title"), ui.text("cohorts.sentence"));
  head.buttons_width = button_width(ui, add);
  const ListPage page(ui, "cohorts", head, content, page_spec);
  if (button(ui, "cohorts.add", page.buttons(), add)) {
    new_name_.emplace();
    adding_.forget_fault();
  }
  if (!everybody_.draw_until_ready(ui, "cohorts.failed", page.list(), 6)) {
    card(ui, page.side(), {});
    return;
  }
  if (!chosen_ && !everybody_.value().cohorts.empty())
    chosen_ = everybody_.value().cohorts.front().cohort.id;
  draw_cohorts(ui, page.list());
  draw_members(ui, page.side(), shell);
}

void CohortsScreen::draw_cohorts(Ui& ui, const Rect& content) {
  const std::vector<Listed>& cohorts = everybody_.value().cohorts;
  if (cohorts.empty()) {
    empty_card(ui, "cohorts.empty", content,
               {Icon::Cohorts, ui.text("cohorts.empty"), ui.text("cohorts.empty.sentence")});
    return;
  }
  const RowTable<Listed> shown{
      ui.text("cohorts.title"),
      [](const Listed& listed) { return std::to_string(listed.cohort.id.number); },
      [](const Listed& listed) { return listed.cohort.name; },
      {{{ui.text("cohorts.name")},
        [](const Listed& listed) { return listed.cohort.name; },
        name_cell},
       {{ui.text("cohorts.trainees"), 72.0F, 1.0F, Align::Right},
        [](const Listed& listed) { return std::to_string(listed.cohort.trainees); }},
       {{ui.text("cohorts.instructors"), 84.0F, 1.0F, Align::Right},
        [](const Listed& listed) { return std::to_string(listed.cohort.instructors); }}}};
  cohort_table_.chosen.clear();
  if (chosen_) cohort_table_.chosen.insert(std::to_string(chosen_->number));
  const TableResponse response = table(ui, "cohorts.row", content, shown, cohorts, cohort_table_);
  if (!response.opened) return;
  chosen_ = cohorts[static_cast<std::size_t>(*response.opened)].cohort.id;
  member_.clear();
}

void CohortsScreen::draw_members(Ui& ui, const Rect& rect, Shell& shell) {
  const Listed* listed = chosen();
  if (listed == nullptr) {
    card(ui, rect, {});
    return;
  }
  Rect inside = card(ui, rect, {});
  const ButtonSpec enrol{ui.text("cohorts.enrol"), ButtonLook::Secondary, Icon::Add};
  Rect head = take_top(inside, header_button_height, 8.0F);
  if (button(ui, "cohorts.enrol", take_right(head, button_width(ui, enrol), 12.0F), enrol)) {
    enrolment_ = Enrolment{};
    enrolling_.forget_fault();
  }
  const ButtonSpec limit{ui.text("limits.open"), ButtonLook::Secondary};
  if (button(ui, "cohorts.limits", take_right(head, button_width(ui, limit), 12.0F), limit))
    limits_.open({listed->cohort.name, everybody_.value().operations, listed->limits});
  ui.canvas().text_in(head, {Type::CardTitle, ui.theme().text}, listed->cohort.name, true);
  if (listed->members.empty()) {
    empty_card(ui, "cohorts.nobody", inside,
               {Icon::People, ui.text("cohorts.nobody"), ui.text("cohorts.nobody.sentence")});
    return;
  }
  const Rect actions = take_bottom(inside, 44.0F, 8.0F);
  draw_member_table(ui, inside, *listed);
  draw_member_actions(ui, actions, *listed, shell);
}

void CohortsScreen::draw_member_table(Ui& ui, const Rect& content, const Listed& listed) {
  using Member = const CohortMember&;
  const RowTable<CohortMember> shown{
      listed.cohort.name,
      &CohortMember::login,
      member_name,
      {{{ui.text("people.name"), 0.0F, 1.4F},
        [](Ui& own, Member member, const Rect& cell) {
          draw_person_cell(own, cell, member_name(member), member.id);
        }},
       {{ui.text("people.role"), 96.0F},
        [&ui](Member member) { return std::string(ui.text(role_id(member.role))); }},
       {{ui.text("cohorts.since"), 140.0F, 1.0F, Align::Left, since_from},
        [](Ui& own, Member member, const Rect& cell) {
          draw_moment_cell(own, cell, member.enrolled_utc,
                           {Type::Body, own.theme().text_secondary});
        }}}};
  member_table_.chosen.clear();
  if (!member_.empty()) member_table_.chosen.insert(member_);
  const TableResponse response =
      table(ui, "cohorts.member", content, shown, listed.members, member_table_);
  if (response.opened) member_ = listed.members[static_cast<std::size_t>(*response.opened)].login;
}

void CohortsScreen::draw_member_actions(Ui& ui, const Rect& line, const Listed& listed,
                                        Shell& shell) {
  const auto member =
      std::find_if(listed.members.begin(), listed.members.end(),
                   [this](const CohortMember& each) { return each.login == member_; });
  if (member == listed.members.end()) {
    ui.canvas().text_in(line, {Type::Small, ui.theme().text_caption}, ui.text("cohorts.choose"),
                        true);
    return;
  }
  const bool is_trainee = member->role == CohortRole::Trainee;
  const std::array<std::string_view, 2> actions{
      ui.text(is_trainee ? "cohorts.to_instructor" : "cohorts.to_trainee"),
      ui.text("cohorts.remove")};
  const bool has_room = ui.width_of(Type::SmallMedium, member->login) < line.w * 0.3F;
  const int pressed = action_bar(ui, "cohorts.action", line,
                                 has_room ? std::string_view(member->login) : "", actions, {});
  if (pressed == 1) removal_ = Removal{listed.cohort.id, member->login, listed.cohort.name};
  if (pressed != 0) return;
  const CohortRole role = is_trainee ? CohortRole::Instructor : CohortRole::Trainee;
  change(work_, ui, shell,
         ui.texts().say(is_trainee ? "cohorts.now_instructor" : "cohorts.now_trainee",
                        {{"login", member->login}, {"cohort", listed.cohort.name}}),
         [cohort = listed.cohort.id, login = member->login,
          role](database::AdministratorDesk& desk) { desk.enrol(cohort, login, role); });
}

void CohortsScreen::draw_add_dialog(Ui& ui, Shell& shell) {
  if (!new_name_) return;
  const Dialog shown =
      form_dialog(ui, ui.text("cohorts.add"), ui.text("cohorts.add"),
                  {adding_.fault(), adding_.is_running()}, field_label_height + field_height);
  const Answer answer = dialog(ui, "cohorts.new", shown, [&](Rect form) {
    labelled_field(ui, "cohorts.new.name", form, *new_name_,
                   {.label = ui.text("cohorts.new.name"),
                    .placeholder = ui.text("cohorts.new.example"),
                    .max_bytes = 80});
    ui.focus_first("cohorts.new.name");
    const bool has_name = new_name_->find_first_not_of(' ') != std::string::npos;
    return has_name ? std::string_view() : ui.text("people.missing.name");
  });
  if (answer == Answer::Act) add(ui, shell);
  if (answer == Answer::Keep) new_name_.reset();
}

void CohortsScreen::add(Ui& ui, Shell& shell) {
  adding_.start<database::CohortId>(
      shell, signed_in_, {std::string(ui.text("people.changing")), {}},
      [name = *new_name_](database::Session& session, WorkReport&) {
        return administrator_of(session).add_cohort(name);
      },
      [this, &shell,
       done = ui.texts().say("cohorts.added", {{"cohort", *new_name_}})](database::CohortId& id) {
        new_name_.reset();
        chosen_ = id;
        member_.clear();
        shell.say({Meaning::Good, done});
        everybody_.read_again();
      });
}

void CohortsScreen::draw_enrol_dialog(Ui& ui, Shell& shell) {
  const Listed* listed = everybody_.is_ready() ? chosen() : nullptr;
  if (!enrolment_ || listed == nullptr) return;
  const std::string title =
      ui.texts().say("cohorts.enrol.title", {{"cohort", listed->cohort.name}});
  const std::string act = enrol_label(ui.texts());
  const Dialog shown = form_dialog(ui, title, act, {enrolling_.fault(), enrolling_.is_running()},
                                   field_height + list_height + segmented_height + 2.0F * gap);
  const Answer answer = dialog(ui, "cohorts.enrolment", shown, [&](const Rect& form) {
    draw_enrol_form(ui, form, *listed);
    return enrolment_->table.chosen.empty() ? ui.text("cohorts.enrol.missing") : std::string_view();
  });
  if (answer == Answer::Act) enrol(ui, shell, listed->cohort);
  if (answer == Answer::Keep) enrolment_.reset();
}

void CohortsScreen::draw_enrol_form(Ui& ui, Rect rest, const Listed& listed) {
  search_field(ui, "cohorts.enrolment.search", take_top(rest, field_height, gap),
               enrolment_->search, ui.text("people.search"));
  ui.focus_first("cohorts.enrolment.search");
  draw_enrol_table(ui, take_top(rest, list_height, gap), listed);
  Rect line = take_top(rest, segmented_height);
  const std::array<std::string_view, 2> roles{ui.text("role.trainee"), ui.text("role.instructor")};
  line.w = std::min(line.w, segmented_width(ui, roles));
  segmented(ui, "cohorts.enrolment.role", line, roles, enrolment_->role);
}

std::string CohortsScreen::enrol_label(const Texts& texts) const {
  const auto count = static_cast<long>(enrolment_->table.chosen.size());
  if (count == 0) return std::string(texts.text("cohorts.enrol"));
  return enrolment_->role == 0 ? texts.say_count("cohorts.enrol.trainees", count)
                               : texts.say_count("cohorts.enrol.instructors", count);
}

void CohortsScreen::enrol(Ui& ui, Shell& shell, const database::Cohort& cohort) {
  const CohortRole role = enrolment_->role == 0 ? CohortRole::Trainee : CohortRole::Instructor;
  const std::set<std::string> logins = enrolment_->table.chosen;
  change(
      enrolling_, ui, shell,
      ui.texts().say_count("cohorts.enrolled", static_cast<long>(logins.size()),
                           {{"cohort", cohort.name}}),
      [id = cohort.id, logins, role](database::AdministratorDesk& desk) {
        for (const std::string& login : logins) desk.enrol(id, login, role);
      },
      [this] { enrolment_.reset(); });
}

void CohortsScreen::draw_enrol_table(Ui& ui, const Rect& rect, const Listed& listed) {
  std::vector<const database::Person*> shown;
  for (const database::Person& person : everybody_.value().people) {
    const bool is_member =
        std::any_of(listed.members.begin(), listed.members.end(),
                    [&](const CohortMember& member) { return member.id == person.id; });
    const bool is_found = contains_text(person.login, enrolment_->search) ||
                          contains_text(person.display_name, enrolment_->search);
    if (!is_member && is_found) shown.push_back(&person);
  }
  if (shown.empty()) {
    empty_card(ui, "cohorts.enrolment.none", rect,
               {Icon::People, ui.text("people.none"), ui.text("cohorts.enrol.none")});
    return;
  }
  const auto name = [](const database::Person& person) {
    return shown_name_of(person.login, person.display_name);
  };
  RowTable<database::Person> people{ui.text("cohorts.enrol"),
                                    &database::Person::login,
                                    name,
                                    {{{ui.text("people.name")}, name, name_cell},
                                     {{ui.text("people.login")}, &database::Person::login}}};
  people.row_height = 38.0F;
  people.has_checkboxes = true;
  table(ui, "cohorts.enrolment.row", rect, people, shown, enrolment_->table);
}

void CohortsScreen::draw_question(Ui& ui, Shell& shell) {
  if (!removal_) return;
  const TextValues who{{"login", removal_->login}, {"cohort", removal_->cohort_name}};
  const std::string title = ui.texts().say("cohorts.ask_remove", who),
                    consequence = ui.texts().say("cohorts.ask_remove.sentence", who);
  const Answer answer =
      question(ui, "cohorts.question",
               {title, consequence, ui.text("cohorts.remove"), ui.text("cohorts.ask_remove.keep")});
  if (answer == Answer::Waiting) return;
  const Removal removal = *std::exchange(removal_, std::nullopt);
  if (answer == Answer::Keep) return;
  change(
      work_, ui, shell, ui.texts().say("cohorts.removed", who),
      [removal](database::AdministratorDesk& desk) {
        desk.remove_from_cohort(removal.cohort, removal.login);
      },
      [this] { member_.clear(); });
}

void CohortsScreen::draw_limits(Ui& ui, Shell& shell) {
  if (!chosen_) return;
  limits_.draw(
      ui, shell,
      [cohort = *chosen_](database::Session& session, const LimitChange& change) {
        database::AdministratorDesk desk = administrator_of(session);
        if (change.attempts_max) {
          desk.set_limit(cohort, change.scenario_name, *change.attempts_max);
        } else {
          desk.clear_limit(cohort, change.scenario_name);
        }
      },
      [this] { everybody_.read_again(); });
}

void CohortsScreen::change(DeskWork& work, Ui& ui, Shell& shell, std::string done,
                           std::function<void(database::AdministratorDesk&)> change,
                           std::function<void()> after) {
  work.change_course(ui, shell, signed_in_,
                     {std::move(change), std::move(done),
                      [this, after = std::move(after)] {
                        if (after) after();
                        everybody_.read_again();
                      },
                      &work != &work_});
}

}  // namespace hallux::ui
