// The cards over the picture of an operation.
//
// Each stands where it hides least: the card that begins at the foot, where the panels will be; a
// pause below the bone where there is room, because whoever pauses may want to look at it; what
// stopped everything in the middle.
#include "ui/screens/operating/operating_cards.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "scenarios/steps/step_order.h"
#include "ui/jobs/devices/device_sentences.h"
#include "ui/jobs/devices/own_station.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr double shown_after_s = 0.3;
/// A question stays as low as the smallest window.
constexpr std::size_t most_steps_named = 8;
constexpr float sealing_height = 44.0F, title_height = 28.0F;
/// The panels at the foot and the line of trouble above them.
constexpr float room_of_panels = 92.0F + 16.0F + 44.0F;

/// Empty where the person paused: they know it.
std::string_view cause_of(PausedBy by) {
  constexpr std::array<std::pair<PausedBy, std::string_view>, 6> causes{{
      {PausedBy::Locked, "operate.paused.locked"},
      {PausedBy::KeysLost, "operate.paused.keys"},
      {PausedBy::PointerLeft, "operate.paused.pointer"},
      {PausedBy::Covered, "operate.paused.covered"},
      {PausedBy::Stillness, "operate.paused.still"},
      {PausedBy::RoomAgain, "operate.paused.room"},
  }};
  const auto* const found = std::ranges::find(causes, by, &decltype(causes)::value_type::first);
  return found == causes.end() ? std::string_view() : found->second;
}

struct PanelWords {
  std::string_view title;
  std::string sentence;
};

/// A panel of a title, a sentence and room for a button; where it lies is the caller's.
float panel_height(const Ui& ui, const PanelWords& words, float width) {
  return 44.0F + ui.paragraph_height(Type::Small, words.sentence, width - 48.0F) + 12.0F +
         button_height + 16.0F;
}

/// Below the bone, where there is room above the panels at the foot.
Rect low_panel(const Ui& ui, const PanelWords& words, float widest) {
  const Rect display = ui.display();
  const float width = std::min(widest, display.w - 32.0F);
  const float height = panel_height(ui, words, width);
  const float low = 0.94F * display.h - room_of_panels - height;
  return {display.mid_x() - 0.5F * width, std::max(display.mid_y() - 0.5F * height, low), width,
          height};
}

/// True where its button was pressed.
bool draw_panel(Ui& ui, const Rect& rect, const PanelWords& words, const char* button_id,
                const ButtonSpec& spec) {
  const LayerScope layer(ui.canvas(), Layer::Page);
  const float inner = rect.w - 48.0F;
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  ui.canvas().text_in({rect.x + 24.0F, rect.y + 12.0F, inner, title_height},
                      {Type::CardTitle, ui.theme().text, Align::Centre}, words.title);
  ui.canvas().paragraph({rect.x + 24.0F, rect.y + 44.0F, inner, rect.h - 72.0F - button_height},
                        {Type::Small, ui.theme().text_secondary, Align::Centre}, words.sentence);
  const float width = button_width(ui, spec);
  return button(
      ui, button_id,
      {rect.mid_x() - 0.5F * width, rect.bottom() - 16.0F - button_height, width, button_height},
      spec);
}

std::string stop_text(const Ui& ui, const OperatingSession::Stop& stop) {
  switch (stop.failure) {
    case LiveFailure::DiskFull:
      return ui.texts().say("operate.stopped.disk", {{"file", stop.file.string()}});
    case LiveFailure::MemoryFull:
      return std::string(ui.text("operate.stopped.memory"));
    case LiveFailure::Other:
      return sentence_of(stop.reason);
    case LiveFailure::None:
      break;
  }
  return std::string(ui.text("operate.stopped.unknown"));
}

/// What must be done and is not: titles, of alternatives of which none is done "X or Y".
std::vector<std::string> undone_titles(const Texts& texts, const scenarios::Scenario& scenario,
                                       const std::vector<bool>& is_done) {
  const std::vector<scenarios::OperationStep>& steps = scenario.steps;
  std::vector<std::string> titles;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    const std::vector<std::size_t> group = alternatives_of(scenario, step);
    const bool is_told_before = group.front() != step;
    if (steps[step].is_optional || is_told_before) continue;
    if (std::ranges::any_of(group, [&](std::size_t each) { return is_done[each]; })) continue;
    std::string title = steps[step].title;
    for (std::size_t i = 1; i < group.size(); ++i)
      title =
          texts.say("operate.ask.finish.or", {{"one", title}, {"other", steps[group[i]].title}});
    titles.push_back(std::move(title));
  }
  return titles;
}

}  // namespace

