// The whole path is asked for, because this machine may be a laboratory's. What was typed stays
// where it is refused.
#include "ui/screens/parts/export_dialog.h"

#include "ui/widgets/controls/dialog.h"

namespace hallux::ui {

namespace {

bool names_a_folder(const std::string& text) {
  const std::filesystem::path path(text);
  return path.is_absolute() && path.has_filename();
}

}  // namespace

void ExportDialog::open() {
  std::string home = home_folder().string();
  if (!home.ends_with('/')) home += '/';
  folder_ = std::move(home);
  work_.forget_fault();
}

void ExportDialog::draw(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
                        const ExportQuestion& asked, const Export& write) {
  if (chooser_.is_open()) {
    const auto chosen =
        chooser_.draw(ui, shell, {ui.text("path.folder.title"), ui.text("path.folder.act"), {}});
    if (chosen) folder_ = *chosen;
    return;
  }
  Dialog shown = form_dialog(ui, asked.title, ui.text("account.export.act"),
                             {work_.fault(), work_.is_running()},
                             field_label_height + field_height + field_message_height);
  shown.sentence = asked.sentence;
  shown.width = 620.0F;
  const std::string field = std::string(asked.id) + ".folder";
  const Answer answer = dialog(ui, asked.id, shown, [&](Rect form) {
    path_field(ui, field, form, *folder_,
               {.label = ui.text("account.export.folder"),
                .hint = ui.text("account.export.rule"),
                .max_bytes = 4096},
               chooser_);
    ui.focus_first(field);
    return names_a_folder(*folder_) ? std::string_view() : ui.text("path.missing.folder");
  });
  if (answer == Answer::Keep) folder_.reset();
  if (answer == Answer::Act && !work_.is_running()) start(ui, shell, signed_in, write);
}

void ExportDialog::start(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
                         const Export& write) {
  work_.start<database::PersonExport>(
      shell, signed_in, {std::string(ui.text("account.export.running")), {}},
      [folder = std::filesystem::path(*folder_), write](database::Session& session,
                                                        WorkReport& report) {
        return write(session, folder, [&report](double share) { return report.reached(share); });
      },
      [this, &shell,
       said = std::string(ui.text("account.export.done"))](database::PersonExport& made) {
        folder_.reset();
        shell.say({Meaning::Good, said, made.directory.string()});
      });
}

}  // namespace hallux::ui
