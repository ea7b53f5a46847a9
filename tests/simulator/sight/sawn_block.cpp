#include "tests/simulator/sight/sawn_block.h"

#include "simulator/record/record.h"
#include "tests/support/worlds.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double above_mm = 12.0;

Blade some_blade() {
  Blade blade;
  blade.width_mm = 10.0;
  blade.depth_mm = 40.0;
  blade.kerf_mm = 0.5;
  return blade;
}

}  // namespace

RigidTransform blade_at(const BladePlace& place) {
  return {rotation_from_axes(Vec3{0.0, -1.0, 0.0}, Vec3{0.0, 0.0, -1.0}),
          Vec3{place.x_mm, place.y_mm, place.z_mm}};
}

SawnBlock::SawnBlock()
    : solid_(uncut_solid(solid_block(block_size_mm))),
      bvh_(solid_.mesh),
      kerfs_(some_blade(), RigidTransform{}) {}

std::int32_t SawnBlock::freeze(double x_mm) {
  return kerfs_.freeze(quantise(blade_at({.x_mm = x_mm, .y_mm = above_mm})));
}

void SawnBlock::saw(std::int32_t kerf, const BladePlace& to) {
  ToolSample sample;
  sample.kerf = kerf;
  sample.status = bit(ToolStatus::SawOn);
  for (const double y_mm : {above_mm, to.y_mm}) {
    sample.tick = tick_++;
    sample.world_from_tool = quantise(blade_at({to.x_mm, y_mm, to.z_mm}));
    kerfs_.apply(sample);
  }
  // Out of the kerf again.
  sample.kerf = -1;
  kerfs_.apply(sample);
}

Section SawnBlock::section(std::int32_t kerf) const {
  return slice_section(solid_, bvh_, kerfs_.plane(kerf));
}

}  // namespace hallux::tests
