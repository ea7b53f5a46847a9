// The audit by pages of 50, newest first, and the backups beside it. A page is asked for by the
// number of the line before it, so that lines which are added meanwhile move nothing. Whatever is
// done here writes a line itself: then the first page is read again.
#include "ui/screens/administrator/audit_screen.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "ui/screens/administrator/audit_text.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

using database::AuditLine;

constexpr float side_width = 320.0F, stacked_height = 704.0F, backup_height = 384.0F,
                roomy_from = 640.0F;
constexpr float search_width = 240.0F, search_least = 160.0F, copy_from = 280.0F;
constexpr double searched_after_s = 0.3;
constexpr std::int32_t lines_per_page = 50, copied_most = 500;

std::string actor_text(const Ui& ui, const AuditLine& line) {
  return line.actor.empty() ? std::string(ui.text("records.nobody")) : line.actor;
}

void draw_deed(Ui& ui, const AuditLine& line, const Rect& cell) {
  Rect rest = cell;
  if (line.was_refused) {
    const float width = pill_width(ui, ui.text("records.refused.one"));
    pill(ui, {rest.x, rest.mid_y()}, ui.text("records.refused.one"), Meaning::Warn);
    take_left(rest, width, 8.0F);
  }
  ui.canvas().text_in(rest, {Type::Small, ui.theme().text}, deed_text(ui.texts(), line), true);
}

std::vector<RowColumn<AuditLine>> columns_of(const Ui& ui) {
  constexpr CellStyle actor{Type::Small, &Theme::text}, entry{Type::Small, &Theme::text_caption};
  using Line = const AuditLine&;
  return {
      {{ui.text("records.when"), 140.0F},
       [](Ui& own, Line line, const Rect& cell) {
         draw_moment_cell(own, cell, line.at_utc, {Type::Small, own.theme().text_secondary});
       }},
      {{ui.text("records.who"), 0.0F, 0.8F},
       [&ui](Line line) { return actor_text(ui, line); },
       actor},
      {{ui.text("records.did"), 0.0F, 1.3F}, draw_deed},
      {{ui.text("records.what"), 0.0F, 1.5F, Align::Left, roomy_from},
       [&ui](Line line) { return subject_text(ui.texts(), line); },
       small_cell},
      {{ui.text("records.entry"), 64.0F, 1.0F, Align::Right, roomy_from},
       [](Line line) { return grouped(static_cast<long>(line.number)); },
       entry},
  };
}

}  // namespace

std::string backup_moment(const std::string& file_name) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0;
  if (std::sscanf(file_name.c_str(), "hallux-%4d%2d%2d-%2d%2d", &year, &month, &day, &hour,
                  &minute) != 5)
    return {};
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d", year, month, day, hour,
                minute);
  return text.data();
}

std::string bytes_text(std::int64_t bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f MB", static_cast<double>(bytes) * 1e-6);
  return text.data();
}

database::AuditRequest AuditScreen::request() const {
  database::AuditRequest request;
  request.before = before_.back();
  request.lines = lines_per_page;
  request.refused_only = filter_ == 1;
  request.search = search_;
  return request;
}

void AuditScreen::read(Ui& ui, Shell& shell) {
  page_.read(ui, shell, ui.text("records.reading"), signed_in_,
             [request = request()](database::Session& session) {
               return administrator_of(session).audit_page(request);
             });
}

void AuditScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (page_.is_new()) read(ui, shell);
  backups_.read(ui, shell, ui.text("records.backup.looking"), signed_in_,
                [](database::Session& session) { return administrator_of(session).backups(); });
  const bool is_stacked = are_panes_stacked(content.w - 2.0F * page_margin(content));
  const Page scrolled(ui, "records", ui.text("records.title"), content,
                      is_stacked ? 480.0F + stacked_height : 704.0F);
  Rect page = scrolled.rect();
  page_head(ui, "records", page,
            course_head(ui, *signed_in_, ui.text("records.title"), ui.text("records.sentence")));
  const Panes panes = panes_of(page, side_width, stacked_height);
  draw_audit(ui, panes.main, shell);
  Rect side = panes.side;
  draw_backup(ui, take_top(side, backup_height, space::between_cards), shell);
  const float origins_height = origins_.height(ui, shell);
  if (origins_height > 0.0F) {
    origins_.draw(ui, take_top(side, origins_height, space::between_cards), shell);
  }
  draw_line(ui, side);
  if (retention_.draw(ui, shell)) read_newest();
}

void AuditScreen::read_newest() {
  before_ = {std::nullopt};
  page_.read_again();
}

