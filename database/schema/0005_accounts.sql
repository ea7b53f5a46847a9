-- What each act of the audit left: the digest of each row that it changed, or that the row is gone. From the first act
-- named baseline_taken on the rows of an act are in its link, in the order of `place`; the newest digest of a row is what
-- the row must be. docs/data_format.md says how a row is digested.
CREATE TABLE audit_row (
  audit_id   INTEGER NOT NULL REFERENCES audit (audit_id),
  place      INTEGER NOT NULL,
  table_name TEXT NOT NULL,
  row_key    TEXT NOT NULL,
  row_digest BLOB CHECK (length(row_digest) = 32),
  PRIMARY KEY (audit_id, place)
) STRICT, WITHOUT ROWID;
CREATE INDEX audit_row_of_row ON audit_row (table_name, row_key);
CREATE TRIGGER audit_row_is_never_altered BEFORE UPDATE ON audit_row
BEGIN SELECT RAISE(ABORT, 'the audit is only added to'); END;
CREATE TRIGGER audit_row_is_never_deleted BEFORE DELETE ON audit_row
BEGIN SELECT RAISE(ABORT, 'the audit is only added to'); END;

-- Of rows that hold names and words: a digest without it could be guessed. It is made anew with each change, and goes
-- with the row.
CREATE TABLE row_salt (
  table_name TEXT NOT NULL,
  row_key    TEXT NOT NULL,
  salt       BLOB NOT NULL CHECK (length(salt) = 16),
  PRIMARY KEY (table_name, row_key)
) STRICT, WITHOUT ROWID;
