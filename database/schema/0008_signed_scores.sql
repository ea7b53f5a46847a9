-- A signature belongs to the score that it was about: points, gates, safety and rubric of the result that stands are that
-- score's. Where the machine scored anew since, the result is no grade until it is signed anew (docs/data_format.md).
DROP VIEW attempt_result;
CREATE VIEW attempt_result AS
SELECT a.attempt_id, a.person_id, v.name AS scenario_name, a.device_class, a.started_utc, a.kind = 'assessment' AS is_assessment,
  a.state <> 'void' AND coalesce(a.is_valid, 1) = 1 AND coalesce(o.is_accepted, 1) = 1 AS counts,
  a.state = 'closed' AND coalesce(a.is_valid, 0) = 1 AND coalesce(o.is_accepted, 1) = 1 AND a.kind = 'assessment'
    AND a.hand = '' AND a.is_simulated = 0 AND coalesce(r.score_id = f.score_id, 0) AND (coalesce(r.kind, '') = 'overridden'
    OR (coalesce(r.kind, '') = 'confirmed' AND s.measured_weight_milli >= 100000)) AS is_confirmed,
  coalesce(r.score_milli, s.score_milli) AS milli, s.rubric_version, s.measured_weight_milli, s.rubric_milli, s.is_gated,
  s.safety_measured_milli, s.safety_earned_milli
FROM attempt a JOIN scenario_version v USING (scenario_version_id)
LEFT JOIN decision r ON r.attempt_id = a.attempt_id AND r.superseded_by IS NULL
LEFT JOIN score f ON f.attempt_id = a.attempt_id AND f.superseded_by IS NULL
LEFT JOIN score s ON s.score_id = coalesce(r.score_id, f.score_id)
LEFT JOIN origin o ON o.origin_id = a.origin_id;
DELETE FROM standing;
INSERT INTO standing SELECT person_id, scenario_name, device_class, attempts, assessments, best_milli, last_milli,
  last_scored_utc, last_started_utc, confirmed_milli, runs FROM standing_as_counted;
