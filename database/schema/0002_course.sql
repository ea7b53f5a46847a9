-- The course: what an attempt was for, notes, help, what instructors decide, published scenarios, one-time codes.
-- Free text stands in columns of its own, so that it can be erased; the audit holds numbers and salted digests of it.

ALTER TABLE attempt ADD COLUMN kind TEXT NOT NULL DEFAULT 'practice' CHECK (kind IN ('practice', 'assessment'));
ALTER TABLE attempt ADD COLUMN is_simulated INTEGER NOT NULL DEFAULT 0 CHECK (is_simulated IN (0, 1));
-- Null where somebody was enrolled before this column was there.
ALTER TABLE membership ADD COLUMN enrolled_utc TEXT;

CREATE INDEX session_of_person ON session (person_id, started_utc);

-- At most one row, made before the first person: nobody in this directory is a person, nothing in it is a grade.
CREATE TABLE simulated_course (
  simulated_course_id INTEGER PRIMARY KEY CHECK (simulated_course_id = 1),
  marked_utc          TEXT NOT NULL
) STRICT;
CREATE TRIGGER simulated_course_stays_so BEFORE DELETE ON simulated_course
BEGIN SELECT RAISE(ABORT, 'a simulated course stays marked as such'); END;
CREATE TRIGGER simulated_course_is_marked_once BEFORE UPDATE ON simulated_course
BEGIN SELECT RAISE(ABORT, 'a simulated course stays marked as such'); END;

-- Lets a person choose a password, once and until it expires; the code itself is nowhere.
CREATE TABLE one_time_code (
  person_id           INTEGER PRIMARY KEY REFERENCES person (person_id),
  argon2id            TEXT NOT NULL,
  issued_by_person_id INTEGER NOT NULL REFERENCES person (person_id),
  issued_utc          TEXT NOT NULL,
  expires_utc         TEXT NOT NULL
) STRICT;

-- The newest row of a version is its state; a version without a row is no part of the catalogue, only operated once.
CREATE TABLE scenario_state (
  scenario_state_id   INTEGER PRIMARY KEY AUTOINCREMENT,
  scenario_version_id INTEGER NOT NULL REFERENCES scenario_version (scenario_version_id),
  state               TEXT NOT NULL CHECK (state IN ('draft', 'published', 'retired')),
  person_id           INTEGER NOT NULL REFERENCES person (person_id),
  since_utc           TEXT NOT NULL
) STRICT;
CREATE INDEX scenario_state_of_version ON scenario_state (scenario_version_id, scenario_state_id);

-- A moment of an attempt, with or without a place on a body (0: the bone as it was, 1...: pieces by number).
CREATE TABLE note (
  note_id          INTEGER PRIMARY KEY AUTOINCREMENT,
  attempt_id       INTEGER NOT NULL REFERENCES attempt (attempt_id),
  author_person_id INTEGER NOT NULL REFERENCES person (person_id),
  moment_us        INTEGER NOT NULL CHECK (moment_us >= 0),
  body             INTEGER CHECK (body >= 0),
  x_in_bone_mm     REAL,
  y_in_bone_mm     REAL,
  z_in_bone_mm     REAL,
  is_private       INTEGER NOT NULL CHECK (is_private IN (0, 1)),
  text             TEXT NOT NULL,
  written_utc      TEXT NOT NULL,
  CHECK ((body IS NULL) = (x_in_bone_mm IS NULL) AND (body IS NULL) = (y_in_bone_mm IS NULL)
         AND (body IS NULL) = (z_in_bone_mm IS NULL))
) STRICT;
CREATE INDEX note_of_attempt ON note (attempt_id, moment_us);

CREATE TABLE note_reply (
  note_reply_id    INTEGER PRIMARY KEY AUTOINCREMENT,
  note_id          INTEGER NOT NULL REFERENCES note (note_id),
  author_person_id INTEGER NOT NULL REFERENCES person (person_id),
  text             TEXT NOT NULL,
  written_utc      TEXT NOT NULL
) STRICT;
CREATE INDEX note_reply_of_note ON note_reply (note_id);
CREATE TRIGGER private_note_has_no_reply BEFORE INSERT ON note_reply
WHEN (SELECT is_private FROM note WHERE note_id = NEW.note_id) = 1
BEGIN SELECT RAISE(ABORT, 'a private note has no replies'); END;

-- Open until it was answered.
CREATE TABLE help_request (
  help_request_id       INTEGER PRIMARY KEY AUTOINCREMENT,
  attempt_id            INTEGER NOT NULL REFERENCES attempt (attempt_id),
  asker_person_id       INTEGER NOT NULL REFERENCES person (person_id),
  moment_us             INTEGER NOT NULL CHECK (moment_us >= 0),
  body                  INTEGER CHECK (body >= 0),
  x_in_bone_mm          REAL,
  y_in_bone_mm          REAL,
  z_in_bone_mm          REAL,
  question              TEXT NOT NULL,
  asked_utc             TEXT NOT NULL,
  answer                TEXT,
  answered_by_person_id INTEGER REFERENCES person (person_id),
  answered_utc          TEXT,
  CHECK ((body IS NULL) = (x_in_bone_mm IS NULL) AND (body IS NULL) = (y_in_bone_mm IS NULL)
         AND (body IS NULL) = (z_in_bone_mm IS NULL)),
  CHECK ((answered_utc IS NULL) = (answer IS NULL) AND (answered_utc IS NULL) = (answered_by_person_id IS NULL))
) STRICT;
CREATE INDEX help_request_of_attempt ON help_request (attempt_id);
CREATE INDEX help_request_of_asker ON help_request (asker_person_id);

-- What an instructor decided about a result. The machine's score stays in `score`; a later decision takes the place of
-- the one before and overwrites nothing.
CREATE TABLE decision (
  decision_id          INTEGER PRIMARY KEY AUTOINCREMENT,
  attempt_id           INTEGER NOT NULL REFERENCES attempt (attempt_id),
  kind                 TEXT NOT NULL CHECK (kind IN ('confirmed', 'overridden', 'voided')),
  score_id             INTEGER REFERENCES score (score_id),
  score_milli          INTEGER CHECK (score_milli BETWEEN 0 AND 100000),
  reason               TEXT NOT NULL,
  decided_by_person_id INTEGER NOT NULL REFERENCES person (person_id),
  decided_utc          TEXT NOT NULL,
  superseded_by        INTEGER REFERENCES decision (decision_id),
  CHECK ((kind = 'voided') = (score_milli IS NULL)),
  CHECK (kind = 'voided' OR score_id IS NOT NULL)
) STRICT;
CREATE UNIQUE INDEX decision_in_force ON decision (attempt_id) WHERE superseded_by IS NULL;
CREATE TRIGGER decision_is_superseded_not_overwritten
BEFORE UPDATE OF decision_id, attempt_id, kind, score_id, score_milli, decided_by_person_id, decided_utc ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is superseded, never overwritten'); END;
CREATE TRIGGER decision_is_never_deleted BEFORE DELETE ON decision
BEGIN SELECT RAISE(ABORT, 'a decision is superseded, never deleted'); END;
