// Versions of operations and the sheet of the chosen one. Publishing retires the version that was
// published: the question says which. What is published is proven first, beside the window: a
// rubric that does not tell a good performance from a bad one reaches no trainee. The sheet is the
// text that a surgeon signs, set as it is printed: lines by their indent, heads darker, origins
// lighter.
#include "ui/screens/administrator/scenarios_screen.h"

#include <algorithm>

#include "simulator/base/progress.h"
#include "ui/jobs/course/course_jobs.h"
#include "ui/jobs/course/scenario_jobs.h"
#include "ui/jobs/publish_scenario.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/sight/check_start_view.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

namespace {

using database::ScenarioState;
using database::ScenarioVersion;

constexpr ListPageSpec page_spec{1000.0F, 0.46F, 560.0F, 420.0F, 520.0F};
constexpr float review_from = 420.0F, attempts_from = 500.0F;

std::string name_text(const Texts& texts, const ScenarioVersion& version) {
  return texts.say("scenarios.version_of", {{"operation", operation_text(version.name)},
                                            {"version", std::to_string(version.version)}});
}

std::string_view state_id(ScenarioState state) noexcept {
  if (state == ScenarioState::Draft) return "scenarios.draft";
  return state == ScenarioState::Published ? "scenarios.published" : "scenarios.retired";
}

Meaning meaning_of(ScenarioState state) noexcept {
  if (state == ScenarioState::Draft) return Meaning::Info;
  return state == ScenarioState::Published ? Meaning::Good : Meaning::Neutral;
}

std::string_view review_id(const ScenarioVersion& version) noexcept {
  return version.is_reviewed ? "scenarios.reviewed" : "scenarios.not_reviewed";
}

std::vector<RowColumn<ScenarioVersion>> columns_of(const Ui& ui) {
  using Version = const ScenarioVersion&;
  return {
      {{ui.text("scenarios.operation")},
       [](Version version) { return operation_text(version.name); },
       name_cell},
      {{ui.text("scenarios.version"), 56.0F, 1.0F, Align::Right},
       [](Version version) { return std::to_string(version.version); }},
      {{ui.text("scenarios.state"), 106.0F},
       [](Ui& own, Version version, const Rect& cell) {
         pill(own, {cell.x, cell.mid_y()}, own.text(state_id(version.state)),
              meaning_of(version.state));
       }},
      {{ui.text("scenarios.review"), 150.0F, 1.0F, Align::Left, review_from},
       [](Ui& own, Version version, const Rect& cell) {
         const CellStyle warning{Type::Small, &Theme::warn_text};
         draw_cell_text(own, cell, Align::Left, version.is_reviewed ? small_cell : warning,
                        own.text(review_id(version)));
       }},
      {{ui.text("scenarios.attempts"), 66.0F, 1.0F, Align::Right, attempts_from},
       [](Version version) { return grouped(version.attempts); }},
  };
}

/// One line of the sheet: how far it is set in, and how it looks.
struct SheetLine {
  std::string_view words;
  float indent = 0.0F;
  bool is_head = false, is_origin = false;
};

std::vector<SheetLine> lines_of(std::string_view sheet) {
  std::vector<SheetLine> lines;
  while (!sheet.empty()) {
    const std::size_t end = std::min(sheet.find('\n'), sheet.size());
    std::string_view words = sheet.substr(0, end);
    sheet.remove_prefix(std::min(end + 1, sheet.size()));
    const std::size_t spaces = std::min(words.find_first_not_of(' '), words.size());
    words.remove_prefix(spaces);
    lines.push_back(
        {words, static_cast<float>(spaces) * 5.0F, spaces == 0, words.starts_with("origin:")});
  }
  return lines;
}

float line_gap(const SheetLine& line) noexcept { return line.words.empty() ? 10.0F : 3.0F; }

float sheet_height(const Ui& ui, const std::vector<SheetLine>& lines, float width) {
  float height = 0.0F;
  for (const SheetLine& line : lines)
    height +=
        line_gap(line) + (line.words.empty()
                              ? 0.0F
                              : ui.paragraph_height(line.is_head ? Type::SmallMedium : Type::Small,
                                                    line.words, width - line.indent));
  return height;
}

void draw_sheet(Ui& ui, const Rect& content, const std::string& sheet) {
  const std::vector<SheetLine> lines = lines_of(sheet);
  const float width = content.w - 12.0F, height = sheet_height(ui, lines, width);
  const float offset =
      ui.begin_scroll("scenarios.sheet", ui.text("scenarios.sheet"), content, height);
  float y = content.y - offset;
  for (const SheetLine& line : lines) {
    const Type type = line.is_head ? Type::SmallMedium : Type::Small;
    const Theme& theme = ui.theme();
    const Color ink = line.is_head     ? theme.text
                      : line.is_origin ? theme.text_caption
                                       : theme.text_secondary;
    if (!line.words.empty()) {
      const float own = ui.paragraph_height(type, line.words, width - line.indent);
      ui.canvas().paragraph({content.x + line.indent, y, width - line.indent, own}, {type, ink},
                            line.words);
      y += own;
    }
    y += line_gap(line);
  }
  ui.end_scroll();
}

}  // namespace

