/// Runs a command with modelled devices plugged in: the real hidapi and libusb speak with them
/// through files that a library makes up (umockdev).
///
///     umockdev-wrapper served_bus DEVICE... [--at SECONDS pull|plug|DEVICE-FAULT DEVICE]...
///                                 [--once FILE pull|plug|DEVICE-FAULT DEVICE]...
///                                 [--report FILE] -- COMMAND...
///
///     DEVICE        falcon, arm, space_mouse or touch, with ':' and options between commas:
///                   serial=S, loaded, homed, unhomed, older, pressed, no-rights, taken,
///                   wrong-echo=BYTE, absent (until it is plugged in); in an action its name,
///                   serial or place: 0, 1
///     DEVICE-FAULT  silent, garbled, long
///
/// One action after the other, in the order in which they are named: at its moment, or once a file
/// is there. The report's FILE becomes JSON: what each device saw. The exit code is the command's.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/support/served_bus/falcon_counts.h"
#include "tests/support/served_bus/served_falcon.h"
#include "tests/support/served_bus/served_hid.h"

namespace {

using namespace hallux;
using namespace hallux::tests;
using Clock = std::chrono::steady_clock;
using nlohmann::ordered_json;

struct DeviceOptions {
  std::string name, serial;
  bool is_loaded = false, is_homed = false, is_older = false, is_pressed = false, has_rights = true,
       is_taken = false, is_absent = false, is_never_homed = false;
  std::size_t wrong_echo_at = 0;
};

/// "falcon:serial=A1,loaded".
DeviceOptions options_in(const std::string& text) {
  DeviceOptions options;
  std::istringstream words(text.find(':') == std::string::npos ? ""
                                                               : text.substr(text.find(':') + 1));
  options.name = text.substr(0, text.find(':'));
  for (std::string word; std::getline(words, word, ',');) {
    const std::string value = word.substr(word.find('=') + 1);
    if (word.starts_with("serial="))
      options.serial = value;
    else if (word.starts_with("wrong-echo="))
      options.wrong_echo_at = std::stoul(value);
    else if (word == "loaded")
      options.is_loaded = true;
    else if (word == "homed")
      options.is_homed = true;
    else if (word == "older")
      options.is_older = true;
    else if (word == "pressed")
      options.is_pressed = true;
    else if (word == "taken")
      options.is_taken = true;
    else if (word == "unhomed")
      options.is_never_homed = true;
    else if (word == "absent")
      options.is_absent = true;
    else if (word == "no-rights")
      options.has_rights = false;
    else
      throw std::runtime_error("no such option of a device: " + word);
  }
  return options;
}

/// A device of the bus with what is said and asked of it.
class Plugged {
 public:
  explicit Plugged(const DeviceOptions& options) : options_(options) {}
  virtual ~Plugged() = default;

  const DeviceOptions& options() const noexcept { return options_; }
  virtual ServedDevice& served() = 0;
  virtual void go_wrong(const std::string& fault) = 0;
  virtual ordered_json seen() const = 0;

 private:
  DeviceOptions options_;
};

class PluggedFalcon final : public Plugged {
 public:
  PluggedFalcon(const DeviceOptions& options, int number)
      : Plugged(options), served_(number, options.serial, model_) {
    if (options.is_loaded) model_.run();
    model_.is_homed = options.is_homed;
    served_.is_taken = options.is_taken;
    model_.faults.wrong_echo_at = options.wrong_echo_at;
    model_.on_packet = [is_never_homed = options.is_never_homed](FalconModel& falcon) {
      hold(falcon);
      if (is_never_homed) falcon.is_homed = false;
    };
  }

  ServedDevice& served() override { return served_; }
  void go_wrong(const std::string& fault) override {
    model_.faults.is_silent = fault == "silent";
    model_.faults.is_garbled = fault == "garbled";
    model_.faults.is_long = fault == "long";
  }
  ordered_json seen() const override {
    return {{"packets", model_.packets()},
            {"runs", model_.mode() == FalconModel::Mode::Runs},
            {"motors", model_.motors()},
            {"lights", model_.lights()}};
  }

