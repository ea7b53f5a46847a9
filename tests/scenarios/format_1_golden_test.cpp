// Plans of format 1 to the bit: random scenarios on bones of closed form, as the first program that
// knew formats planned them. A stored attempt is scored by its plan for ever.
#include <gtest/gtest.h>

#include "scenarios/plan.h"
#include "simulator/base/digest.h"
#include "simulator/base/random.h"
#include "simulator/base/units.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

constexpr int scenarios_tried = 400;

Vec3 place(Random& random, double half_mm) {
  const double x = random.uniform(-half_mm, half_mm), y = random.uniform(-half_mm, half_mm);
  return {x, y, random.uniform(-half_mm, half_mm)};
}

/// A block or a cylinder with all landmarks that the two first scenarios ask for.
Bone bone_of(Random& random) {
  Bone bone;
  bone.name = "stand_in";
  bone.outer =
      random.uniform() < 0.5
          ? tests::solid_block({33.0, 13.0, 15.0})
          : tests::hollow_tube({.outer_radius_mm = 7.5, .inner_radius_mm = 0.0, .length_mm = 33.0});
  bone.outer = tests::moved(bone.outer, {{}, {16.5, 0.0, 0.0}});
  bone.landmarks = {{"base_centre", place(random, 0.5)},
                    {"base_med", Vec3(0.0, 0.0, -7.0) + place(random, 1.0)},
                    {"base_lat", Vec3(0.0, 0.0, 7.0) + place(random, 1.0)},
                    {"ip_centre", Vec3(33.0, 0.0, 0.0)},
                    {"shaft_proximal", Vec3(11.0, 0.0, 0.0) + place(random, 2.0)},
                    {"shaft_distal", Vec3(22.0, 0.0, 0.0) + place(random, 2.0)},
                    {"med_sulcus", Vec3(28.0, 1.0, -4.0) + place(random, 2.0)},
                    {"shaft_medial", Vec3(20.0, 0.0, -7.0) + place(random, 0.5)}};
  return bone;
}

double tilt_rad(Random& random) { return radian_from_degree(random.uniform(-45.0, 45.0)); }

Scenario along(Random& random) {
  Scenario scenario = scenarios_test::format_1("silver");
  ReferenceCut& cut = scenario.cuts[0];
  cut.face.frontal_tilt_rad = tilt_rad(random);
  cut.face.offset_mm = random.uniform(-3.0, 3.0);
  if (random.uniform() < 0.3) std::swap(cut.face.axis_from, cut.face.axis_to);
  cut.waste_side = random.uniform() < 0.7 ? "medial" : "lateral";
  cut.approach = random.uniform() < 0.7 ? "dorsal" : "plantar";
  return scenario;
}

/// Two pairs of faces at two hinges, one to each side, in a random order of the file.
Scenario across(Random& random) {
  Scenario scenario = scenarios_test::format_1("akin");
  const ReferenceHinge first = scenario.hinges[0];
  scenario.hinges.push_back(first);
  scenario.hinges[1].name = "second_hinge";
  scenario.hinges[1].side = "medial";
  for (std::size_t i = 0; i < 2; ++i) {
    scenario.cuts.push_back(scenario.cuts[i]);
    ReferenceCut& cut = scenario.cuts.back();
    cut.name = "other_" + cut.name;
    cut.approach = "lateral";
    cut.face.offset_mm = 16.0;
    if (cut.face.kind == FaceKind::ThroughHinge) cut.face.through = "second_hinge";
  }
  scenario.hinges[1].first_cut = scenario.cuts[2].name;
  scenario.hinges[1].second_cut = scenario.cuts[3].name;
  for (ReferenceCut& cut : scenario.cuts) {
    cut.face.offset_mm += random.uniform(-2.0, 2.0);
    cut.face.transverse_tilt_rad = 0.3 * tilt_rad(random);
    cut.face.sagittal_tilt_rad = 0.3 * tilt_rad(random);
    cut.face.wedge_rad = radian_from_degree(random.uniform(1.0, 30.0));
  }
  for (ReferenceHinge& hinge : scenario.hinges) hinge.thickness_mm = random.uniform(0.1, 5.0);
  if (random.uniform() < 0.5) std::swap(scenario.cuts[0], scenario.cuts[3]);
  return scenario;
}

void add(Digester& digester, const Vec3& vector) {
  for (const double part : {vector.x, vector.y, vector.z}) digester.add_double(part);
}

void add(Digester& digester, const PlannedCut& cut) {
  digester.add_text(cut.name);
  add(digester, cut.face.normal);
  digester.add_double(cut.face.offset_mm);
  for (const Vec3& vector : {cut.axis, cut.depth_point_in_bone_mm, cut.exit_point_in_bone_mm,
                             cut.entry_point_in_bone_mm}) {
    add(digester, vector);
  }
  digester.add_double(cut.depth_mm);
  digester.add_text(cut.hinge);
}

void add(Digester& digester, const PlannedHinge& hinge) {
  digester.add_text(hinge.name);
  const simulator::HingeLine& line = hinge.bridge.line;
  for (const Vec3& vector :
       {line.point_in_bone_mm, line.axis, line.outward, hinge.bridge.toward_moved}) {
    add(digester, vector);
  }
  digester.add_double(line.thickness_mm);
  digester.add_double(hinge.wedge_rad);
}

struct Planned {
  Digest digest;
  int refused = 0;
};

/// Refusals count as well, by their words.
Planned planned_at_random() {
  Digester digester;
  Planned planned;
  for (int i = 0; i < scenarios_tried; ++i) {
    Random random(static_cast<std::uint64_t>(i), "format_1");
    const Bone bone = bone_of(random);
    Scenario scenario = i % 2 == 0 ? along(random) : across(random);
    scenario.joint_surfaces.clear();
    try {
      const Plan plan = plan_on(scenario, bone);
      for (const PlannedCut& cut : plan.cuts) add(digester, cut);
      for (const PlannedHinge& hinge : plan.hinges) add(digester, hinge);
    } catch (const ScenarioError& error) {
      digester.add_text(error.what());
      ++planned.refused;
    }
  }
  planned.digest = digester.finish();
  return planned;
}

TEST(Format1, IsPlannedAsItAlwaysWas) {
  const Planned planned = planned_at_random();
  EXPECT_LT(planned.refused, scenarios_tried / 2) << "most of them are planes, not refusals";
  EXPECT_EQ(hex_from_digest(planned.digest),
            "6f68a2d65281b86c34d9e117a2cfb7cc107e4b6121508cb4dc53e3e2830310a0");
}

}  // namespace
}  // namespace hallux::scenarios
