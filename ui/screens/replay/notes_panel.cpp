// Notes of an attempt with their replies and questions with their answers, in the order of their
// moments. Heights are computed before drawing, because the list scrolls. The line to answer exists
// only for a note that was chosen and may be answered; what was typed there outlives a change of
// the choice. A question is answered in the inbox.
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

using database::HelpRequest;
using database::Note;
using database::NoteReply;

constexpr float edge = 12.0F, face = 28.0F, line_height = 22.0F, reply_inset = 28.0F,
                between = 8.0F, badge_room = 36.0F, said_foot = 6.0F, pill_height = 26.0F;

Remarks read_remarks(database::Session& session, const database::AttemptId& id) {
  const database::AttemptHeader header = header_for(session, id);
  return remarks_of(notes_about(session, header), questions_about(session, header));
}

/// Somebody's words, with a face and a name.
struct Said {
  std::string name;
  std::string_view words;
  database::PersonId person;
};

/// What a remark consists of, top to bottom.
struct RemarkText {
  Said first;
  std::vector<Said> replies;
  /// A pill below the first; empty: none.
  std::string_view pill;
  Meaning pill_meaning = Meaning::Neutral;
};

float said_height(const Ui& ui, std::string_view words, float width) {
  return line_height + ui.paragraph_height(Type::Small, words, width - face - edge) + said_foot;
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

RemarkText text_of_note(const Ui& ui, const Note& note) {
  RemarkText text;
  text.first = {person_name_of(ui.texts(), {}, note.author_name), note.text, note.author};
  if (note.is_private) text.pill = ui.text("notes.private");
  for (const NoteReply& reply : note.replies)
    text.replies.push_back(
        {person_name_of(ui.texts(), {}, reply.author_name), reply.text, reply.author});
  return text;
}

RemarkText text_of_question(const Ui& ui, const HelpRequest& question) {
  RemarkText text;
  text.first = {person_name_of(ui.texts(), {}, question.asker_name), question.question,
                question.asker};
  text.pill = ui.text(question.answer ? "notes.question.answered" : "notes.question.open");
  text.pill_meaning = question.answer ? Meaning::Good : Meaning::Info;
  // Who answered is known by name alone; the face is anybody's.
  if (question.answer)
    text.replies.push_back(
        {person_name_of(ui.texts(), {}, question.answer->by_name), question.answer->text, {}});
  return text;
}

RemarkText text_of_remark(const Ui& ui, const Remarks& remarks, const Remark& remark) {
  const Note* note = remarks.note(remark);
  return note != nullptr ? text_of_note(ui, *note)
                         : text_of_question(ui, *remarks.question(remark));
}

float remark_height(const Ui& ui, const RemarkText& text, float width) {
  const float inner = width - 2.0F * edge;
  float height = 2.0F * edge + said_height(ui, text.first.words, inner);
  if (!text.pill.empty()) height += pill_height;
  for (const Said& reply : text.replies)
    height += between + said_height(ui, reply.words, inner - reply_inset);
  return height;
}

void draw_remark(Ui& ui, const Rect& place, const RemarkText& text, const Remarks& remarks,
                 const Remark& remark) {
  Rect rest = inset(place, edge);
  const std::string moment = clock_text(second_of(remark));
  const float clock = ui.width_of(Type::SmallMedium, moment);
  draw_remark_badge(ui, {rest.right() - clock - 18.0F, rest.y + line_height / 2.0F}, remarks,
                    remark);
  ui.canvas().text({rest.right(), rest.y + line_height / 2.0F},
                   {Type::SmallMedium, ui.theme().accent, Align::Right}, moment);
  draw_said(ui, take_top(rest, said_height(ui, text.first.words, rest.w)), text.first,
            clock + badge_room);
  if (!text.pill.empty()) {
    const Rect line = take_top(rest, pill_height);
    pill(ui, {line.x + face + edge, line.mid_y() - 2.0F}, text.pill, text.pill_meaning,
         text.pill_meaning != Meaning::Neutral);
  }
  take_left(rest, reply_inset);
  for (const Said& reply : text.replies) {
    take_top(rest, between);
    draw_said(ui, take_top(rest, said_height(ui, reply.words, rest.w)), reply, 0.0F);
  }
}

}  // namespace

