#include "ui/report/report_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/metrics/face_plane.h"
#include "assessment/wound_track.h"
#include "simulator/base/units.h"
#include "ui/report/report_facts.h"

namespace hallux::ui {

namespace {

using assessment::CutFace;
using assessment::Examination;
using assessment::FacePlane;
using scenarios::PlannedCut;
using simulator::Bone;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;
using simulator::ToolSample;

/// The slice is drawn as a line: thin enough to be one, thick enough to meet the mesh cleanly.
constexpr double slice_mm = 0.01;
/// Lines of planes reach this far beyond the bone.
constexpr double line_overhang_mm = 3.0;

/// Recordings of earlier ones say nothing of danger zones.
constexpr std::int32_t first_engine_that_watched_zones = 3;

const Vec3 distal{1.0, 0.0, 0.0}, dorsal{0.0, 1.0, 0.0}, lateral{0.0, 0.0, 1.0};

std::vector<simulator::Contour> outlines_in(const simulator::CutSolid& solid,
                                            const simulator::Bvh& bvh,
                                            const RigidTransform& bone_from_picture) {
  std::vector<simulator::Contour> outlines;
  const simulator::Section section = slice_section(solid, bvh, {bone_from_picture, slice_mm});
  for (const simulator::SectionRegion& region : section.regions) {
    outlines.insert(outlines.end(), region.contours.begin(), region.contours.end());
  }
  return outlines;
}

Vec2 flat(const RigidTransform& picture_from_bone, const Vec3& point_in_bone_mm) {
  const Vec3 local = transform_point(picture_from_bone, point_in_bone_mm);
  return Vec2{local.x, local.y};
}

/// Right along the cut's axis, up as dorsal as the face allows; in a face across the bone, whose axis is dorsal, up is where
/// the blade goes in. The origin lies in the planned face.
RigidTransform face_frame(const PlannedCut& cut) {
  const Vec3 inward = cut.exit_point_in_bone_mm - cut.depth_point_in_bone_mm;
  Vec3 up = glm::cross(cut.axis, cut.face.normal);
  if (glm::dot(up, cut.kind == scenarios::FaceKind::AlongAxis ? dorsal : -inward) < 0.0) up = -up;
  const Vec3 foot = cut.depth_point_in_bone_mm + cut.depth_mm * cut.face.normal;
  return {rotation_from_axes(cut.axis, up), foot};
}

/// Where an operator looks for the face: a landmark and the shaft, or where the blade goes in and where it is to stop.
std::vector<NamedPoint> landmarks_of(const PlannedCut& cut,
                                     const RigidTransform& picture_from_bone) {
  const Vec2 depth = flat(picture_from_bone, cut.depth_point_in_bone_mm);
  const Vec2 exit = flat(picture_from_bone, cut.exit_point_in_bone_mm);
  if (cut.kind == scenarios::FaceKind::AlongAxis) {
    return {{"depth landmark", depth}, {"exit", exit}};
  }
  return {{"entry", depth}, {cut.hinge.empty() ? "exit" : "hinge", exit}};
}

FacePicture face_picture(const PlannedCut& cut, const CutFace& face,
                         std::vector<simulator::Contour> outlines) {
  const RigidTransform picture_from_bone = inverse(face_frame(cut));
  const RigidTransform bone_from_picture = face_frame(cut);
  FacePicture picture;
  picture.right = assessment::direction_words(transform_direction(bone_from_picture, distal));
  picture.up = assessment::direction_words(transform_direction(bone_from_picture, dorsal));
  picture.above = assessment::direction_words(cut.face.normal);
  picture.below = assessment::direction_words(-cut.face.normal);
  picture.planned_outlines = std::move(outlines);
  picture.is_finished = face.is_finished;
  const FacePlane planned{cut.face.normal, cut.face.offset_mm};
  for (const Vec3& sample : face.samples_in_bone_mm) {
    picture.dots.push_back({flat(picture_from_bone, sample), signed_distance_mm(planned, sample)});
  }
  if (!picture.dots.empty()) {
    picture.dot_mm = std::sqrt(face.area_mm2 / static_cast<double>(picture.dots.size()));
  }
  picture.landmarks = landmarks_of(cut, picture_from_bone);
  return picture;
}

struct Span {
  double low = 0.0, high = 0.0;
};

Span height_of(const std::vector<simulator::Contour>& outlines) {
  Span span{1.0e9, -1.0e9};
  for (const simulator::Contour& outline : outlines) {
    for (const Vec2& point : outline) {
      span.low = std::min(span.low, point.y);
      span.high = std::max(span.high, point.y);
    }
  }
  return span;
}

/// Where a plane crosses the frontal slice, from below the bone to above it; nothing where it runs flat.
std::optional<PictureLine> line_of(const FacePlane& plane, double x_mm, const Span& height) {
  if (std::abs(plane.normal.z) < 0.2) return std::nullopt;
  const auto at = [&](double y_mm) {
    const double z_mm =
        (plane.offset_mm - plane.normal.x * x_mm - plane.normal.y * y_mm) / plane.normal.z;
    return Vec2{z_mm, y_mm};
  };
  return PictureLine{at(height.low - line_overhang_mm), at(height.high + line_overhang_mm)};
}

std::optional<FrontalPicture> frontal_picture(const simulator::CutSolid& solid,
                                              const simulator::Bvh& bvh, const PlannedCut& cut,
                                              const CutFace* face) {
  const Vec3& landmark = cut.depth_point_in_bone_mm;
  const RigidTransform bone_from_picture{rotation_from_axes(lateral, dorsal),
                                         Vec3{landmark.x, 0.0, 0.0}};
  FrontalPicture picture;
  picture.outlines = outlines_in(solid, bvh, bone_from_picture);
  if (picture.outlines.empty()) return std::nullopt;
  const Span height = height_of(picture.outlines);
  const std::optional<PictureLine> planned =
      line_of({cut.face.normal, cut.face.offset_mm}, landmark.x, height);
  if (!planned) return std::nullopt;
  picture.planned = *planned;
  if (face != nullptr) picture.actual = line_of(face->plane, landmark.x, height);
  picture.landmark = {"depth landmark", Vec2{landmark.z, landmark.y}};
  return picture;
}

std::string title_of(const scenarios::Scenario& scenario, const std::string& cut) {
  for (const scenarios::ReferenceCut& reference : scenario.cuts) {
    if (reference.name == cut) return reference.title;
  }
  return cut;
}

/// Every face; and a slice across the bone where a face runs along it.
void add_pictures(ReportMaterial& material, const scenarios::Scenario& scenario, const Bone& bone,
                  const Examination& examination) {
  const simulator::CutSolid solid = simulator::uncut_solid(solid_of(bone));
  const simulator::Bvh bvh(solid.mesh);
  const CutFace none;
  for (std::size_t index = 0; index < examination.plan.cuts.size(); ++index) {
    const PlannedCut& cut = examination.plan.cuts[index];
    const std::vector<CutFace>& faces = examination.faces[index];
    const CutFace* face = faces.empty() ? nullptr : &faces.front();
    material.faces.push_back(face_picture(cut, face == nullptr ? none : *face,
                                          outlines_in(solid, bvh, face_frame(cut))));
    material.faces.back().title = title_of(scenario, cut.name);
    if (material.frontal || cut.kind != scenarios::FaceKind::AlongAxis) continue;
    material.frontal = frontal_picture(solid, bvh, cut, face);
  }
}

std::string mark_text(CutEventKind kind) {
  switch (kind) {
    case CutEventKind::PlaneFrozen:
      return "plane frozen";
    case CutEventKind::Breakthrough:
      return "through";
    case CutEventKind::PieceFreed:
      return "piece free";
    case CutEventKind::HingeClosed:
      return "closed";
    case CutEventKind::DangerContact:
      return "danger zone";
    case CutEventKind::Kick:
      return "kick";
    default:
      return "";
  }
}

double force_newton_of(const ToolSample& sample) {
  const Vec3 force{newton_from_millinewton(sample.force_mn[0]),
                   newton_from_millinewton(sample.force_mn[1]),
                   newton_from_millinewton(sample.force_mn[2])};
  return std::sqrt(glm::dot(force, force));
}

}  // namespace

std::vector<ZoneContact> zone_contacts(const scenarios::Scenario& scenario,
                                       const Recording& recording) {
  std::vector<ZoneContact> contacts;
  for (const scenarios::DangerZone& zone : scenario.danger_zones) {
    contacts.push_back({zone.title, 0, 0.0});
  }
  std::vector<std::optional<std::int64_t>> begun(contacts.size());
  const auto end_contact = [&](std::size_t zone, std::int64_t tick) {
    if (const auto from = std::exchange(begun[zone], std::nullopt)) {
      contacts[zone].duration_s += second_from_tick(tick - *from);
    }
  };
  for (const CutEvent& event : recording.events) {
    const auto zone = static_cast<std::size_t>(event.subject);
    const bool is_contact = event.kind == CutEventKind::DangerContact;
    if ((!is_contact && event.kind != CutEventKind::DangerLeft) || zone >= contacts.size())
      continue;
    end_contact(zone, event.tick);
    if (!is_contact) continue;
    ++contacts[zone].count;
    begun[zone] = event.tick;
  }
  for (std::size_t zone = 0; zone < contacts.size() && !recording.samples.empty(); ++zone) {
    end_contact(zone, recording.samples.back().tick);
  }
  return contacts;
}

Traces traces_of(const Recording& recording, const Bone& bone, const scenarios::SawBlade& blade,
                 const simulator::KerfSet& kerfs, std::size_t points_max) {
  Traces traces;
  const RigidTransform bone_from_world = inverse(bone.world_from_bone);
  const std::size_t count = recording.samples.size();
  const std::size_t stretch = std::max<std::size_t>(1, (count + points_max - 1) / points_max);
  std::optional<double> before_mm;  // the advance at the sample before, where that cut too
  for (std::size_t index = 0; index < count; ++index) {
    const ToolSample& sample = recording.samples[index];
    if (index % stretch == 0) {
      TracePoint point;
      point.time_s = second_from_tick(sample.tick);
      traces.points.push_back(point);
    }
    TracePoint& point = traces.points.back();
    point.force_newton = std::max(point.force_newton, force_newton_of(sample));
    const std::optional<double> last_mm = std::exchange(before_mm, std::nullopt);
    if (sample.kerf < 0 || sample.kerf >= kerfs.count()) continue;
    const RigidTransform bone_from_tool = bone_from_world * transform_from(sample.world_from_tool);
    point.advance_mm = planar_pose(kerfs.plane(sample.kerf), bone_from_tool).tip_mm.x;
    if (!has(sample.status, simulator::ToolStatus::Cutting)) continue;
    before_mm = point.advance_mm;
    if (last_mm) point.fed_mm += std::max(0.0, *before_mm - *last_mm);
  }
  const assessment::WoundTrack wound = assessment::follow_wound(
      bone, {blade.size, blade.cycles_per_minute, blade.thickness_mm, blade.sharpness}, recording,
      stretch);
  for (std::size_t point = 0; point < traces.points.size(); ++point) {
    traces.points[point].hottest_celsius = wound.hottest_celsius[point];
  }
  traces.heat = wound.heat;
  traces.greatest_deflection_mm = wound.greatest_deflection_mm;
  for (const CutEvent& event : recording.events) {
    const std::string text = mark_text(event.kind);
    if (!text.empty()) traces.marks.push_back({second_from_tick(event.tick), text});
  }
  return traces;
}

ReportMaterial report_material(const scenarios::Scenario& scenario, const Bone& bone,
                               const Recording& recording, const Examination& examination) {
  ReportMaterial material;
  material.card = examination.card;
  add_titles(material, scenario);
  const database::ScoreCard& card = examination.card;
  material.versions = {
      {"Scenario", card.scenario + " version " + std::to_string(card.scenario_version)},
      {"Rubric", "version " + std::to_string(card.rubric_version)},
      {"Engine", "version " + std::to_string(card.engine)}};
  if (!bone.credit.empty()) material.versions.push_back({"Shape", bone.credit});
  add_pictures(material, scenario, bone, examination);
  if (recording.engine >= first_engine_that_watched_zones) {
    material.zones = zone_contacts(scenario, recording);
  }
  material.traces = traces_of(recording, bone, scenario.blade, examination.rebuilt.fields);
  return material;
}

}  // namespace hallux::ui
