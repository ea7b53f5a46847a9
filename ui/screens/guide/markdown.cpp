// Markdown is read by cmark-gfm; its tree becomes a list of blocks that know how deep they lie.
//
//     - a            item, paragraph      Paragraph  depth 1  mark "•"
//       - b          item, paragraph      Paragraph  depth 2  mark "•"
//
// A picture that stands in a paragraph by itself is a block; among words it is the words that it
// shows. A node that is not known gives what stands in it, or its own text: nothing vanishes.
#include "ui/screens/guide/markdown.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>

#include <map>
#include <memory>
#include <utility>

namespace hallux::ui {

namespace {

constexpr std::string_view bullet = "\xE2\x80\xA2";

struct FreeParser {
  void operator()(cmark_parser* parser) const noexcept { cmark_parser_free(parser); }
};
struct FreeNode {
  void operator()(cmark_node* node) const noexcept { cmark_node_free(node); }
};

std::string text_of(const char* text) { return text == nullptr ? std::string() : text; }

void add_run(MarkdownRuns& runs, std::string_view text, const MarkdownRun& look) {
  if (text.empty()) return;
  if (!runs.empty() && runs.back().looks_like(look)) {
    runs.back().text += text;
    return;
  }
  runs.push_back(look);
  runs.back().text = text;
}

// The words below `node`, each with the look of all that it stands in.
void read_inlines(cmark_node* node, const MarkdownRun& look, MarkdownRuns& runs) {
  for (cmark_node* each = cmark_node_first_child(node); each != nullptr;
       each = cmark_node_next(each)) {
    const cmark_node_type type = cmark_node_get_type(each);
    MarkdownRun inner = look;
    inner.is_strong |= type == CMARK_NODE_STRONG;
    inner.is_emphasised |= type == CMARK_NODE_EMPH;
    inner.is_code |= type == CMARK_NODE_CODE;
    if (type == CMARK_NODE_LINK) inner.target = text_of(cmark_node_get_url(each));
    if (type == CMARK_NODE_SOFTBREAK) {
      add_run(runs, " ", look);
    } else if (type == CMARK_NODE_LINEBREAK) {
      add_run(runs, "\n", look);
    } else if (cmark_node_first_child(each) != nullptr) {
      read_inlines(each, inner, runs);
    } else {
      add_run(runs, text_of(cmark_node_get_literal(each)), inner);
    }
  }
}

MarkdownRuns inlines_of(cmark_node* node) {
  MarkdownRuns runs;
  read_inlines(node, {}, runs);
  return runs;
}

// Pictures with nothing but space between them.
bool holds_pictures_only(cmark_node* paragraph) {
  for (cmark_node* each = cmark_node_first_child(paragraph); each != nullptr;
       each = cmark_node_next(each)) {
    const cmark_node_type type = cmark_node_get_type(each);
    if (type != CMARK_NODE_IMAGE && type != CMARK_NODE_SOFTBREAK) return false;
  }
  return cmark_node_first_child(paragraph) != nullptr;
}

class PageReader {
 public:
  MarkdownPage read(cmark_node* document) {
    read_children(document);
    return std::move(page_);
  }

 private:
  void read_children(cmark_node* node) {
    for (cmark_node* each = cmark_node_first_child(node); each != nullptr;
         each = cmark_node_next(each))
      read_block(each);
  }

  MarkdownBlock& add(MarkdownKind kind) {
    MarkdownBlock& block = page_.emplace_back();
    block.kind = kind;
    block.depth = depth_;
    block.mark = std::exchange(mark_, {});
    return block;
  }

  void read_block(cmark_node* node) {
    const cmark_node_type type = cmark_node_get_type(node);
    if (type == CMARK_NODE_HEADING) return read_heading(node);
    if (type == CMARK_NODE_PARAGRAPH) return read_paragraph(node);
    if (type == CMARK_NODE_LIST) return read_list(node);
    if (cmark_gfm_extensions_get_table_columns(node) > 0) return read_table(node);
    if (type == CMARK_NODE_THEMATIC_BREAK) {
      add(MarkdownKind::Rule);
    } else if (cmark_node_first_child(node) != nullptr) {
      ++depth_;
      read_children(node);
      --depth_;
    } else {
      add(MarkdownKind::Code).runs = {{text_of(cmark_node_get_literal(node)), false, false, true}};
    }
  }

