// The page before an operation: picture, choice and words, beside each other or below. Heights come
// from the words, which are laid out anew in each frame; the height that was drawn last serves for
// the scrolling of the next. What was chosen for a practice means nothing for an assessment, and is
// kept for whoever changes their mind.
#include "ui/screens/trainee/briefing_screen.h"

#include <algorithm>
#include <array>

#include "ui/jobs/devices/device_sentences.h"
#include "ui/screens/parts/attempt_desks.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/trainee/briefing_text.h"
#include "ui/screens/trainee/briefing_tray.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float picture_share = 0.48F, stacked_picture = 300.0F, least_body = 420.0F;
constexpr float head_room = 84.0F, watch_gap = 14.0F, law_height = 38.0F;
constexpr float words_frame = 2.0F * space::card + tabs_height + 20.0F;  // of the card around them

std::array<std::string_view, 2> kind_labels(const Ui& ui) {
  return {ui.text("brief.practice"), ui.text("brief.assessment")};
}

constexpr std::array<simulator::Guidance, 3> guidances{
    simulator::Guidance::None, simulator::Guidance::Soft, simulator::Guidance::Slot};

std::array<std::string_view, 3> guidance_labels(const Ui& ui) {
  return {ui.text("brief.guide.none"), ui.text("brief.guide.soft"), ui.text("brief.guide.slot")};
}

bool is_arm(std::string_view device) noexcept {
  const simulator::KindFacts* kind = kind_of_device(device);
  return kind != nullptr && kind->device_class.starts_with("arm");
}

enum class BriefingTab : std::uint8_t { About, Steps, Tray, Scoring };

/// A saw alone needs no page of its own.
std::vector<BriefingTab> tabs_of(const scenarios::Scenario& scenario) {
  if (!has_tray(scenario)) return {BriefingTab::About, BriefingTab::Steps, BriefingTab::Scoring};
  return {BriefingTab::About, BriefingTab::Steps, BriefingTab::Tray, BriefingTab::Scoring};
}

std::vector<std::string_view> tab_labels(const Ui& ui, const scenarios::Scenario& scenario) {
  constexpr std::array ids{"brief.about", "brief.steps", "brief.tray", "brief.scoring"};
  std::vector<std::string_view> labels;
  for (const BriefingTab tab : tabs_of(scenario))
    labels.push_back(ui.text(ids[static_cast<std::size_t>(tab)]));
  return labels;
}

}  // namespace

void BriefingScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (read_.is_new()) {
    read_.start(
        ui, shell, ui.text("brief.reading"), [signed_in = signed_in_, id = scenario_](WorkReport&) {
          return signed_in->in_turn([&](database::Session& session, database::Database& database) {
            return Read{own_operation(session, database, id), is_in_assessment(session)};
          });
        });
  }
  if (read_.has_value()) return draw_briefing(ui, content, shell);
  Rect page = inset(content, page_margin(content));
  PageHead head{ui.text("brief.title")};
  head.has_back = true;
  if (page_head(ui, "brief", page, head).is_back_pressed) shell.pop();
  read_.draw_until_ready(ui, "brief.failed", page, 8);
}

void BriefingScreen::draw_briefing(Ui& ui, const Rect& content, Shell& shell) {
  has_arm_ = is_arm(shell.preferences().device);
  const float margin = page_margin(content), width = content.w - 2.0F * margin;
  const bool is_stacked = are_panes_stacked(width);
  const float start = start_height(ui, is_stacked ? width : width * picture_share);
  const float gap = space::between_cards;
  const float stacked = stacked_picture + gap + start + gap + words_frame + words_height_;
  const OwnOperation& own = this->operation();
  const std::string sentence =
      ui.texts().say("brief.sentence", {{"version", std::to_string(own.published.version)}});
  PageHead head = course_head(ui, *signed_in_, own.title(), sentence);
  head.has_back = true;
  const Page page(ui, "brief", head.title, content,
                  head_room + (is_stacked ? stacked : std::max(least_body, start + 200.0F)));
  Rect rest = page.rect();
  if (page_head(ui, "brief", rest, head).is_back_pressed) shell.pop();
  if (is_stacked) {
    draw_picture(ui, take_top(rest, stacked_picture, gap), shell);
    draw_start(ui, take_top(rest, start, gap));
    return draw_text_card(ui, rest, shell);
  }
  Rect left = take_left(rest, rest.w * picture_share, gap);
  const Rect below = take_bottom(left, start, gap);
  draw_picture(ui, left, shell);
  draw_start(ui, below);
  draw_text_card(ui, rest, shell);
}

