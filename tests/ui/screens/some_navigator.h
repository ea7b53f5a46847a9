/// A navigator that notes where a screen wanted to lead.
#pragma once

#include <string>
#include <vector>

#include "ui/screens/parts/navigator.h"

namespace hallux::ui {

class SomeNavigator : public Navigator {
 public:
  void brief(database::ScenarioVersionId scenario) override {
    asked.push_back("brief " + std::to_string(scenario.number));
  }
  void operate(database::ScenarioVersionId scenario, const WayToOperate& way) override {
    std::string what = way.kind == database::AttemptKind::Assessment ? "assess " : "practise ";
    if (way.guidance != simulator::Guidance::None)
      what += "guided by " + std::string(database::name_of(way.guidance)) + " ";
    if (way.feels_historic_law) what += "by the historic law ";
    asked.push_back(what + std::to_string(scenario.number));
  }
  void fly() override { asked.emplace_back("fly"); }
  void show_result(const database::AttemptId& attempt) override {
    asked.push_back("result " + attempt.text);
  }
  void show_replay(const database::AttemptId& attempt, double moment_s) override {
    asked.push_back("replay " + attempt.text + " at " + std::to_string(moment_s));
  }
  void watch_expert(const scenarios::Scenario& scenario) override {
    asked.push_back("watch " + scenario.name);
  }
  void show_trainee(database::CohortId cohort, database::PersonId trainee) override {
    asked.push_back("trainee " + std::to_string(trainee.number) + " of " +
                    std::to_string(cohort.number));
  }

  std::vector<std::string> asked;
};

}  // namespace hallux::ui
