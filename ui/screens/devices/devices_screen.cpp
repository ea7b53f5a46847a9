// The list comes from the station's own thread once a second, so the screen looks at it anew in
// each frame. A device is opened only where somebody asks to feel it, and let go when they look
// elsewhere. What is set for the station is an administrator's; a new station reads it.
#include "ui/screens/devices/devices_screen.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ui/jobs/devices/device_sentences.h"
#include "ui/jobs/devices/devices_file.h"
#include "ui/screens/devices/felt_view.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

using simulator::FoundDevice;

constexpr ListPageSpec page_spec{560.0F, 0.5F, 640.0F, 300.0F, 600.0F};
constexpr double look_again_s = 0.5, felt_again_s = 0.03;
constexpr float class_from = 420.0F;
/// What can be chosen of a setting, for the station and by a person.
struct Steps {
  std::string_view key, label, own_label;
  std::array<double, 4> values;
  std::array<std::string_view, 4> words;
};
constexpr Steps motion_steps{"motion_scale",
                             "devices.motion",
                             "devices.own.motion",
                             {0.5, 1.0, 1.5, 2.0},
                             {"× 0.5", "× 1", "× 1.5", "× 2"}};
constexpr Steps force_steps{"force_share",
                            "devices.force",
                            "devices.own.force",
                            {0.0, 0.25, 0.5, 1.0},
                            {"0 %", "25 %", "50 %", "100 %"}};

/// The nearest.
int step_of(const Steps& steps, double value) noexcept {
  int nearest = 0;
  for (int step = 1; step < static_cast<int>(steps.values.size()); ++step) {
    const auto off = [&](int at) {
      return std::abs(steps.values[static_cast<std::size_t>(at)] - value);
    };
    if (off(step) < off(nearest)) nearest = step;
  }
  return nearest;
}

/// Empty for what cannot be used.
std::string class_text(const Texts& texts, const FoundDevice& device) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> words{{
      {"mouse", "devices.class.mouse"},
      {"rate", "devices.class.rate"},
      {"arm3", "devices.class.arm3"},
      {"arm6", "devices.class.arm6"},
  }};
  for (const auto& [name, id] : words)
    if (name == facts_of(device.kind).device_class) return std::string(texts.text(id));
  return {};
}

std::string name_of(const Texts& texts, const FoundDevice& device) {
  return device.kind == simulator::DeviceKind::Mouse ? std::string(texts.text("devices.mouse"))
                                                     : device.name;
}

std::vector<RowColumn<FoundDevice>> columns_of(const Ui& ui, const std::string& operating) {
  return {
      {{ui.text("devices.device"), 0.0F, 1.6F},
       [&texts = ui.texts()](const FoundDevice& device) { return name_of(texts, device); },
       name_cell},
      {{ui.text("devices.class"), 0.0F, 1.0F, Align::Left, class_from},
       [&texts = ui.texts()](const FoundDevice& device) { return class_text(texts, device); },
       small_cell},
      {{ui.text("devices.state"), 128.0F},
       [operating](Ui& own, const FoundDevice& device, const Rect& cell) {
         const bool operates = device.id == operating;
         const Meaning meaning = !device.is_usable() ? Meaning::Warn
                                 : operates          ? Meaning::Good
                                                     : Meaning::Neutral;
         pill(own, {cell.x, cell.mid_y()},
              own.text(!device.is_usable() ? "devices.not_usable"
                       : operates          ? "devices.operates"
                                           : "devices.usable"),
              meaning);
       }},
  };
}

/// A label and a choice beside it; whether another was chosen.
bool chosen_in_line(Ui& ui, Rect& rest, std::string_view label,
                    std::span<const std::string_view> words, int& chosen) {
  Rect line = take_top(rest, segmented_height, 10.0F);
  const Rect track = take_right(line, std::min(segmented_width(ui, words), 0.7F * line.w));
  ui.canvas().text_in(line, {Type::Small, ui.theme().text_secondary}, ui.text(label), true);
  return segmented(ui, label, track, words, chosen);
}

/// As it is set for the station, or a person's own; whether they chose otherwise.
bool choose_own(Ui& ui, Rect& rest, const Steps& steps, std::optional<double>& own) {
  std::array<std::string_view, 5> words{ui.text("devices.own.none")};
  std::copy(steps.words.begin(), steps.words.end(), words.begin() + 1);
  int chosen = own ? 1 + step_of(steps, *own) : 0;
  if (!chosen_in_line(ui, rest, steps.own_label, words, chosen)) return false;
  own = chosen == 0 ? std::nullopt
                    : std::optional(steps.values[static_cast<std::size_t>(chosen - 1)]);
  return true;
}

}  // namespace

const FoundDevice* DevicesScreen::chosen() const { return device_with(devices_, chosen_); }

void DevicesScreen::leave(Shell&) {
  is_left_ = true;
  felt_.reset();
}

void DevicesScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  is_left_ = false;
  const PageHead head =
      course_head(ui, *signed_in_, ui.text("devices.title"), ui.text("devices.sentence"));
  const ListPage page(ui, "devices", head, content, page_spec);
  if (station_.is_new()) {
    station_.start(ui, shell, ui.text("devices.reading"), [own = own_](WorkReport&) {
      std::shared_ptr<simulator::Station> found = own->get();
      found->look();
      return found;
    });
  }
  if (!station_.draw_until_ready(ui, "devices.failed", page.list(), 4)) {
    card(ui, page.side(), {});
    return;
  }
  devices_ = station().devices();
  draw_table(ui, page.list(), shell.preferences());
  draw_chosen(ui, page.side(), shell);
  ui.want_frame_in_s(felt_ ? felt_again_s : look_again_s);
}

void DevicesScreen::draw_table(Ui& ui, const Rect& content, const Preferences& preferences) {
  const RowTable<Device> shown{ui.text("devices.title"), &Device::id,
                               [&](const Device& device) { return name_of(ui.texts(), device); },
                               columns_of(ui, preferences.device)};
  table_.chosen = {chosen_};
  const TableResponse response = table(ui, "devices.row", content, shown, devices_, table_);
  if (!response.opened) return;
  chosen_ = devices_[static_cast<std::size_t>(*response.opened)].id;
  felt_.reset();
}

void DevicesScreen::draw_chosen(Ui& ui, const Rect& rect, Shell& shell) {
  Rect rest = card(ui, rect, {});
  const Device* const device = chosen();
  if (device == nullptr) {
    felt_.reset();
    text_line(ui, rest, Type::CardTitle, ui.theme().text, chosen_);
    return text_line(ui, rest, Type::Small, ui.theme().text_secondary, ui.text("devices.gone"));
  }
  const simulator::KindFacts& kind = facts_of(device->kind);
  ui.canvas().text_in(take_top(rest, 26.0F, 4.0F), {Type::CardTitle, ui.theme().text},
                      name_of(ui.texts(), *device), true);
  fact_line(ui, rest, ui.text("devices.id"), device->id);
  if (!kind.device_class.empty())
    fact_line(ui, rest, ui.text("devices.class"), class_text(ui.texts(), *device));
  if (!device->address.empty()) {
    fact_line(ui, rest, ui.text("devices.address"),
              device->address + ", " + std::string(kind.library));
  }
  take_top(rest, 8.0F);
  if (!device->is_usable()) return draw_trouble(ui, rest, *device, shell);
  draw_choice(ui, rest, *device, shell.preferences());
  if (device->kind == simulator::DeviceKind::Mouse)
    return text_line(ui, rest, Type::Small, ui.theme().text_secondary,
                     ui.text("devices.mouse.sentence"));
  draw_settings(ui, rest, *device, shell);
  draw_feel(ui, rest, *device, shell);
}

void DevicesScreen::draw_trouble(Ui& ui, Rect& rest, const Device& device, Shell& shell) const {
  const simulator::KindFacts& kind = facts_of(device.kind);
  text_line(ui, rest, Type::Body, ui.theme().text, sentence_of(device.trouble, kind) + ".");
  const std::string mend = mend_of(device.trouble, kind, device.id);
  if (mend.empty()) return;
  text_line(ui, rest, Type::Small, ui.theme().text_secondary, mend, 12.0F);
  const ButtonSpec copy{ui.text("devices.copy"), ButtonLook::Secondary, Icon::Copy};
  if (!button_in_line(ui, "devices.copy", take_top(rest, button_height), copy)) return;
  ui.clipboard().write(mend);
  shell.say({Meaning::Good, std::string(ui.text("devices.copied"))});
}

void DevicesScreen::draw_choice(Ui& ui, Rect& rest, const Device& device,
                                Preferences& preferences) const {
  const bool operates = preferences.device == device.id;
  ButtonSpec choose{ui.text("devices.choose"), ButtonLook::Primary, Icon::Check};
  if (operates) choose.why_off = ui.text("devices.chosen");
  if (button_in_line(ui, "devices.choose", take_top(rest, button_height, 16.0F), choose)) {
    preferences.device = device.id;
    if (preferences.second_device == device.id) preferences.second_device.clear();
  }
  if (facts_of(device.kind).device_class != "rate" || operates) return;
  bool is_second = preferences.second_device == device.id;
  if (toggle(ui, "devices.second", take_top(rest, 24.0F, 12.0F), ui.text("devices.second"),
             is_second))
    preferences.second_device = is_second ? device.id : std::string();
}

// -- what is set for the station

