/// What instructors and trainee say to each other about moments of an attempt: a list with replies,
/// and a line to answer. Inside this corner only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/screens/parts/attempt_desks.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class NotesPanel {
 public:
  NotesPanel(std::shared_ptr<SignedInSession> signed_in, database::AttemptId attempt)
      : signed_in_(std::move(signed_in)), attempt_(std::move(attempt)) {}

  /// Reads the notes where they are new.
  void read(Ui& ui, Shell& shell);
  void read_again() noexcept { notes_.read_again(); }
  /// By moment; empty until they were read. Their numbers are their places, from 1 on.
  const std::vector<database::Note>& notes() const noexcept;
  void choose(std::size_t note) noexcept { chosen_ = note; }
  const std::optional<std::size_t>& chosen() const noexcept { return chosen_; }
  bool has_reply() const noexcept { return !reply_.empty(); }

  /// Returns the moment of the note that was chosen in this frame.
  std::optional<double> draw(Ui& ui, Shell& shell, const Rect& rect,
                             const database::AttemptHeader& header, const AttemptRights& rights);

 private:
  std::optional<double> draw_list(Ui& ui, const Rect& rect);
  void draw_reply(Ui& ui, Shell& shell, const Rect& rect, const database::AttemptHeader& header);
  void send(Ui& ui, Shell& shell, const database::AttemptHeader& header);

  std::shared_ptr<SignedInSession> signed_in_;
  database::AttemptId attempt_;
  Loaded<std::vector<database::Note>> notes_;
  const std::vector<database::Note> none_;
  std::optional<std::size_t> chosen_;
  std::string reply_;
  DeskWork work_;
};

/// A number on a disc, as it marks a note on the bone, on the timeline and in the list.
void draw_note_badge(Ui& ui, Point centre, std::size_t number);

}  // namespace hallux::ui
