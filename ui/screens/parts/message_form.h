/// A form for a person's own words to somebody: a question, a note. Sent as work; what went wrong
/// is said in the form.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ui/screens/parts/desk_work.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

struct MessageFormSpec {
  /// Of its controls: "ask" gives "ask.words", "ask.act", "ask.keep".
  std::string_view id = {};
  std::string_view title = {}, sentence = {};
  /// Of the field.
  std::string_view label = {};
  std::string_view placeholder = {};
  /// The verb.
  std::string_view act = {};
  /// A choice beside it, "ask.toggle"; empty: none.
  std::string_view toggle = {};
  /// While it is sent; once it was.
  std::string_view sending = {}, sent = {};
};

/// A question about a moment of an attempt, its controls named "ask.…".
MessageFormSpec question_form(const Ui& ui, std::string_view title, std::string_view sentence);

class MessageForm {
 public:
  /// What happens with the words and the choice, beside the window; it holds nothing of the
  /// screen's.
  using Send =
      std::function<void(database::Session& session, const std::string& words, bool is_on)>;

  void open();
  bool is_open() const noexcept { return is_open_; }
  /// Draws the form while it is open. True in the frame after it was sent.
  bool draw(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
            const MessageFormSpec& spec, const Send& send);

 private:
  void start(Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
             const MessageFormSpec& spec, const Send& send);

  bool is_open_ = false, is_on_ = false, was_sent_ = false;
  std::string words_;
  DeskWork work_;
};

}  // namespace hallux::ui
