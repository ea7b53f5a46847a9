// Words flow into lines across looks: a word may consist of parts ("one-time code" strong, the
// comma behind it not), and a line is broken only where a space stands.
//
//     |Ctrl with |plus| and |minus| makes ...|      parts of a look are drawn as one text
//
// A column of a table is as wide as its longest cell where there is room for all; else no narrower
// than its longest word, and what is left goes to those that wish for more.
#include "ui/screens/guide/page_flow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {

namespace {

constexpr float indent = 24.0F, between = 12.0F, between_items = 6.0F, below_heading = 10.0F;
constexpr float above_section = 30.0F, above_small_heading = 20.0F, code_edge = 12.0F;
constexpr float cell_across = 10.0F, cell_down = 7.0F, caption_gap = 8.0F;
constexpr float picture_edge = 6.0F;

float line_of(const Ui& ui, Type type) { return ui.paragraph_height(type, " ", 100.0F); }

struct TypeOfLook {
  Type plain, medium, strong;
};
constexpr TypeOfLook in_text{Type::Body, Type::BodyMedium, Type::BodyStrong};
constexpr TypeOfLook in_cell{Type::Small, Type::SmallMedium, Type::SmallMedium};
constexpr TypeOfLook in_head{Type::CaptionMedium, Type::CaptionMedium, Type::CaptionMedium};

constexpr TypeOfLook all_of(Type type) { return {type, type, type}; }

TypeOfLook of_heading(int level) {
  if (level == 1) return all_of(Type::Title);
  if (level == 2) return all_of(Type::Section);
  return all_of(level == 3 ? Type::CardTitle : Type::BodyStrong);
}

/// A part of a word: of one run.
struct Part {
  std::string text;
  std::size_t run = 0;
};
struct Word {
  std::vector<Part> parts;
  bool begins_line = false;
  float width = 0.0F;
};

/// How words of a paragraph look, and where they lie.
struct Place {
  Rect rect;
  TypeOfLook types = in_text;
  FlowTone tone = FlowTone::Text;
  Align align = Align::Left;
  /// Code stands on a ground of its own; in a heading it is words like others.
  bool marks_code = true;
};

class WordFlow {
 public:
  WordFlow(const Ui& ui, FlowedPage& flowed, const CanFollow& can_follow)
      : ui_(ui), flowed_(flowed), can_follow_(can_follow) {}

  /// Returns the height that the words take.
  float put(const MarkdownRuns& runs, const Place& place) {
    links_.assign(runs.size(), no_link);
    float y = place.rect.y;
    const float line_height = line_of(ui_, place.types.plain);
    const std::vector<Word> words = words_of(runs, place);
    const float space = ui_.width_of(place.types.plain, " ");
    for (std::size_t first = 0; first < words.size();) {
      std::size_t end = first + 1;
      float width = words[first].width;
      while (end < words.size() && !words[end].begins_line &&
             width + space + words[end].width <= place.rect.w)
        width += space + words[end++].width;
      const float left = place.rect.w - width;
      const float shift = place.align == Align::Right    ? left
                          : place.align == Align::Centre ? left / 2.0F
                                                         : 0.0F;
      put_line(runs,
               {words.begin() + static_cast<std::ptrdiff_t>(first),
                words.begin() + static_cast<std::ptrdiff_t>(end)},
               place, {place.rect.x + std::max(shift, 0.0F), y, width, line_height});
      y += line_height;
      first = end;
    }
    return y - place.rect.y;
  }

  /// The width of the words on one line, and of the longest of them.
  std::pair<float, float> widths(const MarkdownRuns& runs, const TypeOfLook& types) {
    float line = 0.0F, longest = 0.0F;
    constexpr float any = 1e6F;
    const float space = ui_.width_of(types.plain, " ");
    for (const Word& word : words_of(runs, {{0.0F, 0.0F, any, 0.0F}, types})) {
      line += (line > 0.0F ? space : 0.0F) + word.width;
      longest = std::max(longest, word.width);
    }
    return {std::ceil(line) + 1.0F, std::ceil(longest) + 1.0F};
  }

 private:
  static constexpr std::size_t no_link = static_cast<std::size_t>(-1);

  /// Of a part that stands by itself, with the edges of its ground.
  float width_of(const MarkdownRun& run, const Place& place, std::string_view text) const {
    const float edges = run.is_code && place.marks_code ? 2.0F * code_ground_edge : 0.0F;
    return ui_.width_of(type_of(run, place.types), text) + edges;
  }

  static Type type_of(const MarkdownRun& run, const TypeOfLook& types) {
    if (run.is_strong) return types.strong;
    return run.is_emphasised ? types.medium : types.plain;
  }

