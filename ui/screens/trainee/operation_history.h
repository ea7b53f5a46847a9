/// A person's attempts at one operation, by time: what a history shows of them, without drawing.
/// Inside this corner only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/jobs/course/standing_jobs.h"
#include "ui/widgets/controls/chart_view.h"

namespace hallux::ui {

/// The attempts at one operation, and what the chart shows of them. Void attempts do not count: the
/// chart leaves their numbers out.
struct OperationHistory {
  std::string scenario_name;
  /// Oldest first, the void ones too.
  std::vector<JudgedAttempt> attempts;
  /// Those that count, in their order.
  std::vector<std::size_t> counted;
  /// Of the counted ones, by number; a gap where there is none.
  std::vector<ChartPoint> scores;
  /// Of the last five by the same device class; a gap where there is no score and where the planned
  /// plane guided the hand.
  std::vector<ChartPoint> medians;
  assessment::LearningState learning;
  /// How the cohort stands, by the device class of the newest counted attempt; nothing where too
  /// few people are in it.
  std::optional<database::CohortComparison> cohort = {};
};

/// By operation, that of the newest attempt first.
std::vector<OperationHistory> histories_of(const std::vector<JudgedAttempt>& attempts);
/// A line for each counted attempt, with a head:
/// "attempt,begun_utc,for,device,guidance,score,median_of_5".
std::string csv_of(const OperationHistory& history);

}  // namespace hallux::ui
