// An attempt at any moment. The player knows the time, all else is shown for it: bone, saw, hand,
// pins, curves. The bone at a moment is looked up in a history that was cut beforehand, so that
// dragging through the time is as quick as playing. Keys lead the time unless somebody writes.
#include "ui/screens/replay/replay_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "simulator/base/units.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/value_text.h"
#include "ui/screens/pictures/planned_frame.h"
#include "ui/screens/pictures/shown_camera.h"
#include "ui/screens/replay/hand_panel.h"
#include "ui/screens/result/result_cards.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float head_height = 64.0F, panel_width = 352.0F, edge = 20.0F, time_edge = 12.0F,
                legend_gap = 8.0F;
constexpr float row_height = 36.0F;
/// Of the section beside the view along the blade.
constexpr float inset_width = 240.0F, inset_height = 220.0F;
constexpr CellStyle moment_cell{Type::SmallMedium, &Theme::accent};

constexpr std::array<StandardView, 5> views{StandardView::Operator, StandardView::Dorsal,
                                            StandardView::Medial, StandardView::Plantar,
                                            StandardView::AlongBlade};

/// Of these, the one that follows what was on the screen; where it was not recorded, the
/// operator's.
constexpr int as_seen = 0, turned_by_hand = -1;

/// Of the section, at the right of the picture.
Rect section_corner(const Rect& picture) {
  return {picture.right() - edge - inset_width, picture.y + 2.0F * edge + segmented_height,
          inset_width, inset_height};
}

void draw_event(Ui& ui, const AttemptEvent& event, const Rect& cell) {
  draw_meaning(ui.canvas(), ui.theme(), event.meaning, {cell.x + 7.0F, cell.mid_y()}, 6.0F);
  ui.canvas().text_in({cell.x + 22.0F, cell.y, cell.w - 22.0F, cell.h},
                      {Type::Small, ui.theme().text}, ui.text(event.words), true);
}

std::vector<ScoreMark> marks_of(const Texts& texts, const ReplayMaterial& material, bool is_made) {
  std::vector<ScoreMark> marks;
  if (material.header.state == database::AttemptState::Void)
    marks.push_back({std::string(texts.text("result.mark.void")), Meaning::Bad, true});
  // Whoever reviewed the scenario has not reviewed the hand.
  if (is_made || !material.scenario.is_reviewed)
    marks.push_back({std::string(texts.text("result.mark.not_reviewed")), Meaning::Warn, true});
  if (is_made || material.header.is_simulated)
    marks.push_back({std::string(texts.text("result.mark.simulated")), Meaning::Info, true});
  return marks;
}

}  // namespace

void ReplayScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (material_.is_new()) start(ui, shell);
  if (!draw_until_ready(ui, content, shell)) return;
  if (!bone_) open(ui);
  if (notes_) notes_->read(ui, shell);
  hear_keys(ui);
  player_.advance(ui);
  draw_replay(ui, content, shell);
  if (!is_made()) draw_forms(ui, shell);
  // Who pressed something with the mouse means the arrows for the time again, not for what was
  // pressed.
  const bool is_writing = ui.focused() == "notes.reply" || ask_.is_open() || pin_.is_open();
  if (!ui.is_steered_by_keys() && !is_writing && !ui.focused().empty()) ui.focus({});
}

void ReplayScreen::start(Ui& ui, Shell& shell) {
  if (is_made()) {
    return material_.start(
        ui, shell, ui.text("replay.making"),
        [signed_in = signed_in_, made = made_, scenario = made_of_](WorkReport& report) {
          return made->find_or_make(scenario, *signed_in, report);
        });
  }
  material_.start(ui, shell, ui.text("replay.reading"),
                  [signed_in = signed_in_, id = attempt_](WorkReport& report) {
                    return load_replay(*signed_in, id, report);
                  });
}

