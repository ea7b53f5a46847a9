/// The catalogue of operations: every version with its state and review, its sheet to read, import,
/// publish, retire.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/path_dialog.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class ScenariosScreen : public Screen {
 public:
  explicit ScenariosScreen(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(std::move(signed_in)) {}

  GuideSection guide_section() const override { return GuideSection::Scenarios; }
  std::string_view navigation_id() const override { return "nav.scenarios"; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  struct Asked {
    database::ScenarioVersion version;
    /// Else it is retired.
    bool is_publishing = true;
  };

  void read_sheet(Ui& ui, Shell& shell);
  bool is_proving() const noexcept { return is_proving_ != nullptr && *is_proving_; }
  const database::ScenarioVersion* chosen() const;
  /// The published version of the same operation, which publishing another would retire; null for
  /// none.
  const database::ScenarioVersion* published_beside(const database::ScenarioVersion& version) const;
  void draw_page(Ui& ui, const Rect& content, Shell& shell);
  void draw_table(Ui& ui, const Rect& content);
  void draw_chosen(Ui& ui, const Rect& rect, Shell& shell);
  void draw_actions(Ui& ui, Rect& rest, const database::ScenarioVersion& version);
  void draw_import_dialog(Ui& ui, Shell& shell);
  void draw_question(Ui& ui, Shell& shell);
  void import(Ui& ui, Shell& shell);
  void publish(Ui& ui, Shell& shell, const database::ScenarioVersion& version);
  void retire(Ui& ui, Shell& shell, const database::ScenarioVersion& version);

  std::shared_ptr<SignedInSession> signed_in_;
  Loaded<std::vector<database::ScenarioVersion>> versions_;
  std::optional<database::ScenarioVersionId> chosen_, sheet_of_;
  Loaded<std::string> sheet_;
  TableState table_;
  /// While one is imported.
  std::optional<std::string> file_;
  PathDialog chooser_;
  std::optional<Asked> asked_;
  DeskWork work_, importing_;
  /// While one is proven and published, which takes a minute: the session is free meanwhile. Held
  /// by the screen alone.
  std::shared_ptr<bool> is_proving_;
};

}  // namespace hallux::ui
