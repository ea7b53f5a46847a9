#include "database/course/measurements.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "database/audit/audit.h"
#include "database/course/detail_json.h"
#include "database/recording/attempts.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr const char* row_columns =
    "line, metric, cut, hinge, zone, value, absence, done_fraction, bound, direction, "
    "detail_json, remark, start_us, end_us, x_in_bone_mm, y_in_bone_mm, z_in_bone_mm, fragment, "
    "implant";

/// What a column of numbers gives back for it: SQLite keeps no minus zero.
double as_kept(double number) noexcept { return number == 0.0 ? 0.0 : number; }

/// In the order of their columns; the value first.
std::array<double, 6> numbers_of(const Measurement& measurement) noexcept {
  const Vec3& place = measurement.place_in_bone_mm;
  return {as_kept(measurement.is_measured() ? measurement.value : 0.0),
          as_kept(measurement.done_fraction),
          as_kept(measurement.bound),
          as_kept(place.x),
          as_kept(place.y),
          as_kept(place.z)};
}

/// Others have no row: a number that is none comes from no measurement.
bool can_be_kept(const Measurement& measurement) {
  const std::array numbers = numbers_of(measurement);
  const auto is_finite = [](double number) { return std::isfinite(number); };
  return std::ranges::all_of(numbers, is_finite) &&
         std::ranges::all_of(measurement.detail.values, is_finite);
}

void add_to(Digester& digester, const Measurement& measurement) {
  for (const std::string& text : {measurement.metric, measurement.cut, measurement.hinge,
                                  measurement.zone, measurement.direction})
    digester.add_text(text);
  digester.add_text(name_of(measurement.absence));
  digester.add_text(json_from_detail(measurement.detail));
  digester.add_text(name_of(measurement.remark));
  for (const double number : numbers_of(measurement)) digester.add_double(number);
  digester.add_int(measurement.start_us);
  digester.add_int(measurement.end_us);
  // Rows of before have neither, and keep their digests.
  for (const auto& [kind, name] :
       {std::pair{"fragment", &measurement.fragment}, std::pair{"implant", &measurement.implant}}) {
    if (name->empty()) continue;
    digester.add_text(kind);
    digester.add_text(*name);
  }
}

[[noreturn]] void refuse_row() {
  throw DatabaseError{DatabaseErrorKind::Damaged, "a row of measurements is none that was stored"};
}

template <Named Enumeration>
Enumeration enumerator_of(const std::string& name) {
  const auto known = named<Enumeration>(name);
  if (!known) refuse_row();
  return *known;
}

/// Only what a row that was stored can hold: one text for each detail, and no value where there is
/// none.
Measurement measurement_in(SQLite::Statement& row) {
  Measurement measurement;
  std::optional<double> value;
  std::string absence, detail, remark;
  Vec3& place = measurement.place_in_bone_mm;
  read_columns(row, 1, measurement.metric, measurement.cut, measurement.hinge, measurement.zone,
               value, absence, measurement.done_fraction, measurement.bound, measurement.direction,
               detail, remark, measurement.start_us, measurement.end_us, place.x, place.y, place.z,
               measurement.fragment, measurement.implant);
  measurement.absence = enumerator_of<Absence>(absence);
  measurement.remark = enumerator_of<Remark>(remark);
  measurement.detail = detail_from_json(detail);
  const bool is_as_stored = json_from_detail(measurement.detail) == detail &&
                            value.has_value() == measurement.is_measured();
  if (!is_as_stored) refuse_row();
  measurement.value = value.value_or(0.0);
  return measurement;
}

struct StoredSet {
  std::int64_t number = 0;
  Digest digest;
};

/// The newest.
std::optional<StoredSet> find_set(Database& database, const MeasurementKey& key) {
  auto rows = prepared(database,
                       "SELECT measurement_set_id, digest FROM measurement_set "
                       "JOIN attempt USING (attempt_id) WHERE uuid = ? AND "
                       "measurement_set.seal = ? AND plan_digest = ? AND metrics_version = ? "
                       "ORDER BY measurement_set_id DESC LIMIT 1",
                       key.attempt, key.seal, key.by.plan, key.by.metrics_version);
  if (!rows.executeStep()) return std::nullopt;
  StoredSet set;
  read_columns(rows, 0, set.number, set.digest);
  return set;
}

