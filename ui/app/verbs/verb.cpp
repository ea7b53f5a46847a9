#include "ui/app/verbs/verb.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "simulator/base/progress.h"
#include "ui/app/terminal/interrupt.h"

namespace hallux::ui {

Progress progress_on(const VerbContext& context, std::string label) {
  if (context.quiet) return [](double) { return !is_interrupted(); };
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  auto shown = std::make_shared<int>(-1);
  return [&notes = context.notes, label = std::move(label), is_terminal, shown](double fraction) {
    const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
    // A log gets one line for each quarter, a terminal one line that is drawn again.
    const int step = is_terminal ? 1 : 25;
    if (percent / step != *shown / step || *shown < 0) {
      notes << (is_terminal ? "\r" : "") << label << "  " << percent << " %"
            << (is_terminal && percent < 100 ? "" : "\n") << std::flush;
      *shown = percent;
    }
    return !is_interrupted();
  };
}

std::function<Progress(const std::string&)> stages_on(const VerbContext& context) {
  return [&context](const std::string& stage) { return progress_on(context, stage); };
}

std::string fault_in_place(const std::string& name) {
  return name.empty() ? "must name a place" : "";
}

void choose(CLI::App& verb, VerbContext& context, std::function<ExitCode()> run) {
  verb.callback([&context, run = std::move(run)] { context.chosen = run; });
}

void write_json(std::ostream& out, const nlohmann::ordered_json& value) {
  out << value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

void answer(const VerbContext& context, const nlohmann::ordered_json& value,
            const std::function<void(std::ostream&)>& print) {
  if (context.json) {
    write_json(context.out, value);
  } else {
    print(context.out);
  }
}

}  // namespace hallux::ui
