// A result in two readings: what is stored, at once, and the cut bone, computed again from the
// recording. A stored score is never touched; one that is missing is computed from the recording,
// or from what it measured, and kept. What was cached beside the recording serves to show alone.
// The shares of the bar are measured.
#include "ui/screens/result/result_material.h"

#include <algorithm>
#include <cmath>

#include "database/content/assets.h"
#include "scenarios/scenario_error.h"
#include "simulator/base/digest.h"
#include "simulator/base/progress.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/pictures/cached_look.h"
#include "ui/screens/pictures/planned_frame.h"
#include "ui/screens/result/attempt_source.h"

namespace hallux::ui {

namespace {

using assessment::CutFace;
using assessment::Examination;
using database::Action;
using database::AttemptState;
using scenarios::PlannedCut;

/// Shares of the time, as measured: reading, scoring, and what is drawn.
constexpr double read_share = 0.1, score_share = 0.55, effects_share = 0.75, look_share = 0.2;
/// The map is cut open this far beyond the face, so that the face itself stays.
constexpr double open_beyond_mm = 0.02;
/// About one for each pixel of a wide window.
constexpr std::size_t trace_points = 960;
constexpr int iso_limit_mm = 2;
constexpr double iso_slack_mm = 0.12;

std::optional<scenarios::Scenario> read_scenario_of(database::Database& database,
                                                    const database::AttemptHeader& header) {
  const database::ScenarioText text = get_scenario_version(database, header.begun.scenario);
  try {
    return scenarios::parse_scenario(text.json, text.name);
  } catch (const scenarios::ScenarioError&) {
    return std::nullopt;  // a stored score is shown all the same, with the names it holds
  }
}

StageProgress stages_on(WorkReport& report) {
  return [&report](const std::string&) -> Progress {
    return [&report](double fraction) {
      return report.reached(read_share + (score_share - read_share) * fraction);
    };
  };
}

bool is_to_be_scored(const database::AttemptHeader& header) {
  return !header.score_milli && header.state == AttemptState::Closed;
}

/// The score where there is none, and what it is made from where that is not kept. Whether the
/// score was stored.
bool store_where_missing(SignedInSession& signed_in, const AttemptSource& loaded,
                         const Examination& examination) {
  const database::AttemptHeader& header = loaded.attempt.header;
  const bool is_all_there = loaded.measurements && !is_to_be_scored(header);
  if (is_all_there || header.state != AttemptState::Closed) return false;
  return signed_in.in_turn([&](database::Session& session, auto&) {
    std::optional<database::AttemptDesk> desk = session.desk_for(Action::StoreScore, header.id);
    if (!desk || !desk->may(Action::StoreScore, header)) return false;
    const bool is_scored_now = is_to_be_scored(header);
    if (is_scored_now) desk->store_score(header.id, examination.card);
    if (!loaded.measurements)
      desk->store_measurements(header.id, measured_by(loaded.attempt.scenario, header.begun.bone),
                               examination.measurements);
    return is_scored_now;
  });
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum(0.0);
  for (const Vec3& point : points) sum += point;
  return sum / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

double reach_from(const Vec3& middle, const std::vector<Vec3>& points) {
  double reach = 0.0;
  for (const Vec3& point : points) reach = std::max(reach, glm::length(point - middle));
  return reach;
}

std::vector<IsoPlace> iso_places_of(const CutFace& face, const PlannedCut& cut) {
  std::vector<IsoPlace> found;
  for (int mm = -iso_limit_mm; mm <= iso_limit_mm; ++mm) {
    IsoPlace iso;
    iso.distance_mm = mm;
    for (const Vec3& sample : face.samples_in_bone_mm) {
      const double off_mm = glm::dot(cut.face.normal, sample) - cut.face.offset_mm;
      if (std::abs(off_mm - mm) < iso_slack_mm) iso.places_in_bone_mm.push_back(sample);
    }
    if (!iso.places_in_bone_mm.empty()) found.push_back(std::move(iso));
  }
  return found;
}

void map_face(CutAgainstPlan& against, const PlannedCut& cut, const CutFace& face,
              const assessment::RebuiltBone& rebuilt) {
  against.is_cut = true;
  const RigidTransform& bone_from_kerf = rebuilt.fields.plane(face.kerf).bone_from_kerf;
  const Vec3 upwards = transform_direction(bone_from_kerf, Vec3(0.0, 0.0, 1.0));
  // The wall on the bone that is kept: below the kerf where its z looks to the waste.
  const std::int32_t side = glm::dot(upwards, cut.face.normal) >= 0.0 ? -1 : 1;
  against.map = {face.kerf, side, cut.face.normal, cut.face.offset_mm, 2.0};
  against.cut_away = {face.plane.normal, face.plane.offset_mm + open_beyond_mm};
  against.middle_in_bone_mm = mean_of(face.samples_in_bone_mm);
  // The outline of the plan stands around what was cut.
  const double off_mm = glm::dot(cut.face.normal, against.middle_in_bone_mm) - cut.face.offset_mm;
  against.bone_from_face.translation_mm = against.middle_in_bone_mm - off_mm * cut.face.normal;
  against.radius_mm = std::max(6.0, reach_from(against.middle_in_bone_mm, face.samples_in_bone_mm));
  against.iso_places = iso_places_of(face, cut);
}

CutAgainstPlan against_plan(const Examination& examination, std::size_t index) {
  const PlannedCut& cut = examination.plan.cuts[index];
  CutAgainstPlan against;
  against.bone = cut.bone;
  against.bone_from_face = bone_from_planned(cut);
  against.middle_in_bone_mm = against.bone_from_face.translation_mm;
  const std::vector<CutFace>& faces = examination.faces[index];
  if (!faces.empty() && !faces.front().samples_in_bone_mm.empty()) {
    map_face(against, cut, faces.front(), examination.rebuilt);
  }
  return against;
}

/// The card's trees live only as long as the light is laid.
void light_pieces(std::vector<BoneMesh>& pieces) {
  std::vector<simulator::Bvh> trees;
  trees.reserve(pieces.size());
  for (const BoneMesh& piece : pieces) trees.emplace_back(piece.solid.mesh);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // What lies on the other side of a kerf is not looked at: the face is shown opened.
    const Occluder own{&trees[i], {}};
    light_cut_faces(pieces[i], std::span(&own, 1));
  }
}

/// Of all bones, where they lay.
std::vector<Vec3> points_in_world_mm(const simulator::Bones& bones) {
  std::vector<Vec3> points_mm;
  for (const simulator::Bone& bone : bones) {
    for (const Vec3& point_mm : bone.outer.points_mm)
      points_mm.push_back(transform_point(bone.world_from_bone, point_mm));
  }
  return points_mm;
}

void add_pictures(ExaminedAttempt& examined, const AttemptSource& loaded,
                  const Examination& examination, WorkReport& report) {
  const AttemptMaterial& material = loaded.attempt;
  const std::string name = "result " + material.header.id.text + " " +
                           std::to_string(material.recording.samples.size()) + " ";
  const Progress whole = [&](double fraction) { return report.reached(fraction); };
  const double share = look_share / static_cast<double>(material.bones.size());
  double reached = effects_share;
  for (const simulator::Bone& bone : material.bones) {
    examined.world_from_bones.push_back(bone.world_from_bone);
    examined.looks.push_back(cancelled_as("stopped before the bone was drawn", [&] {
      return cached_look_of(loaded.directory, bone, part_of(whole, reached, reached + share));
    }));
    reached += share;
  }
  examined.piece_bones = examination.rebuilt.piece_bones;
  for (std::size_t number = 0; number < examination.rebuilt.pieces.size(); ++number) {
    examined.pieces.push_back(mesh_of(picture_id(name + std::to_string(number)),
                                      examination.rebuilt.pieces[number],
                                      examined.looks[examined.piece_bones[number]]));
  }
  light_pieces(examined.pieces);
  const std::vector<Vec3> points_mm = points_in_world_mm(material.bones);
  examined.middle_in_world_mm = mean_of(points_mm);
  examined.radius_mm = std::max(1.0, reach_from(examined.middle_in_world_mm, points_mm));
}

EffectFacts effects_of(const AttemptMaterial& material, const Examination& examination,
                       WorkReport& report) {
  EffectFacts effects;
  effects.traces = cancelled_as("stopped before the heat was followed", [&] {
    return traces_of(
        material.recording, material.bones,
        material.header.begun.guidance != simulator::Guidance::None, examination.rebuilt.fields,
        trace_points, [&](double fraction) {
          return report.reached(score_share + (effects_share - score_share) * fraction);
        });
  });
  effects.zones = watched_zones(material.scenario, material.recording);
  effects.events = events_of(material.recording);
  effects.duration_s = duration_s_of(material.recording);
  effects.steps = steps_of(material.recording, material.scenario, effects.duration_s);
  return effects;
}

}  // namespace

bool ResultFacts::is_unfinished() const noexcept {
  return !score && !header.seal && header.state != AttemptState::Recording;
}

const database::Decision* ResultFacts::decision() const noexcept {
  const bool has_one = !decisions.empty() && decisions.front().is_in_force;
  return has_one ? &decisions.front() : nullptr;
}

std::optional<std::int64_t> ResultFacts::standing_milli() const noexcept {
  if (decision() != nullptr && decision()->score_milli) return decision()->score_milli;
  if (score) return score->card.score_milli;
  return std::nullopt;
}

ResultFacts read_result(SignedInSession& signed_in, const database::AttemptId& id) {
  return signed_in.in_turn([&](database::Session& session, database::Database& database) {
    ResultFacts facts;
    facts.header = header_for(session, id);
    std::optional<database::AttemptDesk> desk =
        session.desk_for(Action::ViewAttempt, facts.header.id);
    facts.score = told_score(*desk, facts.header.id);
    facts.decisions = desk->decisions(facts.header.id);
    facts.scenario = read_scenario_of(database, facts.header);
    facts.rights = rights_to(session, facts.header);
    facts.quality = quality_from_json(facts.header.quality_json);
    return facts;
  });
}

std::shared_ptr<const ExaminedAttempt> examine_attempt(SignedInSession& signed_in,
                                                       const database::AttemptId& id,
                                                       WorkReport& report) {
  const AttemptSource loaded = attempt_source(signed_in, id);
  const AttemptMaterial& material = loaded.attempt;
  report.reached(read_share);
  const Examination examination = examination_of(loaded, stages_on(report));
  auto examined = std::make_shared<ExaminedAttempt>();
  examined->card = examination.card;
  for (std::size_t cut = 0; cut < examination.plan.cuts.size(); ++cut) {
    examined->cuts.push_back(against_plan(examination, cut));
  }
  examined->effects = effects_of(material, examination, report);
  add_pictures(*examined, loaded, examination, report);
  examined->was_stored = store_where_missing(signed_in, loaded, examination);
  report.reached(1.0);
  return examined;
}

void adopt_words(database::ScoreCard& stored, const database::ScoreCard& fresh) {
  stored.sentences = fresh.sentences;
  for (std::size_t line = 0; line < stored.ledger.size(); ++line)
    stored.ledger[line].text = fresh.ledger[line].text;
  for (std::size_t gate = 0; gate < stored.gates.size(); ++gate)
    stored.gates[gate].text = fresh.gates[gate].text;
}

}  // namespace hallux::ui
