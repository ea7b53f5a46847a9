/// What instructors and trainee say to each other about moments of an attempt: notes with their
/// replies and questions with their answers in one list, and a line to answer a note.
/// Inside this corner only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/screens/parts/attempt_desks.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/replay/remarks.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class NotesPanel {
 public:
  NotesPanel(std::shared_ptr<SignedInSession> signed_in, database::AttemptId attempt)
      : signed_in_(std::move(signed_in)), attempt_(std::move(attempt)) {}

  /// Reads them where they are new.
  void read(Ui& ui, Shell& shell);
  void read_again() noexcept { remarks_.read_again(); }
  /// Empty until they were read.
  const Remarks& remarks() const noexcept;
  /// By its place in the order of remarks.
  void choose(std::size_t remark) noexcept { chosen_ = remark; }
  const std::optional<std::size_t>& chosen() const noexcept { return chosen_; }
  bool has_reply() const noexcept { return !reply_.empty(); }

  /// Returns the moment of the note or question that was chosen in this frame.
  std::optional<double> draw(Ui& ui, Shell& shell, const Rect& rect,
                             const database::AttemptHeader& header, const AttemptRights& rights);

 private:
  /// The chosen one, where it is a note.
  const database::Note* chosen_note() const noexcept;
  std::optional<double> draw_list(Ui& ui, const Rect& rect);
  void draw_reply(Ui& ui, Shell& shell, const Rect& rect, const database::AttemptHeader& header);
  void send(Ui& ui, Shell& shell, const database::AttemptHeader& header);

  std::shared_ptr<SignedInSession> signed_in_;
  database::AttemptId attempt_;
  Loaded<Remarks> remarks_;
  const Remarks none_;
  std::optional<std::size_t> chosen_;
  std::string reply_;
  DeskWork work_;
};

/// How a remark is marked on the bone, on the timeline and in the list.
void draw_remark_badge(Ui& ui, Point centre, const Remarks& remarks, const Remark& remark);

}  // namespace hallux::ui
