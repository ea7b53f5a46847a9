-- The record kept for years: an identity of the directory, a guard at the sign-in, what people are told, limits of attempts,
-- where imported attempts come from, what was erased; and the indices that a course of a thousand people needs.

-- One row: this directory, so that an export says where it comes from and a backup's erasures name the right people.
CREATE TABLE directory (
  directory_id INTEGER PRIMARY KEY CHECK (directory_id = 1),
  uuid         TEXT NOT NULL CHECK (length(uuid) = 32),
  made_utc     TEXT NOT NULL
) STRICT;
INSERT INTO directory VALUES (1, lower(hex(randomblob(16))), strftime('%Y-%m-%dT%H:%M:%fZ', 'now'));
CREATE TRIGGER directory_stays_itself BEFORE UPDATE ON directory
BEGIN SELECT RAISE(ABORT, 'a directory keeps its identity'); END;
CREATE TRIGGER directory_is_never_deleted BEFORE DELETE ON directory
BEGIN SELECT RAISE(ABORT, 'a directory keeps its identity'); END;

-- Refused sign-ins in a row, by a digest of the login (known or not) and of the station: how long the next one waits.
CREATE TABLE sign_in_guard (
  account    BLOB NOT NULL CHECK (length(account) = 32),
  station    BLOB NOT NULL CHECK (length(station) = 32),
  failures   INTEGER NOT NULL CHECK (failures > 0),
  failed_utc TEXT NOT NULL,
  PRIMARY KEY (account, station)
) STRICT;
CREATE INDEX sign_in_guard_of_station ON sign_in_guard (station);
CREATE INDEX sign_in_guard_by_age ON sign_in_guard (failed_utc);

-- What is told at the next sign-in: to one person, or to every administrator where person_id is null.
CREATE TABLE notice (
  notice_id INTEGER PRIMARY KEY AUTOINCREMENT,
  person_id INTEGER REFERENCES person (person_id),
  kind      TEXT NOT NULL,
  about_id  INTEGER,
  at_utc    TEXT NOT NULL
) STRICT;
CREATE INDEX notice_of_person ON notice (person_id);
CREATE TABLE notice_seen (
  notice_id INTEGER NOT NULL REFERENCES notice (notice_id),
  person_id INTEGER NOT NULL REFERENCES person (person_id),
  seen_utc  TEXT NOT NULL,
  PRIMARY KEY (notice_id, person_id)
) STRICT;

-- How many valid assessments of an operation a cohort's trainee has; without a row as many as they like.
CREATE TABLE attempt_limit (
  cohort_id         INTEGER NOT NULL REFERENCES cohort (cohort_id),
  scenario_name     TEXT NOT NULL,
  attempts_max      INTEGER NOT NULL CHECK (attempts_max > 0),
  set_by_person_id  INTEGER NOT NULL REFERENCES person (person_id),
  set_utc           TEXT NOT NULL,
  PRIMARY KEY (cohort_id, scenario_name)
) STRICT;

-- Another directory that attempts were imported from; they count only where an administrator accepted it.
CREATE TABLE origin (
  origin_id      INTEGER PRIMARY KEY AUTOINCREMENT,
  directory_uuid TEXT NOT NULL UNIQUE CHECK (length(directory_uuid) = 32),
  is_accepted    INTEGER NOT NULL DEFAULT 0 CHECK (is_accepted IN (0, 1)),
  imported_utc   TEXT NOT NULL
) STRICT;
-- A person of an origin is a person without details here.
CREATE TABLE origin_person (
  origin_id    INTEGER NOT NULL REFERENCES origin (origin_id),
  number_there INTEGER NOT NULL,
  person_id    INTEGER NOT NULL UNIQUE REFERENCES person (person_id),
  PRIMARY KEY (origin_id, number_there)
) STRICT;
ALTER TABLE attempt ADD COLUMN origin_id INTEGER REFERENCES origin (origin_id);
-- The manifest that an imported attempt came with, kept verbatim so that it can be exported again as it came.
ALTER TABLE attempt ADD COLUMN manifest_digest BLOB REFERENCES asset (digest);
-- Whether it may be graded: what its quality certificate says, judged when it was sealed; null before that.
ALTER TABLE attempt ADD COLUMN is_valid INTEGER CHECK (is_valid IN (0, 1));
UPDATE attempt SET is_valid = CASE WHEN json_valid(quality_json) AND json_extract(quality_json, '$.complete') = 1 THEN 1 ELSE 0 END
WHERE seal IS NOT NULL;

-- A recording that was erased: its chunks are gone, its seal and last link stay, and the audit says since when.
CREATE TABLE erased_recording (
  attempt_id INTEGER PRIMARY KEY REFERENCES attempt (attempt_id),
  last_link  BLOB CHECK (length(last_link) = 32),
  windows    INTEGER NOT NULL,
  erased_utc TEXT NOT NULL
) STRICT;
-- People whose details were erased here.
CREATE TABLE erasure (
  person_id  INTEGER PRIMARY KEY REFERENCES person (person_id),
  erased_utc TEXT NOT NULL
) STRICT;

-- What an administrator set for the whole directory, by name; what has no row is as the program ships it.
CREATE TABLE setting (
  name    TEXT PRIMARY KEY,
  value   TEXT NOT NULL,
  set_utc TEXT NOT NULL
) STRICT;

CREATE INDEX chunk_by_tick ON chunk (attempt_id, stream, first_tick);
CREATE INDEX attempt_of_scenario ON attempt (scenario_version_id, person_id);
CREATE INDEX attempt_by_start ON attempt (started_utc);
CREATE INDEX score_of_attempt ON score (attempt_id);
CREATE INDEX decision_of_attempt ON decision (attempt_id);
CREATE INDEX membership_of_cohort ON membership (cohort_id, role);
CREATE INDEX audit_refused ON audit (audit_id) WHERE outcome = 'refused';