void draw_remark_badge(Ui& ui, Point centre, const Remarks& remarks, const Remark& remark) {
  const HelpRequest* question = remarks.question(remark);
  if (question == nullptr) {
    draw_timeline_shape(ui.canvas(), ui.theme(), TimelineShape::Note, centre,
                        std::to_string(remark.number));
  } else {
    draw_timeline_shape(ui.canvas(), ui.theme(),
                        question->answer ? TimelineShape::Answered : TimelineShape::Question,
                        centre);
  }
}

void NotesPanel::read(Ui& ui, Shell& shell) {
  remarks_.read(ui, shell, ui.text("notes.reading"), signed_in_,
                [id = attempt_](database::Session& session) { return read_remarks(session, id); });
}

const Remarks& NotesPanel::remarks() const noexcept {
  return remarks_.has_value() ? remarks_.value() : none_;
}

const Note* NotesPanel::chosen_note() const noexcept {
  return chosen_ && *chosen_ < remarks().order.size() ? remarks().note(remarks().order[*chosen_])
                                                      : nullptr;
}

std::optional<double> NotesPanel::draw(Ui& ui, Shell& shell, const Rect& rect,
                                       const database::AttemptHeader& header,
                                       const AttemptRights& rights) {
  Rect rest = rect;
  if (!remarks_.draw_until_ready(ui, "notes.failed", rest, 4)) return std::nullopt;
  if (remarks().order.empty()) {
    empty_card(ui, "notes.empty", rest,
               {Icon::Note, ui.text("notes.empty"),
                ui.text(rights.may_read_notes ? "notes.empty.sentence" : "notes.none_here")});
    return std::nullopt;
  }
  if (chosen_ && *chosen_ >= remarks().order.size()) chosen_.reset();
  const Note* note = chosen_note();
  if (note != nullptr && rights.may_reply && !note->is_private) {
    const float height =
        field_height + (work_.fault().empty() ? 0.0F : field_message_height) + field_label_height;
    draw_reply(ui, shell, take_bottom(rest, height, 12.0F), header);
  }
  return draw_list(ui, rest);
}

std::optional<double> NotesPanel::draw_list(Ui& ui, const Rect& rect) {
  const std::vector<Remark>& order = remarks().order;
  const float width = rect.w - 6.0F;
  float height = 0.0F;
  std::vector<RemarkText> texts;
  for (const Remark& remark : order) {
    texts.push_back(text_of_remark(ui, remarks(), remark));
    height += remark_height(ui, texts.back(), width) + between;
  }
  const float offset = ui.begin_scroll("notes.list", ui.text("notes.title"), rect, height);
  std::optional<double> asked_s;
  float y = rect.y - offset;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Rect place{rect.x, y, width, remark_height(ui, texts[i], width)};
    y = place.bottom() + between;
    const char* kind = order[i].is_question ? "notes.question." : "notes.note.";
    const Response response = ui.control({.id = kind + std::to_string(order[i].number),
                                          .label = std::string(texts[i].first.words),
                                          .rect = place,
                                          .role = Role::Row,
                                          .is_chosen = chosen_ == i,
                                          .group = "notes.list"});
    ui.canvas().fill(
        place, chosen_ == i ? ui.theme().accent_soft : faded(ui.theme().raise, response.hover),
        radius::control);
    if (response.shows_ring)
      draw_focus_ring(ui.canvas(), ui.theme(), inset(place, 4.0F), radius::control);
    draw_remark(ui, place, texts[i], remarks(), order[i]);
    if (!response.is_pressed()) continue;
    chosen_ = i;
    asked_s = second_of(order[i]);
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
  if (!has_reply()) button_spec.why_off = ui.text("notes.reply.missing");
  button_spec.is_busy = work_.is_running();
  const Rect place = take_right(line, button_width(ui, button_spec), 8.0F);
  FieldSpec words;
  const std::string number = std::to_string(remarks().order[*chosen_].number);
  const std::string label = ui.texts().say("notes.reply", {{"number", number}});
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
  const database::NoteId note = chosen_note()->id;
  work_.change(
      shell, signed_in_, {std::string(ui.text("notes.sending")), {}},
      [header, note, words = reply_](database::Session& session) {
        reply_to_note(session, header, note, words);
      },
      [this] {
        reply_.clear();
        remarks_.read_again();
      });
}

}  // namespace hallux::ui
