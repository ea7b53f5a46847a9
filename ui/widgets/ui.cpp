// The frame: begin, controls, end. While it is drawn, controls are gathered for the next frame's
// events, and answered from the events of this one (input/interaction.h). The focus is settled at
// the end, when it is known what is there: what appears above takes it and gives it back. What no
// frame asked for any more, motions, scrolls, edits, is forgotten.
#include "ui/widgets/ui.h"

#include <imgui.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "simulator/base/check.h"
#include "ui/widgets/input/focus.h"
#include "ui/widgets/shapes.h"
#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {
namespace {

constexpr float hover_s = 0.08F;
constexpr double told_after_s = 0.5;
constexpr float wheel_step = 56.0F;
constexpr double never = std::numeric_limits<double>::infinity();

// What no frame asked for any more is forgotten.
template <typename Memory>
void forget_untouched(Memory& memory) {
  for (auto entry = memory.begin(); entry != memory.end();)
    entry = std::exchange(entry->second.is_touched, false) ? std::next(entry) : memory.erase(entry);
}

}  // namespace

// Dear ImGui keeps one context for the whole process; it is ours while a frame is made.
struct Ui::ImGuiOwner {
  ImGuiContext* context = ImGui::CreateContext();

  ImGuiOwner() {
    make_current();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ImGuiStyle& style = ImGui::GetStyle();
    style.CircleTessellationMaxError = 0.2F;
    style.AntiAliasedLinesUseTex = true;
  }
  ImGuiOwner(const ImGuiOwner&) = delete;
  ImGuiOwner& operator=(const ImGuiOwner&) = delete;
  ~ImGuiOwner() { ImGui::DestroyContext(context); }
  void make_current() const { ImGui::SetCurrentContext(context); }
};

Ui::Ui(const Texts& texts, Clipboard& clipboard, ThemeName theme, float scale)
    : texts_(&texts),
      clipboard_(&clipboard),
      theme_(make_theme(theme)),
      wanted_scale_(scale),
      imgui_(std::make_unique<ImGuiOwner>()) {
  build_fonts();
}

Ui::~Ui() = default;

void Ui::build_fonts() {
  imgui_->make_current();
  fonts_ = std::make_unique<FontAtlas>(*ImGui::GetIO().Fonts, find_fonts(), wanted_scale_);
  ++fonts_version_;
}

void Ui::begin_frame(EventQueue& queue, float width, float height, double time_s) {
  imgui_->make_current();
  if (wanted_scale_ != fonts_->scale())
    build_fonts();
  else if (fonts_->load_wanted())
    ++fonts_version_;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {std::max(width, 1.0F), std::max(height, 1.0F)};
  last_time_s_ = time_s_;
  time_s_ = std::max(time_s, time_s_);
  io.DeltaTime = std::clamp(static_cast<float>(time_s_ - last_time_s_), 0.001F, 0.1F);
  display_ = {0.0F, 0.0F, io.DisplaySize.x / scale(), io.DisplaySize.y / scale()};
  forget_last_frame();
  input_.take_events(queue, shown_, time_s_, scale());
  ImGui::NewFrame();
  building_ = {};
  building_shortcuts_.clear();
  building_gestures_.clear();
  canvas_ = std::make_unique<Canvas>(*ImGui::GetBackgroundDrawList(), *fonts_, building_, display_);
}

void Ui::forget_last_frame() {
  input_.forget_frame();
  first_focus_.clear();
  pointer_shape_ = PointerShape::Arrow;
  is_pointer_hidden_ = is_pointer_carried_ = false;
  due_in_s_ = never;
}

void Ui::end_frame() {
  CHECK(open_scrolls_.empty());
  tell_what_was_cut();
  settle_pointer();
  canvas_->finish();
  canvas_.reset();
  if (fonts_->wants_letters()) want_frame_in_s(0.0);
  ImGui::Render();
  settle_focus();
  building_.focus = input_.focus;
  shown_ = std::move(building_);
  shown_capture_ = std::exchange(building_capture_, {});
  input_.capture = shown_capture_;
  shown_shortcuts_ = std::move(building_shortcuts_);
  shown_gestures_ = std::move(building_gestures_);
  forget_untouched(motions_);
  forget_untouched(scrolls_);
  std::erase_if(edits_of_,
                [this](const auto& entry) { return find_widget(shown_, entry.first) == nullptr; });
}

