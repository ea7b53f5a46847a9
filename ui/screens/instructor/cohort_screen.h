/// A cohort at a glance: each trainee in each operation, what happened last, and who asks for help.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "ui/jobs/course/standing_jobs.h"
#include "ui/screens/parts/limits_dialog.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class CohortScreen : public Screen {
 public:
  /// `navigator` outlives the screen. `open_inbox` leads to the inbox.
  /// needs   the person teaches a cohort
  CohortScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
               std::function<void()> open_inbox = {});

  GuideSection guide_section() const override { return GuideSection::Cohort; }
  std::string_view navigation_id() const override { return "nav.cohort"; }
  /// What was decided and answered in the meantime is read anew.
  void enter(Shell&) override { glance_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  struct LastAttempt {
    database::AttemptHeader header;
    std::string name;
  };
  struct Glance {
    database::Cohort cohort;
    std::vector<TraineeProgress> trainees;
    /// Of the columns, by name.
    std::vector<std::string> operations;
    std::vector<LastAttempt> last_attempts;
    std::vector<database::HelpRequest> open_requests;
    std::vector<database::AttemptLimit> limits;
    std::string now_utc;
    long attempts = 0;
  };
  enum Filter { All, Asking, Slipped, Idle, FilterCount };

  static Glance look(database::Session& session, database::CohortId cohort);
  static bool is_in(const TraineeProgress& trainee, int filter, std::string_view now_utc);
  using SortKey = std::pair<std::int64_t, std::string>;
  /// The best score in an operation, then the name; by the name alone where none is given.
  static SortKey sort_key(const TraineeProgress& trainee, const std::string* operation);
  static std::string last_seen(const database::TraineeStanding& trainee);
  void show(std::size_t cohort);
  void draw_head(Ui& ui, Rect& page);
  void draw_cohort_menu(Ui& ui);
  std::array<std::string, FilterCount> pill_labels(const Texts& texts) const;
  void draw_pills(Ui& ui, Rect& page);
  void draw_grid(Ui& ui, const Rect& content);
  /// As many operations as have room beside each other are a page; with more, cuts a line off
  /// `rest` that turns them.
  void turn_pages(Ui& ui, Rect& rest, const std::vector<std::string>& heads);
  /// The person and all operations; those of other pages are left out and keep their number.
  std::vector<RowColumn<TraineeProgress>> columns_of(const Ui& ui,
                                                     const std::vector<std::string>& heads) const;
  void draw_person_cell(Ui& ui, const TraineeProgress& progress, const Rect& cell) const;
  void draw_standing_cell(Ui& ui, const TraineeProgress& trainee, const std::string& operation,
                          const Rect& cell) const;
  void draw_legend(Ui& ui, const Rect& line) const;
  void draw_requests(Ui& ui, const Rect& rect);
  void draw_last_attempts(Ui& ui, const Rect& rect);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  std::function<void()> open_inbox_;
  std::vector<database::Membership> taught_;
  /// Index into taught_.
  std::size_t cohort_ = 0;
  Loaded<Glance> glance_;
  int filter_ = All;
  /// The operations that are shown.
  int first_column_ = 0, page_columns_ = 1;
  TableState table_;
  LimitsDialog limits_;
  /// Its corner, while the cohorts are listed.
  std::optional<Point> menu_;
};

}  // namespace hallux::ui