bool ReplayScreen::draw_until_ready(Ui& ui, const Rect& content, Shell& shell) {
  Rect page = inset(content, space::page);
  if (is_made() && !material_.has_value()) {
    PageHead head{made_of_.title, ui.text("replay.made.wait")};
    head.has_back = true;
    if (page_head(ui, "replay", page, head).is_back_pressed) shell.pop();
  }
  return material_.draw_until_ready(ui, "replay.failed", page, 10);
}

void ReplayScreen::open(Ui& ui) {
  bone_ = std::make_unique<simulator::BoneMoment>(*material().bone->history);
  std::vector<double> event_s;
  for (const AttemptEvent& event : material().events) event_s.push_back(event.time_s);
  player_.open(material().duration_s, std::move(event_s), first_moment_s_);
  stage_.leave_plus_and_minus();
  stage_.look_at(transform_point(material().world_from_bone, material().middle_in_bone_mm),
                 0.9 * material().radius_mm, views.front());
  ui.want_frame_in_s(0.0);
}

void ReplayScreen::draw_replay(Ui& ui, const Rect& content, Shell& shell) {
  Rect rest = content;
  draw_head(ui, take_top(rest, head_height), shell);
  const Timeline shown = timeline_.shown(ui.texts(), material(), is_made() ? nullptr : &remarks(),
                                         player_.now_s(), ui.display().h);
  draw_time(ui, take_bottom(rest, time_height(ui, shown, rest.w)), shown);
  const float width = std::clamp(0.3F * content.w, 216.0F, panel_width);
  draw_panel(ui, take_right(rest, width), shell);
  draw_view(ui, rest, shell);
}

std::string ReplayScreen::crumb(const Ui& ui) const {
  if (is_made())
    return ui.texts().say("replay.made.crumb", {{"operation", material().scenario.title}});
  const database::AttemptHeader& header = material().header;
  std::string where =
      ui.texts().say("replay.crumb", {{"operation", material().scenario.title},
                                      {"number", grouped(static_cast<long>(header.number))}});
  if (header.begun.person == signed_in_->person().id || header.login.empty()) return where;
  return ui.texts().say("result.of_person", {{"operation", where}, {"person", header.login}});
}

void ReplayScreen::draw_head(Ui& ui, const Rect& bar, Shell& shell) {
  Canvas& canvas = ui.canvas();
  canvas.fill(bar, ui.theme().side);
  canvas.hairline_across(bar.x, bar.bottom() - 1.0F, bar.w, ui.theme().line);
  Rect rest = inset(bar, edge, 8.0F);
  const AttemptRights& rights = material().rights;
  const auto action = [&](const char* id, ButtonSpec spec) {
    if (notes_ && notes_->has_reply()) spec.look = ButtonLook::Secondary;
    const Rect place = take_right(rest, std::min(button_width(ui, spec), rest.w), 8.0F);
    return button(ui, id, {place.x, place.mid_y() - 18.0F, place.w, header_button_height}, spec);
  };
  if (rights.may_ask_for_help &&
      action("replay.flag", {ui.text("replay.flag"), ButtonLook::Primary, Icon::Flag}))
    ask_.open();
  if (rights.may_write_notes &&
      action("replay.pin", {ui.text("replay.pin"), ButtonLook::Primary, Icon::Note}))
    pin_.open();
  if (is_made() && action("replay.back", {ui.text("replay.made.back")})) shell.pop();
  canvas.text_in(take_top(rest, 20.0F), {Type::Small, ui.theme().text_caption}, crumb(ui), true);
  const std::string_view title = ui.text(is_made() ? "replay.made.title" : "replay.title");
  canvas.text_in(rest, {Type::Section, ui.theme().text}, title);
  float x = rest.x + ui.width_of(Type::Section, title) + 16.0F;
  for (const ScoreMark& mark : marks_of(ui.texts(), material(), is_made())) {
    if (x + pill_width(ui, mark.words, mark.has_shape) > rest.right()) break;
    x += pill(ui, {x, rest.mid_y()}, mark.words, mark.meaning, mark.has_shape) + 8.0F;
  }
}