const ImDrawData& Ui::draw_data() const {
  imgui_->make_current();
  const ImDrawData* data = ImGui::GetDrawData();
  CHECK(data != nullptr);
  return *data;
}

double Ui::next_frame_in_s() const noexcept {
  return input_.is_settling || input_.has_waiting_events ? 0.0 : due_in_s_;
}

void Ui::want_frame_in_s(double seconds) noexcept {
  due_in_s_ = std::min(due_in_s_, std::max(seconds, 0.0));
}

namespace {

/// The topmost text under the pointer of which there is more to tell; null where there is none, or
/// something else is told already.
const SeenText* text_to_tell(const FrameContent& content, Point pointer) {
  const Layer lowest = reachable_layer(content);
  const SeenText* found = nullptr;
  for (const SeenText& seen : content.texts) {
    if (seen.layer == Layer::Tooltip) return nullptr;
    const bool has_more = (seen.is_shortened && seen.may_be_shortened) || !seen.hint.empty();
    if (has_more && seen.layer >= lowest && seen.visible.contains(pointer) &&
        (found == nullptr || seen.layer >= found->layer))
      found = &seen;
  }
  return found;
}

}  // namespace

// Words that had no room are told whole once the pointer rests on them.
void Ui::tell_what_was_cut() {
  const bool is_pressing = std::any_of(input_.held.begin(), input_.held.end(),
                                       [](const auto& button) { return button.is_down; });
  if (!input_.is_pointer_inside || is_pointer_hidden_ || is_pressing) return;
  const SeenText* seen = text_to_tell(building_, input_.pointer);
  if (seen == nullptr) return;
  const double rested_s = time_s_ - input_.pointer_still_since_s;
  if (rested_s < told_after_s) return want_frame_in_s(told_after_s - rested_s + 0.01);
  const std::string words = seen->hint.empty() ? seen->whole : seen->hint;
  draw_told_words(*canvas_, theme_, seen->visible, words);
}

// Drawn last, over everything: an arrow whose tip is the place.
void Ui::settle_pointer() {
  const bool is_drawn = is_pointer_carried_ && !is_pointer_hidden_ && input_.is_pointer_inside;
  if (is_pointer_hidden_ || is_pointer_carried_) pointer_shape_ = PointerShape::Hidden;
  if (!is_drawn) return;
  const LayerScope layer(*canvas_, Layer::Tooltip);
  const Point tip = input_.pointer;
  const Point edge[] = {
      {tip.x - 2.0F, tip.y - 4.0F}, {tip.x - 2.0F, tip.y + 22.0F}, {tip.x + 17.0F, tip.y + 15.0F}};
  const Point arrow[] = {tip, {tip.x, tip.y + 18.0F}, {tip.x + 13.0F, tip.y + 13.0F}};
  canvas_->polygon(edge, theme_.page);
  canvas_->polygon(arrow, theme_.text);
}

// A menu or question that appears takes the focus and gives it back when it goes.
void Ui::settle_focus() {
  const Layer before = reachable_layer(shown_), now = reachable_layer(building_);
  const std::string focus_before = input_.focus;
  if (now > before) {
    focus_below_[before] = input_.focus;
    input_.focus.clear();
  } else if (now < before) {
    input_.focus = focus_below_[now];
  }
  const Widget* widget = find_widget(building_, input_.focus);
  if (widget == nullptr || !can_have_focus(building_, *widget)) input_.focus.clear();
  const bool is_new = first_focus_ != shown_first_focus_;
  if (!first_focus_.empty() && (is_new || (input_.focus.empty() && now > Layer::Page))) {
    const Widget* first = find_widget(building_, first_focus_);
    if (first != nullptr && can_have_focus(building_, *first) && now >= before)
      input_.focus = first_focus_;
  }
  shown_first_focus_ = first_focus_;
  if (input_.focus != focus_before) want_frame_in_s(0.0);
}

float Ui::width_of(Type type, std::string_view line) const noexcept {
  return text_width(fonts_->face(type), line) / fonts_->scale();
}

float Ui::paragraph_height(Type type, std::string_view text, float width) const {
  const auto lines = broken_lines(fonts_->face(type), text, width * scale() + 0.5F).size();
  return static_cast<float>(lines) * line_height(type);
}

void Ui::focus(std::string_view id) {
  input_.focus = id;
  want_frame_in_s(0.0);
}

