// Rows of the tray: saws, wires, drills, and a row of lengths for each diameter of screw. What does
// not fit a low window scrolls; arrows lead among the tools by their places.
#include "ui/screens/operating/hand/tray_card.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

using scenarios::LaidOutTool;
using simulator::Drill;
using simulator::Saw;
using simulator::Screwdriver;
using simulator::WireDriver;

constexpr float widest = 1010.0F, edge = 24.0F, title_height = 40.0F, ring_room = 4.0F;
constexpr float pill_height = 30.0F, pill_gap = 6.0F, row_gap = 8.0F, label_width = 132.0F;
constexpr const char* tray_id = "operate.tray";

struct TrayRow {
  std::string title;
  /// Places on the tray, and what their pills say.
  std::vector<std::pair<std::int32_t, std::string>> pills;
};

/// The row of a tool, and what its pill says there.
struct PillWords {
  std::string row, pill;
};

PillWords words_of(const Texts& texts, const LaidOutTool& tool) {
  if (const auto* saw = std::get_if<Saw>(&tool.tool)) {
    return {std::string(texts.text("operate.tray.saws")),
            short_text(saw->blade.width_mm) + " × " + fixed_text(saw->blade.thickness_mm, 2)};
  }
  if (const auto* driver = std::get_if<WireDriver>(&tool.tool))
    return {std::string(texts.text("operate.tray.wires")), short_text(driver->wire.diameter_mm)};
  if (const auto* drill = std::get_if<Drill>(&tool.tool))
    return {std::string(texts.text("operate.tray.drills")), short_text(drill->bit.diameter_mm)};
  const simulator::Screw& screw = std::get<Screwdriver>(tool.tool).screw;
  return {texts.say("operate.tray.screws", {{"diameter", short_text(screw.thread_diameter_mm)}}),
          short_text(screw.length_mm)};
}

std::vector<TrayRow> rows_of(const Texts& texts, const std::vector<LaidOutTool>& tray) {
  std::vector<TrayRow> rows;
  for (std::size_t place = 0; place < tray.size(); ++place) {
    PillWords words = words_of(texts, tray[place]);
    if (rows.empty() || rows.back().title != words.row) rows.push_back({words.row, {}});
    rows.back().pills.emplace_back(static_cast<std::int32_t>(place), std::move(words.pill));
  }
  return rows;
}

bool draw_tool_pill(Ui& ui, const Rect& rect, const std::string& words, const std::string& label,
                    std::int32_t place, bool is_in_hand) {
  const std::string id = std::string(tray_id) + "." + std::to_string(place);
  const Response response = ui.control({.id = id,
                                        .label = label,
                                        .rect = rect,
                                        .role = Role::Option,
                                        .is_chosen = is_in_hand,
                                        .group = tray_id});
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const Color fill = is_in_hand ? theme.accent_soft : theme.chip;
  canvas.fill(rect, mixed(fill, theme.text, response.hover * 0.06F), radius::control);
  if (response.shows_ring) draw_focus_ring(canvas, theme, rect, radius::control);
  canvas.text_in(rect, {Type::CaptionMedium, is_in_hand ? theme.accent : theme.text, Align::Centre},
                 words);
  if (is_in_hand) ui.focus_first(id);
  return response.is_pressed();
}

/// One width for all, so that they stand in columns; the longest row just fits.
float column_of(const std::vector<TrayRow>& rows, float room) {
  std::size_t most = 1;
  for (const TrayRow& row : rows) most = std::max(most, row.pills.size());
  return std::min(40.0F, (room + pill_gap) / static_cast<float>(most) - pill_gap);
}

