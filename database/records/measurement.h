/// One metric of one subject, with the moment and the place that it is about, and what else is to
/// be said of it: ids and values, no words.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "database/records/names.h"
#include "simulator/base/digest.h"
#include "simulator/base/vector.h"

namespace hallux::database {

/// Why a metric has no value.
enum class Absence : std::uint8_t {
  /// It has one.
  None,
  /// The cut that it is about was not made; what it is worth is lost.
  NotMade,
  /// Something else that was asked for was not done; what it is worth is lost.
  NotDone,
  /// There was nothing to measure in a performance that was carried out: nothing is lost.
  Undefined,
  /// What was kept of the attempt does not tell it: nothing is lost.
  NotRecorded
};

template <>
inline constexpr std::array<std::string_view, 5> stored_names<Absence>{"", "not_made", "not_done",
                                                                       "undefined", "not_recorded"};

/// What more there is to say of a value, where points were lost.
enum class DetailKind : std::uint8_t {
  None,
  /// How far the deepest edge of a face is off, and the opposite one [mm, mm]; which way each.
  EdgesOff,
  /// The joint surface that is nearest, by its title.
  NearestJoint,
  /// The zones that were touched, by their titles.
  Zones,
  /// How hot the hottest bone became [degrees Celsius].
  Hottest,
  /// The wedge taken and the planned one, and the bases of both [deg, deg, mm, mm].
  WedgeTaken,
  /// Closing the wedge tips the toe.
  TipsToe,
  /// What the hand felt as the blade broke through [N].
  FeltThrough
};

template <>
inline constexpr std::array<std::string_view, 8> stored_names<DetailKind>{
    "",        "edges_off",   "nearest_joint", "zones",
    "hottest", "wedge_taken", "tips_toe",      "felt_through"};

struct Detail {
  DetailKind kind = DetailKind::None;
  std::vector<double> values;
  std::vector<std::string> words;

  bool operator==(const Detail&) const = default;
};

/// Said of a measurement whatever was lost.
enum class Remark : std::uint8_t {
  None,
  /// Some of the cut was sawn after it was called done.
  SawnAfterDone,
  /// Not measured but supposed: what if.
  Assumed
};

template <>
inline constexpr std::array<std::string_view, 3> stored_names<Remark>{"", "sawn_after_done",
                                                                      "assumed"};

struct Measurement {
  /// "angle_deg"; the unit is the last word.
  std::string metric;
  /// The reference cut's name; empty where it is about a hinge, a zone or the whole attempt.
  std::string cut;
  /// The hinge's name.
  std::string hinge;
  /// Rounded to 1e-6 of its unit.
  double value = 0.0;
  Absence absence = Absence::None;
  /// Below 1: the blade was stopped inside the bone; measured where it was.
  double done_fraction = 1.0;
  /// "dorsal", "plantar-distal"; empty where the metric has no sign.
  std::string direction;
  Detail detail = {};
  Remark remark = Remark::None;
  std::int64_t start_us = 0, end_us = 0;
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
  /// The danger zone's name; empty where all of them together are meant.
  std::string zone = {};
  /// The planned fragment's name, the planned implant's, or that of a group of alternative steps of
  /// which one set some.
  std::string fragment = {}, implant = {};
  /// The value is no further from the exact one, by the grids and steps that it is computed on; the
  /// rounding of what was recorded is not in it.
  double bound = 0.0;

  bool is_measured() const noexcept { return absence == Absence::None; }
  /// It has no value, and that costs nothing.
  bool is_excused() const noexcept {
    return absence == Absence::Undefined || absence == Absence::NotRecorded;
  }
};

/// What a set of measurements depends on beside the recording.
struct MeasuredBy {
  /// Of bone and plan (scenarios/plan_digest.h).
  Digest plan;
  /// assessment/metrics_version.h
  std::int32_t metrics_version = 0;
};

}  // namespace hallux::database
