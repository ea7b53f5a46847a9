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

-- What a card says about passing, read from it when it is stored: a cohort's grid must not open a thousand cards.
ALTER TABLE score ADD COLUMN rubric_milli INTEGER;
ALTER TABLE score ADD COLUMN is_gated INTEGER;
ALTER TABLE score ADD COLUMN safety_measured_milli INTEGER;
ALTER TABLE score ADD COLUMN safety_earned_milli INTEGER;
-- A trigger that read them would be refused: with trusted_schema off no view and no trigger may call json_extract.
UPDATE score SET rubric_milli = json_extract(card_json, '$.rubric_milli'),
  is_gated = EXISTS (SELECT 1 FROM json_each(card_json, '$.gates') WHERE json_extract(value, '$.is_triggered')),
  safety_measured_milli = (SELECT coalesce(sum(json_extract(value, '$.measured_milli')), 0)
    FROM json_each(card_json, '$.groups') WHERE json_extract(value, '$.name') = 'safety'),
  safety_earned_milli = (SELECT coalesce(sum(json_extract(value, '$.earned_milli')), 0)
    FROM json_each(card_json, '$.groups') WHERE json_extract(value, '$.name') = 'safety')
WHERE json_valid(card_json);

-- Each attempt with the result that stands: an instructor's before the machine's. It counts unless it is void, not valid, or
-- of another directory that is not accepted; it is confirmed where it is a grade (docs/data_format.md).
CREATE VIEW attempt_result AS
SELECT a.attempt_id, a.person_id, v.name AS scenario_name, a.device_class, a.started_utc, a.kind = 'assessment' AS is_assessment,
  a.state <> 'void' AND coalesce(a.is_valid, 1) = 1 AND coalesce(o.is_accepted, 1) = 1 AS counts,
  a.state = 'closed' AND coalesce(a.is_valid, 0) = 1 AND coalesce(o.is_accepted, 1) = 1 AND a.kind = 'assessment'
    AND a.hand = '' AND a.is_simulated = 0 AND (coalesce(r.kind, '') = 'overridden'
    OR (coalesce(r.kind, '') = 'confirmed' AND s.measured_weight_milli >= 100000)) AS is_confirmed,
  coalesce(r.score_milli, s.score_milli) AS milli, s.rubric_version, s.measured_weight_milli, s.rubric_milli, s.is_gated,
  s.safety_measured_milli, s.safety_earned_milli
FROM attempt a JOIN scenario_version v USING (scenario_version_id)
LEFT JOIN score s ON s.attempt_id = a.attempt_id AND s.superseded_by IS NULL
LEFT JOIN decision r ON r.attempt_id = a.attempt_id AND r.superseded_by IS NULL
LEFT JOIN origin o ON o.origin_id = a.origin_id;

-- How each person stands in each operation, by device class. A cache: triggers keep it as standing_as_counted says.
-- `runs` are the scored assessments that count, oldest first, with blanks between: second of the start/rubric version/points
-- that stand/points measured/points of the rubric/gated/safety points measured/safety points earned.
CREATE TABLE standing (
  person_id        INTEGER NOT NULL REFERENCES person (person_id),
  scenario_name    TEXT NOT NULL,
  device_class     TEXT NOT NULL,
  attempts         INTEGER NOT NULL,
  assessments      INTEGER NOT NULL,
  best_milli       INTEGER,
  last_milli       INTEGER,
  last_scored_utc  TEXT,
  last_started_utc TEXT NOT NULL,
  confirmed_milli  INTEGER,
  runs             TEXT NOT NULL,
  UNIQUE (person_id, scenario_name, device_class)
) STRICT;
CREATE INDEX standing_confirmed ON standing (scenario_name, device_class, person_id) WHERE confirmed_milli IS NOT NULL;

CREATE VIEW standing_as_counted AS
SELECT e.person_id, e.scenario_name, e.device_class, count(*) AS attempts, sum(e.counts AND e.is_assessment) AS assessments,
  max(CASE WHEN e.counts THEN e.milli END) AS best_milli,
  (SELECT i.milli FROM attempt_result i WHERE i.person_id = e.person_id AND i.scenario_name = e.scenario_name
   AND i.device_class = e.device_class AND i.counts AND i.milli IS NOT NULL
   ORDER BY i.started_utc DESC, i.attempt_id DESC LIMIT 1) AS last_milli,
  max(CASE WHEN e.counts AND e.milli IS NOT NULL THEN e.started_utc END) AS last_scored_utc,
  max(e.started_utc) AS last_started_utc,
  (SELECT i.milli FROM attempt_result i WHERE i.person_id = e.person_id AND i.scenario_name = e.scenario_name
   AND i.device_class = e.device_class AND i.is_confirmed
   ORDER BY i.started_utc DESC, i.attempt_id DESC LIMIT 1) AS confirmed_milli,
  coalesce((SELECT group_concat(run, ' ') FROM (SELECT printf('%d/%d/%d/%d/%d/%d/%d/%d', unixepoch(i.started_utc),
     i.rubric_version, i.milli, i.measured_weight_milli, i.rubric_milli, i.is_gated, i.safety_measured_milli,
     i.safety_earned_milli) AS run
   FROM attempt_result i WHERE i.person_id = e.person_id AND i.scenario_name = e.scenario_name
   AND i.device_class = e.device_class AND i.counts AND i.is_assessment AND i.rubric_version IS NOT NULL
   ORDER BY i.started_utc, i.attempt_id)), '') AS runs
