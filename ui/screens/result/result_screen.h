/// The result of one attempt: the score by group, the ledger with its places and moments, what to
/// take away, plan against cut, heat and danger zones, and what instructors decided.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/message_form.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/result/decide_form.h"
#include "ui/screens/result/plan_card.h"
#include "ui/screens/result/result_material.h"
#include "ui/screens/result/what_if_card.h"
#include "ui/widgets/controls/row_table.h"
#include "ui/widgets/controls/timeline_view.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class ResultScreen : public Screen {
 public:
  /// `navigator` outlives the screen.
  ResultScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
               database::AttemptId attempt)
      : signed_in_(std::move(signed_in)),
        navigator_(navigator),
        attempt_(std::move(attempt)),
        decide_(signed_in_) {}

  GuideSection guide_section() const override { return GuideSection::Result; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void read(Ui& ui, Shell& shell);
  void draw_page(Ui& ui, Rect page, bool has_fixed_head, Shell& shell);
  float draw_head(Ui& ui, const Rect& place);
  /// From the right end of the line; the width that they take.
  float draw_actions(Ui& ui, Rect line);
  float draw_marks(Ui& ui, const Rect& place) const;
  float draw_notices(Ui& ui, const Rect& place) const;
  float draw_reading_cards(Ui& ui, const Rect& place);
  float draw_looking_cards(Ui& ui, const Rect& place, float height, Shell& shell);
  void draw_ledger(Ui& ui, const Rect& rect);
  void draw_ledger_table(Ui& ui, const Rect& rect);
  void draw_ledger_foot(Ui& ui, const Rect& rect);
  void draw_plan(Ui& ui, const Rect& rect, Shell& shell);
  /// The card of what the saw did beside the cut; loading and failed like the plan's.
  float effects_card_height(const Ui& ui, float width) const;
  void draw_effects_card(Ui& ui, const Rect& rect);
  bool are_effects_scored() const noexcept;
  /// A gain is the difference to the stored score, so that must be what this program computes; as
  /// long as that is not known it is taken to be.
  bool shows_what_if() const;
  void compare();
  void draw_forms(Ui& ui, Shell& shell);
  std::vector<std::pair<Meaning, std::string>> notices(const Texts& texts) const;

  const ResultFacts& facts() const { return facts_.value(); }
  const scenarios::Scenario* scenario() const noexcept {
    return facts().scenario ? &*facts().scenario : nullptr;
  }
  void choose_line(std::size_t line);
  void watch(std::size_t line);
  /// Of the ledger's line that is looked at.
  std::optional<double> chosen_moment_s() const;

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  database::AttemptId attempt_;
  Loaded<ResultFacts> facts_;
  Loaded<std::shared_ptr<const ExaminedAttempt>> examined_;
  /// The stored score beside what was examined: as long as both are these.
  struct Compared {
    std::int64_t score = 0;
    const ExaminedAttempt* examined = nullptr;
    bool is_same = false;
  } compared_;
  PlanCard plan_;
  WhatIfCard what_if_;
  DecideForm decide_;
  MessageForm ask_;
  TableState ledger_;
  TimelineState effects_time_;
  std::optional<std::size_t> chosen_line_;
  float page_height_ = 0.0F;
};

}  // namespace hallux::ui
