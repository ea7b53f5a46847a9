#include "tests/ui/widgets/gallery.h"

#include <array>

#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/menu.h"
#include "ui/widgets/controls/toast.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

using Words = std::string_view;

void draw_button_states(Ui& ui, const Rect& rect) {
  constexpr std::array<Words, 6> states{"Normal", "Hover", "Active", "Focus", "Disabled", "Busy"};
  constexpr std::array<Words, 4> looks{"Primary", "Secondary", "Ghost", "Danger"};
  card(ui, rect, "");
  for (std::size_t column = 0; column < states.size(); ++column)
    ui.canvas().text({rect.x + 120.0F + 114.0F * static_cast<float>(column), rect.y + 28.0F},
                     {Type::Caption, ui.theme().text_caption}, states[column]);
  for (std::size_t row = 0; row < looks.size(); ++row) {
    const float y = rect.y + 66.0F + 56.0F * static_cast<float>(row);
    ui.canvas().text({rect.x + 24.0F, y}, {Type::Small, ui.theme().text_secondary}, looks[row]);
    for (std::size_t column = 0; column < states.size(); ++column) {
      ButtonSpec spec{row == 3 ? Words("Erase") : Words("Replay"), static_cast<ButtonLook>(row)};
      if (column == 4) spec.why_off = "Nothing to replay";
      spec.is_busy = column == 5;
      const ControlState state{column == 1 ? 1.0F : 0.0F, column == 2, column == 3};
      draw_button(
          ui,
          {rect.x + 120.0F + 114.0F * static_cast<float>(column), y - 19.0F, 98.0F, button_height},
          spec, state);
    }
  }
}

void draw_fields(Ui& ui, const Rect& rect, GalleryState& state) {
  card(ui, rect, "");
  FieldSpec normal{"Normal", "Name or login"};
  normal.icon = Icon::Search;
  field(ui, "gallery.search", {rect.x + 24.0F, rect.y + 44.0F, 226.0F, field_height}, state.search,
        normal);
  draw_field(ui, {rect.x + 270.0F, rect.y + 44.0F, 226.0F, field_height}, "trainee", {"Focus", ""},
             {}, true);
  FieldSpec disabled{"Disabled", ""};
  disabled.why_off = "Nobody is chosen";
  field(ui, "gallery.disabled", {rect.x + 24.0F, rect.y + 126.0F, 226.0F, field_height},
        state.disabled, disabled);
  FieldSpec wrong{"Error", ""};
  wrong.error = "No spaces in a login";
  field(ui, "gallery.wrong", {rect.x + 270.0F, rect.y + 126.0F, 226.0F, field_height}, state.wrong,
        wrong);
  constexpr std::array<Words, 3> labels{"State", "Best", "Trend"};
  segmented(ui, "gallery.segment", {rect.x + 24.0F, rect.y + 222.0F, 226.0F, segmented_height},
            labels, state.segment);
  const float y = rect.y + 240.0F;
  checkbox(ui, "gallery.checked", {rect.x + 280.0F, y - 9.0F, 18.0F, 18.0F}, "Chosen",
           state.is_checked, false);
  checkbox(ui, "gallery.unchecked", {rect.x + 310.0F, y - 9.0F, 18.0F, 18.0F}, "Not chosen",
           state.is_unchecked, false);
  draw_checkbox(ui, {rect.x + 340.0F, y - 9.0F, 18.0F, 18.0F}, false, true, {0.0F, false, true});
  toggle(ui, "gallery.on", {rect.x + 380.0F, y - 10.0F, 36.0F, 20.0F}, "On", state.is_on, false);
  toggle(ui, "gallery.off", {rect.x + 428.0F, y - 10.0F, 36.0F, 20.0F}, "Off", state.is_off, false);
}

void draw_meanings(Ui& ui, const Rect& rect) {
  constexpr std::array<std::pair<Meaning, Words>, 5> meanings{{{Meaning::Good, "Within target"},
                                                               {Meaning::Warn, "Look at this"},
                                                               {Meaning::Bad, "Harm or error"},
                                                               {Meaning::Info, "Information"},
                                                               {Meaning::Neutral, "Not measured"}}};
  constexpr std::array<std::pair<Competence, Words>, 5> competences{
      {{Competence::Competent, "Competent"},
       {Competence::Learning, "Learning, 60 percent"},
       {Competence::Slipped, "Slipped"},
       {Competence::Stale, "Over 90 days"},
       {Competence::NotStarted, "Not started"}}};
  card(ui, rect, "States and meanings");
  for (std::size_t row = 0; row < meanings.size(); ++row) {
    const float y = rect.y + 66.0F + 28.0F * static_cast<float>(row);
    draw_meaning(ui.canvas(), ui.theme(), meanings[row].first, {rect.x + 34.0F, y}, 7.5F);
    ui.canvas().text({rect.x + 54.0F, y}, {Type::Small, ui.theme().text}, meanings[row].second);
    draw_competence(ui.canvas(), ui.theme(), competences[row].first, {rect.x + 214.0F, y}, 7.5F,
                    0.6F);
    ui.canvas().text({rect.x + 234.0F, y}, {Type::Small, ui.theme().text}, competences[row].second);
  }
}

