/// What the result screen shows: what is stored, read at once, and the cut bone, which is computed
/// again beside it. Inside this corner only.
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
  /// Nothing where this version cannot read its text.
  std::optional<scenarios::Scenario> scenario;
  /// In force; nothing: not scored yet.
  std::optional<database::StoredScore> score;
  /// Newest first.
  std::vector<database::Decision> decisions;
  AttemptRights rights;
  /// Of the recording; nothing: it was not closed.
  std::optional<Quality> quality;

  /// It ended before it was finished, and is never scored.
  bool is_unfinished() const noexcept;
  /// The decision in force, or null.
  const database::Decision* decision() const noexcept;
  /// The score that stands: an instructor's, else the machine's; nothing where there is none.
  std::optional<std::int64_t> standing_milli() const noexcept;
};

/// errors  DatabaseError: NotFound, Refused
/// thread  work's
ResultFacts read_result(SignedInSession& signed_in, const database::AttemptId& id);

/// A label on a line of equal distance to the plan.
struct IsoPlace {
  int distance_mm = 0;
  /// Of samples near that line.
  std::vector<Vec3> places_in_bone_mm;
};

/// One planned cut against what was cut, in the frame of its bone.
struct CutAgainstPlan {
  /// Of the patient's bones.
  std::size_t bone = 0;
  /// Middle of the planned face, z towards the waste.
  RigidTransform bone_from_face;
  /// Of its outline.
  Vec2 half_mm{12.0, 10.0};
  /// False: no face of this cut stands, the rest means nothing.
  bool is_cut = false;
  SignedMap map;
  /// So that the face is looked at.
  CutAway cut_away;
  Vec3 middle_in_bone_mm{0.0, 0.0, 0.0};
  double radius_mm = 12.0;
  std::vector<IsoPlace> iso_places;
};

/// What the saw did beside the cut, by models.
struct EffectFacts {
  Traces traces;
  /// None: none was watched.
  std::vector<ZoneContact> zones;
  std::vector<AttemptEvent> events;
  std::vector<TimelineStep> steps;
  double duration_s = 1.0;
};

/// The bone as the attempt left it, computed from its recording.
struct ExaminedAttempt {
  database::ScoreCard card;
  /// The card, because the store had none.
  bool was_stored = false;
  /// Where each bone lies, and how it looks.
  std::vector<RigidTransform> world_from_bones;
  std::vector<BoneLook> looks;
  /// Largest first of each bone.
  std::vector<BoneMesh> pieces;
  std::vector<std::size_t> piece_bones;
  /// In the plan's order.
  std::vector<CutAgainstPlan> cuts;
  Vec3 middle_in_world_mm{0.0, 0.0, 0.0};
  double radius_mm = 30.0;
  EffectFacts effects;
};

/// Loads the recording, rebuilds the bone, scores it, and makes what is drawn. A score that the
/// store lacks is kept where the person may and the attempt is closed; one that is there is never
/// touched.
/// errors  DatabaseError, ScenarioError, MeshError; Cancelled
/// thread  work's; seconds
std::shared_ptr<const ExaminedAttempt> examine_attempt(SignedInSession& signed_in,
                                                       const database::AttemptId& id,
                                                       WorkReport& report);

/// A stored score in the words of `fresh`: an older program may have worded it otherwise.
/// needs   they are the same score
void adopt_words(database::ScoreCard& stored, const database::ScoreCard& fresh);

}  // namespace hallux::ui
