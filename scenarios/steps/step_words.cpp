#include "scenarios/steps/step_words.h"

#include <algorithm>
#include <array>

namespace hallux::scenarios {
namespace {

struct StepWord {
  std::string_view word;
  StepKind kind;
};

/// In the order in which an operation has them.
constexpr std::array words{
    StepWord{"verify", StepKind::Verify},
    StepWord{"mark", StepKind::Mark},
    StepWord{"guide_wire", StepKind::GuideWire},
    StepWord{"retract", StepKind::Retract},
    StepWord{"cut", StepKind::Cut},
    StepWord{"complete", StepKind::Complete},
    StepWord{"remove", StepKind::Remove},
    StepWord{"shift", StepKind::Shift},
    StepWord{"close", StepKind::Close},
    StepWord{"temporary_wire", StepKind::TemporaryWire},
    StepWord{"fix", StepKind::Fix},
    StepWord{"trim", StepKind::Trim},
    StepWord{"finish", StepKind::Finish},
};

}  // namespace

std::string_view step_word(StepKind kind) noexcept {
  return std::ranges::find(words, kind, &StepWord::kind)->word;
}

std::optional<StepKind> find_step_kind(std::string_view word) noexcept {
  const auto found = std::ranges::find(words, word, &StepWord::word);
  return found == words.end() ? std::nullopt : std::optional(found->kind);
}

std::string step_words() {
  std::string known;
  for (const StepWord& each : words) known.append(known.empty() ? "" : ", ").append(each.word);
  return known;
}

}  // namespace hallux::scenarios
