/// All that a report shows of one attempt, as plain data.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/records/score.h"
#include "simulator/base/vector.h"
#include "ui/report/traces.h"

namespace hallux::ui {

struct Fact {
  std::string label, value;
};

/// A sample of the finished face, in the planned face's own axes.
struct FaceDot {
  Vec2 place_mm{0.0, 0.0};
  double deviation_mm = 0.0;  ///< positive towards the waste: too little taken
};

struct NamedPoint {
  std::string name;
  Vec2 place_mm{0.0, 0.0};
};

/// The planned face seen square on: right and up are said in words of the bone.
struct FacePicture {
  std::string title;  ///< of the cut
  std::string right, up;
  std::string above, below;  ///< where a positive and a negative deviation lie: "medial", "lateral"
  std::vector<std::vector<Vec2>> planned_outlines;  ///< section of the bone in the planned face
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

struct ReportMaterial {
  database::ScoreCard card;
  std::string title;                      ///< of the scenario
  std::vector<std::string> group_titles;  ///< one per group of the card
  std::vector<std::string> gate_titles;   ///< one per gate of the card
  std::vector<Fact> facts;                ///< who, when, with what; in the order shown
  std::string quality;                    ///< one sentence; empty leaves the line out
  std::vector<Fact> versions;             ///< program, engine, scenario, rubric, bone
  std::vector<FacePicture> faces;         ///< one per planned cut
  std::optional<FrontalPicture> frontal;
  Traces traces;
  std::vector<ZoneContact> zones;
};

}  // namespace hallux::ui
