/// Asks into which folder all that is kept of a person goes, and writes it there: for who exports
/// what is kept of themselves, and for an administrator who was asked to.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "database/desks/trainee_desk.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/path_dialog.h"

namespace hallux::ui {

struct ExportQuestion {
  /// Of the dialog, "account.export".
  std::string_view id = {};
  std::string_view title = {}, sentence = {};
};

class ExportDialog {
 public:
  /// At the desk from which it may be done.
  using Export = std::function<database::PersonExport(
      database::Session& session, const std::filesystem::path& folder, const Progress& progress)>;

  void open();
  bool is_open() const noexcept { return folder_.has_value(); }
  void draw(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
            const ExportQuestion& asked, const Export& write);

 private:
  void start(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
             const Export& write);

  /// Typed while the dialog is open.
  std::optional<std::string> folder_;
  PathDialog chooser_;
  DeskWork work_;
};

}  // namespace hallux::ui
