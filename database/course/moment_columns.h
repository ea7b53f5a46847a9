/// Columns of a moment of an attempt: its time, and four that are null where it has no place.
/// Inside this corner only.
#pragma once

#include "database/records/note.h"
#include "database/store/sql.h"

namespace hallux::database {

/// Binds moment_us, body, x, y, z from `first` on.
inline void bind_moment(SQLite::Statement& statement, int first, const AttemptMoment& moment) {
  statement.bind(first, moment.moment_us);
  if (!moment.place) return;
  statement.bind(first + 1, moment.place->body);
  for (int i = 0; i < 3; ++i) {
    statement.bind(first + 2 + i, moment.place->point_in_bone_mm[static_cast<std::size_t>(i)]);
  }
}

inline AttemptMoment moment_in(SQLite::Statement& row, int first) {
  AttemptMoment moment;
  moment.moment_us = row.getColumn(first).getInt64();
  if (row.getColumn(first + 1).isNull()) return moment;
  BonePoint place;
  place.body = row.getColumn(first + 1).getInt();
  for (int i = 0; i < 3; ++i) {
    place.point_in_bone_mm[static_cast<std::size_t>(i)] = row.getColumn(first + 2 + i).getDouble();
  }
  moment.place = place;
  return moment;
}

}  // namespace hallux::database
