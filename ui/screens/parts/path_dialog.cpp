// The path is the only state that counts: the folder that is listed is the one it names, and what
// is typed behind its last slash narrows the list. A press on a folder goes into it; on a file it
// writes its path, and a second press takes it. Folders are listed beside the window.
#include "ui/screens/parts/path_dialog.h"

#include <array>
#include <cstdio>
#include <utility>

#include "ui/screens/parts/page.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"

namespace hallux::ui {

namespace {

constexpr float dialog_room = 680.0F, list_height = 300.0F, line_height_px = 36.0F, gap = 10.0F;
constexpr float changed_from = 520.0F;
constexpr std::size_t path_bytes_max = 1000;

std::string with_slash(const std::filesystem::path& folder) {
  std::string path = folder.string();
  if (!path.ends_with('/')) path += '/';
  return path;
}

std::vector<RowColumn<FolderEntry>> columns_of(const Ui& ui) {
  using Entry = const FolderEntry&;
  return {
      {{ui.text("path.name")},
       [](Ui& own, Entry entry, const Rect& cell) {
         const Color ink = entry.is_folder ? own.theme().accent : own.theme().text_caption;
         own.canvas().icon({cell.x + 9.0F, cell.mid_y()},
                           entry.is_folder ? Icon::Folder : Icon::File, IconSize::Control, ink);
         own.canvas().text_in({cell.x + 28.0F, cell.y, cell.w - 28.0F, cell.h},
                              {Type::Body, own.theme().text}, entry.name, true);
       }},
      {{ui.text("path.changed"), 150.0F, 1.0F, Align::Left, changed_from},
       [](Ui& own, Entry entry, const Rect& cell) {
         draw_moment_cell(own, cell, entry.changed_utc, {Type::Small, own.theme().text_secondary});
       }},
      {{ui.text("path.size"), 84.0F, 1.0F, Align::Right},
       [](Entry entry) { return entry.is_folder ? std::string() : file_size_text(entry.bytes); },
       caption_cell}};
}

}  // namespace

std::string file_size_text(std::uintmax_t bytes) {
  constexpr double kilo = 1e3, mega = 1e6;
  std::array<char, 32> text{};
  const auto size = static_cast<double>(bytes);
  if (size < kilo) return std::to_string(bytes) + " bytes";
  const bool is_large = size >= mega;
  std::snprintf(text.data(), text.size(), is_large ? "%.1f MB" : "%.1f kB",
                size / (is_large ? mega : kilo));
  return text.data();
}

void PathDialog::open(std::string_view path) {
  is_open_ = true;
  is_accepted_ = is_typed_ = false;
  path_ = path.empty() ? with_slash(home_folder()) : typed_path(path, home_folder()).string();
  listed_.clear();
  table_ = {};
}

std::string_view PathDialog::start() const noexcept {
  return std::string_view(path_).substr(path_.rfind('/') + 1);
}

std::filesystem::path PathDialog::folder() const {
  const std::size_t slash = path_.rfind('/');
  return typed_path(slash == std::string::npos ? "~" : path_.substr(0, slash + 1), home_folder());
}

void PathDialog::show(const std::filesystem::path& folder) {
  path_ = with_slash(folder);
  is_typed_ = false;
}

void PathDialog::list(Ui& ui, Shell& shell, const PathQuestion& asked) {
  const std::filesystem::path wanted = folder();
  const bool is_other = wanted != listed_ || with_hidden_ != listed_hidden_;
  if (is_other && !listing_.is_running()) listing_.read_again();
  if (!listing_.is_new()) return;
  listed_ = wanted;
  listed_hidden_ = with_hidden_;
  const ListingFilter filter{std::string(asked.ending), with_hidden_};
  listing_.start(ui, shell, {},
                 [wanted, filter](WorkReport&) { return list_folder(wanted, filter); });
}

const FolderEntry* PathDialog::named() const {
  if (!listing_.is_ready() || listed_ != folder()) return nullptr;
  for (const FolderEntry& entry : listing_.value().entries)
    if (entry.name == start()) return &entry;
  return nullptr;
}

// A folder may be new; a file has to be there, which whoever reads it finds out.
std::string_view PathDialog::missing(const Ui& ui, const PathQuestion& asked) const {
  const bool is_folder = asked.ending.empty();
  if (start().empty()) return ui.text(is_folder ? "path.missing.folder" : "path.missing.file");
  if (is_folder && !std::filesystem::path(path_).is_absolute())
    return ui.text("path.missing.slash");
  return {};
}

void PathDialog::complete() {
  const std::string done = completed(listing_.value(), start());
  path_.replace(path_.rfind('/') + 1, std::string::npos, done);
}

void PathDialog::press(const FolderEntry& entry) {
  const std::string path = with_slash(folder()) + entry.name;
  if (entry.is_folder) return show(path);
  is_accepted_ = path_ == path;
  path_ = path;
  is_typed_ = false;
}

// Up, home, and whether what is hidden is seen.
void PathDialog::draw_line(Ui& ui, Rect line) {
  const std::filesystem::path here = std::filesystem::path(with_slash(folder())).parent_path();
  const IconButtonSpec up{
      .label = ui.text("path.up"),
      .icon = Icon::Up,
      .why_off = here.has_relative_path() ? std::string_view() : ui.text("path.up.off")};
  if (icon_button(ui, "path.up", take_left(line, line_height_px, 4.0F), up))
    show(here.parent_path());
  if (icon_button(ui, "path.home", take_left(line, line_height_px, 12.0F),
                  {ui.text("path.home"), Icon::Home}))
    show(home_folder());
  const std::string_view hidden = ui.text("path.hidden");
  const Rect place = take_right(line, ui.width_of(Type::Body, hidden) + 40.0F, 12.0F);
  checkbox(ui, "path.hidden", centred(place, place.w, 24.0F), hidden, with_hidden_);
  ui.canvas().text_in(line, {Type::Small, ui.theme().text_secondary}, here.string(), true,
                      here.string());
}

void PathDialog::draw_path(Ui& ui, Rect& rest, const PathQuestion& asked) {
  const bool can_complete = listing_.is_ready() && listed_ == folder() && !start().empty() &&
                            completed(listing_.value(), start()) != start();
  for (const FieldEvent& event : ui.field_events("path.path"))
    if (event.chord.key == Key::Tab && can_complete) complete();
  if (const std::optional<std::string> dropped = ui.take_dropped()) {
    path_ = *dropped;
    is_typed_ = false;
  }
  if (path_ != drawn_) {
    ui.text_edit("path.path").cursor = {path_.size(), path_.size()};
    ui.want_frame_in_s(0.0);
  }
  const FieldSpec spec{.label = ui.text(asked.ending.empty() ? "path.folder" : "path.file"),
                       .hint = ui.text("path.hint"),
                       .takes_tab = can_complete,
                       .max_bytes = path_bytes_max};
  if (labelled_field(ui, "path.path", rest, path_, spec, field_message_height)) {
    is_typed_ = true;
    ui.want_frame_in_s(0.0);
  }
  drawn_ = path_;
  ui.focus_first("path.path");
}

void PathDialog::draw_entries(Ui& ui, const Rect& rect) {
  if (!listing_.draw_until_ready(ui, "path.failed", rect, 6)) return;
  const FolderListing& listing = listing_.value();
  const Entries shown = entries_from(listing, is_typed_ ? start() : std::string_view());
  if (!shown.empty()) return draw_table(ui, rect, shown);
  empty_card(ui, "path.empty", rect,
             {Icon::Folder, ui.text("path.empty"), ui.text("path.empty.sentence")});
}

void PathDialog::draw_table(Ui& ui, const Rect& rect, const Entries& shown) {
  RowTable<FolderEntry> entries{ui.text("path.entries"), &FolderEntry::name, &FolderEntry::name,
                                columns_of(ui)};
  entries.row_height = line_height_px;
  table_.chosen = {std::string(start())};
  const TableResponse response = table(ui, "path.row", rect, entries, shown, table_);
  if (!response.opened) return;
  press(*shown[static_cast<std::size_t>(*response.opened)]);
  ui.want_frame_in_s(0.0);
}

std::optional<std::string> PathDialog::draw(Ui& ui, Shell& shell, const PathQuestion& asked) {
  list(ui, shell, asked);
  Dialog shown = form_dialog(ui, asked.title, asked.act, {},
                             field_label_height + field_height + field_message_height + gap +
                                 line_height_px + gap + list_height);
  shown.width = dialog_room;
  const Answer answer = dialog(ui, "path", shown, [&](const Rect& form) {
    Rect rest = form;
    draw_path(ui, rest, asked);
    draw_line(ui, take_top(rest, line_height_px, gap));
    draw_entries(ui, inset(rest, 12.0F, 0.0F));
    return missing(ui, asked);
  });
  if (answer == Answer::Keep) is_open_ = false;
  const FolderEntry* entry = named();
  const bool is_entered =
      answer == Answer::Act && entry != nullptr && entry->is_folder && !asked.ending.empty();
  if (is_entered) show(with_slash(folder()) + entry->name);
  const bool is_chosen =
      std::exchange(is_accepted_, false) || (answer == Answer::Act && !is_entered);
  if (!is_chosen) return std::nullopt;
  is_open_ = false;
  return typed_path(path_, home_folder()).string();
}

void path_field(Ui& ui, std::string_view id, Rect& rest, std::string& path, const FieldSpec& spec,
                PathDialog& dialog) {
  if (const std::optional<std::string> dropped = ui.take_dropped()) path = *dropped;
  const bool has_message = !spec.hint.empty() || !spec.error.empty();
  take_top(rest, field_label_height);
  Rect line = take_top(rest, field_height, has_message ? field_message_height : 0.0F);
  ButtonSpec choose{ui.text("path.choose"), ButtonLook::Secondary, Icon::Folder};
  choose.why_off = spec.why_off;
  const Rect place = take_right(line, button_width(ui, choose), gap);
  field(ui, id, line, path, spec);
  if (button(ui, std::string(id) + ".choose", centred(place, place.w, button_height), choose))
    dialog.open(path);
}

}  // namespace hallux::ui