/// What the act that stored the set says of its rows.
std::optional<Digest> digest_in_audit(Database& database, std::int64_t set_number) {
  return found<Digest>(database,
                       "SELECT u.detail_digest FROM audit_row r JOIN audit u USING (audit_id) "
                       "WHERE r.table_name = 'measurement_set' AND r.row_key = ? "
                       "AND u.action = 'measurements_stored'",
                       std::to_string(set_number));
}

/// Nothing where they are not those that were stored.
std::optional<std::vector<Measurement>> rows_as_stored(Database& database, const StoredSet& set,
                                                       const MeasurementKey& key) {
  try {
    std::vector<Measurement> rows = load_measurement_rows(database, set.number);
    const Digest digest = measurements_digest(key, rows);
    if (digest == set.digest && digest_in_audit(database, set.number) == digest) return rows;
  } catch (const DatabaseError& error) {
    if (error.kind() != DatabaseErrorKind::Damaged) throw;
  }
  return std::nullopt;
}

/// What is absent has no value.
void insert_rows(Database& database, std::int64_t set_number,
                 std::span<const Measurement> measurements) {
  auto insert = prepared(
      database, std::string("INSERT INTO measurement (measurement_set_id, ") + row_columns +
                    ") VALUES (?1, ?2, ?3, ?4, ?5, ?6, iif(?8 = '', ?7, NULL), ?8, ?9, "
                    "?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, ?18, ?19, ?20)");
  std::int64_t line = 0;
  for (const Measurement& each : measurements) {
    const auto [value, done_fraction, bound, x, y, z] = numbers_of(each);
    run_again(insert, set_number, line++, each.metric, each.cut, each.hinge, each.zone, value,
              each.absence, done_fraction, bound, each.direction, json_from_detail(each.detail),
              each.remark, each.start_us, each.end_us, x, y, z, each.fragment, each.implant);
  }
}

std::int64_t insert_set(Database& database, const AttemptHeader& header, const MeasuredBy& by,
                        const Digest& digest) {
  execute(database,
          "INSERT INTO measurement_set (attempt_id, seal, plan_digest, metrics_version, digest, "
          "stored_utc) VALUES (?, ?, ?, ?, ?, ?)",
          header.order, *header.seal, by.plan, by.metrics_version, digest, utc_now(database));
  return database.connection().getLastInsertRowid();
}

}  // namespace

Digest measurements_digest(const MeasurementKey& key, std::span<const Measurement> measurements) {
  Digester digester;
  digester.add_text(key.attempt.text);
  digester.add_digest(key.seal);
  digester.add_digest(key.by.plan);
  digester.add_int(key.by.metrics_version);
  digester.add_int(static_cast<std::int64_t>(measurements.size()));
  for (const Measurement& each : measurements) add_to(digester, each);
  return digester.finish();
}

std::vector<Measurement> load_measurement_rows(Database& database, std::int64_t set_number) {
  return translating(database, "read measurements", [&] {
    auto rows = prepared(database,
                         std::string("SELECT ") + row_columns +
                             " FROM measurement WHERE measurement_set_id = ? ORDER BY line",
                         set_number);
    return collected(rows, measurement_in);
  });
}

std::optional<std::vector<Measurement>> load_measurements(Database& database,
                                                          const AttemptId& attempt,
                                                          const MeasuredBy& by) {
  const AttemptHeader header = load_header(database, attempt);
  if (!header.seal) return std::nullopt;
  const MeasurementKey key{header.id, *header.seal, by};
  return translating(database, "read the measurements of attempt " + header.id.text,
                     [&]() -> std::optional<std::vector<Measurement>> {
                       const auto set = find_set(database, key);
                       return set ? rows_as_stored(database, *set, key) : std::nullopt;
                     });
}

void store_measurements(Database& database, const AttemptId& attempt, const MeasuredBy& by,
                        std::span<const Measurement> measurements, std::optional<PersonId> actor) {
  const AttemptHeader header = load_header(database, attempt);
  if (!header.seal || !std::ranges::all_of(measurements, can_be_kept)) return;
  const MeasurementKey key{header.id, *header.seal, by};
  const Digest digest = measurements_digest(key, measurements);
  in_transaction_of_caller(database, "store the measurements of attempt " + header.id.text, [&] {
    const auto there = find_set(database, key);
    if (there && there->digest == digest && rows_as_stored(database, *there, key)) return;
    const std::int64_t number = insert_set(database, header, by, digest);
    insert_rows(database, number, measurements);
    append_audit(database, {actor, "measurements_stored", "measurement_set", std::to_string(number),
                            false, digest, ""});
  });
}

}  // namespace hallux::database
