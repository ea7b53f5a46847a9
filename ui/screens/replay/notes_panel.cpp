// Notes of an attempt with their replies, in the order of their moments. Heights are computed
// before drawing, because the list scrolls. The line to answer exists only for a note that was
// chosen and may be answered; what was typed there outlives a change of the choice.
#include "ui/screens/replay/notes_panel.h"

#include <algorithm>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/person_cell.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

using database::Action;
using database::Note;
using database::NoteReply;

constexpr float edge = 12.0F, face = 28.0F, line_height = 22.0F, reply_inset = 28.0F,
                between = 8.0F, badge_radius = 9.0F;

std::vector<Note> read_notes(database::Session& session, const database::AttemptId& id) {
  const database::AttemptHeader header = header_for(session, id);
  if (auto desk = instructor_desk_for(session, Action::ReadNotes, header))
    return desk->notes(header.id);
  if (auto own = trainee_desk_for(session, Action::ReadNotes, header)) return own->notes(header.id);
  return {};
}

struct Said {
  std::string name;
  std::string_view words;
  database::PersonId person;
};

float said_height(const Ui& ui, std::string_view words, float width) {
  return line_height + ui.paragraph_height(Type::Small, words, width - face - edge) + 6.0F;
}

/// A face, a name and the words below it. `right` is what stands at the end of the name's line and
/// takes room there.
void draw_said(Ui& ui, Rect rest, const Said& said, float right) {
  Canvas& canvas = ui.canvas();
  person_avatar(ui, {rest.x + face / 2.0F, rest.y + face / 2.0F}, face / 2.0F, said.name,
                said.person);
  take_left(rest, face + edge);
  const Rect head = take_top(rest, line_height);
  canvas.text_in({head.x, head.y, std::max(1.0F, head.w - right), head.h},
                 {Type::SmallMedium, ui.theme().text}, said.name, true);
  canvas.paragraph(rest, {Type::Small, ui.theme().text_secondary}, said.words);
}

float note_height(const Ui& ui, const Note& note, float width) {
  const float inner = width - 2.0F * edge;
  float height = 2.0F * edge + said_height(ui, note.text, inner);
  if (note.is_private) height += line_height + 4.0F;
  for (const NoteReply& reply : note.replies)
    height += between + said_height(ui, reply.text, inner - reply_inset);
  return height;
}

void draw_note(Ui& ui, const Rect& place, const Note& note, std::size_t number) {
  Rect rest = inset(place, edge);
  const std::string moment = clock_text(static_cast<double>(note.moment.moment_us) / 1.0e6);
  const float clock = ui.width_of(Type::SmallMedium, moment);
  draw_note_badge(ui, {rest.right() - clock - 18.0F, rest.y + line_height / 2.0F}, number);
  ui.canvas().text({rest.right(), rest.y + line_height / 2.0F},
                   {Type::SmallMedium, ui.theme().accent, Align::Right}, moment);
  const std::string name = person_name_of(ui.texts(), {}, note.author_name);
  draw_said(ui, take_top(rest, said_height(ui, note.text, rest.w)), {name, note.text, note.author},
            clock + 36.0F);
  if (note.is_private) {
    const Rect line = take_top(rest, line_height, 4.0F);
    pill(ui, {line.x + face + edge, line.mid_y()}, ui.text("notes.private"), Meaning::Neutral,
         false);
  }
  take_left(rest, reply_inset);
  for (const NoteReply& reply : note.replies) {
    take_top(rest, between);
    draw_said(ui, take_top(rest, said_height(ui, reply.text, rest.w)),
              {person_name_of(ui.texts(), {}, reply.author_name), reply.text, reply.author}, 0.0F);
  }
}

}  // namespace

void draw_note_badge(Ui& ui, Point centre, std::size_t number) {
  ui.canvas().disc(centre, badge_radius, ui.theme().accent);
  ui.canvas().text(centre, {Type::CaptionMedium, ui.theme().on_accent, Align::Centre},
                   std::to_string(number));
}

void NotesPanel::read(Ui& ui, Shell& shell) {
  notes_.read(ui, shell, ui.text("notes.reading"), signed_in_,
              [id = attempt_](database::Session& session) { return read_notes(session, id); });
}

