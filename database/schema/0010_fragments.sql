-- What a measurement is about may be a fragment or an implant. Rows of before are about neither, and their digests stay.
ALTER TABLE measurement ADD COLUMN fragment TEXT NOT NULL DEFAULT '';
ALTER TABLE measurement ADD COLUMN implant TEXT NOT NULL DEFAULT '';