void ScenariosScreen::read_sheet(Ui& ui, Shell& shell) {
  sheet_of_ = chosen_;
  sheet_.start(ui, shell, ui.text("scenarios.reading_sheet"),
               [signed_in = signed_in_, id = *chosen_](WorkReport&) {
                 const database::ScenarioText text =
                     signed_in->in_turn([&](database::Session& session, auto&) {
                       return administrator_of(session).scenario_text(id);
                     });
                 return scenario_sheet(scenarios::parse_scenario(text.json, text.name));
               });
}

const ScenarioVersion* ScenariosScreen::chosen() const {
  for (const ScenarioVersion& version : versions_.value())
    if (version.id == chosen_) return &version;
  return nullptr;
}

const ScenarioVersion* ScenariosScreen::published_beside(const ScenarioVersion& version) const {
  for (const ScenarioVersion& other : versions_.value())
    if (other.name == version.name && other.state == ScenarioState::Published &&
        other.id != version.id)
      return &other;
  return nullptr;
}

void ScenariosScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  versions_.read(ui, shell, ui.text("scenarios.reading"), signed_in_,
                 [](database::Session& session) { return administrator_of(session).scenarios(); });
  draw_page(ui, content, shell);
  draw_import_dialog(ui, shell);
  draw_question(ui, shell);
}

void ScenariosScreen::draw_page(Ui& ui, const Rect& content, Shell& shell) {
  const ButtonSpec act{ui.text("scenarios.import"), ButtonLook::Primary, Icon::Import};
  PageHead head =
      course_head(ui, *signed_in_, ui.text("scenarios.title"), ui.text("scenarios.sentence"));
  head.buttons_width = button_width(ui, act);
  const ListPage page(ui, "scenarios", head, content, page_spec);
  if (button(ui, "scenarios.import", page.buttons(), act)) {
    file_.emplace();
    importing_.forget_fault();
  }
  if (!versions_.draw_until_ready(ui, "scenarios.failed", page.list(), 6)) {
    card(ui, page.side(), {});
    return;
  }
  if (!chosen_ && !versions_.value().empty()) chosen_ = versions_.value().front().id;
  draw_table(ui, page.list());
  draw_chosen(ui, page.side(), shell);
}

void ScenariosScreen::draw_table(Ui& ui, const Rect& content) {
  const std::vector<ScenarioVersion>& versions = versions_.value();
  if (versions.empty()) {
    empty_card(ui, "scenarios.empty", content,
               {Icon::Scenarios, ui.text("scenarios.empty"), ui.text("scenarios.empty.sentence")});
    return;
  }
  const RowTable<ScenarioVersion> shown{
      ui.text("scenarios.title"),
      [](const ScenarioVersion& version) { return std::to_string(version.id.number); },
      [&](const ScenarioVersion& version) { return name_text(ui.texts(), version); },
      columns_of(ui)};
  table_.chosen.clear();
  if (chosen_) table_.chosen.insert(std::to_string(chosen_->number));
  const TableResponse response = table(ui, "scenarios.row", content, shown, versions, table_);
  if (response.opened) chosen_ = versions[static_cast<std::size_t>(*response.opened)].id;
}

void ScenariosScreen::draw_chosen(Ui& ui, const Rect& rect, Shell& shell) {
  const Rect inside = card(ui, rect, {});
  const ScenarioVersion* version = chosen();
  if (version == nullptr) {
    empty_card(
        ui, "scenarios.nothing", inside,
        {Icon::Scenarios, ui.text("scenarios.nothing"), ui.text("scenarios.nothing.sentence")});
    return;
  }
  if (sheet_of_ != chosen_ || sheet_.is_new()) read_sheet(ui, shell);
  Rect rest = inside;
  ui.canvas().text_in(take_top(rest, 26.0F, 4.0F), {Type::CardTitle, ui.theme().text},
                      name_text(ui.texts(), *version), true);
  const std::string since =
      version->changed_by.empty()
          ? full_moment_text(version->since_utc)
          : ui.texts().say("scenarios.since", {{"moment", full_moment_text(version->since_utc)},
                                               {"person", version->changed_by}});
  fact_line(ui, rest, ui.text("scenarios.state"), ui.text(state_id(version->state)));
  fact_line(ui, rest, ui.text("scenarios.since_when"), since);
  fact_line(ui, rest, ui.text("scenarios.review"), ui.text(review_id(*version)));
  fact_line(ui, rest, ui.text("scenarios.attempts"), grouped(version->attempts));
  take_top(rest, 8.0F);
  draw_actions(ui, rest, *version);
  ui.canvas().hairline_across(rest.x, rest.y, rest.w, ui.theme().line);
  take_top(rest, 14.0F);
  // What is shown belongs to another version until the sheet was read.
  if (sheet_.draw_until_ready(ui, "scenarios.unread", rest, 6))
    draw_sheet(ui, rest, sheet_.value());
}

