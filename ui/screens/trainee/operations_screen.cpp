// Operations as cards, the next thing to do above them. What is next is decided by a rule of two
// lines that a person can check: the easiest one not mastered, else the one done longest ago. Cards
// take their size from the page; the page scrolls where they do not fit. Pictures come when they
// are ready.
#include "ui/screens/trainee/operations_screen.h"

#include <algorithm>
#include <array>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/standing.h"
#include "ui/screens/trainee/next_strip.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/picture_card.h"

namespace hallux::ui {

namespace {

constexpr float search_width = 190.0F, control_gap = 16.0F, next_height = 72.0F;
constexpr float most_picture_height = 400.0F, least_cards = 240.0F, head_room = 100.0F;
constexpr std::array segment_texts{"operations.all", "operations.not_started",
                                   "operations.learning", "operations.competent"};

std::array<std::string_view, segment_texts.size()> segment_labels(const Ui& ui) {
  std::array<std::string_view, segment_texts.size()> labels;
  std::transform(segment_texts.begin(), segment_texts.end(), labels.begin(),
                 [&](const char* id) { return ui.text(id); });
  return labels;
}

/// What has been begun and is not done yet counts as learning.
bool is_in_segment(Competence competence, int segment) {
  if (segment == 0) return true;
  if (segment == 1) return competence == Competence::NotStarted;
  const bool is_competent = competence == Competence::Competent;
  return segment == 3 ? is_competent : !is_competent && competence != Competence::NotStarted;
}

std::string what_text(const Texts& texts, const OwnOperation& operation) {
  if (!operation.scenario) return std::string(texts.text("operations.unreadable"));
  return texts.say_count("operations.what", static_cast<long>(operation.scenario->cuts.size()),
                         {{"bone", file_name_text(operation.scenario->patient.bone)}});
}

}  // namespace

Competence competence_of(const OwnOperation& operation, std::string_view now_utc) {
  return competence_of(operation.published.standing, operation.learning, now_utc);
}

std::string standing_text(const Texts& texts, const OwnOperation& operation,
                          std::string_view now_utc) {
  const database::OperationStanding& standing = operation.published.standing;
  const Competence competence = competence_of(operation, now_utc);
  if (competence == Competence::Competent)
    return std::string(texts.text("operations.state.competent"));
  if (competence == Competence::Slipped) return std::string(texts.text("operations.state.slipped"));
  if (competence == Competence::NotStarted)
    return std::string(texts.text("operations.state.not_started"));
  if (competence == Competence::Stale)
    return texts.say("operations.state.stale",
                     {{"when", ago_text(texts, standing.last_started_utc, now_utc)}});
  if (operation.learning.evidence_by_run.empty()) {
    return texts.say_count("operations.state.tried", standing.attempts);
  }
  return texts.say("operations.state.learning",
                   {{"runs", std::to_string(operation.learning.clean_runs())},
                    {"needed", std::to_string(assessment::clean_runs_needed())}});
}

const OwnOperation* next_operation(const std::vector<OwnOperation>& operations,
                                   std::string_view now_utc) {
  const OwnOperation* oldest = nullptr;
  for (const OwnOperation& operation : operations) {
    if (!operation.scenario) continue;
    if (competence_of(operation, now_utc) != Competence::Competent) return &operation;
    const std::string& when = operation.published.standing.last_started_utc;
    if (oldest == nullptr || when < oldest->published.standing.last_started_utc) {
      oldest = &operation;
    }
  }
  return oldest;
}

bool is_flight_offered(const std::vector<OwnOperation>& operations, const Preferences& preferences,
                       database::PersonId person) {
  const bool has_tried = std::ranges::any_of(operations, [](const OwnOperation& operation) {
    return operation.published.standing.attempts > 0;
  });
  return !has_tried && !std::ranges::binary_search(preferences.offered_flight, person.number);
}

void keep_flight_answer(Preferences& preferences, database::PersonId person) {
  std::vector<std::int64_t>& numbers = preferences.offered_flight;
  const auto place = std::ranges::lower_bound(numbers, person.number);
  if (place == numbers.end() || *place != person.number) numbers.insert(place, person.number);
}

std::vector<const OwnOperation*> OperationsScreen::shown() const {
  std::vector<const OwnOperation*> found;
  for (const OwnOperation& operation : operations_.value()) {
    if (contains_text(operation.title() + " " + operation.published.name, search_) &&
        is_in_segment(competence_of(operation, now_utc_), segment_)) {
      found.push_back(&operation);
    }
  }
  return found;
}

OperationsScreen::Grid OperationsScreen::grid_of(float width) const {
  constexpr float gap = space::between_cards;
  const int fitting = std::max(1, static_cast<int>((width + gap) / (picture_card_width + gap)));
  const int wanted = std::clamp(static_cast<int>(operations_.value().size()), 2, 4);
  Grid grid;
  grid.across = std::min(fitting, wanted);
  grid.card_width = columns({0.0F, 0.0F, width, 0.0F}, grid.across, gap).front().w;
  const float picture = grid.card_width * picture_height / picture_card_width;
  grid.card_height = picture_card_height - picture_height + std::min(most_picture_height, picture);
  const int rows = (static_cast<int>(shown().size()) + grid.across - 1) / grid.across;
  grid.height = std::max(least_cards, static_cast<float>(rows) * (grid.card_height + gap) - gap);
  return grid;
}

void OperationsScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (operations_.is_new()) {
    operations_.start(
        ui, shell, ui.text("operations.reading"), [signed_in = signed_in_](WorkReport&) {
          return signed_in->in_turn([](database::Session& session, database::Database& database) {
            return own_operations(session, database);
          });
        });
  }
  now_utc_ = utc_now_text();
  PageHead head =
      course_head(ui, *signed_in_, ui.text("operations.title"), ui.text("operations.sentence"));
  head.buttons_width = segmented_width(ui, segment_labels(ui)) + control_gap + search_width;
  const float width = content.w - 2.0F * page_margin(content);
  const float cards = has_operations() ? grid_of(width).height : least_cards;
  const Page page(ui, "operations", head.title, content,
                  head_room + next_height + space::between_cards + cards);
  Rect rest = page.rect();
  draw_controls(ui, page_head(ui, "operations", rest, head).buttons);
  if (operations_.draw_until_ready(ui, "operations.failed", rest, 8)) {
    draw_operations(ui, rest, shell);
  }
}

