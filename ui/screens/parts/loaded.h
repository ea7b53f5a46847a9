/// What a screen has to read before it can show it: bars while it is read, a sentence and a button
/// where it failed.
///
///     Loaded<std::vector<Person>> people_;
///     people_.read(ui, shell, label, signed_in_, [](database::Session& session) { return ...; });
///     if (people_.draw_until_ready(ui, "people.reading", inside, 8))
///       draw_people(ui, inside, people_.value());
#pragma once

#include <functional>
#include <optional>

#include "ui/screens/parts/screen_work.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

/// The failed card of whatever could not be read; its button is `id.action`. True where it was
/// pressed.
inline bool draw_unread(Ui& ui, std::string_view id, const Rect& content,
                        const std::string& reason) {
  const std::string_view why = reason.empty() ? ui.text("reading.stopped") : reason;
  return failed_card(ui, id, content, {ui.text("reading.failed"), why, ui.text("reading.again")});
}

template <typename Value>
class Loaded {
 public:
  bool is_new() const noexcept { return state_ == State::New; }
  bool is_ready() const noexcept { return state_ == State::Ready; }
  bool is_running() const noexcept { return state_ == State::Running; }
  /// Also while it is read anew.
  bool has_value() const noexcept { return value_.has_value(); }
  /// needs   has_value
  const Value& value() const { return value_.value(); }
  Value& value() { return value_.value(); }
  /// What was shown stays until what is read anew takes its place.
  void read_again() noexcept { state_ = State::New; }

  /// Reads in the session's turn where nothing was read yet or it is to be read again.
  void read(Ui& ui, Shell& shell, std::string_view label,
            std::shared_ptr<SignedInSession> signed_in,
            std::function<Value(database::Session&)> read) {
    if (!is_new()) return;
    start(ui, shell, label,
          [signed_in = std::move(signed_in), read = std::move(read)](WorkReport&) {
            return signed_in->in_turn(
                [&](database::Session& session, auto&) { return read(session); });
          });
  }

  /// `read` runs beside the window; it may hold nothing of the screen's.
  void start(Ui& ui, Shell& shell, std::string_view label, std::function<Value(WorkReport&)> read) {
    state_ = State::Running;
    since_s_ = ui.time_s();
    auto found = std::make_shared<std::optional<Value>>();
    work_.start(
        shell, std::string(label),
        [found, read = std::move(read)](WorkReport& report) { found->emplace(read(report)); },
        [this, found](WorkEnd end, const std::string& reason) {
          state_ = end == WorkEnd::Done ? State::Ready : State::Failed;
          reason_ = end == WorkEnd::Failed ? sentence_of(reason) : std::string();
          if (end == WorkEnd::Done) value_ = std::move(*found);
        });
  }

  /// True where there is a value to draw. Else draws what stands in its place; after the button the
  /// next is_new is true.
  bool draw_until_ready(Ui& ui, std::string_view id, const Rect& content, int rows) {
    if (state_ == State::Failed) {
      if (draw_unread(ui, id, content, reason_)) {
        state_ = State::New;
        ui.want_frame_in_s(0.0);
      }
      return false;
    }
    if (!value_) loading_rows(ui, content, rows, since_s_);
    return value_.has_value();
  }

 private:
  enum class State { New, Running, Ready, Failed };

  State state_ = State::New;
  double since_s_ = 0.0;
  std::string reason_;
  std::optional<Value> value_;
  ScreenWork work_;
};

}  // namespace hallux::ui