Scene ReplayScreen::scene_of(const Ui& ui, const HandAtMoment& hand) const {
  Scene scene;
  scene.ground = ui.theme().is_dark() ? Ground::Dark : Ground::Light;
  scene.bones = bones_of(*material().bone, *bone_);
  add_metal(scene, *bone_, material().tray);
  add_tool(scene, hand.tool, {hand.world_from_tool, hand.is_running, player_.now_s()}, *bone_,
           *material().bone->history);
  if (shows_plan_) {
    for (const PlannedFace& face : material().faces) {
      scene.planes.push_back({material().world_from_bone * face.bone_from_face, face.half_mm});
    }
  }
  if (picked_) scene.marks.push_back({bone_->world_place_mm(*picked_), 6.0, Ink::Harm});
  return scene;
}

void ReplayScreen::draw_view(Ui& ui, const Rect& rect, Shell& shell) {
  const HandAtMoment hand = hand_at(material(), player_.now_s());
  const auto tick = static_cast<std::int64_t>(std::llround(player_.now_s() / step_s));
  bone_->move_to(tick);
  const std::string state =
      std::to_string(bone_->revision()) + "/" + std::to_string(tick) +
      (shows_plan_ ? "/plan" : "") +
      (picked_ ? std::to_string(picked_->point_mm.x) + std::to_string(picked_->point_mm.y)
               : std::string());
  // Forceps have no blade to look along: it is the tool's that was in the hand before.
  stage_.set_blade(hand.tool.grip == nullptr ? hand.world_from_tool
                                             : hand.tool.grip->world_from_tool);
  look_as_seen(rect);
  const StageResponse response =
      stage_.draw(ui, shell, rect, scene_of(ui, hand),
                  {"replay.view", ui.text("replay.view"), picture_id(state), 0.0F});
  if (response.pointed) pick(*response.pointed);
  if (response.was_turned) view_ = turned_by_hand;
  if (response.was_turned_back) view_ = as_seen;
  draw_pins(ui);
  const bool has_section = shows_section(rect, hand);
  draw_view_choices(ui, rect, has_section);
  draw_hand_panel(ui, inset(rect, edge), hand);
  if (!has_section) return;
  const Rect corner = section_corner(rect);
  inset_.draw(ui, shell, corner, material_.value(), *bone_, hand, shows_plan_);
  ui.tell("replay.section", ui.text("operate.panel.inset"), corner);
}

/// Of a saw in the hand, along the blade, and where it stood beside the operation as it is seen; if
/// there is room.
bool ReplayScreen::shows_section(const Rect& rect, const HandAtMoment& hand) const {
  if (hand.tool.held != HeldTool::Saw) return false;
  const Rect corner = section_corner(rect);
  if (corner.x <= rect.mid_x() || corner.bottom() + 60.0F >= rect.bottom()) return false;
  if (view_ == turned_by_hand) return false;
  if (view_ != as_seen) return views[static_cast<std::size_t>(view_)] == StandardView::AlongBlade;
  const SeenView seen = material().seen.at(player_.now_s());
  return seen.seen == Seen::Recorded && seen.view.layout == simulator::ShownLayout::WithSection;
}

void ReplayScreen::look_as_seen(const Rect& rect) {
  if (view_ != as_seen) return;
  const SeenView seen = material().seen.at(player_.now_s());
  if (seen.seen == Seen::Recorded) {
    stage_.show(camera_of(seen.view, static_cast<double>(rect.w / std::max(rect.h, 1.0F))));
  } else if (seen.seen == Seen::Unusable) {
    stage_.turn_back();
  }
}

