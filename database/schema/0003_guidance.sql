-- How firmly the planned plane led the hand in an attempt; in an assessment nothing helps. Before this column nothing did.

ALTER TABLE attempt ADD COLUMN guidance TEXT NOT NULL DEFAULT 'none'
  CHECK (guidance IN ('none', 'soft', 'slot') AND (guidance = 'none' OR kind = 'practice'));