void Ui::focus_first(std::string_view id) {
  if (canvas_->layer() >= reachable_layer(building_)) first_focus_ = id;
}

Response Ui::control(Widget widget) {
  CHECK(!widget.id.empty());
  widget.layer = canvas_->layer();
  widget.visible = intersection(widget.rect, canvas_->clip());
  widget.scroll = open_scrolls_.empty() ? -1 : open_scrolls_.back().second;
  Response response;
  const bool is_under_pointer = input_.hovered == widget.id;
  const Interaction::HeldButton& left = input_.held[0];
  response.is_held = widget.is_enabled && left.is_down && left.id == widget.id;
  response.is_hovered = is_under_pointer && (!left.is_down || response.is_held);
  response.has_focus = widget.is_enabled && input_.focus == widget.id;
  response.shows_ring = input_.focus == widget.id && input_.is_ring_shown;
  if (widget.is_enabled && input_.pressed == widget.id) {
    response.pressed_by = input_.pressed_by;
    response.is_double = input_.is_double;
  }
  response.hover = eased(widget.id, response.is_hovered && widget.is_enabled, hover_s);
  if (response.is_hovered && widget.is_enabled)
    pointer_shape_ = widget.role == Role::Field ? PointerShape::Text : PointerShape::Hand;
  building_.widgets.push_back(std::move(widget));
  return response;
}

AreaResponse Ui::area(std::string_view id, std::string_view label, const Rect& rect,
                      bool takes_wheel) {
  Widget widget{.id = std::string(id),
                .label = std::string(label),
                .rect = rect,
                .role = Role::Area,
                .is_focusable = false,
                .takes_wheel = takes_wheel};
  const std::string name = widget.id;
  AreaResponse response;
  response.is_hovered = control(std::move(widget)).is_hovered;
  pointer_shape_ = response.is_hovered ? PointerShape::Arrow : pointer_shape_;
  response.pointer = input_.pointer;
  for (std::size_t button = 0; button < input_.held.size(); ++button) {
    if (input_.held[button].id == name) {
      response.is_down[button] = input_.held[button].is_down;
      response.dragged[button] = input_.dragged[button];
    }
    response.clicked[button] = input_.clicked_areas[button] == name;
  }
  response.is_captured = shown_capture_ == name;
  if (response.is_captured) response.way = input_.captured_way;
  response.is_double = response.clicked[0] && input_.is_double;
  if (input_.wheel_target == name) response.wheel = input_.wheel;
  return response;
}

void Ui::tell(std::string_view id, std::string_view text, const Rect& rect) {
  building_.read_outs.push_back({std::string(id), std::string(text), rect, canvas_->layer()});
}

void Ui::capture_pointer(std::string_view area) {
  if (!can_capture_) return;
  building_capture_ = area;
  hide_pointer();
}

std::vector<FieldEvent> Ui::field_events(const std::string& id) const {
  std::vector<FieldEvent> events;
  for (const Interaction::Edit& edit : input_.edits)
    if (edit.id == id) events.push_back(edit.event);
  return events;
}

// A field that appears is edited from its end on.
TextEdit& Ui::text_edit(const std::string& id) {
  constexpr std::size_t end = std::numeric_limits<std::size_t>::max();
  return edits_of_.try_emplace(id, TextEdit{.cursor = {end, end}}).first->second;
}

std::optional<std::string> Ui::take_dropped() {
  if (canvas_->layer() < reachable_layer(shown_)) return std::nullopt;
  return std::exchange(input_.dropped, std::nullopt);
}

bool Ui::shortcut(Chord chord, std::string_view label) {
  building_shortcuts_.push_back({chord, std::string(label), canvas_->layer()});
  if (!input_.key || *input_.key != chord || canvas_->layer() < reachable_layer(shown_))
    return false;
  input_.key.reset();
  input_.is_letter_taken = true;
  return true;
}

int Ui::shortcut_repeats(Chord chord, std::string_view label) {
  return shortcut(chord, label) ? input_.key_repeats : 0;
}

float Ui::eased(const std::string& id, bool is_on, float duration_s) {
  Motion& motion = motions_.try_emplace(id, Motion{.value = 0.0F}).first->second;
  motion.is_touched = true;
  const float target = is_on ? 1.0F : 0.0F;
  if (is_motion_reduced_ || duration_s <= 0.0F) {
    motion.value = target;
  } else {
    const float step = static_cast<float>(time_s_ - last_time_s_) / duration_s;
    motion.value = std::clamp(target, motion.value - step, motion.value + step);
  }
  if (motion.value != target) want_frame_in_s(0.0);
  return motion.value;
}