/// What is meant by it here, below the choice.
void ReplayScreen::draw_seen(Ui& ui, const Rect& rect, float until_x) const {
  const std::string words = seen_text(ui.texts(), material().seen.at(player_.now_s()));
  const float width = ui.width_of(Type::Small, words) + 24.0F;
  if (rect.x + edge + width > until_x || rect.h < 180.0F) return;
  const Rect panel{rect.x + edge, rect.y + edge + segmented_height + 8.0F, width, 28.0F};
  draw_hud_panel(ui.canvas(), ui.theme(), panel, 14.0F);
  ui.canvas().text({panel.x + 12.0F, panel.mid_y()}, {Type::Small, ui.theme().text_secondary},
                   words);
}

void ReplayScreen::draw_view_choices(Ui& ui, const Rect& rect, bool has_section) {
  const std::array<std::string_view, views.size()> labels{
      ui.text(is_made() ? "replay.made.view" : "replay.view.operator"),
      ui.text("replay.view.dorsal"), ui.text("replay.view.medial"), ui.text("replay.view.plantar"),
      ui.text("replay.view.blade")};
  const float width = segmented_width(ui, labels);
  const float room = rect.w - 2.0F * edge;
  if (width <= room &&
      segmented(ui, "replay.views", {rect.x + edge, rect.y + edge, width, segmented_height}, labels,
                view_)) {
    if (view_ == as_seen) {
      stage_.turn_back();
    } else {
      stage_.turn_to(views[static_cast<std::size_t>(view_)]);
    }
  }
  if (view_ == as_seen && !is_made())
    draw_seen(ui, rect, has_section ? section_corner(rect).x - 8.0F : rect.right() - edge);
  const std::string_view plan = ui.text("replay.plan");
  const float plan_width = 44.0F + ui.width_of(Type::Body, plan) + 24.0F;
  if (width + plan_width + 16.0F > room) return;
  const Rect panel{rect.right() - edge - plan_width, rect.y + edge, plan_width, segmented_height};
  draw_hud_panel(ui.canvas(), ui.theme(), panel, radius::control);
  toggle(ui, "replay.plan", inset(panel, 10.0F, 6.0F), plan, shows_plan_);
}

void ReplayScreen::draw_pins(Ui& ui) {
  const Remarks& remarks = this->remarks();
  for (std::size_t i = 0; i < remarks.order.size(); ++i) {
    const database::AttemptMoment& moment = remarks.moment(remarks.order[i]);
    if (!moment.place) continue;
    const auto seen =
        stage_.seen_at(bone_->world_place_mm(places_.of(*material().bone->history, *moment.place)));
    if (!seen) continue;
    if (notes_->chosen() == i) ui.canvas().ring(*seen, 12.0F, ui.theme().text, 2.0F);
    draw_remark_badge(ui, *seen, remarks, remarks.order[i]);
  }
}

void ReplayScreen::pick(const SightRay& ray) {
  picked_ = bone_->first_hit(ray.from_mm, ray.direction);
  if (picked_) picked_ = material().bone->history->place_at_last(*picked_);
}

void ReplayScreen::draw_panel(Ui& ui, const Rect& rect, Shell& shell) {
  ui.canvas().fill(rect, ui.theme().card);
  ui.canvas().hairline_down(rect.x, rect.y, rect.h, ui.theme().line);
  Rect rest = inset(rect, 16.0F, 12.0F);
  const std::array<std::string_view, 3> labels{ui.text("notes.title"), ui.text("replay.ledger"),
                                               ui.text("replay.events")};
  const int first = notes_ ? notes_tab : ledger_tab;
  int shown = tab_ - first;
  tabs(ui, "replay.tab", take_top(rest, tabs_height, 12.0F),
       std::span(labels).subspan(static_cast<std::size_t>(first)), shown);
  tab_ = shown + first;
  if (tab_ == notes_tab) {
    if (const auto moment_s = notes_->draw(ui, shell, rest, material().header, material().rights))
      player_.look_at(*moment_s);
  } else if (tab_ == ledger_tab) {
    draw_ledger(ui, rest);
  } else {
    draw_events(ui, rest);
  }
}

