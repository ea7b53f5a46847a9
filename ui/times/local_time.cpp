#include "ui/times/local_time.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>

namespace hallux::ui {

namespace {

constexpr std::array<const char*, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                             "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
constexpr int seconds_per_minute = 60, minutes_per_hour = 60, first_year_of_tm = 1900;

/// Only what is a moment of the calendar: the C library would make the 3rd of March of 31 February.
std::optional<std::time_t> second_of(std::string_view utc) noexcept {
  std::array<char, 32> text{};
  utc.copy(text.data(), text.size() - 1);
  int year = 0, hour = 0, minute = 0;
  unsigned month = 0, day = 0;
  if (std::sscanf(text.data(), "%4d-%2u-%2uT%2d:%2d", &year, &month, &day, &hour, &minute) != 5)
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year{year}, std::chrono::month{month},
                                         std::chrono::day{day}};
  if (!date.ok() || hour < 0 || hour > 23 || minute < 0 || minute > 59) return std::nullopt;
  const auto midnight = std::chrono::sys_days{date}.time_since_epoch();
  const auto moment = midnight + std::chrono::hours{hour} + std::chrono::minutes{minute};
  return std::chrono::duration_cast<std::chrono::seconds>(moment).count();
}

std::chrono::sys_days day_of(const LocalTime& time) noexcept {
  return std::chrono::year_month_day{std::chrono::year{time.year},
                                     std::chrono::month{static_cast<unsigned>(time.month)},
                                     std::chrono::day{static_cast<unsigned>(time.day)}};
}

std::string date_of(const LocalTime& time) {
  return std::to_string(time.day) + " " + months[static_cast<std::size_t>(time.month - 1)] + " " +
         std::to_string(time.year);
}

}  // namespace

std::optional<LocalTime> local_time(std::string_view utc) noexcept {
  const std::optional<std::time_t> second = second_of(utc);
  std::tm fields{};
  if (!second || localtime_r(&*second, &fields) == nullptr) return std::nullopt;
  return LocalTime{fields.tm_year + first_year_of_tm,
                   fields.tm_mon + 1,
                   fields.tm_mday,
                   fields.tm_hour,
                   fields.tm_min,
                   static_cast<int>(fields.tm_gmtoff / seconds_per_minute)};
}

std::string offset_text(int offset_min) {
  const int size = offset_min < 0 ? -offset_min : offset_min;
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%c%02d:%02d", offset_min < 0 ? '-' : '+',
                size / minutes_per_hour, size % minutes_per_hour);
  return text.data();
}

std::string moment_text(std::string_view utc) {
  const std::optional<LocalTime> time = local_time(utc);
  if (!time) return std::string(utc);
  std::array<char, 16> clock{};
  std::snprintf(clock.data(), clock.size(), ", %02d:%02d", time->hour, time->minute);
  return date_of(*time) + clock.data();
}

std::string full_moment_text(std::string_view utc) {
  const std::optional<LocalTime> time = local_time(utc);
  return time ? moment_text(utc) + " " + offset_text(time->offset_min) : std::string(utc);
}

std::string date_text(std::string_view utc) {
  const std::optional<LocalTime> time = local_time(utc);
  return time ? date_of(*time) : std::string(utc);
}

int days_between(std::string_view earlier_utc, std::string_view later_utc) noexcept {
  const std::optional<LocalTime> from = local_time(earlier_utc), to = local_time(later_utc);
  return from && to ? static_cast<int>((day_of(*to) - day_of(*from)).count()) : 0;
}

}  // namespace hallux::ui
