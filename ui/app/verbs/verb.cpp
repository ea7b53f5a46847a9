#include "ui/app/verbs/verb.h"

#include <unistd.h>

#include <algorithm>
#include <memory>
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

}  // namespace hallux::ui
