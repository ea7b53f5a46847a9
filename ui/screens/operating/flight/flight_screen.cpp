// The window, the saw and the hand are those of an operation (operating_field.h); the lessons look
// on. A block that was spoilt is exchanged for an uncut one with a loop of its own.
#include "ui/screens/operating/flight/flight_screen.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ui/screens/operating/flight/flight_cards.h"
#include "ui/screens/operating/flight/flight_work.h"
#include "ui/screens/operating/operating_cards.h"
#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/card.h"

namespace hallux::ui {

namespace {

using Phase = OperatingSession::Phase;

/// Ids of texts, in the order of Lesson.
constexpr std::array<std::string_view, lesson_count> tasks{
    "flight.look.task",     "flight.approach.task", "flight.start.task",   "flight.stroke.task",
    "flight.withdraw.task", "flight.second.task",   "flight.take_out.task"};

}  // namespace

FlightScreen::FlightScreen(std::shared_ptr<SignedInSession> signed_in, LendHands lend_hands)
    : signed_in_(std::move(signed_in)), lend_hands_(std::move(lend_hands)) {}

void FlightScreen::leave(Shell&) {
  if (block_) block_->field.session().pause(PausedBy::Locked);
}

void FlightScreen::be_covered() {
  if (block_) block_->field.session().pause(PausedBy::Covered);
}

void FlightScreen::draw(Ui& ui, const Rect& /*content*/, Shell& shell) {
  if (!block_) return prepare(ui, shell);
  if (block_->field.session().phase() == Phase::Stopped) return draw_stopped(ui, shell);
  fly(ui, shell);
}

// -- before

void FlightScreen::prepare(Ui& ui, Shell& shell) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  if (prepared_.is_new()) {
    prepared_.start(ui, shell, ui.text("flight.preparing"),
                    [signed_in = signed_in_](WorkReport& report) {
                      return prepare_flight(*signed_in, report);
                    });
  }
  const Rect inside =
      card(ui, centred(ui.display(), std::min(520.0F, ui.display().w - 32.0F), 300.0F),
           ui.text("flight.preparing"));
  if (ui.shortcut({Key::Escape}, ui.text("flight.leave"))) return shell.pop();
  if (!prepared_.draw_until_ready(ui, "flight.unprepared", inside, 4)) return;
  lay_block(ui, shell);
}

void FlightScreen::lay_block(Ui& ui, Shell& shell) {
  struct Laid {
    std::unique_ptr<UnrecordedAttempt> loop;
    /// Of loop.
    simulator::SteeredDevice* device = nullptr;
    std::unique_ptr<simulator::SecondHand> second = nullptr;
  };
  block_ = std::make_unique<Block>();
  OperatingField& field = block_->field;
  field.make_ready(prepared_.value(), StepProgress({scenarios::StepKind::Remove}));
  world_from_first_view_ = field.viewport().world_from_view();
  static_cast<void>(field.session().begin());
  auto laid = std::make_shared<Laid>();
  work_.start(
      shell, std::string(ui.text("flight.preparing")),
      [prepared_case = field.prepared().prepared_case, lend = lend_hands_, start = field.start(),
       laid](WorkReport& report) {
        LentHands hands = lend(start, [&](double) { return report.reached(0.0); });
        laid->device = hands.saw.get();
        laid->second = std::move(hands.second);
        laid->loop = std::make_unique<UnrecordedAttempt>(prepared_case, std::move(hands.saw));
      },
      [this, &shell, laid, name = "first flight " + std::to_string(ui.time_s())](
          WorkEnd end, const std::string& reason) {
        if (end == WorkEnd::Cancelled) return shell.pop();
        if (end == WorkEnd::Failed) return block_->field.session().fail_to_begin(reason);
        block_->loop = std::move(laid->loop);
        block_->field.run(name, *block_->loop, *laid->device, std::move(laid->second));
      });
  ui.want_frame_in_s(0.0);
}

void FlightScreen::begin_again(Ui& ui, Shell& shell) {
  // A block that is still being laid is an uncut one.
  if (work_.is_running()) return;
  lessons_.begin_again();
  lay_block(ui, shell);
}

// -- in flight

void FlightScreen::fly(Ui& ui, Shell& shell) {
  OperatingField& field = block_->field;
  // Over, the picture is looked at and no more led.
  if (!lessons_.are_over()) {
    field.hear(ui, shell);
    hear_keys(ui, shell);
  }
  if (block_->field.is_running()) {
    block_->field.apply_loop(ui, shell);
    look(ui);
  }
  block_->field.show(ui, shell, goals(ui.texts()));
  draw_cards(ui, shell);
  if (block_->field.session().take_end() != OperatingSession::Onward::Nowhere)
    ui.want_frame_in_s(0.0);
  block_->field.hold_pointer(ui, shell.preferences());
}

