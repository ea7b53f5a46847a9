// How many pictures a second the operating screen makes while somebody saws: panels, patch, swarf,
// the 1 kHz loop, recorder and geometry thread all at work; and how late the loop was meanwhile. A
// whole frame is measured, to the last pixel.
//
//     live_frames [EDGE_MM] [PICTURE_FOLDER]   0.44: a first metatarsal of about 50,000 triangles
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "simulator/loop/priority.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/ui/screens/operating/drawn_operation.h"
#include "ui/render/gl/software_renderer.h"

namespace hallux::benchmarks {

namespace {

using namespace ui;

constexpr int frames_measured = 150, frames_before = 30;

/// Holds the middle button and moves it a little further: the view turns with each picture.
void turn_on(DrawnOperation& window, int picture) {
  InputEvent event;
  event.kind = picture == 0 ? EventKind::ButtonPressed : EventKind::PointerMoved;
  event.button = MouseButton::Middle;
  event.position = {500.0F + 0.5F * static_cast<float>(picture), 400.0F};
  window.person().driver().send({event});
}

/// Saws on while it is measured; one row of the table.
std::vector<Cell> measure(DrawnOperation& window, const std::string& name, bool turns = false) {
  std::vector<double> times_ms;
  for (int i = 0; i < frames_before + frames_measured; ++i) {
    if (turns) turn_on(window, i);
    const double time_ms = window.frame();
    if (i >= frames_before) times_ms.push_back(time_ms);
  }
  const Percentiles spread = percentiles_of(times_ms);
  return {name,         static_cast<double>(window.triangles()),
          spread.least, spread.median,
          spread.p99,   1000.0 / spread.median};
}

void release(DrawnOperation& window) {
  InputEvent event;
  event.kind = EventKind::ButtonReleased;
  event.button = MouseButton::Middle;
  window.person().driver().send({event});
  window.press(Key::Digit1);
}

/// Two rows: in a view that stands still, then in one that turns.
void add_mode(DrawnOperation& window, Table& table, const std::string& name,
              const std::filesystem::path& folder) {
  table.rows.push_back(measure(window, name));
  window.take(folder, name);
  table.rows.push_back(measure(window, name + ", turning", true));
  turn_on(window, frames_before + frames_measured);
  window.take(folder, name + ", turning");
  release(window);
}

/// Seen from medial: over the head, down to it, and a push of some millimetres.
void begin_sawing(DrawnOperation& window) {
  window.press(Key::Enter);
  while (!window.person().driver().has("operate.pause")) window.frame();
  window.press(Key::Digit3);
  window.press(Key::PageUp, 5);
  window.press(Key::Space);
  window.press(Key::Down, 40);
  window.press(Key::Digit1);
}

void print_loop(DrawnOperation& window) {
  window.person().press(Key::End);
  window.press(Key::Tab);
  window.press(Key::Enter);
  while (!window.person().is_gone()) window.frame();
  const auto quality = nlohmann::json::parse(window.course().attempt().quality_json);
  std::cout << "\nloop: p99 lateness " << quality.at("late_p99_us").get<double>() << " us, missed "
            << quality.at("missed_ticks") << " of " << quality.at("expected_samples")
            << " ticks, pauses " << quality.at("pauses") << "; FIFO "
            << (simulator::RealTimePriority().is_granted() ? "granted" : "not granted") << '\n';
}

int run(double edge_mm, const std::filesystem::path& folder) {
  share_processors_with_loop();  // as the window does
  DrawnOperation window("silver", edge_mm);
  window.take(folder, "ready");
  begin_sawing(window);
  Table table{
      .name = "live_frames",
      .title = "The operating screen, live, 1280 x 720",
      .columns = {"picture", "triangles", "least ms", "median ms", "p99 ms", "pictures a second"},
      .rows = {},
      .notes = {"pictures a second: 1000 / median; a saw at work, panels drawn, everything "
                "recorded"}};
  add_mode(window, table, "mono", folder);
  window.press(Key::F9);
  add_mode(window, table, "side by side", folder);
  window.press(Key::F9);
  add_mode(window, table, "anaglyph", folder);
  window.press(Key::F9);
  print_table(std::cout, table);
  print_loop(window);
  return 0;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  const double edge_mm = count > 1 ? std::atof(words[1]) : 0.44;
  if (edge_mm < 0.05) {
    std::cerr << "usage: live_frames [EDGE_MM [PICTURE_FOLDER]], edges of 0.05 mm and more\n";
    return 2;
  }
  try {
    return hallux::benchmarks::run(edge_mm, count > 2 ? words[2] : std::filesystem::path());
  } catch (const std::exception& error) {
    std::cerr << "live_frames: " << error.what() << '\n';
    return 1;
  }
}
