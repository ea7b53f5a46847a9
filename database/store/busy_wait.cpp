#include "database/store/busy_wait.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <thread>

namespace hallux::database {

namespace {

constexpr int mean_step_ms = 2;

/// 1, 2 or 3 ms, in another order for each process: two that wait for a third do not come at the
/// same moments.
int step_ms(int time) noexcept { return 1 + static_cast<int>((time * 7 + ::getpid()) % 3); }

/// The timeout itself is passed on as the argument: nothing has to live as long as the connection.
int wait_once(void* timeout_ms, int times_before) {
  const auto timeout = reinterpret_cast<std::intptr_t>(timeout_ms);
  if (static_cast<std::intptr_t>(times_before) * mean_step_ms >= timeout) return 0;
  std::this_thread::sleep_for(std::chrono::milliseconds{step_ms(times_before)});
  return 1;
}

}  // namespace

void wait_when_busy(SQLite::Database& connection, int timeout_ms) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): it points nowhere
  auto* const passed_on = reinterpret_cast<void*>(static_cast<std::intptr_t>(timeout_ms));
  sqlite3_busy_handler(connection.getHandle(), wait_once, passed_on);
}

void never_wait(SQLite::Database& connection) {
  sqlite3_busy_handler(connection.getHandle(), nullptr, nullptr);
}

}  // namespace hallux::database