void FlightScreen::hear_keys(Ui& ui, Shell& shell) {
  const auto heard = [&](Key key, const char* id) {
    return ui.shortcut({key}, ui.text(id)) && !ui.is_key_held_on();
  };
  if (!block_->field.session().is_heard()) return;
  if (heard(Key::S, "flight.skip")) skip(ui);
  if (heard(Key::End, "flight.leave")) return shell.pop();
  if (heard(Key::B, "flight.again")) begin_again(ui, shell);
}

LessonView FlightScreen::view(const Texts& texts) const {
  return lesson_view(block_->field.sources(texts), sawing_, world_from_first_view_);
}

void FlightScreen::look(Ui& ui) {
  if (lessons_.are_over() || block_->field.loop().lines == 0) return;
  const LessonView seen = view(ui.texts());
  while (!lessons_.are_over() && is_done(lessons_.at_hand(), seen)) lessons_.end(LessonEnd::Done);
  if (lessons_.are_over()) block_->field.session().pause(PausedBy::Person);
}

void FlightScreen::skip(Ui& ui) {
  if (lessons_.are_over()) return;
  lessons_.end(LessonEnd::Skipped);
  if (lessons_.are_over()) block_->field.session().pause(PausedBy::Person);
  ui.want_frame_in_s(0.0);
}

std::vector<Mark> FlightScreen::goals(const Texts& texts) const {
  const bool is_reaching =
      block_->field.is_running() && !lessons_.are_over() && lessons_.at_hand() == Lesson::Approach;
  if (!is_reaching) return {};
  const RigidTransform& world_from_bone = block_->field.prepared_case().bone().world_from_bone;
  return {{transform_point(world_from_bone, place_to_reach_in_bone_mm(view(texts))), 12.0,
           Ink::Accent, MarkShape::Ring}};
}

// -- panels and cards

OperatingHud FlightScreen::hud(const Ui& ui, Shell& shell) {
  OperatingHud hud = block_->field.hud(ui, shell);
  const Lesson lesson = lessons_.at_hand();
  const LessonView seen = view(ui.texts());
  hud.is_simulated = signed_in_->is_simulated();
  hud.is_reviewed = true;
  hud.steps.clear();
  for (std::size_t number = 0; number < lesson_count; ++number) {
    const auto each = static_cast<Lesson>(number);
    hud.steps.push_back(
        {std::string(ui.text(title_of(each))), lessons_.end_of(each) == LessonEnd::Done, false});
  }
  hud.step = lessons_.number();
  if (lesson != Lesson::TakeOut) {
    hud.step_action = {};
    hud.why_step_off.clear();
  }
  hud.lesson = {std::string(ui.text(tasks[lessons_.number()])),
                goal_text(ui.texts(), lesson, seen)};
  const std::optional<Hint> hint = lesson_hint(lesson, seen);
  hud.hint = hint && block_->field.is_hinted()
                 ? hint_text(ui.texts(), *hint, block_->field.session().saw().led())
                 : std::string();
  return hud;
}

void FlightScreen::draw_hud(Ui& ui, Shell& shell) {
  const HudAnswer answer = draw_operating_hud(ui, hud(ui, shell));
  OperatingSession& session = block_->field.session();
  block_->field.answer(answer, ui.texts());
  if (answer.step) session.press_step(true, ui.time_s());
  if (answer.abandon) return shell.pop();
  if (answer.skip) skip(ui);
  if (answer.again) begin_again(ui, shell);
}

void FlightScreen::draw_cards(Ui& ui, Shell& shell) {
  if (lessons_.are_over()) {
    const bool is_left = ui.shortcut({Key::Escape}, ui.text("flight.leave"));
    const FlightAnswer answer = draw_flown_card(ui, lessons_);
    if (is_left || answer == FlightAnswer::Operations) return shell.pop();
    if (answer != FlightAnswer::Again) return;
    lessons_ = {};
    return lay_block(ui, shell);
  }
  if (block_->field.session().phase() != Phase::Operating) return;
  if (block_->field.are_panels_shown()) draw_hud(ui, shell);
  OperatingSession& session = block_->field.session();
  if (session.phase() != Phase::Operating || lessons_.are_over()) return;
  if (session.is_device_lost()) {
    const std::string trouble = block_->field.device_trouble();
    if (draw_device_lost_card(ui, session.is_practice(), trouble) == LostAnswer::TakeMouse)
      session.take_over_from_device();
  } else if (session.pausing().is_paused() && draw_paused_card(ui, session.pausing().by())) {
    session.go_on();
  }
}

void FlightScreen::draw_stopped(Ui& ui, Shell& shell) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  const Rect inside =
      card(ui, centred(ui.display(), std::min(560.0F, ui.display().w - 32.0F), 300.0F), {});
  const std::string& reason = block_->field.session().stop().reason;
  const std::string why =
      reason.empty() ? std::string(ui.text("flight.stopped.sentence")) : sentence_of(reason);
  if (failed_card(ui, "flight.stopped", inside,
                  {ui.text("flight.stopped"), why, ui.text("flight.operations")}))
    shell.pop();
}

}  // namespace hallux::ui