void ReplayScreen::draw_ledger(Ui& ui, const Rect& rect) {
  if (!material().card || material().card->ledger.empty()) {
    empty_card(
        ui, "replay.ledger.empty", rect,
        {Icon::Ratings, ui.text("result.ledger.empty"), ui.text("result.ledger.empty.sentence")});
    return;
  }
  const database::ScoreCard& score = *material().card;
  const std::vector<std::size_t> order = lines_by_loss(score);
  const assessment::ShownPoints shown = assessment::shown_points(score);
  const auto title = [&](std::size_t row) {
    return item_title(score.ledger[row], &material().scenario);
  };
  RowTable<std::size_t> lines{
      ui.text("replay.ledger"),
      [&](std::size_t row) { return score.ledger[row].item; },
      title,
      {{{ui.text("result.ledger.item")}, title, {Type::Small, &Theme::text}},
       {{ui.text("result.ledger.loss"), 52.0F, 1.0F, Align::Right},
        [&](std::size_t row) { return loss_text(score.ledger[row], shown.lines[row]); },
        {Type::SmallMedium, &Theme::text}},
       {{ui.text("result.ledger.moment"), 60.0F, 1.0F, Align::Right},
        [&](std::size_t row) {
          return clock_text(static_cast<double>(score.ledger[row].start_us) / 1.0e6);
        },
        moment_cell}}};
  lines.row_height = row_height;
  const TableResponse response = table(ui, "replay.ledger", rect, lines, order, ledger_);
  if (!response.opened) return;
  const database::LedgerLine& line =
      score.ledger[order[static_cast<std::size_t>(*response.opened)]];
  ledger_.chosen = {line.item};
  picked_ = places_.of(*material().bone->history, {0, line.place_in_bone_mm});
  player_.look_at(static_cast<double>(line.start_us) / 1.0e6);
}

void ReplayScreen::draw_events(Ui& ui, const Rect& rect) {
  const std::vector<AttemptEvent>& events = material().events;
  // An event is known by its number alone.
  const auto id = [&](const AttemptEvent& event) { return std::to_string(&event - events.data()); };
  RowTable<AttemptEvent> shown{
      ui.text("replay.events"),
      id,
      [&](const AttemptEvent& event) { return std::string(ui.text(event.words)); },
      {{{ui.text("replay.event")}, draw_event},
       {{ui.text("result.ledger.moment"), 60.0F, 1.0F, Align::Right},
        [](const AttemptEvent& event) { return clock_text(event.time_s); },
        moment_cell}}};
  shown.row_height = row_height;
  const TableResponse response = table(ui, "replay.event", rect, shown, events, events_);
  if (!response.opened) return;
  events_.chosen = {std::to_string(*response.opened)};
  player_.look_at(events[static_cast<std::size_t>(*response.opened)].time_s);
}

float ReplayScreen::time_height(const Ui& ui, const Timeline& shown, float width) const {
  const float legend = timeline_.shows_legend(ui.display().h)
                           ? timeline_legend_height(ui, shown, width - 2.0F * edge) + legend_gap
                           : 0.0F;
  return Player::height + timeline_height(shown) + legend + 2.0F * time_edge;
}

void ReplayScreen::draw_time(Ui& ui, const Rect& rect, const Timeline& shown) {
  ui.canvas().fill(rect, ui.theme().side);
  ui.canvas().hairline_across(rect.x, rect.y, rect.w, ui.theme().line);
  Rect rest = inset(rect, edge, time_edge);
  Rect line = take_top(rest, Player::height);
  const bool has_legend = timeline_.shows_legend(ui.display().h);
  const float bar = timeline_bar_width(ui, shown, timeline_.state());
  timeline_bar(ui, "replay.time", take_right(line, bar, edge), shown, timeline_.state(),
               has_legend);
  player_.draw(ui, line);
  if (has_legend) {
    const Rect foot = take_bottom(rest, timeline_legend_height(ui, shown, rest.w), legend_gap);
    draw_timeline_legend(ui, foot, shown);
  }
  hear_timeline(timeline(ui, "replay.timeline", rest, shown, timeline_.state()));
}

