/// What the result screen shows: what is stored, read at once, and the cut bone, which is computed again beside it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/desks/session.h"
#include "scenarios/scenario.h"
#include "ui/jobs/recording_quality.h"
#include "ui/render/scene/bone_mesh.h"
#include "ui/render/scene/scene.h"
#include "ui/report/traces.h"
#include "ui/screens/parts/attempt_desks.h"
#include "ui/screens/parts/attempt_timeline.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/window/shell/background.h"

namespace hallux::ui {

/// As it is stored; nothing of it was computed now.
struct ResultFacts {
  database::AttemptHeader header;
  std::optional<scenarios::Scenario> scenario;  ///< nothing where this version cannot read its text
  std::optional<database::StoredScore> score;   ///< in force; nothing: not scored yet
  std::vector<database::Decision> decisions;    ///< newest first
  AttemptRights rights;
  std::optional<Quality> quality;  ///< of the recording; nothing: it was not closed

  /// The decision in force, or null.
  const database::Decision* decision() const noexcept;
  /// The score that stands: an instructor's, else the machine's; nothing where there is none.
  std::optional<std::int64_t> standing_milli() const noexcept;
};

/// errors  DatabaseError: NotFound, Refused
/// thread  work's
ResultFacts read_result(Visit& visit, const database::AttemptId& id);

/// A label on a line of equal distance to the plan.
struct IsoPlace {
  int distance_mm = 0;
  std::vector<Vec3> places_in_bone_mm;  ///< of samples near that line
};

/// One planned cut against what was cut.
struct CutAgainstPlan {
  RigidTransform bone_from_face;  ///< middle of the planned face, z towards the waste
  Vec2 half_mm{12.0, 10.0};       ///< of its outline
  bool is_cut = false;            ///< false: no face of this cut stands, the rest means nothing
  SignedMap map;
  CutAway cut_away;  ///< so that the face is looked at
  Vec3 middle_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 12.0;
  std::vector<IsoPlace> iso_places;
};

/// What the saw did beside the cut: by models, and nothing of it is scored.
struct WoundFacts {
  Traces traces;
  std::vector<ZoneContact> zones;  ///< none: none was watched
  std::vector<AttemptEvent> events;
  std::vector<TimelineStep> steps;
  double duration_s = 1.0;
};

/// The bone as the attempt left it, computed from its recording.
struct ExaminedAttempt {
  database::ScoreCard card;
  bool was_stored = false;  ///< the card, because the store had none
  RigidTransform world_from_bone;
  BoneLook look;
  std::vector<BoneMesh> pieces;      ///< largest first
  std::vector<CutAgainstPlan> cuts;  ///< in the plan's order
  Vec3 middle_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 30.0;
  WoundFacts wound;
};

/// Loads the recording, rebuilds the bone, scores it, and makes what is drawn. A score that the store lacks is kept where
/// the person may and the attempt is closed; one that is there is never touched.
/// errors  DatabaseError, ScenarioError, MeshError; Cancelled
/// thread  work's; seconds
std::shared_ptr<const ExaminedAttempt> examine_attempt(Visit& visit, const database::AttemptId& id,
                                                       WorkReport& report);

/// Whether two cards of one attempt say the same score, item by item.
bool is_same_score(const database::ScoreCard& a, const database::ScoreCard& b) noexcept;

/// Where both say the same score, `stored` says it in the words of `fresh`: an older program may have worded it otherwise.
/// Returns whether any word changed; numbers never do.
bool adopt_words(database::ScoreCard& stored, const database::ScoreCard& fresh);

}  // namespace hallux::ui
