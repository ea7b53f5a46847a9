/// What was said about moments of an attempt: notes and questions in the order of their moments.
/// Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "database/records/note.h"

namespace hallux::ui {

/// A note or a question.
struct Remark {
  bool is_question = false;
  /// In its own list.
  std::size_t index = 0;
  std::int64_t moment_us = 0;
  /// Of notes, and of questions, from 1 on.
  std::size_t number = 1;
};

struct Remarks {
  std::vector<database::Note> notes;
  std::vector<database::HelpRequest> questions;
  /// By moment; a note before a question of the same one.
  std::vector<Remark> order;

  /// Nothing where it is the other.
  const database::Note* note(const Remark& remark) const noexcept {
    return remark.is_question ? nullptr : &notes[remark.index];
  }
  const database::HelpRequest* question(const Remark& remark) const noexcept {
    return remark.is_question ? &questions[remark.index] : nullptr;
  }
  const database::AttemptMoment& moment(const Remark& remark) const noexcept {
    return remark.is_question ? questions[remark.index].moment : notes[remark.index].moment;
  }
};

Remarks remarks_of(std::vector<database::Note> notes, std::vector<database::HelpRequest> questions);
double second_of(const Remark& remark) noexcept;

}  // namespace hallux::ui
