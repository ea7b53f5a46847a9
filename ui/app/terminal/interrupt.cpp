#include "ui/app/terminal/interrupt.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <system_error>
#include <utility>

namespace hallux::ui {

namespace {

// A signal handler can reach nothing but globals.
volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t alarm_descriptor = -1;

/// A handler may call no more than this.
void ring(int descriptor) noexcept {
  const std::uint64_t once = 1;
  [[maybe_unused]] const auto written = ::write(descriptor, &once, sizeof once);
}

void note_interrupt(int /*signal*/) {
  const int error_before = errno;
  interrupted = 1;
  if (alarm_descriptor >= 0) ring(alarm_descriptor);
  errno = error_before;
}

void wait_for_ring(int descriptor) noexcept {
  std::uint64_t rung = 0;
  while (::read(descriptor, &rung, sizeof rung) < 0 && errno == EINTR) {
  }
}

}  // namespace

InterruptWatch::InterruptWatch() {
  interrupted = 0;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool is_interrupted() noexcept { return interrupted != 0; }

InterruptAlarm::InterruptAlarm(std::function<void()> wake) {
  const int descriptor = ::eventfd(0, EFD_CLOEXEC);
  if (descriptor < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  alarm_descriptor = descriptor;
  thread_ = std::jthread([descriptor, wake = std::move(wake)] {
    wait_for_ring(descriptor);
    wake();
  });
  // One that came before is not missed.
  if (is_interrupted()) ring(descriptor);
}

InterruptAlarm::~InterruptAlarm() {
  const int descriptor = alarm_descriptor;
  alarm_descriptor = -1;
  ring(descriptor);
  thread_.join();
  ::close(descriptor);
}

}  // namespace hallux::ui
