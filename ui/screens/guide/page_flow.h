/// Where the words, lines and pictures of a page of Markdown stand at a width.
/// Inside this corner only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/render/picture.h"
#include "ui/screens/guide/markdown.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

enum class FlowTone : std::uint8_t { Text, Caption, Code, Link };

/// The ground of code goes so far beyond its words at each side.
inline constexpr float code_ground_edge = 4.0F;

/// Words of one look on one line; of code with its ground.
struct FlowWords {
  Rect rect;
  std::string text;
  Type type = Type::Body;
  FlowTone tone = FlowTone::Text;
};

enum class FlowShape : std::uint8_t {
  /// Behind code.
  Panel,
  /// Between two rows, and for a rule.
  Line,
};

struct FlowSurface {
  Rect rect;
  FlowShape shape = FlowShape::Panel;
};

/// Words that lead somewhere, line by line.
struct FlowLink {
  std::string target, label;
  std::vector<Rect> rects;
};

struct FlowPicture {
  Rect rect;
  std::string source, label;
};

/// All places are logical pixels from the page's top left corner.
struct FlowedPage {
  float height = 0.0F;
  std::vector<FlowWords> words;
  std::vector<FlowSurface> surfaces;
  std::vector<FlowLink> links;
  std::vector<FlowPicture> pictures;
  /// Of each block of the page.
  std::vector<Rect> blocks;
};

/// The pixels of a picture by its source; nothing where it is not to be had: its words then stand
/// alone.
using FindPictureSize = std::function<std::optional<PixelSize>(std::string_view source)>;
/// Whether a link leads somewhere; else it is text.
using CanFollow = std::function<bool(std::string_view target)>;

FlowedPage flow_page(const Ui& ui, const MarkdownPage& page, float width,
                     const FindPictureSize& size_of, const CanFollow& can_follow);

}  // namespace hallux::ui
