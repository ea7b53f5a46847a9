/// Columns of a moment of an attempt: its time, and four that are null where it has no place.
/// Inside this corner only.
#pragma once

#include "database/records/note.h"
#include "database/store/sql.h"

namespace hallux::database {

/// Bound as moment_us, body, x, y, z.
inline auto columns_of(const AttemptMoment& moment) {
  using Number = std::optional<double>;
  const auto& place = moment.place;
  const auto part = [&](std::size_t i) {
    return place ? Number{place->point_in_bone_mm[i]} : Number{};
  };
  const auto body = place ? std::optional{place->body} : std::nullopt;
  return std::tuple{moment.moment_us, body, part(0), part(1), part(2)};
}

inline AttemptMoment moment_in(SQLite::Statement& row, int first) {
  AttemptMoment moment;
  moment.moment_us = row.getColumn(first).getInt64();
  if (row.getColumn(first + 1).isNull()) return moment;
  BonePoint& place = moment.place.emplace();
  auto& [x, y, z] = place.point_in_bone_mm;
  read_columns(row, first + 1, place.body, x, y, z);
  return moment;
}

}  // namespace hallux::database