double Ui::hovered_for_s(std::string_view id) const noexcept {
  return input_.hovered == id ? time_s_ - input_.hovered_since_s : 0.0;
}

float Ui::begin_scroll(std::string_view id, std::string_view label, const Rect& view,
                       float content_height) {
  const std::string name(id);
  ScrollState& state = scrolls_[name];
  state.is_touched = true;
  state.view = view;
  state.content_height = content_height;
  const float longest = std::max(0.0F, content_height - view.h);
  if (input_.wheel_target == name) state.offset -= input_.wheel * wheel_step;
  scroll_to_focus(name, state);
  state.offset = std::clamp(state.offset, 0.0F, longest);
  control({.id = name,
           .label = std::string(label),
           .rect = view,
           .role = Role::Scroll,
           .is_focusable = false,
           .room_above = state.offset,
           .room_below = longest - state.offset});
  pointer_shape_ = PointerShape::Arrow;
  open_scrolls_.emplace_back(name, static_cast<int>(building_.widgets.size()) - 1);
  canvas_->push_clip(view);
  canvas_->push_room({view.x, view.y - state.offset, view.w, std::max(content_height, view.h)});
  return state.offset;
}

// After the keyboard moved the focus, the region it lies in shows it, and so does each region
// around that one.
void Ui::scroll_to_focus(const std::string& id, ScrollState& state) {
  const Widget* focus = input_.has_focus_moved ? find_widget(shown_, input_.focus) : nullptr;
  if (focus == nullptr) return;
  constexpr float margin = 12.0F;
  Rect wanted = focus->rect;
  for (int around = focus->scroll; around >= 0;) {
    const Widget& region = shown_.widgets[static_cast<std::size_t>(around)];
    if (region.id == id) {
      // It moved since, where a region around it was scrolled just before.
      wanted.y += state.view.y - region.rect.y;
      state.offset += std::max(0.0F, wanted.bottom() + margin - state.view.bottom());
      state.offset -= std::max(0.0F, state.view.y - (wanted.y - margin));
      return;
    }
    wanted.y = std::clamp(wanted.y, region.rect.y,
                          std::max(region.rect.y, region.rect.bottom() - wanted.h));
    around = region.scroll;
  }
}

void Ui::end_scroll() {
  CHECK(!open_scrolls_.empty());
  const std::string id = open_scrolls_.back().first;
  canvas_->pop_room();
  canvas_->pop_clip();
  open_scrolls_.pop_back();
  draw_scroll_bar(id, scrolls_[id]);
}

// The region itself keeps it inside, in the next frame at the latest.
void Ui::scroll_by(std::string_view id, float distance) {
  ScrollState& state = scrolls_[std::string(id)];
  scroll_to(id, state.offset + distance);
}

void Ui::scroll_to(std::string_view id, float offset) {
  ScrollState& state = scrolls_[std::string(id)];
  state.is_touched = true;
  state.offset = std::max(0.0F, offset);
  want_frame_in_s(0.0);
}

void Ui::draw_scroll_bar(const std::string& id, ScrollState& state) {
  const float longest = state.content_height - state.view.h;
  if (longest <= 0.5F) return;
  const Rect track{state.view.right() - 10.0F, state.view.y, 10.0F, state.view.h};
  const float length = std::max(32.0F, track.h * state.view.h / state.content_height);
  const float travel = track.h - length;
  const Response response = control({.id = std::string(id + ".bar"),
                                     .label = std::string(text("scroll.bar")),
                                     .rect = track,
                                     .role = Role::Area,
                                     .is_focusable = false});
  pointer_shape_ = response.is_hovered ? PointerShape::Arrow : pointer_shape_;
  if (response.is_held && travel > 0.0F && input_.dragged[0].y != 0.0F) {
    state.offset = std::clamp(state.offset + input_.dragged[0].y * longest / travel, 0.0F, longest);
    want_frame_in_s(0.0);
  }
  const Rect thumb{track.x + 3.0F, track.y + travel * state.offset / longest, 4.0F, length};
  canvas_->fill(thumb, faded(theme_.border, response.is_hovered || response.is_held ? 0.9F : 0.5F),
                2.0F);
}

}  // namespace hallux::ui
