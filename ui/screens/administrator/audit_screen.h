/// What was done in the course, line by line, and copies of all that is kept.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/administrator/origins_card.h"
#include "ui/screens/administrator/retention_dialogs.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

class AuditScreen : public Screen {
 public:
  explicit AuditScreen(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(signed_in), retention_(signed_in), origins_(std::move(signed_in)) {}

  GuideSection guide_section() const override { return GuideSection::Records; }
  std::string_view navigation_id() const override { return "nav.records"; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  database::AuditRequest request() const;
  void read(Ui& ui, Shell& shell);
  void draw_head(Ui& ui, Rect head);
  /// Reads what fits as many lines as there may be, and puts them on the clipboard.
  void copy(Ui& ui, Shell& shell);
  /// Goes back to the first page, which is read again.
  void read_newest();
  void draw_audit(Ui& ui, const Rect& rect, Shell& shell);
  void draw_table(Ui& ui, const Rect& content);
  void draw_pager(Ui& ui, const Rect& line, Shell& shell);
  void draw_line(Ui& ui, const Rect& rect) const;
  void draw_backup(Ui& ui, const Rect& rect, Shell& shell);
  void draw_last_backup(Ui& ui, Rect& rest, Shell& shell);
  void back_up(Ui& ui, Shell& shell);

  std::shared_ptr<SignedInSession> signed_in_;
  Loaded<database::AuditPage> page_;
  /// Newest first.
  Loaded<std::vector<database::Backup>> backups_;
  /// Of each page so far.
  std::vector<std::optional<std::int64_t>> before_{std::nullopt};
  /// 0 all, 1 refused only.
  int filter_ = 0;
  std::string search_;
  /// Frame time at which something was typed that was not searched for yet; below 0: nothing.
  double typed_s_ = -1.0;
  TableState table_;
  /// Number of the line whose words are shown; 0: none.
  std::int64_t chosen_ = 0;
  DeskWork backing_up_, copying_;
  /// Copied, for the clipboard of the next frame.
  std::optional<std::string> copied_;
  RetentionDialogs retention_;
  OriginsCard origins_;
};

/// The moment in a backup's name, "hallux-20260303-140210.db": ISO 8601; "" where it has none.
std::string backup_moment(const std::string& file_name);

/// "12.3 MB"
std::string bytes_text(std::int64_t bytes);

}  // namespace hallux::ui