// Search and filter beside the title, which goes where there is no room for it.
void AuditScreen::draw_head(Ui& ui, Rect head) {
  const std::array<std::string_view, 2> filters{ui.text("records.all"), ui.text("records.refused")};
  const Rect filter = take_right(head, segmented_width(ui, filters), 16.0F);
  if (segmented(ui, "records.filter", filter, filters, filter_)) read_newest();
  const std::string_view title = ui.text("records.audit");
  const float words = ui.width_of(Type::CardTitle, title) + 24.0F;
  if (head.w >= words + search_least)
    ui.canvas().text_in(take_left(head, words), {Type::CardTitle, ui.theme().text}, title);
  const Rect place = take_right(head, std::min(search_width, head.w));
  if (search_field(ui, "records.search", centred(place, place.w, header_button_height), search_,
                   ui.text("records.search")))
    typed_s_ = ui.time_s();
  if (ui.shortcut({Key::Slash}, ui.text("records.search"))) ui.focus("records.search");
  if (typed_s_ < 0.0) return;
  const double wait_s = typed_s_ + searched_after_s - ui.time_s();
  if (wait_s > 0.0 || page_.is_running()) return ui.want_frame_in_s(std::max(wait_s, 0.02));
  typed_s_ = -1.0;
  read_newest();
  ui.want_frame_in_s(0.0);
}

void AuditScreen::draw_audit(Ui& ui, const Rect& rect, Shell& shell) {
  Rect rest = card(ui, rect, {});
  draw_head(ui, take_top(rest, segmented_height, 6.0F));
  if (!page_.draw_until_ready(ui, "records.failed", rest, 8)) return;
  const Rect foot = take_bottom(rest, 40.0F, 4.0F);
  if (page_.value().lines.empty()) {
    empty_card(ui, "records.none", rest,
               {Icon::Audit, ui.text("records.none"), ui.text("records.none.sentence")});
  } else {
    draw_table(ui, rest);
  }
  draw_pager(ui, foot, shell);
}

void AuditScreen::copy(Ui& ui, Shell& shell) {
  database::AuditRequest all = request();
  all.before.reset();
  all.lines = copied_most;
  copying_.start<database::AuditPage>(
      shell, signed_in_,
      {std::string(ui.text("records.copying")), std::string(ui.text("records.not_copied"))},
      [all](database::Session& session, WorkReport&) {
        return administrator_of(session).audit_page(all);
      },
      [this, &shell, texts = &ui.texts()](database::AuditPage& page) {
        copied_ = audit_csv(*texts, page.lines);
        shell.say({Meaning::Good,
                   texts->say_count("records.copied", static_cast<long>(page.lines.size())),
                   std::string(page.older ? texts->text("records.copied.newest")
                                          : texts->text("history.copied.detail"))});
      });
}

void AuditScreen::draw_table(Ui& ui, const Rect& content) {
  const std::vector<AuditLine>& lines = page_.value().lines;
  RowTable<AuditLine> shown{
      ui.text("records.audit"), [](const AuditLine& line) { return std::to_string(line.number); },
      [&](const AuditLine& line) {
        return ui.texts().say("records.row", {{"did", deed_text(ui.texts(), line)},
                                              {"moment", moment_text(line.at_utc)}});
      },
      columns_of(ui)};
  shown.row_height = 38.0F;
  table_.chosen = {std::to_string(chosen_)};
  const TableResponse response = table(ui, "records.row", content, shown, lines, table_);
  if (response.opened) chosen_ = lines[static_cast<std::size_t>(*response.opened)].number;
}

void AuditScreen::draw_line(Ui& ui, const Rect& rect) const {
  const AuditLine* chosen = nullptr;
  if (page_.is_ready())
    for (const AuditLine& line : page_.value().lines)
      if (line.number == chosen_) chosen = &line;
  if (chosen == nullptr) {
    empty_card(ui, "records.nothing", card(ui, rect, {}, space::side_card),
               {Icon::Audit, ui.text("records.nothing"), ui.text("records.nothing.sentence")});
    return;
  }
  const std::string title =
      ui.texts().say("records.line", {{"number", grouped(static_cast<long>(chosen->number))}});
  Rect rest = card(ui, rect, title, space::side_card);
  fact_moment(ui, rest, ui.text("records.when"), chosen->at_utc);
  fact_line(ui, rest, ui.text("records.who"), actor_text(ui, *chosen));
  fact_line(ui, rest, ui.text("records.outcome"),
            ui.text(chosen->was_refused ? "records.outcome.refused" : "records.outcome.done"));
  take_top(rest, 8.0F);
  text_line(ui, rest, Type::BodyMedium, ui.theme().text, deed_text(ui.texts(), *chosen), 4.0F);
  // A reason may be longer than the card.
  const std::string subject = subject_text(ui.texts(), *chosen);
  const float height = ui.paragraph_height(Type::Small, subject, rest.w - 12.0F);
  const float offset = ui.begin_scroll("records.words", title, rest, height);
  ui.canvas().paragraph({rest.x, rest.y - offset, rest.w - 12.0F, height},
                        {Type::Small, ui.theme().text_secondary}, subject);
  ui.end_scroll();
}

