/// What would have earned more: the changes that gain most, worked out beside the window.
/// Inside this corner only.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "ui/report/what_if_text.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/result/result_material.h"

namespace hallux::ui {

class WhatIfCard {
 public:
  WhatIfCard() = default;
  WhatIfCard(const WhatIfCard&) = delete;
  WhatIfCard& operator=(const WhatIfCard&) = delete;
  /// What is being worked out stops.
  ~WhatIfCard() { *is_left_ = true; }

  /// Begins where it has not begun, and again after its button.
  void work_out(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
                const database::AttemptId& attempt);
  float height(const Ui& ui, const ResultFacts& facts, float width) const;
  /// needs   facts.score
  /// Returns the ledger line whose moment was asked for.
  std::optional<std::size_t> draw(Ui& ui, const Rect& rect, const ResultFacts& facts);

 private:
  Loaded<SaidWhatIf> said_;
  /// Seen by the work, which may outlive the card.
  std::shared_ptr<std::atomic<bool>> is_left_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace hallux::ui
