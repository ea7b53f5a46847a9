/// A trainee as their instructor sees them: how they stand in each operation, and their attempts.
#pragma once

#include <string>
#include <vector>

#include "ui/jobs/course/standing_jobs.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class TraineeScreen : public Screen {
 public:
  /// `navigator` outlives the screen.
  TraineeScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                database::CohortId cohort, database::PersonId trainee)
      : signed_in_(std::move(signed_in)),
        navigator_(navigator),
        cohort_(cohort),
        trainee_(trainee) {}

  GuideSection guide_section() const override { return GuideSection::Cohort; }
  std::string_view navigation_id() const override { return "nav.cohort"; }
  /// What was decided in the meantime is read anew.
  void enter(Shell&) override { file_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  struct File {
    std::string cohort_name;
    TraineeProgress progress;
    /// Newest first.
    std::vector<database::AttemptHeader> attempts;
    std::string now_utc;
  };

  static File read(database::Session& session, database::CohortId cohort,
                   database::PersonId trainee);
  bool draw_head(Ui& ui, Rect& page);
  void draw_standings(Ui& ui, Rect& page) const;
  void draw_standing(Ui& ui, const Rect& rect, std::size_t operation) const;
  void draw_attempts(Ui& ui, const Rect& content);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  database::CohortId cohort_;
  database::PersonId trainee_;
  Loaded<File> file_;
  TableState table_;
};

}  // namespace hallux::ui