 private:
  /// A hand that pushes it home within 50 packets and then goes to and fro a little.
  static void hold(FalconModel& falcon) {
    constexpr std::uint64_t homed_after = 50, turn = 200;
    if (falcon.packets() > homed_after) falcon.is_homed = true;
    const auto phase = static_cast<double>(falcon.packets() % turn);
    const Vec3 grip_mm = simulator::falcon_middle_mm +
                         Vec3(0.0, 0.0, 0.05 * (phase < 100.0 ? phase : 200.0 - phase));
    falcon.encoders = falcon_counts_at(grip_mm);
  }

  FalconModel model_;
  ServedFalcon served_;
};

class PluggedArm final : public Plugged {
 public:
  PluggedArm(const DeviceOptions& options, int number)
      : Plugged(options), served_(number, arm_identity(options.serial), model_) {
    model_.is_pressed = options.is_pressed;
  }

  ServedDevice& served() override { return served_; }
  void go_wrong(const std::string& fault) override {
    model_.is_silent = fault == "silent";
    model_.report_bytes = fault == "garbled" ? 63 : fault == "long" ? 128 : 64;
  }
  ordered_json seen() const override {
    return {{"packets", model_.reports}, {"motors", model_.currents_ma}};
  }

 private:
  ArmModel model_;
  ServedHid served_;
};

class PluggedSpaceMouse final : public Plugged {
 public:
  PluggedSpaceMouse(const DeviceOptions& options, int number)
      : Plugged(options),
        served_(number, space_mouse_identity(options.serial), model_, [this] { move(); }) {
    model_.is_older = options.is_older;
  }

  ServedDevice& served() override { return served_; }
  void go_wrong(const std::string& fault) override { fault_ = fault; }
  ordered_json seen() const override { return {{"lights", model_.lights}}; }

 private:
  /// Its cap is turned about, a report a millisecond.
  void move() {
    if (fault_ == "silent" || model_.waiting() > 8) return;
    if (fault_ == "garbled") return model_.say({1, 2, 3});
    const int push = static_cast<int>(++moves_ % 351);
    model_.push({push, -push, 7}, {1, -2, push});
  }

  SpaceMouseModel model_;
  ServedHid served_;
  std::string fault_;
  std::uint64_t moves_ = 0;
};

/// One whose maker keeps its protocol closed: it is there, and nobody speaks with it.
class PluggedTouch final : public Plugged {
 public:
  PluggedTouch(const DeviceOptions& options, int number)
      : Plugged(options), served_(number, touch_identity(options.serial), model_) {}

  ServedDevice& served() override { return served_; }
  void go_wrong(const std::string&) override {}
  ordered_json seen() const override { return ordered_json::object(); }

 private:
  SpaceMouseModel model_;
  ServedHid served_;
};

struct Action {
  double at_s = 0.0;
  /// That it waits for; empty: for none.
  std::string file;
  std::string what, device;

