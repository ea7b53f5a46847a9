/// All that a report shows of one attempt, as plain data. Inside this corner only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/records/score.h"
#include "simulator/base/vector.h"
#include "ui/report/traces.h"
#include "ui/report/what_if_text.h"

namespace hallux::ui {

struct Fact {
  std::string label, value;
};

/// A sample of the finished face, in the planned face's own axes.
struct FaceDot {
  Vec2 place_mm{0.0, 0.0};
  /// Positive towards the waste: too little taken.
  double deviation_mm = 0.0;
};

struct NamedPoint {
  std::string name;
  Vec2 place_mm{0.0, 0.0};
};

/// The planned face seen square on: right and up are said in words of the bone.
struct FacePicture {
  /// Of the cut.
  std::string title;
  std::string right, up;
  /// Where a positive and a negative deviation lie: "medial", "lateral".
  std::string above, below;
  /// Section of the bone in the planned face.
  std::vector<std::vector<Vec2>> planned_outlines;
  std::vector<FaceDot> dots;
  double dot_mm = 0.25;
  std::vector<NamedPoint> landmarks;
  bool is_finished = true;
};

struct PictureLine {
  Vec2 from_mm{0.0, 0.0}, to_mm{0.0, 0.0};
};

/// A slice of the bone across its axis at the depth landmark; right is lateral, up is dorsal.
struct FrontalPicture {
  std::vector<std::vector<Vec2>> outlines;
  PictureLine planned;
  std::optional<PictureLine> actual;
  NamedPoint landmark;
};

/// Of a score for which nobody stands yet.
inline constexpr std::string_view unsigned_score = "machine score, not confirmed";

struct ReportMaterial {
  database::ScoreCard card;
  /// Of the scenario.
  std::string title;
  /// One per group of the card.
  std::vector<std::string> group_titles;
  /// One per gate of the card.
  std::vector<std::string> gate_titles;
  /// Who stands for the score, and whether for this one.
  std::string signature = std::string(unsigned_score);
  /// Who, when, with what; in the order shown.
  std::vector<Fact> facts;
  /// One sentence; empty leaves the line out.
  std::string quality;
  /// Program, engine, scenario, rubric, bone.
  std::vector<Fact> versions;
  /// One per planned cut.
  std::vector<FacePicture> faces;
  std::optional<FrontalPicture> frontal;
  Traces traces;
  std::vector<ZoneContact> zones;
  /// Empty leaves the section out.
  SaidWhatIf what_if = {};
};

}  // namespace hallux::ui
