-- What an attempt measured, so that a change of knots, weights or gates scores it anew without following its recording.
-- A set is of one recording (its seal), one plan and one version of the metrics; its digest is that of its rows in their
-- order (docs/data_format.md), and its act in the audit accounts for the set. A value that there is none of is NULL.
CREATE TABLE measurement_set (
  measurement_set_id INTEGER PRIMARY KEY AUTOINCREMENT,
  attempt_id         INTEGER NOT NULL REFERENCES attempt (attempt_id),
  seal               BLOB NOT NULL CHECK (length(seal) = 32),
  plan_digest        BLOB NOT NULL CHECK (length(plan_digest) = 32),
  metrics_version    INTEGER NOT NULL CHECK (metrics_version > 0),
  digest             BLOB NOT NULL CHECK (length(digest) = 32),
  stored_utc         TEXT NOT NULL
) STRICT;
CREATE INDEX measurement_set_of_attempt ON measurement_set (attempt_id);

CREATE TABLE measurement (
  measurement_set_id INTEGER NOT NULL REFERENCES measurement_set (measurement_set_id),
  line               INTEGER NOT NULL CHECK (line >= 0),
  metric             TEXT NOT NULL,
  cut                TEXT NOT NULL,
  hinge              TEXT NOT NULL,
  zone               TEXT NOT NULL,
  value              REAL,
  absence            TEXT NOT NULL,
  done_fraction      REAL NOT NULL,
  bound              REAL NOT NULL,
  direction          TEXT NOT NULL,
  detail_json        TEXT NOT NULL,
  remark             TEXT NOT NULL,
  start_us           INTEGER NOT NULL,
  end_us             INTEGER NOT NULL,
  x_in_bone_mm       REAL NOT NULL,
  y_in_bone_mm       REAL NOT NULL,
  z_in_bone_mm       REAL NOT NULL,
  UNIQUE (measurement_set_id, line)
) STRICT;

CREATE TRIGGER measurement_set_is_never_altered BEFORE UPDATE ON measurement_set
BEGIN SELECT RAISE(ABORT, 'measurements are only added to'); END;
CREATE TRIGGER measurement_set_is_never_deleted BEFORE DELETE ON measurement_set
BEGIN SELECT RAISE(ABORT, 'measurements are only added to'); END;
CREATE TRIGGER measurement_is_never_altered BEFORE UPDATE ON measurement
BEGIN SELECT RAISE(ABORT, 'measurements are only added to'); END;
CREATE TRIGGER measurement_is_never_deleted BEFORE DELETE ON measurement
BEGIN SELECT RAISE(ABORT, 'measurements are only added to'); END;