const std::vector<Note>& NotesPanel::notes() const noexcept {
  return notes_.has_value() ? notes_.value() : none_;
}

std::optional<double> NotesPanel::draw(Ui& ui, Shell& shell, const Rect& rect,
                                       const database::AttemptHeader& header,
                                       const AttemptRights& rights) {
  Rect rest = rect;
  if (!notes_.draw_until_ready(ui, "notes.failed", rest, 4)) return std::nullopt;
  if (notes().empty()) {
    empty_card(ui, "notes.empty", rest,
               {Icon::Note, ui.text("notes.empty"),
                ui.text(rights.may_read_notes ? "notes.empty.sentence" : "notes.none_here")});
    return std::nullopt;
  }
  if (chosen_ && *chosen_ >= notes().size()) chosen_.reset();
  const bool may_reply = chosen_ && rights.may_reply && !notes()[*chosen_].is_private;
  if (may_reply) {
    const float height =
        field_height + (work_.fault().empty() ? 0.0F : field_message_height) + field_label_height;
    draw_reply(ui, shell, take_bottom(rest, height, 12.0F), header);
  }
  return draw_list(ui, rest);
}

std::optional<double> NotesPanel::draw_list(Ui& ui, const Rect& rect) {
  float height = 0.0F;
  for (const Note& note : notes()) height += note_height(ui, note, rect.w) + between;
  const float offset = ui.begin_scroll("notes.list", ui.text("notes.title"), rect, height);
  std::optional<double> asked_s;
  float y = rect.y - offset;
  for (std::size_t i = 0; i < notes().size(); ++i) {
    const Note& note = notes()[i];
    const Rect place{rect.x, y, rect.w - 6.0F, note_height(ui, note, rect.w - 6.0F)};
    y = place.bottom() + between;
    const Response response = ui.control({.id = "notes.note." + std::to_string(i + 1),
                                          .label = note.text,
                                          .rect = place,
                                          .role = Role::Row,
                                          .is_chosen = chosen_ == i,
                                          .group = "notes.list"});
    if (chosen_ == i) {
      ui.canvas().fill(place, ui.theme().accent_soft, radius::control);
    } else {
      ui.canvas().fill(place, faded(ui.theme().raise, response.hover), radius::control);
    }
    if (response.shows_ring)
      draw_focus_ring(ui.canvas(), ui.theme(), inset(place, 4.0F), radius::control);
    draw_note(ui, place, note, i + 1);
    if (!response.is_pressed()) continue;
    chosen_ = i;
    asked_s = static_cast<double>(note.moment.moment_us) / 1.0e6;
  }
  ui.end_scroll();
  return asked_s;
}

void NotesPanel::draw_reply(Ui& ui, Shell& shell, const Rect& rect,
                            const database::AttemptHeader& header) {
  Rect rest = rect;
  take_top(rest, field_label_height);
  Rect line = take_top(rest, field_height);
  ButtonSpec button_spec{ui.text("notes.send"), ButtonLook::Primary, Icon::Send};
  button_spec.is_enabled = has_reply();
  button_spec.is_busy = work_.is_running();
  const Rect place = take_right(line, button_width(ui, button_spec), 8.0F);
  FieldSpec words;
  const std::string label =
      ui.texts().say("notes.reply", {{"number", std::to_string(*chosen_ + 1)}});
  words.label = label;
  words.error = work_.fault();
  words.max_bytes = 2000;
  // Whether Enter sends is drawn from what is written, at the head of the screen too.
  if (field(ui, "notes.reply", line, reply_, words)) ui.want_frame_in_s(0.0);
  if (button(ui, "notes.send", {place.x, place.mid_y() - 19.0F, place.w, button_height},
             button_spec))
    send(ui, shell, header);
}

void NotesPanel::send(Ui& ui, Shell& shell, const database::AttemptHeader& header) {
  const database::NoteId note = notes()[*chosen_].id;
  work_.change(
      shell, signed_in_, {std::string(ui.text("notes.sending")), {}},
      [header, note, words = reply_](database::Session& session) {
        reply_to_note(session, header, note, words);
      },
      [this] {
        reply_.clear();
        notes_.read_again();
      });
}

}  // namespace hallux::ui
