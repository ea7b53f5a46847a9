/// How an instructor decides about a result: confirm, override or void, with a reason; voiding asks
/// once more. Inside this corner only.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/result/result_material.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// A score as it is written: "81", "81.5". Nothing where it is none from 0 to 100.
std::optional<std::int64_t> score_from(std::string_view words) noexcept;

class DecideForm {
 public:
  explicit DecideForm(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(std::move(signed_in)) {}

  void open(const ResultFacts& facts);
  /// Draws the form while it is open. True in the frame after something was decided: the facts are
  /// old then.
  bool draw(Ui& ui, Shell& shell, const ResultFacts& facts);

 private:
  database::DecisionKind kind() const noexcept {
    return static_cast<database::DecisionKind>(chosen_);
  }
  /// False where something is missing.
  /// What is still missing; empty: nothing.
  std::string_view draw_fields(Ui& ui, const Rect& form);
  void start(Ui& ui, Shell& shell, const ResultFacts& facts);
  void draw_question(Ui& ui, Shell& shell, const ResultFacts& facts);

  std::shared_ptr<SignedInSession> signed_in_;
  bool is_open_ = false, is_asking_ = false, was_decided_ = false;
  /// A DecisionKind.
  int chosen_ = 0;
  std::string score_, reason_;
  DeskWork work_;
};

}  // namespace hallux::ui
