/// A dialog in which somebody looks for a file, or for the place of a new folder: a path to type,
/// which completes, above what is in its folder.
///
///     if (chooser_.is_open()) {
///       if (const auto chosen = chooser_.draw(ui, shell, question)) file_ = *chosen;
///       return;
///     }
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/jobs/files/folder_listing.h"
#include "ui/screens/parts/loaded.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

struct PathQuestion {
  /// Its title, and the verb of its button: "Take this file".
  std::string_view title = {}, act = {};
  /// Of the files that are shown, ".json"; "": a folder is chosen, which may be new.
  std::string_view ending = {};
};

class PathDialog {
 public:
  /// Shows the folder of `path`, which may be "": the home.
  void open(std::string_view path);
  bool is_open() const noexcept { return is_open_; }
  /// The path that was chosen; it is closed then, and where somebody turned back.
  std::optional<std::string> draw(Ui& ui, Shell& shell, const PathQuestion& asked);

 private:
  using Entries = std::vector<const FolderEntry*>;

  void show(const std::filesystem::path& folder);
  void list(Ui& ui, Shell& shell, const PathQuestion& asked);
  /// What is typed behind the last slash.
  std::string_view start() const noexcept;
  std::filesystem::path folder() const;
  void draw_line(Ui& ui, Rect line);
  void draw_path(Ui& ui, Rect& rest, const PathQuestion& asked);
  void draw_entries(Ui& ui, const Rect& rect);
  void draw_table(Ui& ui, const Rect& rect, const Entries& shown);
  void press(const FolderEntry& entry);
  /// Of the folder that is seen, by name; null where there is none.
  const FolderEntry* named() const;
  std::string_view missing(const Ui& ui, const PathQuestion& asked) const;
  void complete();

  bool is_open_ = false, is_accepted_ = false;
  std::string path_;
  /// Of the listing that is asked for or seen.
  std::filesystem::path listed_;
  bool with_hidden_ = false, listed_hidden_ = false;
  /// The list shows what begins as the path does: it was typed, not pressed.
  bool is_typed_ = false;
  /// As the field showed it: where the path became another by itself, it is edited from its end on.
  std::string drawn_;
  Loaded<FolderListing> listing_;
  TableState table_;
};

/// A field for a path with a button that opens the dialog beside it; what is dropped on the window
/// fills it. The button is `id.choose`.
void path_field(Ui& ui, std::string_view id, Rect& rest, std::string& path, const FieldSpec& spec,
                PathDialog& dialog);

/// "640 bytes", "12.3 kB", "4.0 MB".
std::string file_size_text(std::uintmax_t bytes);

}  // namespace hallux::ui
