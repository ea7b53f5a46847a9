#include "tests/benchmarks/fragments/driven_operation.h"

#include <array>
#include <stdexcept>

#include "simulator/base/elementary.h"
#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/simulator/contact/bore/bore_world.h"

namespace hallux::benchmarks {

namespace {

using simulator::Command;
using simulator::CommandKind;
using tests::blade_down;
using tests::pointing;

constexpr std::int32_t saw_place = 0, wire_place = 1;
/// Above and below the axis there is no bone.
constexpr double clear_mm = 14.0, lifted_mm = 20.0, through_mm = -10.0;
constexpr double kerf_depth_mm = 2.0, hole_depth_mm = 2.0;
constexpr int ticks_at_most = 60'000;
const Vec3 down{0.0, -1.0, 0.0};

/// Places are counted from the middle of the shaft.
class DrivenOperation {
 public:
  explicit DrivenOperation(const simulator::Bone& bone)
      : middle_(middle_of(bone.outer)), run_({bone, shaft_tray()}, blade_down(at(0.0, clear_mm))) {}

  /// So deep below where the teeth found the bone.
  void saw_kerf(double x_mm) {
    const std::int32_t before = kerf_count();
    approach(blade_down(at(x_mm, clear_mm)));
    double begun_at_mm = 0.0;
    push(20.0, [&](double tip_mm) {
      if (kerf_count() == before) begun_at_mm = tip_mm;
      return kerf_count() == before || tip_mm > begun_at_mm - kerf_depth_mm;
    });
    withdraw(blade_down(at(x_mm, clear_mm)));
  }
  void saw_off(double x_mm, const Vec3& moved_by_mm) {
    approach(blade_down(at(x_mm, clear_mm)));
    push(30.0, [](double tip_mm) { return tip_mm > through_mm; });
    withdraw(blade_down(at(x_mm, clear_mm)));
    run_.step({{CommandKind::Grip, simulator::piece_freed_last, 0}});
    run_.hold(3);
    run_.glide(blade_down(at(x_mm, clear_mm + lifted_mm) + moved_by_mm), 400);
    run_.hold(100);
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(3);
  }
  void leave_wire(double x_mm) {
    bore_hole(x_mm, 0.0, [](double tip_mm) { return tip_mm > through_mm; });
    run_.step({{CommandKind::LeaveImplant, 0, 0}});
    withdraw(pointing(at(x_mm, 2.0 * clear_mm), down));
  }
  void bore_short(double x_mm, double z_mm) {
    double begun_at_mm = 0.0;
    const std::int32_t before = run_.simulation().bores().count();
    bore_hole(x_mm, z_mm, [&](double tip_mm) {
      if (run_.simulation().bores().count() == before) begun_at_mm = tip_mm;
      return run_.simulation().bores().count() == before || tip_mm > begun_at_mm - hole_depth_mm;
    });
    withdraw(pointing(at(x_mm, clear_mm, z_mm), down));
  }
  void choose(std::int32_t place) {
    run_.step({{CommandKind::ChooseTool, place, 0}});
    run_.hold(3);
  }

  void measure_sawing() {
    approach(blade_down(at(0.0, clear_mm)));
    begin(sawing);
    for (int i = 0; i < 4000; ++i) push_once(12.0);
    end();
    withdraw(blade_down(at(0.0, clear_mm)));
  }
  /// The blade's face, pressed, slid and tilted to and fro.
  void measure_laying() {
    const Quat flat = rotation_from_axes(Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 1.0});
    run_.switches = 0;
    approach({flat, at(8.0, 12.0)});
    begin(laying);
    for (int i = 0; i < 4000; ++i) {
      const double swing = elementary::sin(0.003 * i);
      const Quat tilt = rotation_about(Vec3{1.0, 0.0, 0.0}, 0.1 * swing);
      run_.glide({normalised(tilt * flat), at(8.0 + 3.0 * swing, 4.0, 2.0 * swing)}, 1);
    }
    end();
    withdraw({flat, at(8.0, clear_mm)});
    run_.switches = tests::saw_runs;
  }
  /// A piece that lies on the side of +x.
  void measure_grip(std::int32_t piece) {
    const auto hand = [&](double x_mm, double z_mm) {
      return blade_down(at(20.0 + x_mm, clear_mm + lifted_mm, z_mm));
    };
    run_.glide(hand(0.0, 0.0), 300);
    run_.step({{CommandKind::Grip, piece, 0}});
    run_.hold(3);
    begin(leading);
    run_.glide(hand(4.0, 3.0), 2000);
    run_.glide(hand(0.0, 0.0), 2000);
    end();
    run_.glide(hand(-5.0, 0.0), 300);
    begin(pressing);
    for (int i = 0; i < 4000; ++i) run_.glide(hand(-5.0, 2.0 * elementary::sin(0.003 * i)), 1);
    end();
    run_.glide(hand(2.0, 0.0), 300);
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(3);
  }
  void measure_boring(const std::string& what, double x_mm, double z_mm) {
    approach(pointing(at(x_mm, clear_mm, z_mm), down));
    begin(what);
    for (int i = 0; i < 4000; ++i) push_once(10.0);
    end();
    withdraw(pointing(at(x_mm, clear_mm, z_mm), down));
  }

