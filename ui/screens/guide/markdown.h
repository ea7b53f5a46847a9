/// A page of Markdown as plain data: what a reader sees of it, from top to bottom.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/canvas.h"

namespace hallux::ui {

/// Words of one look.
struct MarkdownRun {
  std::string text;
  bool is_strong = false, is_emphasised = false, is_code = false;
  /// Where it leads, as it is written: "trainee.md#watch-it-again"; "" nowhere.
  std::string target = {};

  bool looks_like(const MarkdownRun& other) const noexcept {
    return is_strong == other.is_strong && is_emphasised == other.is_emphasised &&
           is_code == other.is_code && target == other.target;
  }
};
using MarkdownRuns = std::vector<MarkdownRun>;

enum class MarkdownKind : std::uint8_t { Heading, Paragraph, Code, Picture, Table, Rule };

struct MarkdownBlock {
  MarkdownKind kind = MarkdownKind::Paragraph;
  /// Of a heading: 1-6.
  int level = 0;
  /// Of a heading, as links name it: "watch-it-again".
  std::string anchor = {};
  /// How many lists and quotations it lies in.
  int depth = 0;
  /// Of the first block of a list's item: "•" or "3.".
  std::string mark = {};
  /// Words; of a picture what it shows; of code its lines, with a newline behind each.
  MarkdownRuns runs = {};
  /// Of a picture: its file, as it is written.
  std::string source = {};
  /// Of a table; the first row is its head.
  std::vector<std::vector<MarkdownRuns>> rows = {};
  std::vector<Align> aligns = {};
};
using MarkdownPage = std::vector<MarkdownBlock>;

/// Reads CommonMark with tables. What the page has and this does not know is shown as its text.
MarkdownPage read_markdown(std::string_view text);

/// The words alone.
std::string plain_text(const MarkdownRuns& runs);
/// Of a block with all that stands in it, a table's cells too.
std::string plain_text(const MarkdownBlock& block);

/// A heading as links name it: small letters, hyphens for spaces, no signs.
std::string anchor_of(std::string_view heading);

}  // namespace hallux::ui
