#include "ui/render/gl/software_renderer.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <thread>

#include "simulator/loop/priority.h"

namespace hallux::ui {

void share_processors_with_loop() {
  const unsigned processors = std::max(2U, std::thread::hardware_concurrency());
  const unsigned left_to_loop = simulator::RealTimePriority().is_granted() ? 0U : 1U;
  ::setenv("LP_NUM_THREADS", std::to_string(processors - left_to_loop).c_str(), 0);
}

}  // namespace hallux::ui
