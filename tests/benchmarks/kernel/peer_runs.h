/// One bone cut once by every method, timed: what the table of peers is made of.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "simulator/cutting/field/kerf.h"
#include "simulator/mesh/indexed_mesh.h"
#include "tests/benchmarks/report/percentiles.h"

namespace hallux::benchmarks {

enum class Method : std::uint8_t {
  VtkHalves,
  CgalHalves,
  CgalSplit,
  CgalDifference,
  ThesisSlice,
  OurContact,
  OurSlab,
  OurCompacted
};

struct NamedMethod {
  Method method;
  const char* text;
};

inline constexpr std::array<NamedMethod, 8> all_methods{{
    {Method::VtkHalves, "VTK ClipClosedSurface, both halves"},
    {Method::CgalHalves, "CGAL clip, both halves"},
    {Method::CgalSplit, "CGAL split, no caps"},
    {Method::CgalDifference, "CGAL corefinement difference"},
    {Method::ThesisSlice, "thesis: slice and caps"},
    {Method::OurContact, "Hallux: contact slice"},
    {Method::OurSlab, "Hallux: contact and whole slab"},
    {Method::OurCompacted, "Hallux: the same, buffers compacted"},
}};

struct BoneWorld {
  /// Triangles.
  std::size_t wanted = 0;
  bool is_hollow = false;
  simulator::IndexedMesh mesh;
  simulator::KerfPlane plane;

  /// "50k hollow".
  std::string name() const;
};

struct Outcome {
  Percentiles time_ms;
  /// Where the method removes the slab.
  std::optional<double> removed_mm3;
  /// Where it was looked at.
  bool is_closed = true;
};

using Outcomes = std::map<Method, Outcome>;

/// What each needs before (its own mesh, a search tree, a copy to work on) is made outside the
/// clock.
/// errors  std::runtime_error where a peer gives up
void run_vtk(const BoneWorld& world, Outcomes& outcomes);
void run_cgal(const BoneWorld& world, Outcomes& outcomes);
void run_thesis(const BoneWorld& world, Outcomes& outcomes);
/// ensures OurContact and OurSlab give one mesh and a patch; OurCompacted one mesh with buffers of
///         its own
void run_ours(const BoneWorld& world, Outcomes& outcomes);

}  // namespace hallux::benchmarks
