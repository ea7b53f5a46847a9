-- How somebody holds the saw, whatever device it is held by: from which side, and over what is set for the station how many
-- millimetres the saw goes for one of the hand and how much of the device's force is felt. NULL: as the station has it. Never
-- more force than the station allows: that is asked where both are known.
CREATE TABLE hand_setting (
  person_id          INTEGER PRIMARY KEY REFERENCES person (person_id),
  is_left_handed     INTEGER NOT NULL CHECK (is_left_handed IN (0, 1)),
  motion_scale_milli INTEGER CHECK (motion_scale_milli BETWEEN 250 AND 4000),
  force_share_milli  INTEGER CHECK (force_share_milli BETWEEN 0 AND 1000),
  changed_utc        TEXT NOT NULL
) STRICT;