void ScenariosScreen::draw_actions(Ui& ui, Rect& rest, const ScenarioVersion& version) {
  const bool is_published = version.state == ScenarioState::Published;
  ButtonSpec act{ui.text(is_published ? "scenarios.retire" : "scenarios.publish"),
                 is_published ? ButtonLook::Danger : ButtonLook::Secondary};
  if (is_proving()) act.why_off = ui.text("button.busy");
  if (button_in_line(ui, is_published ? "scenarios.retire" : "scenarios.publish",
                     take_top(rest, button_height, 14.0F), act))
    asked_ = Asked{version, !is_published};
}

void ScenariosScreen::draw_import_dialog(Ui& ui, Shell& shell) {
  if (!file_) {
    file_ = ui.take_dropped();
    if (!file_) return;
    importing_.forget_fault();
  }
  if (chooser_.is_open()) {
    const auto chosen =
        chooser_.draw(ui, shell, {ui.text("path.file.title"), ui.text("path.file.act"), ".json"});
    if (chosen) file_ = *chosen;
    return;
  }
  const std::string error = importing_.fault().empty() ? std::string()
                                                       : std::string(ui.text("scenarios.refused")) +
                                                             "\n" + importing_.fault();
  Dialog shown = form_dialog(ui, ui.text("scenarios.import"), ui.text("scenarios.file.act"),
                             {error, importing_.is_running()}, field_label_height + field_height);
  shown.sentence = ui.text("scenarios.import.sentence");
  shown.width = 620.0F;
  const Answer answer = dialog(ui, "scenarios.file", shown, [&](Rect form) {
    path_field(ui, "scenarios.file.path", form, *file_,
               {.label = ui.text("scenarios.file"),
                .placeholder = ui.text("scenarios.file.example"),
                .why_off = importing_.is_running() ? ui.text("button.busy") : std::string_view(),
                .max_bytes = 1000},
               chooser_);
    ui.focus_first("scenarios.file.path");
    return file_->empty() ? ui.text("path.missing.file") : std::string_view();
  });
  if (answer == Answer::Act) import(ui, shell);
  if (answer == Answer::Keep) file_.reset();
}

namespace {

/// Of the work: the patient is built and the planes laid on it; the start view was looked at.
constexpr double on_patient_share = 0.5, looked_at_share = 0.95;

/// A version that was taken in.
struct Imported {
  database::ScenarioVersionId id;
  /// Why nobody could look at its start view; empty otherwise.
  std::string why_not_drawn;
};

Imported import_file(database::Session& session, const std::filesystem::path& file,
                     WorkReport& report) {
  const auto reached = [&](double share) {
    if (!report.reached(share))
      throw Cancelled("stopped while the scenario was checked; nothing was stored");
  };
  database::AdministratorDesk desk = administrator_of(session);
  const CheckedScenario checked = check_scenario_file(file);
  reached(on_patient_share);
  const StartViewCheck view =
      check_start_view(checked.scenario, checked.bones, checked.plan, file.filename().string());
  reached(looked_at_share);
  return {import_scenario(desk, checked.scenario), view.why_not_drawn};
}

}  // namespace

void ScenariosScreen::import(Ui& ui, Shell& shell) {
  importing_.start<Imported>(
      shell, signed_in_, {std::string(ui.text("scenarios.checking")), {}},
      [file = typed_path(*file_, home_folder())](database::Session& session, WorkReport& report) {
        return import_file(session, file, report);
      },
      [this, &shell, &texts = ui.texts()](Imported& imported) {
        file_.reset();
        chosen_ = imported.id;
        std::string detail(texts.text("scenarios.imported.sentence"));
        if (!imported.why_not_drawn.empty())
          detail += " " + texts.say("scenarios.imported.unseen", {{"why", imported.why_not_drawn}});
        shell.say({Meaning::Good, std::string(texts.text("scenarios.imported")), detail});
        versions_.read_again();
      });
}

