#include "ui/screens/trainee/operation_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ui/screens/parts/value_text.h"

namespace hallux::ui {

namespace {

constexpr std::size_t median_window = 5;

std::vector<std::string> names_of(const std::vector<JudgedAttempt>& attempts) {
  std::vector<std::string> names;
  for (auto attempt = attempts.rbegin(); attempt != attempts.rend(); ++attempt) {
    const std::string& name = attempt->header.scenario_name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// Medians over the last scores, of each device class for itself.
class RunningMedians {
 public:
  double with(const std::string& device_class, double score) {
    std::vector<double>& last = last_[device_class];
    last.push_back(score);
    if (last.size() > median_window) last.erase(last.begin());
    return assessment::running_median(last, median_window).back();
  }

 private:
  std::map<std::string, std::vector<double>> last_;
};

/// The points of the chart; the median runs over the scores that there are, those of a guided hand
/// aside.
void count(OperationHistory& history) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  RunningMedians medians;
  for (std::size_t row = 0; row < history.attempts.size(); ++row) {
    const JudgedAttempt& attempt = history.attempts[row];
    if (attempt.header.state == database::AttemptState::Void) continue;
    const auto number = static_cast<double>(attempt.header.number);
    history.counted.push_back(row);
    history.scores.push_back({number, nothing});
    history.medians.push_back({number, nothing});
    if (!attempt.score_milli) continue;
    const double score = static_cast<double>(*attempt.score_milli) / 1000.0;
    history.scores.back().y = score;
    const database::NewAttempt& begun = attempt.header.begun;
    if (begun.guidance != simulator::Guidance::None) continue;
    history.medians.back().y = medians.with(begun.device_class, score);
  }
}

std::string csv_number(double points) {
  return std::isnan(points) ? std::string() : points_text(std::llround(points * 1000.0));
}

}  // namespace

std::vector<OperationHistory> histories_of(const std::vector<JudgedAttempt>& attempts) {
  std::vector<OperationHistory> histories;
  for (const std::string& name : names_of(attempts)) {
    OperationHistory& history = histories.emplace_back();
    history.scenario_name = name;
    std::copy_if(attempts.begin(), attempts.end(), std::back_inserter(history.attempts),
                 [&](const JudgedAttempt& each) { return each.header.scenario_name == name; });
    count(history);
    history.learning = learning_of(attempts, name);
  }
  return histories;
}

std::string csv_of(const OperationHistory& history) {
  std::string csv = "attempt,begun_utc,for,device,guidance,score,median_of_5\n";
  for (std::size_t point = 0; point < history.counted.size(); ++point) {
    const database::AttemptHeader& header = history.attempts[history.counted[point]].header;
    csv += std::to_string(header.number) + "," + header.started_utc + "," +
           std::string(name_of(header.begun.kind)) + "," + header.begun.device_class + "," +
           std::string(database::name_of(header.begun.guidance)) + "," +
           csv_number(history.scores[point].y) + "," + csv_number(history.medians[point].y) + "\n";
  }
  return csv;
}

}  // namespace hallux::ui
