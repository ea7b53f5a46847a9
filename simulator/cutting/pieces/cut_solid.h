/// A solid that remembers where each of its faces came from.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// kerf -1: the bone's own surface. Otherwise the wall that this kerf left: side +1 lies at
/// +thickness/2 (the solid stands above it, its face looks down the kerf's z), side -1 at
/// -thickness/2.
struct FaceSource {
  std::int32_t kerf = -1;
  std::int32_t side = 0;

  friend bool operator==(const FaceSource&, const FaceSource&) = default;
};

struct CutSolid {
  /// Closed, oriented; may hold several pieces and inward-facing canal shells.
  IndexedMesh mesh;
  /// One per triangle.
  std::vector<FaceSource> sources;
};

/// The solid of a bone that was never cut.
CutSolid uncut_solid(IndexedMesh mesh);

/// Appends the faces of `added` with their sources.
void append_solid(CutSolid& solid, const CutSolid& added);

/// The pieces of a solid, largest first; an inward-facing shell goes with the piece around it.
/// source  volumes of equal size are ordered by their lowest point index, so the order is the same
///         everywhere
std::vector<CutSolid> split_pieces(const CutSolid& solid);

/// A piece that knows where in the whole it was.
struct SolidPiece {
  CutSolid solid;
  /// Per triangle of the piece the one of the whole.
  std::vector<std::uint32_t> triangles;
};

/// The same pieces in the same order.
std::vector<SolidPiece> find_pieces(const CutSolid& solid);

/// Pieces below this are debris: counted in the balance, not shown as bodies.
inline constexpr double debris_limit_mm3 = 0.05;

}  // namespace hallux::simulator
