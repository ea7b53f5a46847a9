// The places of those who teach a cohort and of those who administer the course.
#include "ui/app/window/course.h"
#include "ui/screens/administrator/audit_screen.h"
#include "ui/screens/administrator/cohorts_screen.h"
#include "ui/screens/administrator/people_screen.h"
#include "ui/screens/administrator/scenarios_screen.h"
#include "ui/screens/instructor/cohort_screen.h"

namespace hallux::ui {

void Course::add_staff_places(const Visit& visit, std::vector<Visitor::Place>& places) const {
  const auto add = [&](const char* id, std::string_view label, Icon icon) {
    places.push_back({id, std::string(label), icon});
  };
  if (visit.person().is_administrator) {
    add("nav.people", texts_.text("place.people"), Icon::People);
    add("nav.cohorts", texts_.text("place.cohorts"), Icon::Cohorts);
    add("nav.scenarios", texts_.text("place.scenarios"), Icon::Scenarios);
    add("nav.records", texts_.text("place.records"), Icon::Audit);
  }
  if (visit.taught().empty()) return;
  add("nav.cohort", texts_.text("place.cohort"), Icon::Cohort);
  add("nav.inbox", texts_.text("place.inbox"), Icon::Inbox);
}

bool Course::show_staff_place(const std::string& id) {
  std::unique_ptr<Screen> screen;
  if (id == "nav.people") screen = std::make_unique<PeopleScreen>(visit_, cost_);
  if (id == "nav.cohorts") screen = std::make_unique<CohortsScreen>(visit_);
  if (id == "nav.scenarios") screen = std::make_unique<ScenariosScreen>(visit_);
  if (id == "nav.records") screen = std::make_unique<RecordsScreen>(visit_);
  if (id == "nav.cohort")
    screen =
        std::make_unique<CohortScreen>(visit_, *this, [this] { show_staff_place("nav.inbox"); });
  if (id == "nav.inbox")
    screen = std::make_unique<InboxScreen>(visit_, *this, answer_drafts_,
                                           [this](int open) { show_badge(open); });
  if (screen == nullptr) return false;
  shell_.replace_all(std::move(screen));
  return true;
}

void Course::count_questions() {
  if (visit_->taught().empty()) return;
  auto open = std::make_shared<int>(0);
  shell_.background().start(
      std::string(texts_.text("course.counting")),
      [open, visit = visit_](WorkReport&) {
        *open = visit->in_turn([](database::Session& session, database::Database&) {
          return count_open(read_inbox(session));
        });
      },
      // Somebody else may have come in meanwhile. A count that failed leaves no badge; the inbox says why.
      [this, open, visit = visit_](WorkEnd end, const std::string&) {
        if (end == WorkEnd::Done && visit == visit_) show_badge(*open);
      });
}

void Course::show_badge(int open_questions) {
  if (!shell_.visitor()) return;
  Visitor visitor = *shell_.visitor();
  for (Visitor::Place& place : visitor.places)
    if (place.id == "nav.inbox") place.badge = open_questions;
  shell_.set_visitor(std::move(visitor));
}

}  // namespace hallux::ui
