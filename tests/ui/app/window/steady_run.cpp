// Operates, looks at the result, replays it and goes to the history, again and again, drawn with
// OpenGL:
//
//     steady_run SECONDS [ROUNDS]     so long, and at least so many rounds
//
// After each round it stands at the list of operations until pictures that nobody looks at were let
// go, and counts: of no kind may there be more of OpenGL's objects than after the first round;
// resident memory may rise by what is allowed below.
#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/ui/app/window/course_window.h"
#include "tests/ui/render/graphics.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "ui/render/imgui_painter.h"
#include "ui/render/scene_painter.h"

namespace {

using namespace hallux;
using namespace hallux::ui;
using Clock = std::chrono::steady_clock;

constexpr PixelSize size{1280, 720};
/// More than the painter keeps a picture that nobody looks at.
constexpr int frames_until_let_go = 320;
/// With one heap for all threads both came to the same tenth of a megabyte after each round but the
/// first, which had 3 more (with a heap for each, threads that end leave up to 39 MiB of pages
/// behind, up and down, while what is in use stays). Each round adds an attempt to the course,
/// which its lists show.
constexpr double allowed_in_use_mib = 4.0, allowed_resident_mib = 8.0;

double resident_mib() {
  ::malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

/// What was asked for and not given back yet, of what resident memory is only the pages.
double in_use_mib() {
  const struct mallinfo2 heap = ::mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / (1024.0 * 1024.0);
}

std::string text_of(const tests::ObjectCensus& census) {
  return std::to_string(census.buffers) + " buffers, " + std::to_string(census.vertex_arrays) +
         " vertex arrays, " + std::to_string(census.textures) + " textures, " +
         std::to_string(census.framebuffers) + " framebuffers, " +
         std::to_string(census.renderbuffers) + " renderbuffers, " +
         std::to_string(census.programs_and_shaders) + " programs and shaders";
}

/// The course's window without a window.
class DrawnCourse {
 public:
  explicit DrawnCourse(const std::filesystem::path& data) : target_(size) {
    DriverSetting setting;
    setting.width = static_cast<float>(size.width);
    setting.height = static_cast<float>(size.height);
    window_ = std::make_unique<CourseWindow>(
        data, database::cheap,
        [this](Shell& shell, Ui& ui) {
          scenes_.begin_frame(target_.target());
          shell.draw(ui, scenes_);
        },
        setting);
    painter_ = std::make_unique<ImguiPainter>();
  }

  CourseWindow& window() { return *window_; }
  Driver& driver() { return window_->driver(); }

  void frame(double seconds = 0.02) {
    driver().frame(seconds);
    const Color page = driver().ui().theme().page;
    scenes_.finish_frame({page.red, page.green, page.blue}, [&](float columns) {
      painter_->draw(driver().ui().draw_data(), driver().ui().fonts_version(), columns);
    });
    // As the swap of a window does: else the software renderer keeps what waits to be drawn,
    // hundreds of megabytes of it.
    glFinish();
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }
  /// errors  std::runtime_error where it does not come within a minute
  void wait_for(std::string_view id) {
    const auto end = Clock::now() + std::chrono::minutes(1);
    while (!driver().has(id) || !driver().widget(id).is_enabled) {
      if (Clock::now() > end) throw std::runtime_error("there is no " + std::string(id));
      frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  /// A running operation never settles: nothing here waits until the screen has.
  void press(Key key, int times = 1) {
    for (int i = 0; i < times; ++i) {
      driver().send(key_events(key));
      frames(3);
    }
  }
  void click(std::string_view id) {
    wait_for(id);
    driver().send(click_events(driver().widget(id).visible.centre()));
    frames(4);
  }

 private:
  HeadlessContext context_;
  RenderTarget target_;
  OpenGlScenePainter scenes_;
  std::unique_ptr<CourseWindow> window_;
  std::unique_ptr<ImguiPainter> painter_;
};

void operate(DrawnCourse& course) {
  course.click("nav.operations");
  course.click("operations.card.silver_coarse");
  course.click("brief.begin");
  course.wait_for("operate.begin");
  course.press(Key::Enter);
  course.wait_for("operate.pause");
  course.press(Key::Digit3);
  course.press(Key::PageUp, 5);
  course.press(Key::Space);
  course.press(Key::Down, 40);
  course.frames(40);
  for (int mode = 0; mode < 3; ++mode) {
    course.press(Key::F9);
    course.frames(5);
  }
  course.press(Key::End);
  course.click("operate.ask_finish.act");
}

void look_back(DrawnCourse& course) {
  course.wait_for("result.replay");
  course.window().finish_work();
  course.frames(10);
  course.click("result.replay");
  course.wait_for("replay.view");
  course.window().finish_work();
  course.press(Key::Space);
  course.frames(40);
  course.press(Key::Escape, 2);
  course.window().finish_work();
  course.click("nav.history");
  course.window().finish_work();
  course.frames(10);
  course.click("nav.operations");
  course.frames(frames_until_let_go);
  // What a screen that is gone began may still run.
  if (!course.window().finish_work(300.0))
    throw std::runtime_error("work beside the window does not end");
}

/// What is left after a round.
struct Left {
  tests::ObjectCensus objects;
  double resident_mib = 0.0, in_use_mib = 0.0;
};

Left round(DrawnCourse& course, int number, Clock::time_point start) {
  operate(course);
  look_back(course);
  const Left left{tests::count_objects(), resident_mib(), in_use_mib()};
  std::printf("round %d, %.0f s: %.1f MiB resident, %.1f in use; %s\n", number,
              std::chrono::duration<double>(Clock::now() - start).count(), left.resident_mib,
              left.in_use_mib, text_of(left.objects).c_str());
  std::fflush(stdout);
  return left;
}

/// What was still on its way out after the first round may be gone later.
bool has_grown(const tests::ObjectCensus& first, const tests::ObjectCensus& now) {
  return now.buffers > first.buffers || now.vertex_arrays > first.vertex_arrays ||
         now.textures > first.textures || now.framebuffers > first.framebuffers ||
         now.renderbuffers > first.renderbuffers ||
         now.programs_and_shaders > first.programs_and_shaders;
}

bool is_steady(const Left& first, const Left& now) {
  const bool has_more_objects = has_grown(first.objects, now.objects);
  const double resident_mib = now.resident_mib - first.resident_mib;
  const double in_use_mib = now.in_use_mib - first.in_use_mib;
  const bool has_more_memory =
      resident_mib > allowed_resident_mib || in_use_mib > allowed_in_use_mib;
  if (has_more_objects) std::printf("OpenGL's objects grow\n");
  if (has_more_memory) {
    std::printf("memory grew by %.1f MiB resident, %.1f in use; %.0f and %.0f are allowed\n",
                resident_mib, in_use_mib, allowed_resident_mib, allowed_in_use_mib);
  }
  return !has_more_objects && !has_more_memory;
}

bool run(double seconds, int rounds_at_least) {
  OperableCourse course("silver");
  DrawnCourse drawn(course.course().database().directory());
  drawn.window().sign_in("ada", database::good_password);
  const auto start = Clock::now();
  const Left first = round(drawn, 1, start);
  const std::chrono::duration<double> wanted(seconds);
  bool is_well = true;
  for (int number = 2; number <= rounds_at_least || Clock::now() - start < wanted; ++number) {
    is_well = is_steady(first, round(drawn, number, start)) && is_well;
  }
  return is_well;
}

}  // namespace

int main(int count, char** arguments) {
  ::mallopt(M_ARENA_MAX, 1);
  testing::InitGoogleTest(&count, arguments);
  if (count < 2) {
    std::fprintf(stderr, "usage: steady_run SECONDS [ROUNDS]\n");
    return 2;
  }
  try {
    const bool is_well = run(std::atof(arguments[1]), count > 2 ? std::atoi(arguments[2]) : 2);
    return is_well && !testing::Test::HasFailure() ? 0 : 1;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
