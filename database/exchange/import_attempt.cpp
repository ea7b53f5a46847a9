/// All is stored in one transaction, through the functions that store what is made here: a scenario
/// version, a score, a decision get the same checks and the same lines of the audit. Scores and
/// decisions are told again in their order, and what they lead to must be what the manifest says;
/// else nothing was imported.
#include "database/exchange/import_attempt.h"

#include "database/course/decisions.h"
#include "database/course/score_json.h"
#include "database/course/scores.h"
#include "database/exchange/origins.h"
#include "database/exchange/read_manifest.h"
#include "database/exchange/vouched_facts.h"
#include "database/recording/attempts.h"
#include "database/recording/certificate_json.h"
#include "database/recording/display_facts.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

/// What was decided there was decided for a reason that stayed there: free text is not exported.
constexpr const char* reason_there = "decided where it was recorded; the reason stayed there";

[[noreturn]] void refuse(const AttemptId& id, const std::string& why) {
  throw DatabaseError{DatabaseErrorKind::BadInput, "attempt " + id.text + " " + why};
}

/// What tells two attempts of one uuid apart: the seal, or where there is none the last link.
struct Identity {
  std::optional<Digest> seal;
  Digest last_link;
};

std::optional<Identity> identity_here(Database& database, const AttemptId& id) {
  auto row = prepared(
      database,
      "SELECT a.seal, coalesce((SELECT link FROM chunk c WHERE c.attempt_id = a.attempt_id "
      "ORDER BY seq DESC, stream DESC LIMIT 1), e.last_link) FROM attempt a "
      "LEFT JOIN erased_recording e USING (attempt_id) WHERE a.uuid = ?",
      id.text);
  if (!row.executeStep()) return std::nullopt;
  Identity identity;
  read_columns(row, 0, identity.seal, identity.last_link);
  return identity;
}

ScenarioVersionId put_scenario(Database& database, const Manifest& manifest) {
  const ScenarioVersionId id = put_scenario_version(database, manifest.scenario);
  const ScenarioText here = get_scenario_version(database, id);
  if (here.name != manifest.scenario.name || here.version != manifest.scenario.version) {
    refuse(manifest.header.id, "calls its scenario by another name than this directory does");
  }
  return id;
}

struct Placed {
  std::int64_t origin = 0;
  ScenarioVersionId scenario;
  std::optional<PersonId> person;
  Digest manifest;
};

std::int64_t insert_header(Database& database, const Manifest& manifest, const Placed& placed) {
  const AttemptHeader& header = manifest.header;
  std::optional<std::string> quality;
  std::optional<bool> is_valid;
  if (header.seal) {
    quality = header.quality_json;
    is_valid = is_valid_by(header.quality_json);
  }
  // A void one is set so by the decision that voided it.
  const auto state = header.seal ? AttemptState::Closed : AttemptState::Interrupted;
  execute(database,
          "INSERT INTO attempt (uuid, scenario_version_id, person_id, hand, seed, device_class, "
          "pacing, stereo_mode, bone_digest, engine_version, started_utc, kind, guidance, "
          "is_simulated, state, duration_ticks, quality_json, seal, is_valid, origin_id, "
          "manifest_digest) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
          header.id, placed.scenario, placed.person, header.begun.hand,
          static_cast<std::int64_t>(header.begun.seed), header.begun.device_class,
          header.begun.pacing, header.begun.stereo_mode, header.begun.bone, header.begun.engine,
          header.started_utc, name_of(header.begun.kind), name_of(header.begun.guidance),
          header.is_simulated, name_of(state), header.seal ? header.duration_ticks : std::nullopt,
          quality, header.seal, is_valid, placed.origin, placed.manifest);
  return database.connection().getLastInsertRowid();
}

void insert_chunks(Database& database, std::int64_t number, const ImportedAttempt& attempt) {
  auto insert = prepared(database,
                         "INSERT INTO chunk (attempt_id, seq, stream, first_tick, row_count, "
                         "bytes, link) VALUES (?, ?, ?, ?, ?, ?, ?)");
  ChunkPacker packer;
  std::vector<std::byte> payload_bytes;
  Columns tape;
  std::int64_t tape_window = -1;
  Digest link;
  visit_chunks(attempt.tables.recording, attempt.tables.places,
               [&](const ChunkPlace& place, const auto& rows) {
                 const Columns columns = columns_from(rows);
                 const std::span<const std::byte> payload = payload_in(payload_bytes, columns);
                 const bool is_beside_tape =
                     place.stream == Stream::Sample && tape_window == place.seq;
                 const std::vector<std::byte> bytes =
                     packer.pack(columns, payload, is_beside_tape ? &tape : nullptr);
                 link = link_of(link, attempt.manifest.header.id, place, payload);
                 run_again(insert, number, place.seq, static_cast<int>(place.stream),
                           place.first_tick, place.row_count, bytes, link);
                 if (place.stream != Stream::Tape) return;
                 tape = columns;
                 tape_window = place.seq;
               });
}

