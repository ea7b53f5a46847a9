// Rules first, then what they mean today: the rules are stored when the plan is asked for, and
// nothing goes before the list of it was seen and agreed to. The lines are made once, when the plan
// arrives, and only those in sight are laid out: there may be thousands.
#include "ui/screens/administrator/retention_dialogs.h"

#include <charconv>
#include <utility>

#include "ui/screens/administrator/audit_screen.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {

namespace {

using database::RetentionPiece;
using database::RetentionRules;

constexpr float field_gap = 14.0F, row_height = 24.0F, list_height = 264.0F;
constexpr std::array<std::string_view, 4> field_ids{
    "records.retention.practice", "records.retention.assessment", "records.retention.account",
    "records.retention.cache"};
constexpr std::array<std::string_view, 4> kind_ids{
    "records.retention.kind.practice", "records.retention.kind.assessment",
    "records.retention.kind.account", "records.retention.kind.cache"};

std::string text_of(const std::optional<std::int32_t>& days) {
  return days ? std::to_string(*days) : std::string();
}

bool is_days(const std::string& text) {
  return text.size() <= 5 && text.find_first_not_of("0123456789") == std::string::npos &&
         text != "0";
}

std::optional<std::int32_t> days_in(const std::string& text) {
  if (text.empty()) return std::nullopt;
  std::int32_t days = 0;
  std::from_chars(text.data(), text.data() + text.size(), days);
  return days;
}

std::string line_of(const Texts& texts, const RetentionPiece& piece) {
  const std::string_view kind = texts.text(kind_ids[static_cast<std::size_t>(piece.kind)]);
  const std::string whose = piece.login.empty() ? piece.name.substr(0, 12) : piece.login;
  return texts.say("records.retention.piece", {{"kind", std::string(kind)},
                                               {"whose", whose},
                                               {"since", date_text(piece.since_utc)},
                                               {"size", bytes_text(piece.bytes)}});
}

}  // namespace

RetentionDialogs::Plan RetentionDialogs::plan_of(const Texts& texts,
                                                 const std::vector<RetentionPiece>& pieces) {
  std::array<long, 4> counts{};
  std::int64_t bytes = 0;
  Plan plan;
  for (const RetentionPiece& piece : pieces) {
    ++counts[static_cast<std::size_t>(piece.kind)];
    bytes += piece.bytes;
    plan.lines.push_back(line_of(texts, piece));
  }
  plan.summary = texts.say("records.retention.summary", {{"practices", std::to_string(counts[0])},
                                                         {"assessments", std::to_string(counts[1])},
                                                         {"accounts", std::to_string(counts[2])},
                                                         {"cached", std::to_string(counts[3])},
                                                         {"size", bytes_text(bytes)}});
  return plan;
}

void RetentionDialogs::open(Ui& ui, Shell& shell) {
  if (work_.is_running()) return;
  work_.start<RetentionRules>(
      shell, signed_in_,
      {std::string(ui.text("records.retention.reading")),
       std::string(ui.text("records.retention.failed"))},
      [](database::Session& session, WorkReport&) { return administrator_of(session).retention(); },
      [this](RetentionRules& rules) {
        days_ = Days{text_of(rules.practice_days), text_of(rules.assessment_days),
                     text_of(rules.account_days), text_of(rules.cache_days)};
      });
}

bool RetentionDialogs::draw(Ui& ui, Shell& shell) {
  if (days_) draw_days(ui, shell);
  if (plan_) draw_plan(ui, shell);
  return std::exchange(has_changed_, false);
}

void RetentionDialogs::draw_days(Ui& ui, Shell& shell) {
  Dialog shown = form_dialog(ui, ui.text("records.retention"), ui.text("records.retention.look"),
                             {work_.fault(), work_.is_running()},
                             4.0F * (field_label_height + field_height + field_gap));
  shown.sentence = ui.text("records.retention.sentence");
  const Answer answer = dialog(ui, "records.retention.days", shown, [&](Rect form) {
    bool are_days = true;
    for (std::size_t i = 0; i < field_ids.size(); ++i) {
      labelled_field(ui, field_ids[i], form, (*days_)[i],
                     {.label = ui.text(field_ids[i]),
                      .placeholder = ui.text("records.retention.ever"),
                      .max_bytes = 5},
                     field_gap);
      are_days = are_days && is_days((*days_)[i]);
    }
    ui.focus_first(field_ids[0]);
    return are_days ? std::string_view() : ui.text("records.retention.missing");
  });
  if (answer == Answer::Keep) days_.reset();
  if (answer == Answer::Act) save(ui, shell);
}

void RetentionDialogs::save(Ui& ui, Shell& shell) {
  const RetentionRules rules{days_in((*days_)[0]), days_in((*days_)[1]), days_in((*days_)[2]),
                             days_in((*days_)[3])};
  work_.start<std::vector<RetentionPiece>>(
      shell, signed_in_, {std::string(ui.text("records.retention.reading")), {}},
      [rules](database::Session& session, WorkReport&) {
        database::AdministratorDesk desk = administrator_of(session);
        if (desk.retention() != rules) desk.set_retention(rules);
        return desk.retention_plan();
      },
      [this, &shell, &texts = ui.texts()](std::vector<RetentionPiece>& pieces) {
        days_.reset();
        has_changed_ = true;
        if (pieces.empty()) {
          shell.say({Meaning::Info, std::string(texts.text("records.retention.nothing"))});
        } else {
          plan_ = plan_of(texts, pieces);
        }
      });
}

void RetentionDialogs::draw_plan(Ui& ui, Shell& shell) {
  Dialog shown =
      form_dialog(ui, ui.text("records.retention.plan"), ui.text("records.retention.act"),
                  {work_.fault(), work_.is_running()}, list_height);
  shown.keep = ui.text("records.retention.keep");
  shown.sentence = plan_->summary;
  shown.is_dangerous = true;
  const Answer answer = dialog(ui, "records.retention.plan", shown, [&](const Rect& form) {
    const float height = row_height * static_cast<float>(plan_->lines.size());
    const float offset = ui.begin_scroll("records.retention.list", shown.title, form, height);
    Rect line{form.x, form.y - offset, form.w - 12.0F, row_height};
    for (const std::string& words : plan_->lines) {
      // What is scrolled away need not be laid out: there may be thousands.
      if (line.bottom() > form.y && line.y < form.bottom()) {
        ui.canvas().text_in(line, {Type::Small, ui.theme().text_secondary}, words, true);
      }
      line.y += row_height;
    }
    ui.end_scroll();
    return std::string_view();
  });
  if (answer == Answer::Keep) plan_.reset();
  if (answer == Answer::Act) clean_up(ui, shell);
}

void RetentionDialogs::clean_up(Ui& ui, Shell& shell) {
  work_.start<database::RetentionDone>(
      shell, signed_in_,
      {std::string(ui.text("records.retention.running")),
       {},
       std::string(ui.text("records.retention.stopped"))},
      [](database::Session& session, WorkReport& report) {
        return administrator_of(session).retain(
            [&report](double share) { return report.reached(share); });
      },
      [this, &shell, &texts = ui.texts()](database::RetentionDone& done) {
        plan_.reset();
        has_changed_ = true;
        shell.say({Meaning::Good, texts.say("records.retention.done",
                                            {{"recordings", std::to_string(done.recordings)},
                                             {"accounts", std::to_string(done.accounts)},
                                             {"cached", std::to_string(done.cached)},
                                             {"size", bytes_text(done.bytes)}})});
      });
}

}  // namespace hallux::ui
