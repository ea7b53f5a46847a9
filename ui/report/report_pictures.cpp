// Pictures of a report as outlines in millimetres, still without SVG: each planned face seen square
// on, with the samples of the cut face on it, and a slice across the bone for cuts along a shaft. A
// slice is a thin slab, because the mesh is met cleanly by a slab and not by a plane.
#include "ui/report/report_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/metrics/face_plane.h"
#include "scenarios/site/bone_words.h"
#include "ui/report/report_facts.h"

namespace hallux::ui {

namespace {

using assessment::CutFace;
using assessment::Examination;
using assessment::FacePlane;
using scenarios::PlannedCut;
using simulator::Bone;
using simulator::Recording;

/// The slice is drawn as a line: thin enough to be one, thick enough to meet the mesh cleanly.
constexpr double slice_mm = 0.01;
/// Lines of planes reach this far beyond the bone.
constexpr double line_overhang_mm = 3.0;

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

/// Right along the cut's axis, up as dorsal as the face allows; in a face across the bone, whose
/// axis is dorsal, up is where the blade goes in. The origin lies in the planned face.
RigidTransform face_frame(const PlannedCut& cut) {
  const Vec3 inward = cut.exit_point_in_bone_mm - cut.depth_point_in_bone_mm;
  Vec3 up = glm::cross(cut.axis, cut.face.normal);
  if (glm::dot(up, cut.is_along_bone ? dorsal : -inward) < 0.0) up = -up;
  const Vec3 foot = cut.depth_point_in_bone_mm + cut.depth_mm * cut.face.normal;
  return {rotation_from_axes(cut.axis, up), foot};
}

/// Where an operator looks for the face: a landmark and the shaft, or where the blade goes in and
/// where it is to stop.
std::vector<NamedPoint> landmarks_of(const PlannedCut& cut,
                                     const RigidTransform& picture_from_bone) {
  const Vec2 depth = flat(picture_from_bone, cut.depth_point_in_bone_mm);
  const Vec2 exit = flat(picture_from_bone, cut.exit_point_in_bone_mm);
  if (cut.is_along_bone) {
    return {{"depth landmark", depth}, {"exit", exit}};
  }
  return {{"entry", depth}, {cut.hinge.empty() ? "exit" : "hinge", exit}};
}

FacePicture face_picture(const PlannedCut& cut, const CutFace& face,
                         std::vector<simulator::Contour> outlines) {
  const RigidTransform picture_from_bone = inverse(face_frame(cut));
  const RigidTransform bone_from_picture = face_frame(cut);
  FacePicture picture;
  picture.right = scenarios::direction_text(transform_direction(bone_from_picture, distal));
  picture.up = scenarios::direction_text(transform_direction(bone_from_picture, dorsal));
  picture.above = scenarios::direction_text(cut.face.normal);
  picture.below = scenarios::direction_text(-cut.face.normal);
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

/// Where a plane crosses the frontal slice, from below the bone to above it; nothing where it runs
/// flat.
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
void add_pictures(ReportMaterial& material, const scenarios::Scenario& scenario,
                  const simulator::Bones& bones, const Examination& examination) {
  std::vector<std::unique_ptr<const simulator::WholeBone>> wholes;
  for (const Bone& bone : bones)
    wholes.push_back(std::make_unique<const simulator::WholeBone>(solid_of(bone)));
  const CutFace none;
  for (std::size_t index = 0; index < examination.plan.cuts.size(); ++index) {
    const PlannedCut& cut = examination.plan.cuts[index];
    const std::vector<CutFace>& faces = examination.faces[index];
    const CutFace* face = faces.empty() ? nullptr : &faces.front();
    const simulator::WholeBone& whole = *wholes[cut.bone];
    material.faces.push_back(face_picture(cut, face == nullptr ? none : *face,
                                          outlines_in(whole.solid, whole.tree, face_frame(cut))));
    material.faces.back().title = title_of(scenario, cut.name);
    if (material.frontal || !cut.is_along_bone) continue;
    material.frontal = frontal_picture(whole.solid, whole.tree, cut, face);
  }
}

}  // namespace

ReportMaterial report_material(const scenarios::Scenario& scenario, simulator::Bones bones,
                               const Recording& recording, const Examination& examination,
                               simulator::Guidance guidance) {
  ReportMaterial material;
  material.card = examination.card;
  add_titles(material, scenario);
  const database::ScoreCard& card = examination.card;
  material.versions = {
      {"Scenario", card.scenario + " version " + std::to_string(card.scenario_version)},
      {"Rubric", "version " + std::to_string(card.rubric_version)},
      {"Engine", "version " + std::to_string(card.engine)}};
  for (const Bone& bone : bones) {
    if (!bone.credit.empty()) material.versions.push_back({"Shape", bone.credit});
  }
  add_pictures(material, scenario, bones, examination);
  material.zones = watched_zones(scenario, recording);
  material.traces = traces_of(recording, bones, guidance != simulator::Guidance::None,
                              examination.rebuilt.fields);
  return material;
}

}  // namespace hallux::ui