  std::vector<Word> words_of(const MarkdownRuns& runs, const Place& place) const {
    std::vector<Word> words;
    bool is_open = false, begins_line = false;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      const std::string& text = runs[run].text;
      for (std::size_t at = 0; at < text.size();) {
        if (text[at] == ' ' || text[at] == '\n') {
          begins_line |= text[at++] == '\n';
          is_open = false;
          continue;
        }
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        if (!is_open) words.push_back({{}, std::exchange(begins_line, false), 0.0F});
        words.back().parts.push_back({text.substr(at, end - at), run});
        words.back().width += width_of(runs[run], place, words.back().parts.back().text);
        is_open = true;
        at = end;
      }
    }
    return broken_to(place.rect.w, std::move(words), runs, place);
  }

  // A word that is wider than the line is broken between two letters.
  std::vector<Word> broken_to(float width, std::vector<Word> words, const MarkdownRuns& runs,
                              const Place& place) const {
    std::vector<Word> fitting;
    for (Word& word : words) {
      if (word.width <= width) {
        fitting.push_back(std::move(word));
        continue;
      }
      Word line{{}, word.begins_line, 0.0F};
      for (const Part& part : word.parts) {
        const float edges = width_of(runs[part.run], place, {});
        line.parts.push_back({{}, part.run});
        line.width += edges;
        for (std::size_t at = 0; at < part.text.size();) {
          const std::size_t next = following_place(part.text, at);
          const std::string letter = part.text.substr(at, next - at);
          const float letter_width = width_of(runs[part.run], place, letter) - edges;
          if (line.width > edges && line.width + letter_width > width)
            fitting.push_back(std::exchange(line, Word{{{{}, part.run}}, true, edges}));
          line.parts.back().text += letter;
          line.width += letter_width;
          at = next;
        }
      }
      fitting.push_back(std::move(line));
    }
    return fitting;
  }

  void put_line(const MarkdownRuns& runs, std::vector<Word> line, const Place& place, Rect rest) {
    // Behind each word but the last there is a space, of the look of the word where it goes on.
    float x = rest.x;
    const float space = ui_.width_of(place.types.plain, " ");
    std::vector<std::pair<Part, float>> pieces;
    for (std::size_t word = 0; word < line.size(); ++word) {
      for (std::size_t part = 0; part < line[word].parts.size(); ++part) {
        Part& own = line[word].parts[part];
        const bool is_first = part == 0 && word > 0;
        const bool goes_on = !pieces.empty() && pieces.back().first.run == own.run;
        if (is_first && !goes_on) x += space;
        if (goes_on) {
          const std::string text = (is_first ? " " : "") + own.text;
          pieces.back().first.text += text;
          x += ui_.width_of(type_of(runs[own.run], place.types), text);
        } else {
          const float width = width_of(runs[own.run], place, own.text);
          pieces.emplace_back(std::move(own), x);
          x += width;
        }
      }
    }
    for (const auto& [piece, left] : pieces) put_piece(runs[piece.run], piece, left, place, rest);
  }

  void put_piece(const MarkdownRun& run, const Part& piece, float left, const Place& place,
                 const Rect& line) {
    const Type type = type_of(run, place.types);
    const Rect rect{left, line.y, width_of(run, place, piece.text), line.h};
    const bool leads = !run.target.empty() && can_follow_(run.target);
    const FlowTone tone = leads                             ? FlowTone::Link
                          : run.is_code && place.marks_code ? FlowTone::Code
                                                            : place.tone;
    flowed_.words.push_back({rect, piece.text, type, tone});
    if (!leads) return;
    std::size_t& link = links_[piece.run];
    if (link == no_link) {
      link = flowed_.links.size();
      flowed_.links.push_back({run.target, run.text, {}});
    }
    flowed_.links[link].rects.push_back(rect);
  }

  const Ui& ui_;
  FlowedPage& flowed_;
  const CanFollow& can_follow_;
  /// Of each run of the paragraph: its link.
  std::vector<std::size_t> links_;
};

class PageFlow {
 public:
  PageFlow(const Ui& ui, float width, const FindPictureSize& size_of, const CanFollow& can_follow)
      : ui_(ui), width_(width), size_of_(size_of), words_(ui, flowed_, can_follow) {}

  FlowedPage flow(const MarkdownPage& page) {
    const MarkdownBlock* before = nullptr;
    for (const MarkdownBlock& block : page) {
      if (before != nullptr) y_ += gap_between(*before, block);
      const float top = y_;
      put(block);
      flowed_.blocks.push_back({0.0F, top, width_, y_ - top});
      before = &block;
    }
    flowed_.height = y_;
    return std::move(flowed_);
  }

 private:
  static float gap_between(const MarkdownBlock& before, const MarkdownBlock& block) {
    if (block.kind == MarkdownKind::Heading)
      return block.level <= 2 ? above_section : above_small_heading;
    if (before.kind == MarkdownKind::Heading) return below_heading;
    return !block.mark.empty() && before.depth > 0 ? between_items : between;
  }

  Rect room_of(const MarkdownBlock& block) const {
    const float left = indent * static_cast<float>(block.depth);
    return {left, y_, std::max(width_ - left, indent), 0.0F};
  }