std::optional<std::int32_t> draw_row(Ui& ui, const ToolsInHand& tools, const TrayRow& row,
                                     const Rect& line, float column) {
  ui.canvas().text_in({line.x, line.y, label_width, line.h},
                      {Type::Small, ui.theme().text_secondary}, row.title);
  std::optional<std::int32_t> taken;
  float x = line.x + label_width;
  for (const auto& [place, words] : row.pills) {
    const float width = std::max(column, ui.width_of(Type::CaptionMedium, words) + 12.0F);
    const std::string label = tool_text(ui.texts(), tools.tray()[static_cast<std::size_t>(place)]);
    if (draw_tool_pill(ui, {x, line.y, width, line.h}, words, label, place, place == tools.place()))
      taken = place;
    x += width + pill_gap;
  }
  return taken;
}

}  // namespace

ToolWords tool_words(const Texts& texts, const LaidOutTool& tool) {
  const auto title = [&](std::string_view id) { return std::string(texts.text(id)); };
  if (const auto* saw = std::get_if<Saw>(&tool.tool)) {
    return {title("operate.saw"),
            texts.say("operate.blade", {{"width", short_text(saw->blade.width_mm)},
                                        {"thickness", fixed_text(saw->blade.thickness_mm, 2)}})};
  }
  if (const auto* driver = std::get_if<WireDriver>(&tool.tool)) {
    return {title("operate.tool.wire_driver"),
            texts.say("operate.tool.wire", {{"diameter", short_text(driver->wire.diameter_mm)}})};
  }
  if (const auto* drill = std::get_if<Drill>(&tool.tool)) {
    return {title("operate.tool.drill"),
            texts.say("operate.tool.bit", {{"diameter", short_text(drill->bit.diameter_mm)}})};
  }
  const simulator::Screw& screw = std::get<Screwdriver>(tool.tool).screw;
  return {title("operate.tool.screwdriver"),
          texts.say("operate.tool.screw", {{"diameter", short_text(screw.thread_diameter_mm)},
                                           {"length", short_text(screw.length_mm)}})};
}

std::string tool_text(const Texts& texts, const LaidOutTool& tool) {
  const ToolWords words = tool_words(texts, tool);
  return words.title + ", " + words.size;
}

TrayAnswer draw_tray_card(Ui& ui, const ToolsInHand& tools) {
  const LayerScope layer(ui.canvas(), Layer::Modal);
  Canvas& canvas = ui.canvas();
  canvas.fill(ui.display(), ui.theme().scrim);
  const std::vector<TrayRow> rows = rows_of(ui.texts(), tools.tray());
  const float rows_height = static_cast<float>(rows.size()) * (pill_height + row_gap);
  const float width = std::min(widest, ui.display().w - 32.0F);
  const float height = std::min(2.0F * edge + title_height + rows_height + button_height + 16.0F,
                                ui.display().h - 32.0F);
  const Rect panel = centred(ui.display(), width, height);
  draw_popup(canvas, ui.theme(), panel, radius::picture);
  Rect inner = inset(panel, edge);
  canvas.text_in(take_top(inner, title_height), {Type::CardTitle, ui.theme().text},
                 ui.text("operate.tray"));
  Rect foot = take_bottom(inner, button_height, 16.0F);
  TrayAnswer answer;
  const float offset = ui.begin_scroll("operate.tray.rows", ui.text("operate.tray"),
                                       inset(inner, -ring_room), rows_height + 2.0F * ring_room);
  const float column = column_of(rows, inner.w - label_width);
  Rect line{inner.x, inner.y - offset, inner.w, pill_height};
  for (const TrayRow& row : rows) {
    if (const auto taken = draw_row(ui, tools, row, line, column)) answer = {true, taken};
    line.y += pill_height + row_gap;
  }
  ui.end_scroll();
  const ButtonSpec keep{ui.text("operate.tray.keep"), ButtonLook::Secondary};
  const float keep_width = button_width(ui, keep);
  if (button(ui, "operate.tray.keep",
             {foot.right() - keep_width, foot.y, keep_width, button_height}, keep) ||
      ui.shortcut({Key::Escape}, keep.label))
    answer.is_closed = true;
  if (answer.is_closed) ui.want_frame_in_s(0.0);
  return answer;
}

}  // namespace hallux::ui