// Where the window is too narrow for both, the search goes.
void OperationsScreen::draw_controls(Ui& ui, const Rect& controls) {
  const auto labels = segment_labels(ui);
  Rect rest = controls;
  const float width = std::min(segmented_width(ui, labels), rest.w);
  segmented(ui, "operations.filter", take_left(rest, width, control_gap), labels, segment_);
  if (rest.w < 120.0F) return;
  search_field(ui, "operations.search", rest, search_, ui.text("operations.search"));
}

void OperationsScreen::show_all(Ui& ui) {
  segment_ = 0;
  search_.clear();
  ui.want_frame_in_s(0.0);
}

void OperationsScreen::draw_operations(Ui& ui, Rect page, Shell& shell) {
  draw_next(ui, take_top(page, next_height, space::between_cards), shell);
  if (operations_.value().empty()) {
    empty_card(ui, "operations.none", page,
               {Icon::Operations, ui.text("operations.none"), ui.text("operations.none.sentence")});
    return;
  }
  if (!shown().empty()) return draw_cards(ui, page, shell);
  const EmptyCard nothing{Icon::Search, ui.text("operations.no_match"),
                          ui.text("operations.no_match.sentence"), ui.text("operations.show_all")};
  if (empty_card(ui, "operations.no_match", page, nothing)) show_all(ui);
}

namespace {

/// Why this one is next, in the order of Competence.
constexpr std::array reasons_for_next{"operations.next.not_started", "operations.next.learning",
                                      "operations.next.competent", "operations.next.slipped",
                                      "operations.next.stale"};

}  // namespace

void OperationsScreen::draw_next(Ui& ui, const Rect& strip, Shell& shell) {
  const database::PersonId person = signed_in_->person().id;
  if (is_flight_offered(operations_.value(), shell.preferences(), person)) {
    const NextAnswer answer = draw_next_strip(
        ui, strip,
        {Icon::Play, std::string(ui.text("flight.offer")), ui.text("flight.offer.sentence"),
         "flight.offer.fly", ui.text("flight.offer.fly"), "flight.offer.not_now",
         ui.text("flight.offer.not_now")});
    if (answer == NextAnswer::Waiting) return;
    keep_flight_answer(shell.preferences(), person);
    if (answer == NextAnswer::Go) navigator_.fly();
    return ui.want_frame_in_s(0.0);
  }
  const OwnOperation* const next = next_operation(operations_.value(), now_utc_);
  if (next != nullptr) return draw_next_operation(ui, strip, *next);
  const NextStrip flight{Icon::Play,
                         std::string(ui.text("flight.offer")),
                         ui.text("flight.offer.sentence"),
                         "operations.fly",
                         ui.text("flight.offer.fly"),
                         {},
                         {},
                         false};
  if (draw_next_strip(ui, strip, flight) == NextAnswer::Go) navigator_.fly();
}

