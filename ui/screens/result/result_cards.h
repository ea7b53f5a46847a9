/// The cards of the result that read: score by group, what to take away, decisions.
#pragma once

#include <optional>

#include "ui/screens/result/result_text.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The ring with its pass mark, what it means, and a bar for each group.
void draw_score_card(Ui& ui, const Rect& rect, const ResultFacts& facts);
float score_card_height(const ResultFacts& facts) noexcept;

/// The sentences; where they are fewer than three, what was kept as well. Returns the ledger line
/// whose moment was asked for.
std::optional<std::size_t> draw_sentences_card(Ui& ui, const Rect& rect, const ResultFacts& facts);
float sentences_card_height(const Ui& ui, const ResultFacts& facts, float width);

/// What instructors decided, newest first.
void draw_decisions_card(Ui& ui, const Rect& rect, const ResultFacts& facts);
float decisions_card_height(const Ui& ui, const ResultFacts& facts, float width);

/// One line that must not be overlooked, across the page: why it is void, that it scores
/// differently now.
void draw_notice(Ui& ui, const Rect& rect, Meaning meaning, std::string_view words);
float notice_height(const Ui& ui, std::string_view words, float width);

}  // namespace hallux::ui