/// Scores and decisions in the order in which they came to be there: a decision is about the score
/// in force.
void replay_results(Database& database, const Manifest& manifest, std::int64_t origin,
                    PersonId by) {
  const AttemptId& id = manifest.header.id;
  std::size_t stored = 0;
  const auto store_up_to = [&](std::size_t count) {
    for (; stored < count; ++stored) {
      store_score_as_it_was(database, id, card_from_json(manifest.scores[stored].card_json), by);
    }
  };
  for (const ExportedDecision& decision : manifest.decisions) {
    if (decision.about) store_up_to(*decision.about + 1);
    const PersonId decider = note_origin_person(database, origin, decision.decided_by);
    decide(database, {id, decision.kind, decision.score_milli.value_or(0), reason_there}, decider);
    if (load_header(database, id).decided_milli != decision.score_milli) {
      refuse(id, "was confirmed with another score than the one that stood");
    }
  }
  store_up_to(manifest.scores.size());
}

Placed place(Database& database, const ImportedAttempt& attempt) {
  const Manifest& manifest = attempt.manifest;
  Placed placed;
  placed.scenario = put_scenario(database, manifest);
  put_asset(database, "bone", attempt.bone);
  placed.manifest = put_asset(
      database, "manifest",
      std::as_bytes(std::span{attempt.manifest_text.data(), attempt.manifest_text.size()}));
  placed.origin = note_origin(database, manifest.directory);
  if (manifest.header.begun.person) {
    const PersonId there = *manifest.header.begun.person;
    placed.person = note_origin_person(database, placed.origin, there);
    refuse_erased(database, placed.origin, there);
  }
  return placed;
}

std::optional<PersonId> person_there(Database& database, const AttemptId& id) {
  return found<PersonId>(database,
                         "SELECT p.number_there FROM attempt a JOIN origin_person p ON "
                         "p.origin_id = a.origin_id AND p.person_id = a.person_id WHERE a.uuid = ?",
                         id.text);
}

bool has_same_facts(const AttemptHeader& here, const AttemptHeader& there) {
  const NewAttempt &a = here.begun, &b = there.begun;
  return here.seal == there.seal && here.duration_ticks == there.duration_ticks &&
         here.quality_json == there.quality_json && here.started_utc == there.started_utc &&
         here.is_simulated == there.is_simulated && here.scenario_digest == there.scenario_digest &&
         a.hand == b.hand && a.seed == b.seed && a.device_class == b.device_class &&
         a.pacing == b.pacing && a.stereo_mode == b.stereo_mode && a.bone == b.bone &&
         a.engine == b.engine && a.kind == b.kind && a.guidance == b.guidance;
}

}  // namespace

bool is_here(Database& database, const ImportedAttempt& attempt) {
  const AttemptId& id = attempt.manifest.header.id;
  return translating(database, "look for attempt " + id.text, [&] {
    const auto here = identity_here(database, id);
    if (!here) return false;
    const auto& seal = attempt.manifest.header.seal;
    if (here->seal == seal && here->last_link == attempt.manifest.last_link) return true;
    refuse(id, "is in " + database.file().string() +
                   " already, and is another one there; one of the two was altered");
  });
}

void store_imported(Database& database, const ImportedAttempt& attempt,
                    const std::optional<ScoreCard>& rescored, PersonId by) {
  const Manifest& manifest = attempt.manifest;
  const AttemptId& id = manifest.header.id;
  in_transaction_of_caller(database, "import attempt " + id.text, [&] {
    if (is_here(database, attempt)) return;
    const Placed placed = place(database, attempt);
    const std::int64_t number = insert_header(database, manifest, placed);
    insert_chunks(database, number, attempt);
    store_display_facts(database, number, attempt.display_facts);
    append_audit(database,
                 {by, "attempt_imported", "attempt", id.text, false, placed.manifest, ""});
    replay_results(database, manifest, placed.origin, by);
    if (rescored) store_score(database, id, *rescored, by);
    if (load_header(database, id).state != manifest.header.state) {
      refuse(id, "has another state than its decisions give it");
    }
  });
}

void check_imported(Database& database, const AuditEntry& entry) {
  const AttemptHeader here = load_header(database, {entry.subject_id});
  const auto fail = [&](const char* what) {
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        std::string{what} + " of the imported attempt " + here.id.text + " in " +
                            database.file().string() + " was altered; restore a backup"};
  };
  auto row = prepared(database,
                      "SELECT a.manifest_digest, o.directory_uuid FROM attempt a LEFT JOIN "
                      "origin o USING (origin_id) WHERE a.uuid = ?",
                      here.id.text);
  row.executeStep();
  const auto digest = digest_in(row.getColumn(0));
  if (!digest || digest != entry.detail) fail("the manifest");
  const std::vector<std::byte> bytes = get_asset(database, *digest);
  const Manifest there =
      manifest_from_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (row.getColumn(1).getString() != there.directory.text) fail("the origin");
  // An older program took what nothing vouched for as it was; its rows are accounted for since.
  if (!has_same_facts(here, there.header) && !has_same_facts(here, taken_of(there).manifest.header))
    fail("a fact");
  if (person_there(database, here.id) != there.header.begun.person ||
      here.begun.person.has_value() != there.header.begun.person.has_value()) {
    fail("the person");
  }
}

}  // namespace hallux::database