std::string left_steps_text(const Texts& texts, const scenarios::Scenario& scenario,
                            const StepProgress& progress) {
  std::vector<bool> is_done;
  for (std::size_t step = 0; step < scenario.steps.size(); ++step)
    is_done.push_back(progress.is_done(step) ||
                      scenario.steps[step].kind == scenarios::StepKind::Finish);
  if (is_all_done(scenario, is_done)) return std::string(texts.text("operate.ask.finish.all"));
  const std::vector<std::string> titles = undone_titles(texts, scenario, is_done);
  const std::size_t named = std::min(titles.size(), most_steps_named);
  std::string list = titles.front();
  for (std::size_t i = 1; i < named; ++i) list += ", " + titles[i];
  if (named < titles.size())
    list = texts.say("operate.ask.finish.more",
                     {{"steps", list}, {"count", std::to_string(titles.size() - named)}});
  return texts.say_count("operate.ask.finish.left", static_cast<long>(titles.size()),
                         {{"steps", list}});
}

std::string ready_text(const Ui& ui, bool is_practice, bool is_beginning,
                       const std::string& device) {
  const std::string shown(
      ui.text(is_practice ? "operate.ready.shown.practice" : "operate.ready.shown.assessment"));
  const simulator::KindFacts* const kind = device == mouse_id ? nullptr : kind_of_device(device);
  if (kind == nullptr) return std::string(ui.text("operate.ready.mouse")) + " " + shown;
  std::string home = home_sentence(*kind);
  if (is_beginning && !home.empty()) return home;
  return ui.texts().say("operate.ready.device", {{"device", std::string(kind->name)}}) + " " +
         shown;
}

ReadyAnswer draw_ready_card(Ui& ui, const std::string& title, const std::string& words,
                            bool is_beginning) {
  const float width = std::min(520.0F, ui.display().w - 32.0F);
  const float words_height = ui.paragraph_height(Type::Body, words, width - 2.0F * space::card);
  const float height = 64.0F + words_height + 24.0F + button_height + 24.0F;
  const Rect display = ui.display();
  const float above = std::max(display.bottom() - height - hud_inset_share * display.h, 0.0F);
  const Rect inside = card(ui, {display.mid_x() - 0.5F * width, above, width, height}, title);
  ui.canvas().paragraph({inside.x, inside.y, inside.w, words_height},
                        {Type::Body, ui.theme().text_secondary}, words);
  ButtonSpec start{ui.text("operate.begin"), ButtonLook::Primary, Icon::Play};
  start.is_busy = is_beginning;
  const ButtonSpec back{ui.text("operate.back"), ButtonLook::Ghost};
  const float start_width = button_width(ui, start), back_width = button_width(ui, back);
  const float y = inside.bottom() - button_height;
  if (button(ui, "operate.begin", {inside.right() - start_width, y, start_width, button_height},
             start))
    return ReadyAnswer::Begin;
  const Rect left{inside.right() - start_width - back_width - 12.0F, y, back_width, button_height};
  return !is_beginning && button(ui, "operate.back", left, back) ? ReadyAnswer::Back
                                                                 : ReadyAnswer::Waiting;
}

bool draw_paused_card(Ui& ui, PausedBy by) {
  const std::string_view cause = cause_of(by);
  const PanelWords words{ui.text("operate.paused"),
                         (cause.empty() ? std::string() : std::string(ui.text(cause)) + " ") +
                             std::string(ui.text("operate.paused.sentence"))};
  return draw_panel(ui, low_panel(ui, words, 440.0F), words, "operate.go_on",
                    {ui.text("operate.resume"), ButtonLook::Secondary, Icon::Play});
}

