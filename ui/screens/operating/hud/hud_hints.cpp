// Lines of words: what to do next and why a button is off, below the steps.
#include "ui/screens/operating/hud/hud_hints.h"

#include <algorithm>
#include <vector>

#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

namespace {

constexpr float line_gap = 8.0F, sign_room = 36.0F;
constexpr float edge_x = 16.0F, edge_y = 7.0F;
/// So far from the tool the sentences go back to the steps, lest they leap with each stroke.
constexpr float back_from_low = 60.0F;

/// On a panel in the middle, broken where it is long.
struct Sentence {
  const char* id;
  Meaning meaning;
  const std::string& words;
};

/// Below `y`.
Rect place_of(const Hud& in, const std::string& words, float y, float most) {
  const float width = std::min(most, in.ui.width_of(Type::Small, words) + sign_room + 20.0F);
  const float inner = width - sign_room - edge_x;
  const float height = in.ui.paragraph_height(Type::Small, words, inner) + 2.0F * edge_y;
  return {in.ui.display().mid_x() - 0.5F * width, y + line_gap, width, height};
}

void draw_sentence(Hud& in, const Sentence& sentence, const Rect& rect) {
  const HudPanel panel(in, sentence.id, rect, std::min(18.0F, 0.5F * rect.h), HudFading::Never);
  draw_meaning(in.canvas(), in.theme(), sentence.meaning, {rect.x + 20.0F, rect.y + 17.0F}, 6.0F);
  in.canvas().paragraph(
      {rect.x + sign_room, rect.y + edge_y, rect.w - sign_room - edge_x, rect.h - 2.0F * edge_y},
      {Type::Small, in.theme().text}, sentence.words);
  in.ui.tell(sentence.id, sentence.words, rect);
}

/// Sentences one below the other.
struct Sentences {
  std::vector<Sentence> each;
  std::vector<Rect> places;
  float bottom = 0.0F;

  bool have_tool_behind(const Hud& in, float around = 0.0F) const {
    return std::any_of(places.begin(), places.end(), [&](const Rect& place) {
      return in.has_fading_tool_behind(inset(place, -around, -around));
    });
  }
};

Sentences sentences_below(const Hud& in, float y, float most) {
  Sentences sentences{{}, {}, y};
  for (const Sentence& sentence : {Sentence{"operate.reason", Meaning::Info, in.hud.why_step_off},
                                   Sentence{"operate.hint", Meaning::Neutral, in.hud.hint}}) {
    if (sentence.words.empty()) continue;
    sentences.each.push_back(sentence);
    sentences.places.push_back(place_of(in, sentence.words, sentences.bottom, most));
    sentences.bottom = sentences.places.back().bottom();
  }
  return sentences;
}

/// What tells the next thing to do is read: where the tool passes behind it, it stands above the
/// lower panels, if it can be read there.
Sentences readable_sentences(Hud& in, const Sentences& high, float y, float lower_end) {
  // Between the panels that stand above the lower ones.
  const float most = std::min(widest_hint_share * in.room.w, in.room.w - 2.0F * in.side_width);
  const float height = sentences_below(in, y, most).bottom - y;
  const Sentences low = sentences_below(in, lower_end - line_gap - height, most);
  const float around = in.hud.are_hints_low ? back_from_low : 0.0F;
  in.answer.are_hints_low = high.have_tool_behind(in, around) && !low.have_tool_behind(in);
  return in.answer.are_hints_low ? low : high;
}

}  // namespace

HintsPlace draw_hud_hints(Hud& in, float y, float lower_end) {
  const Sentences high = sentences_below(in, y, widest_hint_share * in.room.w);
  const Sentences sentences = readable_sentences(in, high, y, lower_end);
  for (std::size_t i = 0; i < sentences.each.size(); ++i)
    draw_sentence(in, sentences.each[i], sentences.places[i]);
  return {high.bottom, in.answer.are_hints_low ? sentences.places : std::vector<Rect>()};
}

}  // namespace hallux::ui
