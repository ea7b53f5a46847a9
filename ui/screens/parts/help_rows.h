/// Questions about a moment of an attempt, as they stand in a list: of the inbox and of the one who
/// asked.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "database/records/note.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// How a list of questions names a row.
struct HelpRowsSpec {
  /// Of the table.
  std::string_view id = {};
  std::string_view label = {};
  /// The inbox; else who asked is the reader.
  bool names_asker = false;
};

/// A table of questions with the chosen one lit. Returns the row that was opened, -1 for none.
int help_rows(Ui& ui, const Rect& rect, const HelpRowsSpec& spec,
              std::span<const database::HelpRequest* const> requests,
              database::HelpRequestId chosen);

/// "Akin, at 02:31".
std::string help_moment(const Texts& texts, const database::HelpRequest& request);

/// The question, what it is about, and the answer where there is one; cuts what it takes off
/// `rest`. True where the moment should be shown; its button is `id.moment`.
bool draw_help_request(Ui& ui, std::string_view id, Rect& rest,
                       const database::HelpRequest& request, bool names_asker);

/// The height draw_help_request takes at this width.
float help_request_height(const Ui& ui, const database::HelpRequest& request, float width);

}  // namespace hallux::ui