  std::int32_t kerf_count() const { return run_.simulation().kerfs().count(); }
  const tests::SimulationRun& run() const { return run_; }
  DrivenRecording recording() const { return {run_.recording(), works_}; }

 private:
  Vec3 at(double x_mm, double y_mm, double z_mm = 0.0) const {
    return middle_ + Vec3{x_mm, y_mm, z_mm};
  }
  /// High over the bone, then down.
  void approach(const RigidTransform& handle) {
    run_.glide({handle.rotation, handle.translation_mm + Vec3{0.0, lifted_mm, 0.0}}, 200);
    run_.glide(handle, 100);
    hand_ = handle;
  }
  void withdraw(const RigidTransform& handle) {
    run_.glide(handle, 400);
    run_.glide({handle.rotation, handle.translation_mm + Vec3{0.0, lifted_mm, 0.0}}, 200);
    run_.hold(20);
  }
  /// Straight down below where the hand came from.
  void push_once(double force_newton) {
    RigidTransform handle = hand_;
    handle.translation_mm.y =
        run_.bone_from_tool().translation_mm.y - force_newton / tests::coupling_newton_per_mm;
    run_.glide(handle, 1);
  }
  template <typename GoesOn>
  void push(double force_newton, const GoesOn& goes_on) {
    for (int i = 0; goes_on(run_.bone_from_tool().translation_mm.y - middle_.y); ++i) {
      if (i == ticks_at_most) throw std::runtime_error("a stroke does not get through");
      push_once(force_newton);
    }
  }
  template <typename GoesOn>
  void bore_hole(double x_mm, double z_mm, const GoesOn& goes_on) {
    approach(pointing(at(x_mm, clear_mm, z_mm), down));
    push(20.0, goes_on);
  }
  void begin(const std::string& what) { works_.push_back({what, run_.recording().tape.size(), 0}); }
  void end() { works_.back().end = run_.recording().tape.size(); }

  Vec3 middle_;
  tests::SimulationRun run_;
  RigidTransform hand_;
  std::vector<MeasuredWork> works_;
};

void expect(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(std::string("the operation has not ") + what);
}

}  // namespace

simulator::Bone shaft(std::size_t triangles) {
  simulator::Bone bone = tests::cortical_bone(make_bone_like({triangles, false}));
  bone.cortex = simulator::CortexLaw{.length_mm = 62.0};
  return bone;
}

simulator::Tray shaft_tray() {
  const std::array<simulator::Tool, 1> further{simulator::WireDriver{}};
  return {simulator::Saw{.blade = {.width_mm = 18.0}}, further};
}

DrivenRecording with_two_kerfs(const simulator::Bone& bone) {
  DrivenOperation operation(bone);
  operation.saw_kerf(-2.0);
  operation.measure_sawing();
  operation.measure_laying();
  expect(operation.kerf_count() == 2, "two kerfs");
  operation.choose(wire_place);
  operation.measure_boring(boring, 1.0, 3.0);
  return operation.recording();
}

DrivenRecording with_sixteen_kerfs(const simulator::Bone& bone) {
  DrivenOperation operation(bone);
  operation.saw_off(15.0, {2.0, 0.0, 1.0});
  operation.saw_off(-15.0, {-2.0, 0.0, 1.0});
  for (const double x_mm :
       {20.0, 28.0, -20.0, -28.0, -10.0, -8.0, -6.0, -4.0, -2.0, 2.0, 4.0, 6.0, 8.0})
    operation.saw_kerf(x_mm);
  operation.choose(wire_place);
  for (const double x_mm : {12.5, -12.5, 24.0, -24.0}) operation.leave_wire(x_mm);
  operation.choose(saw_place);
  operation.measure_sawing();
  expect(operation.kerf_count() == simulator::kerf_limit, "16 kerfs");
  expect(operation.run().simulation().implants().count() == 4, "four wires");
  expect(operation.run().simulation().kerfs().fragments().count() == 3, "three bodies");
  operation.measure_laying();
  operation.measure_grip(1);
  operation.choose(wire_place);
  operation.measure_boring(boring, 1.0, 3.0);
  for (int hole = 0; hole < 12; ++hole)
    operation.bore_short(-11.0 + 2.0 * (hole % 6), hole < 6 ? 4.0 : -4.0);
  operation.measure_boring(boring_late, 1.0, -3.0);
  return operation.recording();
}

}  // namespace hallux::benchmarks
