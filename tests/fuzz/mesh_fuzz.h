/// Feeds any bytes to one of the mesh readers: it must return or throw MeshError, and what it
/// returns must be usable.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "simulator/base/check.h"
#include "simulator/mesh/bvh.h"
#include "simulator/mesh/read_mesh.h"

namespace hallux::tests {

inline void feed_reader(const std::uint8_t* bytes, std::size_t size, simulator::MeshFormat format) {
  using namespace simulator;
  try {
    const IndexedMesh mesh =
        parse_mesh(std::as_bytes(std::span{bytes, size}), format, "fuzz",
                   {.bytes = std::size_t{1} << 20U, .triangles = 20000, .points = 20000});
    check_closed_solid(mesh, "fuzz");
    CHECK(Bvh{mesh}.nearest(mesh.points_mm.front()).has_value());
  } catch (const MeshError&) {
  }
}

}  // namespace hallux::tests
