/// The machine in another time zone, as long as this is alive.
/// thread  the one that reads times
#pragma once

#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>

namespace hallux {

class TimeZone {
 public:
  /// By a rule of its own ("CET-1CEST,M3.5.0,M10.5.0/3"), so that no table of zones need be
  /// installed.
  explicit TimeZone(const char* rule) {
    if (const char* before = std::getenv("TZ")) before_ = before;
    setenv("TZ", rule, 1);
    tzset();
  }
  TimeZone(const TimeZone&) = delete;
  TimeZone& operator=(const TimeZone&) = delete;
  ~TimeZone() {
    if (before_)
      setenv("TZ", before_->c_str(), 1);
    else
      unsetenv("TZ");
    tzset();
  }

 private:
  std::optional<std::string> before_;
};

}  // namespace hallux