  void read_heading(cmark_node* node) {
    MarkdownBlock& block = add(MarkdownKind::Heading);
    block.level = cmark_node_get_heading_level(node);
    block.runs = inlines_of(node);
    block.anchor = anchor_of(plain_text(block.runs));
    // The second of a name has its number behind it.
    const int same = anchors_[block.anchor]++;
    if (same > 0) block.anchor += "-" + std::to_string(same);
  }

  void read_paragraph(cmark_node* node) {
    if (!holds_pictures_only(node)) {
      add(MarkdownKind::Paragraph).runs = inlines_of(node);
      return;
    }
    for (cmark_node* each = cmark_node_first_child(node); each != nullptr;
         each = cmark_node_next(each)) {
      if (cmark_node_get_type(each) != CMARK_NODE_IMAGE) continue;
      MarkdownBlock& block = add(MarkdownKind::Picture);
      block.source = text_of(cmark_node_get_url(each));
      block.runs = inlines_of(each);
    }
  }

  void read_list(cmark_node* list) {
    const bool is_numbered = cmark_node_get_list_type(list) == CMARK_ORDERED_LIST;
    int number = cmark_node_get_list_start(list);
    ++depth_;
    for (cmark_node* item = cmark_node_first_child(list); item != nullptr;
         item = cmark_node_next(item)) {
      mark_ = is_numbered ? std::to_string(number++) + "." : std::string(bullet);
      read_children(item);
      // An item without anything in it.
      if (!mark_.empty()) add(MarkdownKind::Paragraph);
    }
    --depth_;
  }

  void read_table(cmark_node* table) {
    MarkdownBlock& block = add(MarkdownKind::Table);
    const std::uint8_t* aligns = cmark_gfm_extensions_get_table_alignments(table);
    for (int column = 0; column < cmark_gfm_extensions_get_table_columns(table); ++column)
      block.aligns.push_back(aligns[column] == 'r'   ? Align::Right
                             : aligns[column] == 'c' ? Align::Centre
                                                     : Align::Left);
    for (cmark_node* row = cmark_node_first_child(table); row != nullptr;
         row = cmark_node_next(row)) {
      std::vector<MarkdownRuns>& cells = block.rows.emplace_back();
      for (cmark_node* cell = cmark_node_first_child(row); cell != nullptr;
           cell = cmark_node_next(cell))
        cells.push_back(inlines_of(cell));
    }
  }

  MarkdownPage page_;
  int depth_ = 0;
  /// Of the item whose first block comes next.
  std::string mark_;
  std::map<std::string, int> anchors_;
};

}  // namespace

MarkdownPage read_markdown(std::string_view text) {
  cmark_gfm_core_extensions_ensure_registered();
  const std::unique_ptr<cmark_parser, FreeParser> parser(cmark_parser_new(CMARK_OPT_DEFAULT));
  cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension("table"));
  cmark_parser_feed(parser.get(), text.data(), text.size());
  const std::unique_ptr<cmark_node, FreeNode> document(cmark_parser_finish(parser.get()));
  return PageReader().read(document.get());
}

std::string plain_text(const MarkdownRuns& runs) {
  std::string text;
  for (const MarkdownRun& run : runs) text += run.text;
  return text;
}

std::string plain_text(const MarkdownBlock& block) {
  std::string text = plain_text(block.runs);
  for (const std::vector<MarkdownRuns>& row : block.rows)
    for (const MarkdownRuns& cell : row) text += (text.empty() ? "" : " ") + plain_text(cell);
  return text;
}

std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char letter : heading) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == ' ' || letter == '-') anchor += '-';
    if (letter >= 'A' && letter <= 'Z') anchor += static_cast<char>(letter - 'A' + 'a');
    const bool stays = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
                       letter == '_' || byte >= 0x80;
    if (stays) anchor += letter;
  }
  return anchor;
}

}  // namespace hallux::ui