  void put(const MarkdownBlock& block) {
    const Rect room = room_of(block);
    if (!block.mark.empty()) put_mark(block, room);
    switch (block.kind) {
      case MarkdownKind::Heading:
        y_ += words_.put(block.runs,
                         {room, of_heading(block.level), FlowTone::Text, Align::Left, false});
        return;
      case MarkdownKind::Paragraph:
        y_ += words_.put(block.runs, {room});
        return;
      case MarkdownKind::Code:
        return put_code(block, room);
      case MarkdownKind::Picture:
        return put_picture(block, room);
      case MarkdownKind::Table:
        return put_table(block, room);
      case MarkdownKind::Rule:
        flowed_.surfaces.push_back({{room.x, y_, room.w, 1.0F}, FlowShape::Line});
        y_ += 1.0F;
        return;
    }
  }

  // In the indent, right of its middle.
  void put_mark(const MarkdownBlock& block, const Rect& room) {
    const float width = ui_.width_of(Type::Body, block.mark);
    flowed_.words.push_back({{room.x - width - 8.0F, y_, width, line_of(ui_, Type::Body)},
                             block.mark,
                             Type::Body,
                             FlowTone::Caption});
  }

  void put_code(const MarkdownBlock& block, const Rect& room) {
    const float top = y_;
    const std::size_t surface = flowed_.surfaces.size();
    flowed_.surfaces.push_back({});
    y_ += code_edge;
    const std::string code = plain_text(block.runs);
    for (std::size_t at = 0; at < code.size();) {
      const std::size_t end = std::min(code.find('\n', at), code.size());
      const MarkdownRuns line{{code.substr(at, end - at)}};
      const float height =
          words_.put(line, {{room.x + code_edge, y_, room.w - 2.0F * code_edge, 0.0F},
                            all_of(Type::Small),
                            FlowTone::Text,
                            Align::Left,
                            false});
      y_ += std::max(height, line_of(ui_, Type::Small));
      at = end + 1;
    }
    y_ += code_edge;
    flowed_.surfaces[surface] = {{room.x, top, room.w, y_ - top}, FlowShape::Panel};
  }

  void put_picture(const MarkdownBlock& block, const Rect& room) {
    if (const std::optional<PixelSize> size = size_of_(block.source)) {
      y_ += picture_edge;
      const float share = static_cast<float>(size->height) / static_cast<float>(size->width);
      flowed_.pictures.push_back(
          {{room.x, y_, room.w, std::round(room.w * share)}, block.source, plain_text(block.runs)});
      y_ += flowed_.pictures.back().rect.h + caption_gap;
    }
    y_ += words_.put(block.runs,
                     {{room.x, y_, room.w, 0.0F}, all_of(Type::Small), FlowTone::Caption});
  }

  std::vector<float> column_widths(const MarkdownBlock& table, float width) {
    std::vector<float> whole(table.aligns.size(), 0.0F), least(table.aligns.size(), 0.0F);
    for (const std::vector<MarkdownRuns>& row : table.rows)
      for (std::size_t column = 0; column < std::min(row.size(), whole.size()); ++column) {
        const auto [line, word] = words_.widths(row[column], in_cell);
        whole[column] = std::max(whole[column], line + 2.0F * cell_across);
        least[column] = std::max(least[column], word + 2.0F * cell_across);
      }
    float wished = 0.0F, needed = 0.0F;
    for (std::size_t column = 0; column < whole.size(); ++column)
      wished += whole[column], needed += least[column];
    const float share = wished <= needed ? 1.0F : (width - needed) / (wished - needed);
    for (std::size_t column = 0; column < whole.size(); ++column)
      whole[column] = needed > width   ? least[column] * width / needed
                      : wished > width ? least[column] + share * (whole[column] - least[column])
                                       : whole[column];
    return whole;
  }

  void put_table(const MarkdownBlock& table, const Rect& room) {
    const std::vector<float> widths = column_widths(table, room.w);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      if (row > 0) flowed_.surfaces.push_back({{room.x, y_, room.w, 1.0F}, FlowShape::Line});
      float x = room.x, height = 0.0F;
      for (std::size_t column = 0; column < widths.size(); ++column) {
        if (column >= table.rows[row].size()) break;
        const Rect cell{x + cell_across, y_ + cell_down, widths[column] - 2.0F * cell_across, 0.0F};
        height = std::max(height, words_.put(table.rows[row][column],
                                             {cell, row == 0 ? in_head : in_cell,
                                              row == 0 ? FlowTone::Caption : FlowTone::Text,
                                              table.aligns[column]}));
        x += widths[column];
      }
      y_ += height + 2.0F * cell_down;
    }
  }

  const Ui& ui_;
  float width_;
  const FindPictureSize& size_of_;
  FlowedPage flowed_;
  WordFlow words_;
  float y_ = 0.0F;
};

}  // namespace

FlowedPage flow_page(const Ui& ui, const MarkdownPage& page, float width,
                     const FindPictureSize& size_of, const CanFollow& can_follow) {
  return PageFlow(ui, width, size_of, can_follow).flow(page);
}

}  // namespace hallux::ui
