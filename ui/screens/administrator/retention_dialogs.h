/// How long what is kept, and what would go: two dialogs of an administrator, one after the other.
/// Inside this corner only.
///
///     if (button(ui, "records.retention", ...)) retention_.open(ui, shell);
///     retention_.draw(ui, shell);   // last: it lies over everything
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

class RetentionDialogs {
 public:
  explicit RetentionDialogs(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(std::move(signed_in)) {}

  void open(Ui& ui, Shell& shell);
  /// True in the frame after something went or was changed: what is shown beside it is old.
  bool draw(Ui& ui, Shell& shell);

 private:
  /// Days as they are typed: of practices, assessments, accounts, what is cached; "" is for ever.
  using Days = std::array<std::string, 4>;
  struct Plan {
    /// One for each piece that would go.
    std::vector<std::string> lines;
    std::string summary;
  };

  void draw_days(Ui& ui, Shell& shell);
  void draw_plan(Ui& ui, Shell& shell);
  void save(Ui& ui, Shell& shell);
  void clean_up(Ui& ui, Shell& shell);
  static Plan plan_of(const Texts& texts, const std::vector<database::RetentionPiece>& pieces);

  std::shared_ptr<SignedInSession> signed_in_;
  std::optional<Days> days_;
  std::optional<Plan> plan_;
  bool has_changed_ = false;
  DeskWork work_;
};

}  // namespace hallux::ui