void DevicesScreen::draw_settings(Ui& ui, Rect& rest, const Device& device, Shell& shell) {
  const simulator::KindFacts& kind = facts_of(device.kind);
  const simulator::Hold set_now =
      hold_of(station().settings().of(device.id, std::string(kind.id)), {});
  const auto setting = [&](const Steps& steps, double value) {
    int chosen = step_of(steps, value);
    if (!signed_in_->person().is_administrator) {
      return fact_line(ui, rest, ui.text(steps.label),
                       steps.words[static_cast<std::size_t>(chosen)]);
    }
    if (chosen_in_line(ui, rest, steps.label, steps.words, chosen) && !setting_.is_running()) {
      set(ui, shell, device, steps.key,
          fixed_text(steps.values[static_cast<std::size_t>(chosen)], 2));
    }
  };
  HandPreferences& hand = shell.hand();
  setting(motion_steps, set_now.motion_scale);
  // What is felt now is felt as it was chosen before.
  if (choose_own(ui, rest, motion_steps, hand.motion_scale)) felt_.reset();
  if (kind.device_class != "rate") {
    setting(force_steps, set_now.force_share);
    if (choose_own(ui, rest, force_steps, hand.force_share)) felt_.reset();
  }
  take_top(rest, 6.0F);
}

void DevicesScreen::set(Ui& ui, Shell& shell, const Device& device, std::string_view key,
                        const std::string& value) {
  felt_.reset();
  setting_.start(
      shell, std::string(ui.text("devices.setting")),
      [own = own_, id = device.id, key = std::string(key), value](WorkReport&) {
        set_device(own->data_directory(), id, key, value);
        own->read_again();
      },
      [this, &shell, failed = std::string(ui.text("devices.unset"))](WorkEnd end,
                                                                     const std::string& reason) {
        if (end == WorkEnd::Failed) shell.say({Meaning::Warn, failed, sentence_of(reason)});
        station_.read_again();
      });
}

// -- how it feels

void DevicesScreen::open(Ui& ui, Shell& shell, const Device& device) {
  auto opened = std::make_shared<std::unique_ptr<FeltDevice>>();
  const simulator::Hold hold =
      hold_of(station().settings().of(device.id, std::string(facts_of(device.kind).id)),
              {shell.hand().motion_scale, shell.hand().force_share});
  opening_.start(
      shell, std::string(ui.text("devices.opening")),
      [opened, station = station_.value(), device, share = hold.force_share](WorkReport&) {
        *opened = std::make_unique<FeltDevice>(station, device, share);
      },
      [this, opened](WorkEnd end, const std::string&) {
        // Somebody may look at another meanwhile, or elsewhere.
        if (end == WorkEnd::Done && !is_left_ && (*opened)->device().id == chosen_)
          felt_ = std::move(*opened);
      });
}

void DevicesScreen::draw_feel(Ui& ui, Rect rest, const Device& device, Shell& shell) {
  if (!felt_) {
    ButtonSpec feel{ui.text("devices.feel"), ButtonLook::Secondary, Icon::Eye};
    feel.is_busy = opening_.is_running();
    if (button_in_line(ui, "devices.feel", take_top(rest, button_height), feel))
      open(ui, shell, device);
    return;
  }
  Rect buttons = take_bottom(rest, button_height, 12.0F);
  draw_felt(ui, rest, facts_of(device.kind));
  const ButtonSpec again{ui.text("devices.reach.again"), ButtonLook::Ghost},
      stop{ui.text("devices.let_go"), ButtonLook::Secondary, Icon::Stop};
  const Rect left = take_left(buttons, button_width(ui, stop), 8.0F);
  if (button(ui, "devices.reach_again", take_left(buttons, button_width(ui, again)), again))
    felt_->forget_reach();
  if (button(ui, "devices.let_go", left, stop)) felt_.reset();
}

/// Why it is away, how far it is until it is at home, or what it says.
void DevicesScreen::draw_felt(Ui& ui, Rect rest, const simulator::KindFacts& kind) {
  const FeltState& felt = felt_->state();
  if (const simulator::TroubleReport trouble = felt_->trouble()) {
    text_line(ui, rest, Type::Body, ui.theme().text, sentence_of(trouble, kind) + ".");
    return text_line(ui, rest, Type::Small, ui.theme().text_secondary,
                     mend_of(trouble, kind, felt_->device().id));
  }
  if (felt.phase != simulator::PortPhase::Running) {
    const bool is_homing = felt.phase == simulator::PortPhase::Homing;
    text_line(ui, rest, Type::Body, ui.theme().text,
              is_homing ? home_sentence(kind) : std::string(ui.text("devices.loading")));
    return bar(ui, take_top(rest, 8.0F), static_cast<float>(felt.fraction));
  }
  draw_felt_view(ui, take_top(rest, std::min(felt_view_height, rest.h), 12.0F), felt,
                 felt_->figures());
  bool is_wall = felt_->is_wall_wanted();
  const std::string_view why_off =
      felt.has_motors ? std::string_view() : ui.text("devices.wall.none");
  if (toggle(ui, "devices.wall", take_top(rest, 24.0F, 8.0F), ui.text("devices.wall"), is_wall,
             true, why_off))
    felt_->set_wall(is_wall);
}

}  // namespace hallux::ui