void AuditScreen::draw_pager(Ui& ui, const Rect& line, Shell& shell) {
  const database::AuditPage& page = page_.value();
  const long first = static_cast<long>(before_.size() - 1) * lines_per_page;
  const auto count = static_cast<long>(page.lines.size());
  Rect rest = line;
  ButtonSpec older{ui.text("records.older"), ButtonLook::Secondary},
      newer{ui.text("records.newer"), ButtonLook::Secondary};
  if (!page.older) older.why_off = ui.text("records.older.none");
  if (before_.size() <= 1) newer.why_off = ui.text("records.newer.none");
  if (page_.is_new()) older.why_off = newer.why_off = ui.text("records.reading");
  const auto place = [&](const ButtonSpec& spec) {
    const Rect strip = take_right(rest, button_width(ui, spec), 8.0F);
    return Rect{strip.x, strip.y + 4.0F, strip.w, header_button_height};
  };
  const bool to_older = button(ui, "records.older", place(older), older);
  const bool to_newer = button(ui, "records.newer", place(newer), newer);
  ButtonSpec csv{ui.text("records.copy"), ButtonLook::Secondary, Icon::Copy};
  csv.is_busy = copying_.is_running();
  if (rest.w > copy_from && button(ui, "records.copy", place(csv), csv)) copy(ui, shell);
  if (const std::optional<std::string> copied = std::exchange(copied_, std::nullopt))
    ui.clipboard().write(*copied);
  ui.canvas().text_in(
      rest, {Type::Small, ui.theme().text_caption},
      ui.texts().say("records.range", {{"first", grouped(count > 0 ? first + 1 : 0)},
                                       {"last", grouped(first + count)},
                                       {"all", grouped(static_cast<long>(page.total))}}),
      true);
  if (to_older) before_.push_back(page.older);
  if (to_newer) before_.pop_back();
  if (to_older || to_newer) {
    page_.read_again();
    ui.want_frame_in_s(0.0);
  }
}

void AuditScreen::draw_backup(Ui& ui, const Rect& rect, Shell& shell) {
  Rect rest = card(ui, rect, ui.text("records.backup"), space::side_card);
  text_line(ui, rest, Type::Small, ui.theme().text_secondary, ui.text("records.backup.sentence"),
            16.0F);
  ButtonSpec act{ui.text("records.backup.act"), ButtonLook::Primary, Icon::Backup};
  act.is_busy = backing_up_.is_running();
  Rect line = take_top(rest, button_height, 16.0F);
  line.w = std::min(line.w, button_width(ui, act) + 24.0F);
  if (button(ui, "records.backup", line, act)) back_up(ui, shell);
  const ButtonSpec keep{ui.text("records.retention"), ButtonLook::Secondary};
  if (button_in_line(ui, "records.retention", take_bottom(rest, button_height, 12.0F), keep))
    retention_.open(ui, shell);
  if (backups_.draw_until_ready(ui, "records.backup.failed", rest, 2))
    draw_last_backup(ui, rest, shell);
}

void AuditScreen::draw_last_backup(Ui& ui, Rect& rest, Shell& shell) {
  const std::vector<database::Backup>& backups = backups_.value();
  if (backups.empty()) {
    text_line(ui, rest, Type::Small, ui.theme().warn_text, ui.text("records.backup.none"));
    return;
  }
  const database::Backup& last = backups.front();
  const std::string when =
      ui.texts().say("records.backup.last",
                     {{"moment", full_moment_text(backup_moment(last.file.filename().string()))},
                      {"ago", ago_text(ui.texts(), last.made_utc, utc_now_text())},
                      {"size", bytes_text(last.bytes)}});
  text_line(ui, rest, Type::SmallMedium, ui.theme().text, when, 4.0F);
  if (backups.size() > 1) {
    text_line(ui, rest, Type::Small, ui.theme().text_secondary,
              ui.texts().say("records.backup.kept",
                             {{"count", grouped(static_cast<long>(backups.size()))},
                              {"moment", full_moment_text(backups.back().made_utc)}}),
              4.0F);
  }
  text_line(ui, rest, Type::Small, ui.theme().text_caption, last.file.string(), 10.0F);
  if (link(ui, "records.backup.copy", {rest.x, rest.y + 10.0F}, ui.text("records.backup.copy"))) {
    ui.clipboard().write(last.file.string());
    shell.say({Meaning::Good, std::string(ui.text("records.backup.copied"))});
    ui.want_frame_in_s(0.0);
  }
}

void AuditScreen::back_up(Ui& ui, Shell& shell) {
  backing_up_.start<database::Backup>(
      shell, signed_in_,
      {std::string(ui.text("records.backup.running")),
       std::string(ui.text("records.backup.not_made")),
       std::string(ui.text("records.backup.stopped"))},
      [](database::Session& session, WorkReport& report) {
        return administrator_of(session).back_up(
            {}, [&report](double share) { return report.reached(share); });
      },
      [this, &shell, said = std::string(ui.text("records.backup.made"))](database::Backup& backup) {
        shell.say({Meaning::Good, said, backup.file.string()});
        backups_.read_again();
        read_newest();
      });
}

}  // namespace hallux::ui
