// The frames of the operating screen while an expert's hand saws the shipped patients: bone as
// dense as it is shipped, inset, halo, tints and panels, the 1 kHz loop, recorder and geometry
// thread all at work; and those of a picture at rest. A whole frame is measured, to the last pixel.
//
//     expert_frames [--no-edge-pass] [--pictures FOLDER] [OPERATION...]
//
// The hand's motion is recorded in virtual time first and played back by the clock: it feels
// nothing while it is measured, so that each run saws the same.
#include <chrono>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "simulator/device/steered_device.h"
#include "simulator/loop/priority.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/ui/screens/operating/drawn_operation.h"
#include "ui/render/gl/software_renderer.h"

namespace hallux::benchmarks {

namespace {

using namespace ui;

constexpr int frames_measured = 200, frames_before = 20, frames_at_rest = 60;
constexpr double shipped_edge_mm = 0.3;
constexpr std::uint64_t seed = 1;

/// Plays a recorded tape back, tick by tick.
class PlayedHand final : public simulator::SteeredDevice {
 public:
  explicit PlayedHand(std::shared_ptr<const simulator::Recording> recording)
      : recording_(std::move(recording)) {}

  void aim(const Aim&) noexcept override {}
  simulator::DeviceDescription description() const override { return {"played hand", "mouse"}; }
  bool exchange(const Vec3&, std::int64_t tick,
                simulator::RawDeviceState& state) noexcept override {
    const std::vector<simulator::TapeLine>& tape = recording_->tape;
    while (next_ + 1 < tape.size() && tape[next_ + 1].tick <= tick) ++next_;
    const simulator::DeviceState& device = tape[next_].device;
    state.world_from_handle = simulator::transform_from(device.world_from_handle);
    state.switches = device.switches;
    return true;
  }

 private:
  std::shared_ptr<const simulator::Recording> recording_;
  std::size_t next_ = 0;
};

std::shared_ptr<const simulator::Recording> motion_of_expert(const std::string& operation) {
  const scenarios::Scenario scenario = scenarios::load_shipped_scenario(operation);
  return std::make_shared<const simulator::Recording>(
      tests::run_hand(scenario, make_patient_bones(scenario).front(), "expert", seed).recording);
}

double processor_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One row: those frames of the coming ones that count.
template <typename Counts>
std::vector<Cell> measure(DrawnOperation& window, const std::string& name, int frames,
                          const Counts& counts) {
  std::vector<double> times_ms;
  double processor_sum_ms = 0.0;
  for (int i = 0; i < frames; ++i) {
    const double before_ms = processor_ms();
    const double time_ms = window.frame();
    if (!counts(i)) continue;
    processor_sum_ms += processor_ms() - before_ms;
    times_ms.push_back(time_ms);
  }
  const Percentiles spread = percentiles_of(times_ms);
  return {name,
          static_cast<double>(spread.count),
          spread.median,
          spread.p99,
          1000.0 / spread.median,
          processor_sum_ms / static_cast<double>(spread.count)};
}

std::vector<Cell> measure_sawing(DrawnOperation& window, const std::string& name) {
  return measure(window, name, frames_before + frames_measured,
                 [](int frame) { return frame >= frames_before; });
}

/// Frames that draw a sample, then those that draw nothing.
void add_rest(DrawnOperation& window, Table& table, const std::string& name) {
  bool was_unfinished = true;
  const auto is_sample = [&](int frame) {
    const bool counts = was_unfinished && frame > 24;
    was_unfinished = window.scenes().is_unfinished();
    return counts;
  };
  table.rows.push_back(measure(window, name + ", at rest: a sample", frames_at_rest, is_sample));
  table.rows.push_back(measure(window, name + ", at rest: refined", frames_at_rest,
                               [](int frame) { return frame > 2; }));
}

struct Setting {
  bool has_edge_pass = true;
  std::filesystem::path pictures;
};

void add_operation(Table& table, const std::string& operation, const Setting& setting) {
  const auto motion = motion_of_expert(operation);
  const auto lend = [&](const HandStart&, const Progress&) {
    return LentHands{std::make_unique<PlayedHand>(motion)};
  };
  DrawnOperation window(operation, shipped_edge_mm, {1280, 720}, {}, lend);
  RenderQuality quality = live_quality();
  quality.smooths_edges = setting.has_edge_pass;
  window.scenes().set_quality(quality);
  window.press(Key::Enter);
  if (!window.until([&] { return window.person().driver().has("operate.pause"); }))
    throw std::runtime_error("the operation does not begin");
  window.press(Key::Enter);                      // the case is verified
  for (int i = 0; i < 150; ++i) window.frame();  // to the bone and into it
  table.rows.push_back(measure_sawing(window, operation + ", mono"));
  window.take(setting.pictures, operation + ", mono");
  window.press(Key::F9);
  table.rows.push_back(measure_sawing(window, operation + ", side by side"));
  window.take(setting.pictures, operation + ", side by side");
  window.press(Key::P);
  add_rest(window, table, operation + ", side by side");
  window.press(Key::F9, 2);
  add_rest(window, table, operation + ", mono");
  window.take(setting.pictures, operation + ", mono, at rest");
}

int run(const Setting& setting, const std::vector<std::string>& operations) {
  share_processors_with_loop();  // as the window does
  Table table{
      .name = "expert_frames",
      .title = "The operating screen in an expert's hand, 1280 x 720",
      .columns = {"picture", "frames", "median ms", "p99 ms", "pictures a second", "processor ms"},
      .rows = {},
      .notes = {"pictures a second: 1000 / median; processor ms: of the whole program, all "
                "threads, for each frame",
                "edge pass " + std::string(setting.has_edge_pass ? "on" : "off") + "; FIFO " +
                    (simulator::RealTimePriority().is_granted() ? "granted" : "not granted"),
                "a million square roots in a row take " + text_of(calibration_ms()) + " ms here"}};
  for (const std::string& operation : operations) add_operation(table, operation, setting);
  print_table(std::cout, table);
  return 0;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  hallux::benchmarks::Setting setting;
  std::vector<std::string> operations;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--no-edge-pass") {
      setting.has_edge_pass = false;
    } else if (word == "--pictures" && i + 1 < count) {
      setting.pictures = words[++i];
    } else {
      operations.push_back(word);
    }
  }
  if (operations.empty()) operations = {"silver", "akin"};
  try {
    return hallux::benchmarks::run(setting, operations);
  } catch (const std::exception& error) {
    std::cerr << "expert_frames: " << error.what() << '\n';
    return 1;
  }
}