// -- the picture

namespace {

/// A chip for what is said over the picture.
Rect draw_chip(Ui& ui, const Rect& chip) {
  ui.canvas().fill(chip, ui.theme().hud, 12.0F);
  return chip;
}

/// As on the cards to choose from.
void draw_mark(Ui& ui, Point left_top, std::string_view mark) {
  const Rect chip = draw_chip(
      ui, {left_top.x, left_top.y, ui.width_of(Type::CaptionMedium, mark) + 40.0F, 24.0F});
  draw_meaning(ui.canvas(), ui.theme(), Meaning::Warn, {chip.x + 15.0F, chip.mid_y()}, 5.5F);
  ui.canvas().text({chip.x + 28.0F, chip.mid_y()}, {Type::CaptionMedium, ui.theme().text}, mark);
}

/// How to turn the bone, in as many lines as it needs.
void draw_hint(Ui& ui, const Rect& picture) {
  const std::string_view hint = ui.text("brief.picture.hint");
  const float width = std::min(ui.width_of(Type::Caption, hint) + 26.0F, picture.w - 24.0F);
  const float words = ui.paragraph_height(Type::Caption, hint, width - 24.0F);
  const float height = words + 6.0F;
  const Rect chip =
      draw_chip(ui, {picture.x + 12.0F, picture.bottom() - 12.0F - height, width, height});
  ui.canvas().paragraph({chip.x + 12.0F, chip.y + 3.0F, chip.w - 24.0F, words},
                        {Type::Caption, ui.theme().text_secondary}, hint);
}

}  // namespace

void BriefingScreen::draw_picture(Ui& ui, const Rect& rect, Shell& shell) {
  const Theme& theme = ui.theme();
  const scenarios::Scenario& scenario = *operation().scenario;
  draw_card(ui.canvas(), theme, rect, radius::picture);
  if (const PatientView* view = pictures_.find(shell, scenario)) {
    if (!stage_.has_view()) {
      const Camera camera = camera_of(*view, PatientPicture::Whole, 1.0);
      stage_.look_at(camera.target_mm, radius_of(*view, PatientPicture::Whole),
                     camera.world_from_view);
      if (!view->faces.empty()) stage_.set_blade(view->faces.front().world_from_plane);
    }
    stage_.draw(
        ui, shell, rect, scene_of(*view, PatientPicture::Whole, ground_of(theme)),
        {"brief.picture", ui.text("brief.picture"), theme.is_dark() ? 1U : 2U, radius::picture});
    draw_hint(ui, rect);
  } else {
    ui.canvas().fill(rect, theme.raise, radius::picture);
    ui.canvas().paragraph(inset(rect, space::card, 52.0F), {Type::Small, theme.text_caption},
                          pictures_.fault(scenario));
  }
  ui.canvas().outline(rect, theme.line, radius::picture);
  if (!operation().published.is_reviewed) {
    draw_mark(ui, {rect.x + 12.0F, rect.y + 12.0F}, ui.text("course.not_reviewed"));
  }
}

// -- the beginning

std::string BriefingScreen::choice_text(const Ui& ui) const {
  if (kind_ != 0) {
    std::string means(ui.text("brief.assessment.means"));
    const auto& allowance = operation().published.allowance;
    if (!allowance) return means;
    const TextValues about{{"max", std::to_string(allowance->attempts_max)},
                           {"cohort", allowance->cohort_name}};
    return means + " " +
           (allowance->left() > 0 ? ui.texts().say_count("brief.left", allowance->left(), about)
                                  : ui.texts().say("brief.none_left", about));
  }
  constexpr std::array means{"brief.guide.none.means", "brief.guide.soft.means",
                             "brief.guide.slot.means"};
  return std::string(ui.text("brief.practice.means")) + " " +
         std::string(ui.text(means[static_cast<std::size_t>(guidance_)]));
}

bool BriefingScreen::may_begin() const {
  const auto& allowance = operation().published.allowance;
  return kind_ == 0 || !allowance || allowance->left() > 0;
}

float BriefingScreen::start_height(const Ui& ui, float width) const {
  const float words =
      ui.paragraph_height(Type::Small, choice_text(ui), width - 2.0F * space::side_card);
  const float choices = (kind_ == 0 ? 2.0F : 1.0F) * (segmented_height + 14.0F) +
                        (kind_ == 0 && has_arm_ ? law_height : 0.0F);
  return space::side_card + choices + std::max(40.0F, words) + 14.0F + button_height +
         watch_height(ui, width - 2.0F * space::side_card) + space::side_card;
}

