// How many pictures a second the operating view makes here, mono and stereo, with the bone at about
// 50,000 triangles: the whole of a frame is measured, from the patch's upload to the last pixel
// (glFinish).
//
//     operating_frames [EDGE_MM]     0.21 gives a phalanx of about 50,000 triangles
#include <epoxy/gl.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/ui/render/operating_world.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/stereo.h"

namespace hallux::benchmarks {

namespace {

using namespace ui;

struct Case {
  std::string name;
  StereoMode mode = StereoMode::Mono;
  PixelSize size{1280, 720};
  int supersampling = 1;
  bool is_sawing = true;
  double eye_columns = 1.0;
};

struct FrameTime {
  double on_clock_ms = 0.0, worked_ms = 0.0;  ///< worked: by all threads of the program together
};

FrameTime measure(Renderer& renderer, StereoStage& stage, tests::OperatingWorld& world,
                  const Case& what, const RenderTarget& window, double& reach_mm) {
  if (what.is_sawing) world.saw_to(reach_mm += 0.02);
  const Scene scene = world.scene();
  const Stopwatch watch;
  stage.draw(renderer, scene, world.camera(), {.mode = what.mode, .eye_columns = what.eye_columns},
             window.target());
  glFinish();
  return {watch.milliseconds(), watch.worked_milliseconds()};
}

int run(double edge_mm) {
  const HeadlessContext context;
  tests::OperatingWorld world(edge_mm);
  StereoStage stage;
  double reach_mm = -6.0;
  Table table{.name = "operating_frames",
              .title = "The operating view on " + renderer_name(),
              .columns = {"picture", "triangles", "least ms", "median ms", "p99 ms",
                          "least processor ms", "processor ms", "pictures a second"},
              .rows = {},
              .notes = {"pictures a second: 1000 / median on the clock; processor ms: all threads "
                        "together, which does not depend on what else the machine does"}};
  const std::vector<Case> cases{
      {"mono 1280 x 720"},
      {"mono 1280 x 720, bone at rest", StereoMode::Mono, {1280, 720}, 1, false},
      {"side by side 1280 x 720", StereoMode::SideBySide},
      {"anaglyph 1280 x 720, live", StereoMode::Anaglyph, {1280, 720}, 1, true, live_eye_columns()},
      {"anaglyph 1280 x 720, all columns", StereoMode::Anaglyph},
      {"mono 1280 x 720, supersampled", StereoMode::Mono, {1280, 720}, 2}};
  for (const Case& what : cases) {
    Renderer renderer({.supersampling = what.supersampling});
    const RenderTarget window(what.size);
    std::vector<double> times_ms, worked_ms;
    for (int frame = 0; frame < 70; ++frame) {
      const FrameTime time = measure(renderer, stage, world, what, window, reach_mm);
      if (frame < 10) continue;
      times_ms.push_back(time.on_clock_ms);
      worked_ms.push_back(time.worked_ms);
    }
    const Percentiles spread = percentiles_of(times_ms), worked = percentiles_of(worked_ms);
    table.rows.push_back({what.name, static_cast<double>(renderer.counts().triangles), spread.least,
                          spread.median, spread.p99, worked.least, worked.median,
                          1000.0 / spread.median});
  }
  print_table(std::cout, table);
  return 0;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  try {
    return hallux::benchmarks::run(count > 1 ? std::atof(words[1]) : 0.21);
  } catch (const std::exception& error) {
    std::cerr << "operating_frames: " << error.what() << '\n';
    return 1;
  }
}
