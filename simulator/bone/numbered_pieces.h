/// The pieces of a bone under their numbers, and those that were taken out of it.
/// Inside this corner only.
///
/// A piece is known by where it lies: what was cut from a piece has that piece's number (of several
/// parts the largest), and what lies in a body that was taken out is gone, however its kerfs go on.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

struct PieceBody {
  /// 0 is the first bone; what is cut off gets the next number and keeps it.
  std::int32_t id = 0;
  /// Came free since the pieces were numbered before.
  bool is_new = false;
  double volume_mm3 = 0.0;
  /// A point well inside it; of the fragment's own piece none.
  Vec3 inside_mm{0.0, 0.0, 0.0};
  CutSolid solid;
  /// None before it is asked for: a tree is several times as large as its solid.
  std::unique_ptr<const Bvh> bvh;
};

/// A point inside a solid, half way through it behind the middle of one of its largest triangles.
/// needs   the solid is closed and has triangles; bvh was built over its mesh
Vec3 point_inside(const CutSolid& solid, const Bvh& bvh);

/// Whether most of a piece lies in a body: of points just inside its skin, spread over its
/// triangles.
bool lies_in(const CutSolid& piece, const Bvh& body);

/// Bodies that count and crumbs that do not: a crumb is smaller than debris_limit_mm3.
struct SortedBodies {
  std::vector<CutSolid> bodies;
  std::vector<double> volumes_mm3;
  std::vector<CutSolid> crumbs;
  double debris_mm3 = 0.0;
};
/// ensures both keep their order
SortedBodies sort_bodies(std::vector<CutSolid> solids);

class NumberedPieces {
 public:
  /// One piece.
  /// main    its number, which what is left of the fragment keeps
  explicit NumberedPieces(const CutSolid& whole, std::int32_t main = 0);

  std::int32_t main() const noexcept { return main_; }
  /// Numbers what the kerfs leave now.
  /// solids   as split_pieces gives them, with those that were taken out; largest first
  /// next_id  the next number of the attempt; counted on
  void number(std::vector<CutSolid> solids, std::int32_t& next_id);
  /// Numbers one of the parts into which what is left was divided, as pieces of its own: what lies
  /// in another piece of this than its main one, or `main`, keeps that number.
  /// main     the number of the part itself
  NumberedPieces of_part(const CutSolid& part, std::int32_t main) const;
  /// From now on, what lies in this piece is gone.
  /// errors  null where no piece has this number; else its body, which lives as long as this
  const Bvh* take_out(std::int32_t id);

  /// Largest first, without debris and what was taken out.
  const std::vector<PieceBody>& pieces() const noexcept { return pieces_; }
  double debris_mm3() const noexcept { return debris_mm3_; }
  bool has_taken_out() const noexcept { return !taken_out_.empty(); }
  /// They live as long as this.
  std::vector<const Bvh*> taken_out() const;
  /// Pieces and debris as one solid.
  CutSolid gathered() const { return gathered_without(-1); }
  /// The same without one piece.
  CutSolid gathered_without(std::int32_t id) const;
  /// What is left of a solid of the same bone. Nothing where a piece that was taken out would hang
  /// on the rest again.
  std::optional<CutSolid> without_taken_out(const CutSolid& solid) const;

 private:
  /// The taken-out body in which a solid lies; the number of bodies where it lies in none.
  std::size_t body_of(const CutSolid& solid) const;
  std::int32_t inherited_id(const CutSolid& solid, std::vector<std::int32_t>& taken);
  void keep(std::vector<PieceBody> numbered, SortedBodies sorted);

  std::vector<PieceBody> pieces_;
  std::vector<std::unique_ptr<const Bvh>> taken_out_;
  std::vector<CutSolid> crumbs_;
  double debris_mm3_ = 0.0;
  std::int32_t main_;
};

}  // namespace hallux::simulator
