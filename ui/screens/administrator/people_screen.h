/// The people of the course: who they are, what they may do, and the one-time codes with which they
/// come in.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/export_dialog.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/person_dialogs.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

/// Whether a person can come in.
enum class Admission {
  /// With a password.
  Active,
  /// A one-time code waits for them.
  Invited,
  /// Neither: the code ran out.
  NeedsCode,
  Disabled
};
Admission admission_of(const database::Person& person, std::string_view now_utc) noexcept;

class PeopleScreen : public Screen {
 public:
  explicit PeopleScreen(std::shared_ptr<SignedInSession> signed_in,
                        database::PasswordCost cost = {})
      : signed_in_(std::move(signed_in)), cost_(cost) {}

  GuideSection guide_section() const override { return GuideSection::People; }
  std::string_view navigation_id() const override { return "nav.people"; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  struct Listed {
    database::Person person;
    /// Names, "Autumn, Spring".
    std::string cohorts;
    /// In at least one cohort.
    bool is_instructor = false, is_trainee = false;
    Admission admission = Admission::Active;
  };
  struct Asked {
    enum class Deed { Reset, Disable, TakeRole } deed = Deed::Reset;
    std::string login;
  };
  using List = std::vector<Listed>;

  static List read(database::Session& session);
  static std::string login_of(const Listed& listed) { return listed.person.login; }
  static std::string name_of(const Listed& listed);
  static std::string_view role_id(const Listed& listed) noexcept;
  std::vector<RowColumn<Listed>> columns_of(const Ui& ui) const;
  /// Those who are searched for, of the tab.
  std::vector<const Listed*> found() const;
  const Listed* chosen() const;
  bool is_last_administrator(const database::Person& person) const;
  /// Of what cannot be done with somebody; empty: it can.
  struct WhyNot {
    std::string_view code, role, disable, erase;
  };
  WhyNot why_not(const Ui& ui, const Listed& listed) const;
  /// Of the card of whoever is chosen, with the reasons in it.
  float person_height(const Ui& ui, const Listed& listed) const;
  void draw_page(Ui& ui, const Rect& content, Shell& shell);
  void draw_head_buttons(Ui& ui, Rect buttons, const ButtonSpec& add);
  void draw_list(Ui& ui, const Rect& content);
  void draw_table(Ui& ui, const Rect& content, std::vector<const Listed*> shown);
  void draw_person(Ui& ui, const Rect& content, Shell& shell);
  void draw_facts(Ui& ui, Rect& rest, const Listed& listed) const;
  void draw_rename_button(Ui& ui, Rect& rest, const Listed& listed);
  void draw_code_button(Ui& ui, Rect& rest, const Listed& listed);
  void draw_role_button(Ui& ui, Rect& rest, const Listed& listed, Shell& shell);
  void draw_disable_button(Ui& ui, Rect& rest, const Listed& listed, Shell& shell);
  void draw_export_button(Ui& ui, Rect& rest, const Listed& listed);
  void draw_erase_button(Ui& ui, Rect& rest, const Listed& listed);
  void draw_export(Ui& ui, Shell& shell);
  void draw_dialogs(Ui& ui, Shell& shell);
  void draw_question(Ui& ui, Shell& shell);
  void add(Ui& ui, Shell& shell);
  void reset(Ui& ui, Shell& shell, const std::string& login);
  void rename(Ui& ui, Shell& shell);
  void erase(Ui& ui, Shell& shell);
  /// Says `done` and reads the list anew once `change` was made.
  void change(Ui& ui, Shell& shell, std::string done,
              std::function<void(database::AdministratorDesk&)> change);

  std::shared_ptr<SignedInSession> signed_in_;
  database::PasswordCost cost_;
  Loaded<List> people_;
  std::string search_, now_utc_;
  int tab_ = 0;
  TableState table_;
  /// Login.
  std::string chosen_;
  DeskWork work_, adding_, renaming_, erasing_;
  std::optional<NewPersonForm> added_;
  std::optional<NameForm> renamed_;
  std::optional<ShownCode> code_;
  std::optional<Asked> asked_;
  /// Of whom, while its dialog is open.
  std::string exported_;
  ExportDialog exporting_;
  /// While the dialog is open.
  std::optional<EraseForm> erased_;
};

}  // namespace hallux::ui
