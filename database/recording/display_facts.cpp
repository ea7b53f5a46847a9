#include "database/recording/display_facts.h"

#include "database/store/sql.h"

namespace hallux::database {

namespace {

using FactValues = std::array<std::int64_t, simulator::display_columns>;

simulator::DisplayFact fact_in(SQLite::Statement& row) {
  FactValues values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = row.getColumn(static_cast<int>(i)).getInt64();
  }
  return simulator::display_fact_from(values);
}

}  // namespace

std::vector<simulator::DisplayFact> load_display_facts(Database& database, const AttemptId& id) {
  return translating(database, "read what was on the screen in attempt " + id.text, [&] {
    auto rows =
        prepared(database,
                 "SELECT f.tick, f.target_x_in_world_um, f.target_y_in_world_um, "
                 "f.target_z_in_world_um, f.rotation_w_micro, f.rotation_x_micro, "
                 "f.rotation_y_micro, f.rotation_z_micro, f.magnification_milli, "
                 "f.target_depth_um, f.width_over_height_milli, f.stereo, f.layout, f.lost_before "
                 "FROM attempt a JOIN display_fact f USING (attempt_id) WHERE a.uuid = ? "
                 "ORDER BY f.tick",
                 id);
    return collected(rows, fact_in);
  });
}

void store_display_facts(Database& database, std::int64_t attempt_number,
                         std::span<const simulator::DisplayFact> facts) {
  if (facts.empty()) return;
  auto insert =
      prepared(database,
               "INSERT OR REPLACE INTO display_fact (attempt_id, tick, "
               "target_x_in_world_um, target_y_in_world_um, target_z_in_world_um, "
               "rotation_w_micro, rotation_x_micro, rotation_y_micro, rotation_z_micro, "
               "magnification_milli, target_depth_um, width_over_height_milli, stereo, "
               "layout, lost_before) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const simulator::DisplayFact& fact : facts) {
    std::apply([&](const auto&... values) { run_again(insert, attempt_number, values...); },
               columns_of(fact));
  }
}

void erase_display_facts(Database& database, std::int64_t attempt_number) {
  execute(database, "DELETE FROM display_fact WHERE attempt_id = ?", attempt_number);
}

}  // namespace hallux::database
