/// A person's own attempts at an operation: their scores over time, what to take from them, and each of them to open.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/jobs/course/standing_jobs.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/places.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/widgets/controls/chart_view.h"
#include "ui/widgets/controls/table.h"

namespace hallux::ui {

/// The attempts at one operation, and what the chart shows of them. Void attempts do not count and have no number.
struct OperationHistory {
  std::string scenario_name;
  std::vector<JudgedAttempt> attempts;  ///< oldest first, the void ones too
  std::vector<int> numbers;             ///< of each attempt, from 1; 0: void
  std::vector<std::size_t> counted;     ///< those with a number, in their order
  std::vector<ChartPoint> scores;       ///< of the counted ones; a gap where there is none
  /// Of the last five by the same device class; a gap where there is no score and where the planned plane guided the hand.
  std::vector<ChartPoint> medians;
  assessment::LearningState learning;
  /// How the cohort stands, by the device class of the newest counted attempt; nothing where too few people are in it.
  std::optional<database::CohortComparison> cohort = {};
};

/// By operation, that of the newest attempt first.
std::vector<OperationHistory> histories_of(const std::vector<JudgedAttempt>& attempts);
/// A line for each counted attempt, with a head: "attempt,begun_utc,for,device,guidance,score,median_of_5".
std::string csv_of(const OperationHistory& history);

class HistoryScreen : public Screen {
 public:
  /// `places` outlives the screen.
  HistoryScreen(std::shared_ptr<Visit> visit, Places& places)
      : visit_(std::move(visit)), places_(places) {}

  std::string_view navigation_id() const override { return "nav.history"; }
  void enter(Shell&) override { histories_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void start_reading(Ui& ui, Shell& shell);
  void draw_controls(Ui& ui, const Rect& controls, Shell& shell);
  void draw_history(Ui& ui, Rect page);
  void draw_chart(Ui& ui, const Rect& rect);
  void draw_facts(Ui& ui, const Rect& rect) const;
  void draw_attempts(Ui& ui, const Rect& rect);
  void copy(Ui& ui, Shell& shell) const;
  const OperationHistory& history() const;

  std::shared_ptr<Visit> visit_;
  Places& places_;
  Reading<std::vector<OperationHistory>> histories_;
  int chosen_ = 0;
  TableState table_;
};

}  // namespace hallux::ui
