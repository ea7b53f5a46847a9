#include "simulator/device/inverse3/inverse3_driver.h"

#include <algorithm>
#include <utility>

namespace hallux::simulator {

namespace {

constexpr std::chrono::milliseconds inventory_within{300}, state_within{5};
constexpr int unnamed_most = 50, ignored_most = 20;
constexpr InverseVersion oldest{3, 1}, says_vector{3, 5};
constexpr int majors_known = 3;
constexpr double millimetres_in_metre = 1000.0;
/// Of the service's frame, in the middle of the arm's reach [m].
const Vec3 middle_m{0.0, -0.12, 0.15};
/// A push that is felt, and one that is none [N].
constexpr double push_newton = 0.1, nothing_newton = 0.01;
/// Of the averages of what is said and told.
constexpr double newest_share = 0.02;

// The service: x right, y away, z up. The device: x right, y up, z to the person.
Vec3 device_from_service(const Vec3& v) noexcept { return {v.x, v.z, -v.y}; }
Vec3 service_from_device(const Vec3& v) noexcept { return {v.x, -v.z, v.y}; }

InverseForceKey other_than(InverseForceKey key) noexcept {
  return key == InverseForceKey::Vector ? InverseForceKey::Values : InverseForceKey::Vector;
}

std::string words_of(const InverseVersion& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor);
}

}  // namespace

OpenedInverse open_inverse(const InverseAccess& access) {
  OpenedInverse inverse;
  const auto ended = [&](TroubleReport trouble) {
    inverse.channel.reset();
    inverse.trouble = std::move(trouble);
    return std::move(inverse);
  };
  const auto other_protocol = [&](std::string detail) {
    return ended({DeviceTrouble::ServiceVersion, {}, std::move(detail)});
  };
  OpenedService opened = access.open();
  if (opened.trouble) return ended(std::move(opened.trouble));
  inverse.channel = std::move(opened.channel);
  if (const auto page = access.version_page()) {
    const std::optional<InverseVersion> version = inverse_version(*page);
    if (version && (version->is_before(oldest) || version->major > majors_known))
      return other_protocol(words_of(*version));
    if (version && !version->is_before(says_vector)) inverse.force_key = InverseForceKey::Vector;
  }
  const HeardMessage heard = inverse.channel->hear(inventory_within);
  if (heard.answer == BusAnswer::Gone) return ended({DeviceTrouble::ServiceGone, {}, {}});
  if (heard.answer == BusAnswer::Nothing)
    return other_protocol("it does not begin with what it has");
  const auto inventory = heard.answer == BusAnswer::Done ? inverse_message(heard.text)
                                                         : std::optional<InverseMessage>();
  if (!inventory) return other_protocol("what it says is no list of devices");
  if (inventory->is_older_form) return other_protocol("3.0");
  inverse.inventory = *inventory;
  return inverse;
}

TroubleReport trouble_with_inverse(const InverseArm& arm) {
  // Services of before 3.5 do not say it.
  const bool is_known = arm.type.empty() || arm.type == "inverse3" || arm.type == "inverse3x";
  return is_known ? TroubleReport{} : TroubleReport{DeviceTrouble::WrongModel, arm.id, arm.type};
}

Inverse3Driver::Inverse3Driver(InverseAccess access, std::string id)
    : access_(std::move(access)), id_(std::move(id)) {}

/// Its maker names no limits in its protocol: these are careful ones.
DeviceDescription Inverse3Driver::description() const {
  return {.name = "Haply Inverse3",
          .device_class = "arm3",
          .limits = DeviceLimits{.force_newton = 6.0,
                                 .continuous_force_newton = 2.0,
                                 .thermal_time_s = 10.0,
                                 .stiffness_newton_per_mm = 0.8,
                                 .damping_newton_s_per_mm = 0.004,
                                 .transport_ticks = 1},
          .pulse = DevicePulse{.numbers_packets = true},
          .measures_rotation = has_grip_};
}

TroubleReport Inverse3Driver::open(const OpeningWatch&) {
  OpenedInverse opened = open_inverse(access_);
  if (opened.trouble) return opened.trouble;
  const InverseArm* arm = opened.inventory.arm_with(id_);
  if (arm == nullptr) return {DeviceTrouble::Unplugged, id_, {}};
  if (TroubleReport trouble = trouble_with_inverse(*arm)) return trouble;
  channel_ = std::move(opened.channel);
  force_key_ = opened.force_key;
  belief_ = {};
  unanswered_ = unnamed_ = gripless_ = 0;
  is_calibrated_ = true;
  has_grip_ = opened.inventory.grip_count > 0;
  state_ = {};
  take(opened.inventory);
  return {};
}

