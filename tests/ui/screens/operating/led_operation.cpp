#include "tests/ui/screens/operating/led_operation.h"

#include <array>

namespace hallux::ui {

using scenarios::StepKind;

LedOperation::LedOperation(database::AttemptKind kind) : session(kind) {
  session.make_ready(StepProgress({StepKind::Verify, StepKind::Cut, StepKind::Remove,
                                   StepKind::Close, StepKind::Finish}),
                     LedSaw({Quat(1.0, 0.0, 0.0, 0.0), start_mm}, {0.0, 0.0, 0.0}));
  session.begin();
  session.run(attempt, device);
}

void LedOperation::lead(const Vec2& across_mm, double now_s) {
  simulator::PointerMotion motion;
  motion.across_mm = across_mm;
  session.lead(std::array{motion}, Quat(1.0, 0.0, 0.0, 0.0), now_s);
}

void LedOperation::saw(double now_s) {
  session.set_saw_on(true);
  lead({0.0, 0.0}, now_s);
}

simulator::CutEvent event_of(simulator::CutEventKind kind, std::int32_t subject) {
  simulator::CutEvent event;
  event.kind = kind;
  event.subject = subject;
  return event;
}

}  // namespace hallux::ui
