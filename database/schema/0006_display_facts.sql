-- What was on the screen while somebody operated, from `tick` on until the next row of the attempt. It is beside the
-- recording and no part of it: not scored, outside the seal, accounted for by no act; it goes with the recording.
-- `stereo`: 0 one picture, 1 side by side, 2 red and cyan. `layout`: 0 one picture, 1 with the section as an inset.
-- `lost_before` counts what found no room since the row before.
CREATE TABLE display_fact (
  attempt_id              INTEGER NOT NULL REFERENCES attempt (attempt_id),
  tick                    INTEGER NOT NULL CHECK (tick >= 0),
  target_x_in_world_um    INTEGER NOT NULL,
  target_y_in_world_um    INTEGER NOT NULL,
  target_z_in_world_um    INTEGER NOT NULL,
  rotation_w_micro        INTEGER NOT NULL,
  rotation_x_micro        INTEGER NOT NULL,
  rotation_y_micro        INTEGER NOT NULL,
  rotation_z_micro        INTEGER NOT NULL,
  magnification_milli     INTEGER NOT NULL CHECK (magnification_milli > 0),
  target_depth_um         INTEGER NOT NULL,
  width_over_height_milli INTEGER NOT NULL CHECK (width_over_height_milli > 0),
  stereo                  INTEGER NOT NULL CHECK (stereo >= 0),
  layout                  INTEGER NOT NULL CHECK (layout >= 0),
  lost_before             INTEGER NOT NULL CHECK (lost_before >= 0),
  PRIMARY KEY (attempt_id, tick)
) STRICT, WITHOUT ROWID;