DriverExchange Inverse3Driver::exchange(const Vec3& force_in_device_newton) noexcept {
  DriverExchange exchange{DriverAnswer::Nothing, state_, DeviceTrouble::None};
  const auto gone = [&](DeviceTrouble trouble) {
    return DriverExchange{DriverAnswer::Gone, state_, trouble};
  };
  if (!channel_ || say(force_in_device_newton) == BusAnswer::Gone)
    return gone(DeviceTrouble::ServiceGone);
  if (hear(exchange.answer) == BusAnswer::Gone) return gone(DeviceTrouble::ServiceGone);
  if (unnamed_ > unnamed_most) return gone(DeviceTrouble::Unplugged);
  if (belief_.ignored > ignored_most) {
    if (belief_.was_changed) return gone(DeviceTrouble::ServiceVersion);
    change_word();
  }
  exchange.state = state_;
  return exchange;
}

BusAnswer Inverse3Driver::say(const Vec3& force_in_device_newton) noexcept {
  force_newton_ = service_from_device(force_in_device_newton);
  ++unanswered_;
  return channel_->say(inverse_force(id_, force_key_, force_newton_));
}

/// A state that came late would else be followed by late ones for ever.
BusAnswer Inverse3Driver::hear(DriverAnswer& answer) noexcept {
  HeardMessage heard = channel_->hear(state_within);
  while (heard.answer == BusAnswer::Done || heard.answer == BusAnswer::Refused) {
    answer = take(heard);
    unanswered_ = std::max(unanswered_ - 1, 0);
    if (unanswered_ == 0) break;
    heard = channel_->hear(std::chrono::milliseconds{0});
  }
  return heard.answer;
}

DriverAnswer Inverse3Driver::take(const HeardMessage& heard) noexcept {
  if (heard.answer == BusAnswer::Refused) return DriverAnswer::Garbled;
  const std::optional<InverseMessage> message = inverse_message(heard.text);
  return message ? take(*message) : DriverAnswer::Garbled;
}

DriverAnswer Inverse3Driver::take(const InverseMessage& message) noexcept {
  gripless_ = message.grip_count == 0 ? gripless_ + 1 : 0;
  for (std::size_t i = 0; i < message.grip_count; ++i) take(message.grips[i]);
  const InverseArm* arm = message.arm_with(id_);
  unnamed_ = arm == nullptr ? unnamed_ + 1 : 0;
  if (arm == nullptr) return DriverAnswer::Nothing;
  take(*arm);
  return arm->cursor_m ? DriverAnswer::Said : DriverAnswer::Nothing;
}

void Inverse3Driver::take(const InverseArm& arm) noexcept {
  if (arm.cursor_m) {
    state_.device_from_handle.translation_mm =
        millimetres_in_metre * device_from_service(*arm.cursor_m - middle_m);
  }
  is_calibrated_ = arm.is_calibrated.value_or(is_calibrated_);
  // Nobody knows how a grip lies that says nothing, nor whether its buttons are held.
  const bool is_grip_lost = has_grip_ && gripless_ > unnamed_most;
  if (is_grip_lost) state_.buttons = 0;
  state_.is_homed = is_calibrated_ && !is_grip_lost;
  if (arm.force_newton) believe(*arm.force_newton);
}

void Inverse3Driver::take(const InverseGrip& grip) noexcept {
  // One that comes later than the arm was opened would turn the saw at once.
  if (grip.rotation && has_grip_) {
    const Vec3 axis = device_from_service({grip.rotation->x, grip.rotation->y, grip.rotation->z});
    state_.device_from_handle.rotation = Quat(grip.rotation->w, axis.x, axis.y, axis.z);
  }
  state_.buttons = grip.buttons.value_or(state_.buttons);
}

void Inverse3Driver::believe(const Vec3& told_newton) noexcept {
  const double said = length_of(force_newton_), told = length_of(told_newton);
  belief_.said += newest_share * (said - belief_.said);
  belief_.told += newest_share * (told - belief_.told);
  if (belief_.said > push_newton) state_.own_force_scale = belief_.told / belief_.said;
  belief_.ignored = said > push_newton && told < nothing_newton ? belief_.ignored + 1 : 0;
}

void Inverse3Driver::change_word() noexcept {
  static_cast<void>(say({0.0, 0.0, 0.0}));
  force_key_ = other_than(force_key_);
  belief_ = {};
  belief_.was_changed = true;
}

/// Under both words: it may have understood the one and not told so. What is answered is heard, so
/// that the service has read it before the channel goes.
void Inverse3Driver::close() noexcept {
  if (!channel_) return;
  for (int word = 0; word < 2; ++word) {
    force_key_ = other_than(force_key_);
    static_cast<void>(say({0.0, 0.0, 0.0}));
    static_cast<void>(channel_->hear(state_within));
  }
  channel_.reset();
}

}  // namespace hallux::simulator