FROM attempt_result e WHERE e.person_id IS NOT NULL
GROUP BY e.person_id, e.scenario_name, e.device_class;

-- Whoever inserts a person, an operation and a device class here has that row of `standing` counted anew.
CREATE VIEW standing_to_mend AS SELECT person_id, scenario_name, device_class FROM standing;
CREATE TRIGGER standing_is_mended INSTEAD OF INSERT ON standing_to_mend WHEN NEW.person_id IS NOT NULL BEGIN
  DELETE FROM standing WHERE person_id = NEW.person_id AND scenario_name = NEW.scenario_name AND device_class = NEW.device_class;
  INSERT INTO standing SELECT person_id, scenario_name, device_class, attempts, assessments, best_milli, last_milli,
    last_scored_utc, last_started_utc, confirmed_milli, runs FROM standing_as_counted
  WHERE person_id = NEW.person_id AND scenario_name = NEW.scenario_name AND device_class = NEW.device_class;
END;
CREATE TRIGGER standing_after_attempt AFTER INSERT ON attempt BEGIN
  INSERT INTO standing_to_mend SELECT NEW.person_id, name, NEW.device_class FROM scenario_version
  WHERE scenario_version_id = NEW.scenario_version_id;
END;
CREATE TRIGGER standing_after_change AFTER UPDATE OF scenario_version_id, person_id, hand, device_class, started_utc, state,
    kind, is_simulated, origin_id, is_valid ON attempt BEGIN
  INSERT INTO standing_to_mend SELECT OLD.person_id, name, OLD.device_class FROM scenario_version
  WHERE scenario_version_id = OLD.scenario_version_id;
  INSERT INTO standing_to_mend SELECT NEW.person_id, name, NEW.device_class FROM scenario_version
  WHERE scenario_version_id = NEW.scenario_version_id;
END;
CREATE TRIGGER standing_after_loss AFTER DELETE ON attempt BEGIN
  INSERT INTO standing_to_mend SELECT OLD.person_id, name, OLD.device_class FROM scenario_version
  WHERE scenario_version_id = OLD.scenario_version_id;
END;
CREATE TRIGGER standing_after_score AFTER INSERT ON score BEGIN
  INSERT INTO standing_to_mend SELECT person_id, scenario_name, device_class FROM attempt_result
  WHERE attempt_id = NEW.attempt_id;
END;
CREATE TRIGGER standing_after_succession AFTER UPDATE OF superseded_by ON score BEGIN
  INSERT INTO standing_to_mend SELECT person_id, scenario_name, device_class FROM attempt_result
  WHERE attempt_id = NEW.attempt_id;
END;
CREATE TRIGGER standing_after_lost_score AFTER DELETE ON score BEGIN
  INSERT INTO standing_to_mend SELECT person_id, scenario_name, device_class FROM attempt_result
  WHERE attempt_id = OLD.attempt_id;
END;
CREATE TRIGGER standing_after_decision AFTER INSERT ON decision BEGIN
  INSERT INTO standing_to_mend SELECT person_id, scenario_name, device_class FROM attempt_result
  WHERE attempt_id = NEW.attempt_id;
END;
CREATE TRIGGER standing_after_later_decision AFTER UPDATE OF superseded_by ON decision BEGIN
  INSERT INTO standing_to_mend SELECT person_id, scenario_name, device_class FROM attempt_result
  WHERE attempt_id = NEW.attempt_id;
END;
CREATE TRIGGER standing_after_acceptance AFTER UPDATE OF is_accepted ON origin BEGIN
  INSERT INTO standing_to_mend SELECT DISTINCT e.person_id, e.scenario_name, e.device_class
  FROM attempt a JOIN attempt_result e USING (attempt_id) WHERE a.origin_id = NEW.origin_id;
END;
CREATE INDEX attempt_of_origin ON attempt (origin_id) WHERE origin_id IS NOT NULL;
INSERT INTO standing SELECT person_id, scenario_name, device_class, attempts, assessments, best_milli, last_milli,
  last_scored_utc, last_started_utc, confirmed_milli, runs FROM standing_as_counted;

-- What a cohort's trainees are told of each other: counts and quartiles of an operation by one device class, made anew only
-- where five people's results differ from the last time, so that two figures cannot be subtracted to learn one person's.
CREATE TABLE cohort_snapshot (
  cohort_id     INTEGER NOT NULL REFERENCES cohort (cohort_id),
  scenario_name TEXT NOT NULL,
  device_class  TEXT NOT NULL,
  made_utc      TEXT NOT NULL,
  PRIMARY KEY (cohort_id, scenario_name, device_class)
) STRICT;
CREATE TABLE cohort_snapshot_result (
  cohort_id     INTEGER NOT NULL,
  scenario_name TEXT NOT NULL,
  device_class  TEXT NOT NULL,
  person_id     INTEGER NOT NULL REFERENCES person (person_id),
  milli         INTEGER NOT NULL,
  PRIMARY KEY (cohort_id, scenario_name, device_class, person_id),
  FOREIGN KEY (cohort_id, scenario_name, device_class) REFERENCES cohort_snapshot (cohort_id, scenario_name, device_class)
) STRICT;