  bool is_due(double passed_s) const {
    return at_s <= passed_s && (file.empty() || ::access(file.c_str(), F_OK) == 0);
  }
};

struct Arguments {
  std::vector<DeviceOptions> devices;
  std::vector<Action> actions;
  std::string report;
  std::vector<char*> command;
};

Arguments arguments_in(int count, char** words) {
  Arguments arguments;
  int i = 1;
  const auto next = [&] {
    if (++i >= count) throw std::runtime_error("a word is missing at the end");
    return std::string(words[i]);
  };
  for (; i < count && std::string(words[i]) != "--"; ++i) {
    const std::string word = words[i];
    if (word == "--report") {
      arguments.report = next();
    } else if (word == "--at" || word == "--once") {
      Action action;
      if (word == "--at")
        action.at_s = std::stod(next());
      else
        action.file = next();
      action.what = next();
      action.device = next();
      arguments.actions.push_back(action);
    } else {
      arguments.devices.push_back(options_in(word));
    }
  }
  for (++i; i < count; ++i) arguments.command.push_back(words[i]);
  if (arguments.command.empty()) throw std::runtime_error("no command after --");
  arguments.command.push_back(nullptr);
  return arguments;
}

std::unique_ptr<Plugged> made(const DeviceOptions& options, int number) {
  if (options.name == "falcon") return std::make_unique<PluggedFalcon>(options, number + 1);
  if (options.name == "arm") return std::make_unique<PluggedArm>(options, number);
  if (options.name == "space_mouse") return std::make_unique<PluggedSpaceMouse>(options, number);
  if (options.name == "touch") return std::make_unique<PluggedTouch>(options, number);
  throw std::runtime_error("no such device: " + options.name);
}

class Bus {
 public:
  explicit Bus(const Arguments& arguments) : testbed_(umockdev_testbed_new()) {
    int number = 0;
    for (const DeviceOptions& each : arguments.devices) {
      devices_.push_back(made(each, number++));
      // Who answers for a file must stand ready before the file is there.
      ServedDevice& served = devices_.back()->served();
      umockdev_testbed_attach_ioctl(testbed_.get(), ("/dev/" + served.node()).c_str(),
                                    served.calls(), nullptr);
      if (!each.is_absent) plug(*devices_.back());
    }
  }

  void act(const Action& action) {
    for (std::size_t place = 0; place < devices_.size(); ++place) {
      const std::unique_ptr<Plugged>& each = devices_[place];
      const bool is_meant = each->options().name == action.device ||
                            each->options().serial == action.device ||
                            std::to_string(place) == action.device;
      if (!is_meant) continue;
      if (action.what == "pull")
        pull(*each);
      else if (action.what == "plug")
        plug(*each);
      else
        each->go_wrong(action.what);
    }
  }

  void tick() {
    for (const std::unique_ptr<Plugged>& each : devices_) each->served().tick();
  }

  ordered_json seen() const {
    auto rows = ordered_json::array();
    for (const std::unique_ptr<Plugged>& each : devices_) {
      ordered_json row{{"name", each->options().name}, {"serial", each->options().serial}};
      row.update(each->seen());
      rows.push_back(row);
    }
    return rows;
  }

 private:
  void plug(Plugged& device) {
    ServedDevice& served = device.served();
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(testbed_.get(), served.description().c_str(), &error))
      throw std::runtime_error(error->message);
    served.plugged(*testbed_);
    umockdev_testbed_uevent(testbed_.get(), ("/sys" + served.folder()).c_str(), "add");
    if (device.options().has_rights) return;
    const std::unique_ptr<char, void (*)(void*)> root(umockdev_testbed_get_root_dir(testbed_.get()),
                                                      g_free);
    const std::string file = std::string(root.get()) + "/dev/" + served.node();
    if (::chmod(file.c_str(), 0) != 0) throw std::runtime_error(file + ": rights cannot be taken");
  }

  void pull(Plugged& device) {
    device.served().pull();
    const std::string folder = "/sys" + device.served().folder();
    umockdev_testbed_uevent(testbed_.get(), folder.c_str(), "remove");
    umockdev_testbed_remove_device(testbed_.get(), folder.c_str());
  }

  GlibPtr<UMockdevTestbed> testbed_;
  std::vector<std::unique_ptr<Plugged>> devices_;
};

int run(const Arguments& arguments) {
  Bus bus(arguments);
  const auto begun = Clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    ::execvp(arguments.command.front(), arguments.command.data());
    ::_exit(127);
  }
  std::size_t done = 0;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    bus.tick();
    const std::chrono::duration<double> passed = Clock::now() - begun;
    while (done < arguments.actions.size() && arguments.actions[done].is_due(passed.count()))
      bus.act(arguments.actions[done++]);
  }
  if (!arguments.report.empty()) std::ofstream(arguments.report) << bus.seen().dump(1) << "\n";
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(arguments_in(count, words));
  } catch (const std::exception& error) {
    std::cerr << "served_bus: " << error.what() << "\n";
    return 64;
  }
}