LostAnswer draw_device_lost_card(Ui& ui, bool is_practice, const std::string& trouble) {
  const std::string_view rule =
      ui.text(is_practice ? "operate.lost.practice" : "operate.lost.assessment");
  const PanelWords words{ui.text("operate.lost"),
                         (trouble.empty() ? std::string() : trouble + " ") + std::string(rule)};
  const Rect rect = low_panel(ui, words, 560.0F);
  if (is_practice) {
    return draw_panel(ui, rect, words, "operate.lost.mouse",
                      {ui.text("operate.lost.mouse"), ButtonLook::Secondary})
               ? LostAnswer::TakeMouse
               : LostAnswer::Waiting;
  }
  return draw_panel(ui, rect, words, "operate.lost.abandon",
                    {ui.text("operate.lost.abandon"), ButtonLook::Secondary})
             ? LostAnswer::Abandon
             : LostAnswer::Waiting;
}

bool draw_storage_full_card(Ui& ui, const std::filesystem::path& directory) {
  const PanelWords words{
      ui.text("operate.full"),
      ui.texts().say("operate.full.sentence", {{"directory", directory.string()}})};
  const float width = std::min(560.0F, ui.display().w - 32.0F);
  return draw_panel(ui, centred(ui.display(), width, panel_height(ui, words, width)), words,
                    "operate.full.stop", {ui.text("operate.full.stop"), ButtonLook::Secondary});
}

Answer draw_end_question(Ui& ui, Asked asked, const EndWords& words) {
  const auto text = [&](const char* id) { return ui.text(id); };
  switch (asked) {
    case Asked::Finish:
      return question(ui, "operate.ask_finish",
                      {text("operate.ask.finish"),
                       words.left + " " + std::string(text("operate.ask.finish.detail")),
                       text("operate.ask.finish.act"), text("operate.ask.keep"), false});
    case Asked::EndUnfinished: {
      const std::string detail =
          words.held.empty()
              ? std::string(text("operate.ask.unfinished.detail"))
              : ui.texts().say("operate.ask.unfinished.detail_at", {{"held", words.held}});
      return question(ui, "operate.ask_unfinished",
                      {text("operate.ask.unfinished"), detail, text("operate.ask.unfinished.act"),
                       text("operate.ask.unfinished.keep"), false});
    }
    case Asked::Leave:
      return question(ui, "operate.ask_leave",
                      {text("operate.ask.leave"), text("operate.ask.leave.detail"),
                       text("operate.ask.abandon.act"), text("operate.ask.keep"), true,
                       text("operate.ask.leave.finish")});
    case Asked::Abandon:
    case Asked::Tool:
    case Asked::Nothing:
      break;
  }
  return question(ui, "operate.ask_abandon",
                  {text("operate.ask.abandon"), text("operate.ask.abandon.detail"),
                   text("operate.ask.abandon.act"), text("operate.ask.keep"), true});
}

void draw_sealing(Ui& ui, double since_s) {
  if (ui.time_s() - since_s < shown_after_s) return;
  const std::string_view words = ui.text("operate.sealing");
  const float width = ui.width_of(Type::BodyMedium, words) + 48.0F;
  const Rect display = ui.display();
  const Rect rect{display.mid_x() - 0.5F * width, 0.94F * display.h - sealing_height, width,
                  sealing_height};
  draw_hud_panel(ui.canvas(), ui.theme(), rect);
  ui.canvas().text_in(rect, {Type::BodyMedium, ui.theme().text, Align::Centre}, words);
}

StoppedAnswer draw_stopped_card(Ui& ui, const OperatingSession::Stop& stop, bool is_kept) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  const std::string why =
      stop_text(ui, stop) + (is_kept ? " " + std::string(ui.text("operate.kept")) : "");
  const float width = std::min(560.0F, ui.display().w - 32.0F);
  const float height = 250.0F + ui.paragraph_height(Type::Small, why, width - 2.0F * space::card);
  Rect inside = card(ui, centred(ui.display(), width, height), {});
  if (is_kept) {
    const ButtonSpec see{ui.text("operate.see_kept"), ButtonLook::Ghost, Icon::Eye};
    const float see_width = button_width(ui, see);
    inside.h -= button_height;
    if (button(ui, "operate.see_kept",
               {inside.mid_x() - 0.5F * see_width, inside.bottom(), see_width, button_height}, see))
      return StoppedAnswer::SeeKept;
  }
  return failed_card(ui, "operate.stopped", inside,
                     {ui.text("operate.stopped"), why, ui.text("operate.back")})
             ? StoppedAnswer::Back
             : StoppedAnswer::Waiting;
}

}  // namespace hallux::ui
