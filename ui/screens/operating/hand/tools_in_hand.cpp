#include "ui/screens/operating/hand/tools_in_hand.h"

#include "simulator/record/refusals.h"

namespace hallux::ui {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::GripRefusal;
using simulator::ImplantRefusal;
using simulator::ToolRefusal;

Notice notice_of_grip(GripRefusal why) noexcept {
  switch (why) {
    case GripRefusal::NoSuchPiece:
      return Notice::NothingToGrip;
    case GripRefusal::BoneItself:
      return Notice::BoneItself;
    case GripRefusal::HandsFull:
      return Notice::HandsFull;
    case GripRefusal::ToolInBone:
      return Notice::ToolInBone;
    case GripRefusal::TooMany:
      return Notice::TooManyMoved;
    case GripRefusal::Held:
      break;
  }
  return Notice::PieceFixed;
}

Notice notice_of_implant(ImplantRefusal why) noexcept {
  switch (why) {
    case ImplantRefusal::NothingToLeave:
      return Notice::NothingToLeave;
    case ImplantRefusal::NoSuchImplant:
    case ImplantRefusal::OtherTool:
      return Notice::NothingToTake;
    case ImplantRefusal::HandsFull:
      return Notice::HandsFull;
    case ImplantRefusal::TooMany:
      break;
  }
  return Notice::TooManyLeft;
}

}  // namespace

double rate_per_minute(const simulator::Tool& tool) noexcept {
  return std::visit(
      [](const auto& each) {
        if constexpr (requires { each.cycles_per_minute; }) {
          return each.cycles_per_minute;
        } else {
          return each.revolutions_per_minute;
        }
      },
      tool);
}

const scenarios::LaidOutTool* ToolsInHand::tool() const noexcept {
  const auto place = static_cast<std::size_t>(place_);
  return place < tray_.size() ? &tray_[place] : nullptr;
}

const simulator::Saw* ToolsInHand::saw() const noexcept {
  return tool() == nullptr ? nullptr : std::get_if<simulator::Saw>(&tool()->tool);
}

bool ToolsInHand::is_implant_driver() const noexcept {
  return tool() != nullptr && implant_of(tool()->tool).has_value();
}

std::optional<Notice> ToolsInHand::apply(const CutEvent& event) {
  switch (event.kind) {
    case CutEventKind::ToolChosen:
      place_ = event.subject;
      is_seated_ = false;
      break;
    case CutEventKind::ToolRefused:
      return event.subject == static_cast<std::int32_t>(ToolRefusal::HandsFull)
                 ? Notice::HandsFull
                 : Notice::ToolInBone;
    case CutEventKind::Gripped:
      forceps_ = Forceps::Holding;
      gripped_ = event.subject;
      was_driven_home_ = false;
      break;
    case CutEventKind::Released:
      forceps_ = Forceps::Open;
      gripped_ = -1;
      break;
    case CutEventKind::GripRefused:
      if (forceps_ == Forceps::Closing) forceps_ = Forceps::Open;
      return notice_of_grip(static_cast<GripRefusal>(event.subject));
    case CutEventKind::ImplantLeft:
      is_seated_ = false;
      break;
    case CutEventKind::ScrewSeated:
      is_seated_ = true;
      break;
    case CutEventKind::ImplantRefused:
      return notice_of_implant(static_cast<ImplantRefusal>(event.subject));
    case CutEventKind::BoreRefused:
      return Notice::BoreRefused;
    case CutEventKind::MetalMet:
      return Notice::MetalMet;
    default:
      break;
  }
  return std::nullopt;
}

}  // namespace hallux::ui
