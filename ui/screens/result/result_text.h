/// What the result says in words: items, values against plan, moments, marks of a score.
/// Inside this corner only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assessment/shown_points.h"
#include "ui/screens/result/result_material.h"
#include "ui/widgets/look/theme.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// Where full points end: "≤ 0.5 mm", "0.8–2 mm", "≥ 60 %", "0 s"; of a claim "yes" or "no".
std::string target_text(const database::LedgerLine& line, const scenarios::Scenario* scenario);
/// The item's title in the scenario; its own name where that is not known.
std::string item_title(const database::LedgerLine& line, const scenarios::Scenario* scenario);
std::string group_title(const database::GroupScore& group, const scenarios::Scenario* scenario);
/// "−17.6"; "0" where nothing was lost, "< 0.1" where too little to show.
std::string loss_text(const database::LedgerLine& line, const assessment::ShownLine& shown);
/// What a group could have given, without needless decimals: "100", "86.2".
std::string possible_text(const assessment::ShownGroup& shown);

/// Who decided, by the name that is shown; somebody where it was erased.
std::string decider_text(const Texts& texts, const database::Decision& decision);

/// Of which planned cut the line is; nothing where it is about none or several.
std::optional<std::size_t> cut_of(const database::LedgerLine& line,
                                  const scenarios::Scenario* scenario);

/// The lines by what they cost, greatest first; equal ones in their order.
std::vector<std::size_t> lines_by_loss(const database::ScoreCard& card);
/// The line that this sentence explains; nothing where it is about the whole attempt.
std::optional<std::size_t> line_of_sentence(const database::ScoreCard& card,
                                            std::string_view sentence);

/// One thing that must be known beside a score.
struct ScoreMark {
  std::string words;
  Meaning meaning = Meaning::Neutral;
  bool has_shape = false;
};
/// Advisory or signed, void, partial, not surgeon-reviewed, simulated, practice, interrupted.
std::vector<ScoreMark> score_marks(const Texts& texts, const ResultFacts& facts);

}  // namespace hallux::ui
