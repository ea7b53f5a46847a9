/// The guide in the window: a page with its pictures, the contents beside it, links and search.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/guide/guide_pictures.h"
#include "ui/screens/guide/guides.h"
#include "ui/screens/guide/page_flow.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class GuideScreen : public Screen {
 public:
  explicit GuideScreen(GuideSection section);

  GuideSection guide_section() const override { return section_; }
  WindowChrome surround() const override { return WindowChrome::Nothing; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  /// What a flowed page was made for.
  struct FlowedFor {
    std::size_t page = 0;
    float width = 0.0F, scale = 0.0F;

    bool operator==(const FlowedFor&) const = default;
  };
  /// What was asked for and what came of it.
  struct Search {
    std::string words;
    std::vector<GuideHit> hits;
  };
  /// Where the reader is, and was.
  struct Reading {
    GuidePlace place;
    std::vector<GuidePlace> earlier;
    /// The page is to be scrolled there.
    bool is_to_come = true;
    /// How far it was scrolled when it had come; below 0: not known yet.
    float came_at = -1.0F;
    /// A block that is lit: what was found.
    std::optional<GuidePlace> lit;
  };

  const GuidePage& page() const { return guides_.pages()[reading_.place.page]; }
  void go_to(GuidePlace place);
  void go_back();
  void come_to(GuidePlace place);
  void close_uppermost(Shell& shell);
  void show_found(Ui& ui, GuidePlace place, bool is_beside);
  void flow(const Ui& ui, float width);
  void draw_head(Ui& ui, Rect head, bool has_list_button, Shell& shell);
  void draw_list(Ui& ui, const Rect& rect, bool is_beside);
  void draw_page(Ui& ui, const Rect& view, Shell& shell);
  void draw_blocks(Ui& ui, Point at, const Rect& view, Shell& shell);
  void draw_words(Ui& ui, Point at, const Rect& view) const;
  void draw_links(Ui& ui, Point at);
  void note_place(float scrolled, bool is_at_end);
  /// The heading that a block stands under, of those that the contents list.
  std::size_t heading_above(std::size_t block) const;
  void hear_keys(Ui& ui, const Rect& view, Shell& shell);

  GuideSection section_;
  Guides guides_;
  Reading reading_;
  Search search_;
  FlowedPage flowed_;
  std::optional<FlowedFor> flowed_for_;
  GuidePictures pictures_;
  /// In a narrow window, in place of the page.
  bool is_list_shown_ = false;
};

}  // namespace hallux::ui