void ScenariosScreen::draw_question(Ui& ui, Shell& shell) {
  if (!asked_) return;
  const ScenarioVersion& version = asked_->version;
  const TextValues what{{"version", name_text(ui.texts(), version)}};
  const std::string title = ui.texts().say(
      asked_->is_publishing ? "scenarios.ask_publish" : "scenarios.ask_retire", what);
  std::string consequence;
  const ScenarioVersion* beside = published_beside(version);
  if (!asked_->is_publishing) {
    consequence = ui.text("scenarios.ask_retire.sentence");
  } else if (beside != nullptr) {
    consequence = ui.texts().say("scenarios.ask_publish.instead",
                                 {{"other", name_text(ui.texts(), *beside)}});
  } else {
    consequence = ui.text("scenarios.ask_publish.sentence");
  }
  if (asked_->is_publishing)
    consequence += "\n" + std::string(ui.text("scenarios.ask_publish.proof"));
  if (asked_->is_publishing && !version.is_reviewed)
    consequence += "\n" + std::string(ui.text("scenarios.ask_publish.not_reviewed"));
  const Answer answer =
      question(ui, "scenarios.question",
               {title, consequence,
                ui.text(asked_->is_publishing ? "scenarios.publish" : "scenarios.retire"),
                ui.text("scenarios.keep"), !asked_->is_publishing});
  if (answer == Answer::Waiting) return;
  const Asked asked = *std::exchange(asked_, std::nullopt);
  if (answer != Answer::Act) return;
  asked.is_publishing ? publish(ui, shell, asked.version) : retire(ui, shell, asked.version);
}

namespace {

/// The last share of the work writes.
constexpr double proved_share = 0.98;

/// How a publication ended; written by the work, read once it has.
struct Publication {
  bool is_published = false;
  /// The scenario lists faults, by which its rubric was proven as well.
  bool has_faults = false;
};

Publication prove_and_publish(SignedInSession& signed_in, database::ScenarioVersionId id,
                              WorkReport& report) {
  const database::ScenarioText text =
      signed_in.in_turn([&](database::Session& session, database::Database&) {
        return administrator_of(session).scenario_text(id);
      });
  const scenarios::Scenario scenario = scenarios::parse_scenario(text.json, text.name);
  prove_to_publish(scenario,
                   [&report](double done) { return report.reached(proved_share * done); });
  signed_in.in_turn([&](database::Session& session, database::Database&) {
    // Another may have had the session's turn for long.
    if (!report.reached(proved_share)) throw Cancelled("stopped before it was published");
    administrator_of(session).publish_scenario(id);
  });
  return {true, !scenario.proof.empty()};
}

Message message_about(const Texts& texts, const std::string& name, WorkEnd end,
                      const Publication& made, const std::string& reason) {
  const TextValues version{{"version", name}};
  if (made.is_published) {
    return {Meaning::Good, texts.say("scenarios.was_published", version),
            std::string(texts.text(made.has_faults ? "scenarios.was_proven"
                                                   : "scenarios.was_proven_perfect"))};
  }
  const std::string title = texts.say("scenarios.not_published", version);
  if (end == WorkEnd::Failed) return {Meaning::Bad, title, sentence_of(reason)};
  return {Meaning::Info, title};
}

}  // namespace

void ScenariosScreen::publish(Ui& ui, Shell& shell, const ScenarioVersion& version) {
  const Texts& texts = ui.texts();
  const std::string name = name_text(texts, version);
  const auto made = std::make_shared<Publication>();
  is_proving_ = std::make_shared<bool>(true);
  // Whoever left the screen meanwhile is told all the same.
  shell.background().start(
      texts.say("scenarios.proving", {{"version", name}}),
      [signed_in = signed_in_, id = version.id, made](WorkReport& report) {
        *made = prove_and_publish(*signed_in, id, report);
      },
      [this, &shell, &texts, name, made, still_here = std::weak_ptr<bool>(is_proving_)](
          WorkEnd end, const std::string& reason) {
        shell.say(message_about(texts, name, end, *made, reason));
        const std::shared_ptr<bool> here = still_here.lock();
        if (here == nullptr) return;
        *here = false;
        versions_.read_again();
      });
}

void ScenariosScreen::retire(Ui& ui, Shell& shell, const ScenarioVersion& version) {
  work_.change_course(
      ui, shell, signed_in_,
      {[id = version.id](database::AdministratorDesk& desk) { desk.retire_scenario(id); },
       ui.texts().say("scenarios.was_retired", {{"version", name_text(ui.texts(), version)}}),
       [this] { versions_.read_again(); }});
}

}  // namespace hallux::ui
