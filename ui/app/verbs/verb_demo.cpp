#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "ui/app/terminal/terminal_text.h"
#include "ui/jobs/demo/demo_course.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

void print_course(const VerbContext& context, const DemoCourse& course) {
  context.out << "A simulated course in " << terminal_text(context.data_directory.string()) << ": "
              << course.attempts << " attempts, " << course.notes << " notes, "
              << course.help_requests << " questions, " << course.decisions
              << " decisions. Nobody in it is a person, and nothing in it is a grade.\n\n";
  for (const DemoAccount& account : course.accounts) {
    context.out << "  " << account.login << "  (" << account.role << ")\n";
  }
  context.out << "\nThe password of all of them, shown this once: " << course.password << "\n";
}

ordered_json course_json(const DemoCourse& course) {
  ordered_json accounts = ordered_json::array();
  for (const DemoAccount& account : course.accounts) {
    accounts.push_back({{"login", account.login}, {"role", account.role}});
  }
  return {{"simulated", true},
          {"password", course.password},
          {"accounts", accounts},
          {"attempts", course.attempts},
          {"notes", course.notes},
          {"replies", course.replies},
          {"help_requests", course.help_requests},
          {"decisions", course.decisions}};
}

ExitCode demo_on(const VerbContext& context, int attempts_max) {
  if (!context.login.empty()) {
    throw VerbError(ExitCode::WrongUsage,
                    "a simulated course is made where nobody is yet; leave --as out");
  }
  DemoOptions options;
  options.attempts_max = attempts_max;
  const DemoCourse course = make_demo_course(context.data_directory, options, stages_on(context));
  answer(context, course_json(course), [&](std::ostream&) { print_course(context, course); });
  return ExitCode::Done;
}

}  // namespace

void add_demo_verb(CLI::App& app, VerbContext& context) {
  auto attempts_max = std::make_shared<int>(DemoOptions{}.attempts_max);
  CLI::App* demo = app.add_subcommand(
      "demo", "fill an empty data directory with a simulated course, so that every screen is full");
  demo->add_option("--attempts", *attempts_max, "attempts of each trainee, at most")
      ->check(CLI::Range(1, DemoOptions{}.attempts_max))
      ->capture_default_str();
  choose(*demo, context, [attempts_max, &context] { return demo_on(context, *attempts_max); });
}

}  // namespace hallux::ui