void ReplayScreen::hear_timeline(const TimelineAnswer& answer) {
  if (!answer.asked_s) return;
  player_.look_at(*answer.asked_s);
  if (!answer.note || !notes_) return;
  notes_->choose(*answer.note);
  tab_ = notes_tab;
}

void ReplayScreen::hear_keys(Ui& ui) {
  hear_timeline_keys(ui,
                     {.duration_s = material().duration_s,
                      .range = timeline_.state().range,
                      .now_s = player_.now_s()},
                     timeline_.state());
  if (ui.shortcut({Key::G}, ui.text("replay.plan"))) shows_plan_ = !shows_plan_;
  // What a click picks, for those without a mouse: turn the place to the middle, then mark it.
  if (ui.shortcut({Key::M}, ui.text("replay.mark"))) pick(stage_.ray_through(Vec2(0.5, 0.5)));
  if (material().rights.may_ask_for_help && ui.shortcut({Key::F}, ui.text("replay.flag"))) {
    player_.look_at(player_.now_s());
    ask_.open();
  }
  if (material().rights.may_write_notes && ui.shortcut({Key::C}, ui.text("replay.pin"))) {
    player_.look_at(player_.now_s());
    pin_.open();
  }
}

database::AttemptMoment ReplayScreen::moment_now() const {
  database::AttemptMoment moment;
  moment.moment_us = std::llround(player_.now_s() * 1.0e6);
  if (material().header.duration_ticks) {
    const std::int64_t last_us = time_us_from_tick(*material().header.duration_ticks - 1);
    moment.moment_us =
        std::clamp<std::int64_t>(moment.moment_us, 0, std::max<std::int64_t>(0, last_us));
  }
  if (picked_) moment.place = bone_point_of(*material().bone->history, *picked_);
  return moment;
}

void ReplayScreen::draw_forms(Ui& ui, Shell& shell) {
  const std::string clock = clock_text(player_.now_s());
  const auto about = [&](const char* with_place, const char* without) {
    return ui.texts().say(picked_ ? with_place : without, {{"moment", clock}});
  };
  const std::string asked = about("replay.ask.placed", "replay.ask.unplaced");
  const database::AttemptHeader& header = material().header;
  const bool was_asked = ask_.draw(
      ui, shell, signed_in_, question_form(ui, ui.text("replay.flag"), asked),
      [header, moment = moment_now()](database::Session& session, const std::string& words, bool) {
        ask_for_help(session, header, {header.id, moment, words});
      });
  const std::string pinned = about("replay.pin.placed", "replay.pin.unplaced");
  MessageFormSpec pin;
  pin.id = "pin";
  pin.title = ui.text("replay.pin");
  pin.sentence = pinned;
  pin.label = ui.text("replay.pin.words");
  pin.placeholder = ui.text("replay.pin.example");
  pin.act = ui.text("replay.pin.act");
  pin.toggle = ui.text("replay.pin.private");
  pin.sending = ui.text("replay.pin.sending");
  pin.sent = ui.text("replay.pin.sent");
  const bool was_pinned =
      pin_.draw(ui, shell, signed_in_, pin,
                [header, moment = moment_now()](database::Session& session,
                                                const std::string& words, bool is_private) {
                  desk_or_refused(instructor_desk_for(session, database::Action::WriteNote, header),
                                  "notes on this attempt are not yours to write")
                      .add_note({header.id, moment, is_private, words});
                });
  if (!was_pinned && !was_asked) return;
  picked_.reset();
  tab_ = notes_tab;
  notes_->read_again();
  ui.want_frame_in_s(0.0);
}

}  // namespace hallux::ui
