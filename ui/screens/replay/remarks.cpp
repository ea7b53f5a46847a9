#include "ui/screens/replay/remarks.h"

#include <algorithm>

namespace hallux::ui {

Remarks remarks_of(std::vector<database::Note> notes,
                   std::vector<database::HelpRequest> questions) {
  Remarks remarks{std::move(notes), std::move(questions), {}};
  // Numbers follow the moments, as they are seen on the timeline.
  const auto by_moment = [](const auto& a, const auto& b) {
    return a.moment.moment_us < b.moment.moment_us;
  };
  std::stable_sort(remarks.notes.begin(), remarks.notes.end(), by_moment);
  std::stable_sort(remarks.questions.begin(), remarks.questions.end(), by_moment);
  for (std::size_t i = 0; i < remarks.notes.size(); ++i)
    remarks.order.push_back({false, i, remarks.notes[i].moment.moment_us, i + 1});
  for (std::size_t i = 0; i < remarks.questions.size(); ++i)
    remarks.order.push_back({true, i, remarks.questions[i].moment.moment_us, i + 1});
  std::stable_sort(remarks.order.begin(), remarks.order.end(),
                   [](const Remark& a, const Remark& b) { return a.moment_us < b.moment_us; });
  return remarks;
}

double second_of(const Remark& remark) noexcept {
  return static_cast<double>(remark.moment_us) / 1.0e6;
}

}  // namespace hallux::ui
