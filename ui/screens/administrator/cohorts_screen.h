/// The cohorts of the course, and who is trainee and instructor in which.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/limits_dialog.h"
#include "ui/screens/parts/loaded.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class CohortsScreen : public Screen {
 public:
  explicit CohortsScreen(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(signed_in), limits_(std::move(signed_in)) {}

  GuideSection guide_section() const override { return GuideSection::Cohorts; }
  std::string_view navigation_id() const override { return "nav.cohorts"; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  struct Listed {
    database::Cohort cohort;
    std::vector<database::CohortMember> members;
    std::vector<database::AttemptLimit> limits;
  };
  struct Everybody {
    std::vector<Listed> cohorts;
    std::vector<database::Person> people;
    /// Those in the catalogue, by name.
    std::vector<std::string> operations;
  };
  struct Enrolment {
    std::string search;
    /// 0 trainee, 1 instructor.
    int role = 0;
    TableState table;
  };
  struct Removal {
    database::CohortId cohort;
    std::string login, cohort_name;
  };

  static Everybody read(database::Session& session);
  const Listed* chosen() const;
  void draw_page(Ui& ui, const Rect& content, Shell& shell);
  void draw_cohorts(Ui& ui, const Rect& content);
  void draw_members(Ui& ui, const Rect& rect, Shell& shell);
  void draw_member_table(Ui& ui, const Rect& content, const Listed& listed);
  void draw_member_actions(Ui& ui, const Rect& line, const Listed& listed, Shell& shell);
  void draw_add_dialog(Ui& ui, Shell& shell);
  void draw_enrol_dialog(Ui& ui, Shell& shell);
  void draw_enrol_table(Ui& ui, const Rect& rect, const Listed& listed);
  void draw_enrol_form(Ui& ui, Rect rest, const Listed& listed);
  std::string enrol_label(const Texts& texts) const;
  void draw_question(Ui& ui, Shell& shell);
  void draw_limits(Ui& ui, Shell& shell);
  void add(Ui& ui, Shell& shell);
  void enrol(Ui& ui, Shell& shell, const database::Cohort& cohort);
  /// Reads anew once `change` was made and says `done`; `after` is called before that.
  void change(DeskWork& work, Ui& ui, Shell& shell, std::string done,
              std::function<void(database::AdministratorDesk&)> change,
              std::function<void()> after = {});

  std::shared_ptr<SignedInSession> signed_in_;
  Loaded<Everybody> everybody_;
  std::optional<database::CohortId> chosen_;
  /// Login of the chosen member.
  std::string member_;
  TableState cohort_table_, member_table_;
  /// While a cohort is added.
  std::optional<std::string> new_name_;
  std::optional<Enrolment> enrolment_;
  std::optional<Removal> removal_;
  LimitsDialog limits_;
  /// What fails in work_ has no dialog that would say it.
  DeskWork work_, adding_, enrolling_;
};

}  // namespace hallux::ui