void BriefingScreen::draw_start(Ui& ui, const Rect& rect) {
  Rect inside = card(ui, rect, {}, space::side_card);
  segmented(ui, "brief.kind", take_top(inside, segmented_height, 14.0F), kind_labels(ui), kind_);
  if (kind_ == 0) {
    segmented(ui, "brief.guide", take_top(inside, segmented_height, 14.0F), guidance_labels(ui),
              guidance_);
  }
  if (kind_ == 0 && has_arm_) {
    toggle(ui, "brief.law", inset(take_top(inside, law_height), 0.0F, 7.0F), ui.text("brief.law"),
           feels_historic_law_);
  }
  const Rect watch = take_bottom(inside, watch_height(ui, inside.w));
  const Rect foot = take_bottom(inside, button_height, 14.0F);
  ui.canvas().paragraph(inside, {Type::Small, ui.theme().text_secondary}, choice_text(ui));
  const ButtonSpec begin{ui.text(kind_ == 0 ? "brief.begin.practice" : "brief.begin.assessment"),
                         ButtonLook::Primary, Icon::None,
                         may_begin() ? std::string_view() : ui.text("brief.begin.none_left")};
  const float width = std::min(foot.w, std::max(160.0F, button_width(ui, begin)));
  if (button(ui, "brief.begin", {foot.x, foot.y, width, foot.h}, begin)) {
    // What was chosen for a practice means nothing for an assessment.
    const bool is_practice = kind_ == 0;
    navigator_.operate(scenario_, is_practice
                                      ? WayToOperate{database::AttemptKind::Practice,
                                                     guidances[static_cast<std::size_t>(guidance_)],
                                                     has_arm_ && feels_historic_law_}
                                      : WayToOperate{database::AttemptKind::Assessment});
  }
  draw_watch(ui, watch);
}

float BriefingScreen::watch_height(const Ui& ui, float width) const {
  return watch_gap + 1.0F + watch_gap + button_height + 8.0F +
         ui.paragraph_height(Type::Small, ui.text("brief.watch.means"), width);
}

void BriefingScreen::draw_watch(Ui& ui, const Rect& rect) {
  Rect rest = rect;
  ui.canvas().hairline_across(rest.x, rest.y + watch_gap, rest.w, ui.theme().line);
  take_top(rest, watch_gap + 1.0F + watch_gap);
  ButtonSpec watch{ui.text("brief.watch"), ButtonLook::Secondary, Icon::Eye};
  if (read_.value().is_in_assessment) watch.why_off = ui.text("brief.watch.assessed");
  if (button_in_line(ui, "brief.watch", take_top(rest, button_height, 8.0F), watch))
    navigator_.watch_expert(*operation().scenario);
  ui.canvas().paragraph(rest, {Type::Small, ui.theme().text_caption}, ui.text("brief.watch.means"));
}

// -- the words

float BriefingScreen::draw_text(Ui& ui, const Rect& rect, Shell& shell) {
  const scenarios::Scenario& scenario = *operation().scenario;
  const BriefingTab tab = tabs_of(scenario)[static_cast<std::size_t>(tab_)];
  if (tab == BriefingTab::Scoring) return draw_scoring(ui, rect, scenario);
  if (tab == BriefingTab::Tray) return draw_tray(ui, rect, scenario);
  const PatientView* view = pictures_.find(shell, scenario);
  const std::span<const PassesInView> passes =
      view == nullptr ? std::span<const PassesInView>() : view->passes;
  if (tab == BriefingTab::Steps) return draw_steps(ui, rect, scenario, passes);
  return draw_about(ui, rect, scenario, passes);
}

void BriefingScreen::draw_text_card(Ui& ui, const Rect& rect, Shell& shell) {
  Rect inside = card(ui, rect, {});
  inside.y -= 8.0F;
  inside.h += 8.0F;
  const std::vector<std::string_view> labels = tab_labels(ui, *operation().scenario);
  tabs(ui, "brief.tab", take_top(inside, tabs_height, 16.0F), labels, tab_);
  const Rect view = inset(inside, -8.0F, 0.0F);
  const float scrolled = ui.begin_scroll("brief.words", labels[static_cast<std::size_t>(tab_)],
                                         view, words_height_ + 8.0F);
  const Rect words{inside.x, inside.y + 4.0F - scrolled, inside.w - 8.0F, inside.h};
  const float height = draw_text(ui, words, shell);
  ui.end_scroll();
  if (height != words_height_) ui.want_frame_in_s(0.0);
  words_height_ = height;
}

}  // namespace hallux::ui