void draw_type_scale(Ui& ui, const Rect& rect) {
  constexpr std::array<std::pair<Type, Words>, 5> samples{
      {{Type::Title, "Title 26"},
       {Type::Section, "Section 20"},
       {Type::CardTitle, "Card 16"},
       {Type::Body, "Body 14 \xE2\x80\x93 12.3\xC2\xB0 \xC2\xB1 0.5"},
       {Type::Caption, "Caption 12 \xE2\x80\x93 axis, time, n"}}};
  card(ui, rect, "Type");
  float y = rect.y + 74.0F;
  for (const auto& [type, words] : samples) {
    ui.canvas().text_on_baseline({rect.x + 24.0F, y}, {type, ui.theme().text}, words);
    y += type == Type::Title ? 32.0F : 28.0F;
  }
  ui.canvas().text_on_baseline({rect.right() - 24.0F, rect.y + 110.0F},
                               {Type::Score, ui.theme().text, Align::Right}, "76.8");
  ui.canvas().text_on_baseline({rect.right() - 24.0F, rect.y + 162.0F},
                               {Type::Number, ui.theme().text, Align::Right}, "11.8");
}

void draw_notices(Ui& ui, const Rect& left, const Rect& right, GalleryState& state) {
  card(ui, left, "");
  if (empty_card(
          ui, "gallery.empty", inset(left, 16.0F),
          {Icon::Inbox, "No help requests", "Flags from trainees appear here.", "Open cohort"}))
    ++state.presses;
  card(ui, right, "");
  if (failed_card(ui, "gallery.failed", inset(right, 16.0F),
                  {"Replay cannot be read", "Chunk 41 fails its check.", "Verify attempt"}))
    state.has_question = true;
}

void draw_messages(Ui& ui, const Rect& rect, GalleryState& state) {
  toast(ui, "gallery.saved", {rect.x, rect.y + 8.0F, toast_width, toast_height},
        {Meaning::Good, "Note saved", "Visible to Trainee 12", "Undo"});
  toast(ui, "gallery.silent", {rect.x, rect.y + 84.0F, toast_width, toast_height},
        {Meaning::Warn, "Arm does not answer", "Recording paused at 01:04", "Retry"});
  if (progress(ui, "gallery.work", {rect.x, rect.y + 162.0F, 400.0F, 48.0F},
               {"Re-scoring 412 attempts", "", 0.62F}))
    ++state.presses;
}

constexpr std::array<MenuItem, 5> menu_items{{{"Replay", Icon::Play, "R"},
                                              {"Compare", Icon::Compare, "C"},
                                              {"Ask for help", Icon::Flag, "F"},
                                              {"Export", Icon::Export, "E"},
                                              {"Withdraw", Icon::Delete, "Del", true}}};

void draw_series_colours(Ui& ui, const Rect& rect) {
  card(ui, rect, "Series colours", 20.0F);
  const Theme& theme = ui.theme();
  Canvas& canvas = ui.canvas();
  constexpr std::array<Words, 5> names{"You", "Expert, reference", "Target band", "Second attempt",
                                       "Cohort"};
  for (std::size_t row = 0; row < names.size(); ++row) {
    const float x = rect.x + 20.0F, y = rect.y + 66.0F + 28.0F * static_cast<float>(row);
    canvas.text({x + 48.0F, y}, {Type::Small, theme.text}, names[row]);
    if (row == 0)
      canvas.fill({x, y - 1.0F, 36.0F, 2.0F}, theme.accent),
          canvas.disc({x + 18.0F, y}, 4.5F, theme.accent);
    if (row == 1) canvas.dashes({x, y}, {x + 36.0F, y}, theme.reference, 7.0F, 4.0F, 2.5F);
    if (row == 2) canvas.fill({x, y - 7.0F, 36.0F, 14.0F}, faded(theme.good, 0.25F), 2.0F);
    if (row == 3)
      canvas.fill({x, y - 1.0F, 36.0F, 2.0F}, theme.warn),
          canvas.fill({x + 14.0F, y - 4.0F, 8.0F, 8.0F}, theme.warn);
    if (row == 4) canvas.dashes({x, y}, {x + 36.0F, y}, theme.text_caption, 2.0F, 3.0F, 2.0F);
  }
}

void draw_overlays(Ui& ui, GalleryState& state) {
  if (state.has_menu && menu(ui, "gallery.menu", {900.0F, 300.0F}, menu_items) != menu_open)
    state.has_menu = false;
  if (!state.has_question) return;
  const Answer answer = question(
      ui, "gallery.question",
      {"Erase Trainee 12?",
       "14 attempts, 6 notes and every recording of this person are gone for good. The audit log "
       "keeps that it was done, by whom and when.",
       "Erase Trainee 12", "Keep"});
  if (answer != Answer::Waiting) state.has_question = false;
  if (answer == Answer::Act) ++state.presses;
}

}  // namespace

void draw_components(Ui& ui, GalleryState& state) {
  Canvas& canvas = ui.canvas();
  canvas.fill(ui.display(), ui.theme().page);
  const float shift = -ui.begin_scroll("gallery", "Components", ui.display(), 900.0F);
  const auto at = [&](float x, float y, float w, float h) { return Rect{x, y + shift, w, h}; };
  page_title(ui, {40.0F, 32.0F + shift}, "Components",
             "Every control in every state, drawn by the same code as the screens.");
  draw_button_states(ui, at(40, 104, 820, 292));
  draw_fields(ui, at(880, 104, 520, 292), state);
  draw_meanings(ui, at(40, 416, 400, 214));
  draw_type_scale(ui, at(460, 416, 400, 214));
  draw_notices(ui, at(880, 416, 250, 214), at(1150, 416, 250, 214), state);
  const Rect loading = card(ui, at(40, 650, 400, 210), "Loading");
  loading_rows(ui, loading, 4, -1.0);
  draw_spinner(canvas, {404.0F, 681.0F + shift}, 8.0F, ui.theme().accent);
  draw_messages(ui, at(460, 650, 400, 210), state);
  draw_menu(ui, at(880, 650, 250, 210), menu_items, 1);
  draw_series_colours(ui, at(1150, 650, 250, 210));
  ui.end_scroll();
  draw_overlays(ui, state);
}

}  // namespace hallux::ui
