/// metrics: what a score is made of.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "assessment/number_text.h"
#include "scenarios/metric_facts.h"
#include "ui/app/verbs/verbs.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;
using scenarios::MetricName;

ordered_json metric_json(const MetricName& metric) {
  const scenarios::MetricFacts& facts = scenarios::facts_of(metric.metric);
  return {{"id", metric.name},
          {"unit", metric.unit},
          {"about", scenarios::about_text(metric.subject)},
          {"better", scenarios::sense_text(metric.sense)},
          {"formula", facts.formula},
          {"source", facts.source}};
}

void print_metric(std::ostream& out, const MetricName& metric) {
  const scenarios::MetricFacts& facts = scenarios::facts_of(metric.metric);
  out << metric.name << (metric.unit.empty() ? "" : " [" + assessment::unit_text(metric.unit) + "]")
      << "  (" << scenarios::about_text(metric.subject) << ", "
      << scenarios::sense_text(metric.sense) << ")\n    " << facts.formula << "\n    "
      << facts.source << "\n";
}

}  // namespace

void add_metrics_verb(CLI::App& app, VerbContext& context) {
  CLI::App* verb =
      app.add_subcommand("metrics", "list what is measured, with unit, formula and source");
  choose(*verb, context, [&context] {
    return answer_with_list(context, scenarios::known_metrics(), metric_json, print_metric);
  });
}

}  // namespace hallux::ui
