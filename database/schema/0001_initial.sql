-- Units are the last word of a column's name. Texts ending in _utc are ISO 8601 with milliseconds and a Z.
-- docs/data_format.md says what each row means and what is valid after a crash.

CREATE TABLE person (
  person_id        INTEGER PRIMARY KEY AUTOINCREMENT,
  is_administrator INTEGER NOT NULL CHECK (is_administrator IN (0, 1)),
  is_disabled      INTEGER NOT NULL DEFAULT 0 CHECK (is_disabled IN (0, 1)),
  created_utc      TEXT NOT NULL
) STRICT;

-- All that names a person; erasing a person deletes this row and keeps the number.
CREATE TABLE person_detail (
  person_id    INTEGER PRIMARY KEY REFERENCES person (person_id),
  login        TEXT NOT NULL UNIQUE,
  display_name TEXT NOT NULL
) STRICT;

CREATE TABLE password (
  person_id   INTEGER PRIMARY KEY REFERENCES person (person_id),
  argon2id    TEXT NOT NULL,
  changed_utc TEXT NOT NULL
) STRICT;

CREATE TABLE session (
  session_id  INTEGER PRIMARY KEY AUTOINCREMENT,
  person_id   INTEGER NOT NULL REFERENCES person (person_id),
  started_utc TEXT NOT NULL,
  ended_utc   TEXT
) STRICT;

CREATE TABLE cohort (
  cohort_id   INTEGER PRIMARY KEY AUTOINCREMENT,
  name        TEXT NOT NULL UNIQUE,
  created_utc TEXT NOT NULL
) STRICT;

CREATE TABLE membership (
  cohort_id INTEGER NOT NULL REFERENCES cohort (cohort_id),
  person_id INTEGER NOT NULL REFERENCES person (person_id),
  role      TEXT NOT NULL CHECK (role IN ('trainee', 'instructor')),
  PRIMARY KEY (cohort_id, person_id)
) STRICT;
CREATE INDEX membership_of_person ON membership (person_id);

CREATE TABLE scenario_version (
  scenario_version_id INTEGER PRIMARY KEY,
  name        TEXT NOT NULL,
  version     INTEGER NOT NULL,
  json        TEXT NOT NULL,
  digest      BLOB NOT NULL UNIQUE CHECK (length(digest) = 32),
  is_reviewed INTEGER NOT NULL CHECK (is_reviewed IN (0, 1)),
  stored_utc  TEXT NOT NULL
) STRICT;

-- The digest is that of the plain bytes, so that the same bone is stored once however it was packed.
CREATE TABLE asset (
  asset_id    INTEGER PRIMARY KEY,
  digest      BLOB NOT NULL UNIQUE CHECK (length(digest) = 32),
  kind        TEXT NOT NULL,
  plain_bytes INTEGER NOT NULL,
  zstd        BLOB NOT NULL
) STRICT;

CREATE TABLE attempt (
  attempt_id          INTEGER PRIMARY KEY AUTOINCREMENT,
  uuid                TEXT NOT NULL UNIQUE,
  scenario_version_id INTEGER NOT NULL REFERENCES scenario_version (scenario_version_id),
  person_id           INTEGER REFERENCES person (person_id),
  hand                TEXT NOT NULL,
  seed                INTEGER NOT NULL,
  device_class        TEXT NOT NULL,
  pacing              TEXT NOT NULL,
  stereo_mode         TEXT NOT NULL,
  bone_digest         BLOB NOT NULL REFERENCES asset (digest),
  engine_version      INTEGER NOT NULL,
  started_utc         TEXT NOT NULL,
  state               TEXT NOT NULL CHECK (state IN ('recording', 'closed', 'interrupted', 'void')),
  duration_ticks      INTEGER,
  quality_json        TEXT,
  seal                BLOB CHECK (length(seal) = 32),
  CHECK (state <> 'closed' OR (duration_ticks IS NOT NULL AND quality_json IS NOT NULL AND seal IS NOT NULL))
) STRICT;
CREATE INDEX attempt_of_person ON attempt (person_id, attempt_id);
CREATE INDEX attempt_being_recorded ON attempt (state) WHERE state = 'recording';

-- A rowid table: WITHOUT ROWID wastes half a page for each blob of this size (measured).
CREATE TABLE chunk (
  chunk_id   INTEGER PRIMARY KEY,
  attempt_id INTEGER NOT NULL REFERENCES attempt (attempt_id),
  seq        INTEGER NOT NULL,
  stream     INTEGER NOT NULL CHECK (stream IN (0, 1, 2)),
  first_tick INTEGER NOT NULL,
  row_count  INTEGER NOT NULL CHECK (row_count > 0),
  bytes      BLOB NOT NULL,
  link       BLOB NOT NULL CHECK (length(link) = 32),
  UNIQUE (attempt_id, seq, stream)
) STRICT;

CREATE TABLE score (
  score_id              INTEGER PRIMARY KEY AUTOINCREMENT,
  attempt_id            INTEGER NOT NULL REFERENCES attempt (attempt_id),
  scenario_version      INTEGER NOT NULL,
  rubric_version        INTEGER NOT NULL,
  engine_version        INTEGER NOT NULL,
  score_milli           INTEGER NOT NULL,
  measured_weight_milli INTEGER NOT NULL,
  card_json             TEXT NOT NULL,
  stored_utc            TEXT NOT NULL,
  superseded_by         INTEGER REFERENCES score (score_id)
) STRICT;
CREATE UNIQUE INDEX score_in_force ON score (attempt_id) WHERE superseded_by IS NULL;

CREATE TRIGGER score_is_superseded_not_overwritten
BEFORE UPDATE OF score_id, attempt_id, scenario_version, rubric_version, engine_version, score_milli,
                 measured_weight_milli, card_json, stored_utc ON score
BEGIN SELECT RAISE(ABORT, 'a stored score is superseded, never overwritten'); END;

-- Holds numbers, uuids and digests only: names and free text live in tables that can be erased.
CREATE TABLE audit (
  audit_id        INTEGER PRIMARY KEY,
  at_utc          TEXT NOT NULL,
  actor_person_id INTEGER,
  action          TEXT NOT NULL,
  subject_kind    TEXT NOT NULL,
  subject_id      TEXT NOT NULL,
  outcome         TEXT NOT NULL CHECK (outcome IN ('done', 'refused')),
  detail_digest   BLOB CHECK (length(detail_digest) = 32),
  link            BLOB NOT NULL CHECK (length(link) = 32)
) STRICT;

CREATE TABLE audit_text (
  audit_id INTEGER PRIMARY KEY REFERENCES audit (audit_id),
  salt     BLOB NOT NULL,
  text     TEXT NOT NULL
) STRICT;

CREATE TRIGGER audit_is_never_altered BEFORE UPDATE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit is only added to'); END;
CREATE TRIGGER audit_is_never_deleted BEFORE DELETE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit is only added to'); END;
