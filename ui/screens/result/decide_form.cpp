#include "ui/screens/result/decide_form.h"

#include <array>
#include <charconv>
#include <cmath>

#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {

namespace {

using database::DecisionKind;

constexpr float reason_height = 84.0F, gap = 18.0F;

constexpr std::array<std::string_view, 3> verbs{"result.decide.confirm", "result.decide.override",
                                                "result.decide.void"};
constexpr std::array<std::string_view, 3> sentences{"result.decide.confirm.sentence",
                                                    "result.decide.override.sentence",
                                                    "result.decide.void.sentence"};
constexpr std::array<std::string_view, 3> outcomes{
    "result.decided.confirmed", "result.decided.overridden", "result.decided.voided"};

}  // namespace

std::optional<std::int64_t> score_from(std::string_view words) noexcept {
  double points = 0.0;
  const char* const end = words.data() + words.size();
  const auto read = std::from_chars(words.data(), end, points, std::chars_format::fixed);
  if (read.ec != std::errc() || read.ptr != end || !(points >= 0.0) || points > 100.0)
    return std::nullopt;
  return std::llround(points * 1000.0);
}

void DecideForm::open(const ResultFacts& facts) {
  is_open_ = true;
  is_asking_ = false;
  chosen_ = facts.score ? 0 : static_cast<int>(DecisionKind::Voided);
  score_ = facts.score ? points_text(facts.standing_milli().value_or(0)) : std::string();
  reason_.clear();
  work_.forget_fault();
}

std::string_view DecideForm::draw_fields(Ui& ui, const Rect& form) {
  Rect rest = form;
  const std::array<std::string_view, 3> labels{ui.text("result.decide.confirm.short"),
                                               ui.text("result.decide.override.short"),
                                               ui.text("result.decide.void.short")};
  segmented(ui, "decide.kind", take_top(rest, segmented_height, gap), labels, chosen_);
  if (kind() == DecisionKind::Overridden) {
    FieldSpec score;
    score.label = ui.text("result.decide.score");
    if (!score_.empty() && !score_from(score_)) score.error = ui.text("result.decide.score.rule");
    if (labelled_field(ui, "decide.score", rest, score_, score, field_message_height))
      ui.want_frame_in_s(0.0);
  }
  take_top(rest, field_label_height);
  FieldSpec reason;
  reason.label = ui.text("result.decide.reason");
  reason.placeholder = ui.text("result.decide.reason.example");
  reason.lines = 3;
  reason.max_bytes = 2000;
  field(ui, "decide.reason", take_top(rest, reason_height), reason_, reason);
  ui.focus_first("decide.reason");
  if (kind() == DecisionKind::Overridden && !score_from(score_))
    return ui.text("result.decide.missing.score");
  return reason_.empty() ? ui.text("result.decide.missing.reason") : std::string_view();
}

void DecideForm::start(Ui& ui, Shell& shell, const ResultFacts& facts) {
  database::NewDecision decision{facts.header.id, kind(), score_from(score_).value_or(0), reason_};
  const std::string title(ui.text(outcomes[static_cast<std::size_t>(chosen_)]));
  work_.change(
      shell, signed_in_, {std::string(ui.text("result.deciding")), {}},
      [header = facts.header, decision](database::Session& session) {
        desk_or_refused(instructor_desk_for(session, database::Action::DecideResult, header),
                        "this result is not yours to decide")
            .decide(decision);
      },
      [this, &shell, title] {
        is_open_ = false;
        was_decided_ = true;
        shell.say({Meaning::Good, title});
      });
}

void DecideForm::draw_question(Ui& ui, Shell& shell, const ResultFacts& facts) {
  const Question asked{ui.text("result.void.question"), ui.text("result.void.consequence"),
                       ui.text("result.decide.void"), ui.text("result.void.keep"), true};
  const Answer answer = question(ui, "decide.void", asked);
  if (answer == Answer::Waiting) return;
  is_asking_ = false;
  if (answer == Answer::Act) start(ui, shell, facts);
}

bool DecideForm::draw(Ui& ui, Shell& shell, const ResultFacts& facts) {
  if (std::exchange(was_decided_, false)) return true;
  if (!is_open_) return false;
  if (is_asking_) {
    draw_question(ui, shell, facts);
    return false;
  }
  const bool is_override = kind() == DecisionKind::Overridden;
  Dialog shown =
      form_dialog(ui, ui.text("result.decide"), ui.text(verbs[static_cast<std::size_t>(chosen_)]),
                  {work_.fault(), work_.is_running()},
                  segmented_height + gap + field_label_height + reason_height);
  shown.keep = ui.text("result.decide.cancel");
  shown.sentence = ui.text(sentences[static_cast<std::size_t>(chosen_)]);
  shown.is_dangerous = kind() == DecisionKind::Voided;
  if (is_override) shown.form_height += field_label_height + field_height + field_message_height;
  const Answer answer =
      dialog(ui, "decide", shown, [&](const Rect& form) { return draw_fields(ui, form); });
  if (answer == Answer::Keep) is_open_ = false;
  if (answer != Answer::Act || work_.is_running()) return false;
  if (kind() == DecisionKind::Voided) {
    is_asking_ = true;
  } else {
    start(ui, shell, facts);
  }
  return false;
}

}  // namespace hallux::ui
