/// One's own account: how one is known here, in which cohorts one is what, and a new password.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/export_dialog.h"
#include "ui/screens/parts/person_dialogs.h"

namespace hallux::ui {

class AccountScreen : public Screen {
 public:
  explicit AccountScreen(std::shared_ptr<SignedInSession> signed_in,
                         database::PasswordCost cost = {})
      : signed_in_(std::move(signed_in)), cost_(cost) {}

  GuideSection guide_section() const override { return GuideSection::Account; }
  std::string_view navigation_id() const override { return account_place; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

  /// No place of the navigation: it is opened from the menu beside one's name.
  static constexpr std::string_view account_place = "account";

 private:
  void draw_person(Ui& ui, Rect rest, Shell& shell);
  void draw_cohorts(Ui& ui, Rect rest) const;
  void change_password(Ui& ui, Shell& shell);
  void draw_export(Ui& ui, Shell& shell);
  /// When windows lock: a fact, and for administrators a choice.
  void draw_lock(Ui& ui, Rect& rest, Shell& shell);
  /// On which sides the panels of an operation lie.
  static void draw_hand(Ui& ui, Rect& rest, HandPreferences& hand);
  void set_lock(Ui& ui, Shell& shell, std::int32_t minutes);

  std::shared_ptr<SignedInSession> signed_in_;
  database::PasswordCost cost_;
  /// While the dialog is open.
  std::optional<PasswordForm> typed_;
  DeskWork changing_, setting_;
  ExportDialog exporting_;
  /// Of the choices; below 0: as it was at the sign-in.
  int lock_choice_ = -1;
};

}  // namespace hallux::ui