void OperationsScreen::draw_next_operation(Ui& ui, const Rect& strip, const OwnOperation& next) {
  const auto competence = static_cast<std::size_t>(competence_of(next, now_utc_));
  const NextAnswer answer = draw_next_strip(
      ui, strip,
      {Icon::Drill, ui.texts().say("operations.next", {{"operation", next.title()}}),
       ui.text(reasons_for_next[competence]), "operations.start", ui.text("operations.start"),
       "operations.fly", ui.text("flight.title")});
  if (answer == NextAnswer::Go) navigator_.brief(next.published.scenario);
  if (answer == NextAnswer::Aside) navigator_.fly();
}

void OperationsScreen::draw_cards(Ui& ui, const Rect& page, Shell& shell) {
  const std::vector<const OwnOperation*> cards = shown();
  const Grid grid = grid_of(page.w);
  for (std::size_t number = 0; number < cards.size(); ++number) {
    const int place = static_cast<int>(number);
    const int column = place % grid.across, row = place / grid.across;
    const Rect rect{page.x + static_cast<float>(column) * (grid.card_width + space::between_cards),
                    page.y + static_cast<float>(row) * (grid.card_height + space::between_cards),
                    grid.card_width, grid.card_height};
    if (draw_card(ui, rect, *cards[number], shell)) {
      navigator_.brief(cards[number]->published.scenario);
    }
  }
}

namespace {

/// What a card says beside its picture; the words are kept by whoever calls.
void say_difficulty(const Ui& ui, const OwnOperation& operation, PictureCardSpec& spec) {
  constexpr std::array words{"operations.gentle", "operations.easy", "operations.moderate",
                             "operations.hard", "operations.expert"};
  spec.difficulty = operation.scenario ? difficulty_of(*operation.scenario) : 0;
  if (spec.difficulty > 0) {
    spec.difficulty_word = ui.text(words[static_cast<std::size_t>(spec.difficulty - 1)]);
  }
}

}  // namespace

Picture OperationsScreen::picture_of(Ui& ui, const Rect& card, const OwnOperation& operation,
                                     Shell& shell) {
  const PatientView* view =
      operation.scenario ? pictures_.find(shell, *operation.scenario) : nullptr;
  if (view == nullptr) return {};
  const Rect rect{0.0F, 0.0F, card.w, card.h - (picture_card_height - picture_height)};
  const std::string name =
      "operations." + operation.published.name + "." + std::string(ground_word(ui.theme()));
  return still_picture(
      ui, shell, name, rect, scene_of(*view, PatientPicture::Card, ground_of(ui.theme())),
      camera_of(*view, PatientPicture::Card, static_cast<double>(rect.w / rect.h)));
}

std::string OperationsScreen::picture_note(const Ui& ui, const OwnOperation& operation) const {
  if (!operation.scenario) return std::string(ui.text("operations.picture.none"));
  const std::string fault = pictures_.fault(*operation.scenario);
  if (fault.empty()) return std::string(ui.text("operations.picture.coming"));
  return ui.texts().say("operations.picture.failed", {{"reason", fault}});
}

bool OperationsScreen::draw_card(Ui& ui, const Rect& rect, const OwnOperation& operation,
                                 Shell& shell) {
  const std::string what = what_text(ui.texts(), operation);
  std::string state = standing_text(ui.texts(), operation, now_utc_);
  if (const auto& allowance = operation.published.allowance)
    state = ui.texts().say("operations.left", {{"state", state},
                                               {"left", std::to_string(allowance->left())},
                                               {"max", std::to_string(allowance->attempts_max)}});
  const std::optional<std::int64_t> best_milli = operation.published.standing.best_milli;
  const std::string best = best_milli ? points_text(*best_milli) : std::string();
  PictureCardSpec spec{
      .name = operation.title(), .what = what, .picture = picture_of(ui, rect, operation, shell)};
  const std::string note = picture_note(ui, operation);
  spec.picture_note = note;
  say_difficulty(ui, operation, spec);
  spec.competence = competence_of(operation, now_utc_);
  spec.progress = progress_of(operation.published.standing, operation.learning);
  spec.state = state;
  spec.best_word = ui.text("operations.best");
  spec.best = best;
  spec.group = "operations.cards";
  if (!operation.published.is_reviewed) spec.mark = ui.text("course.not_reviewed");
  const bool is_pressed =
      picture_card(ui, "operations.card." + operation.published.name, rect, spec);
  return is_pressed && operation.scenario.has_value();
}

}  // namespace hallux::ui
