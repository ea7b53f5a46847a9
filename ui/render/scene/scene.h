/// What is to be seen, as plain data: the screens fill it, the renderer draws it and keeps nothing
/// of it but copies.
///
/// All places are millimetres of the world (foot frame) unless a name says another frame. Pointers
/// are borrowed for the call.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/cutting/field/kerf.h"
#include "ui/render/scene/bone_mesh.h"
#include "ui/render/scene/site.h"
#include "ui/render/scene/tools.h"

namespace hallux::ui {

enum class Ground : std::uint8_t { Dark, Light };

/// The roles that colours have; each has one for dark and one for light grounds. What is planned is
/// Reference everywhere, what the blade does is Accent.
enum class Ink : std::uint8_t { Accent, Reference, Warn, Harm, Plain };

/// Signed distance of cut faces to a planned plane, in colours: too much taken, as planned, left
/// standing.
struct SignedMap {
  /// Faces of this kerf only; -1: of every kerf.
  std::int32_t kerf = 0;
  /// +1 or -1: of this wall only; 0: of both.
  std::int32_t side = 0;
  /// Of the planned face, towards the waste.
  Vec3 normal_in_bone{0.0, 0.0, 1.0};
  /// Normal . p of the planned face.
  double offset_mm = 0.0;
  /// Where the colours end.
  double range_mm = 2.0;

  friend bool operator==(const SignedMap&, const SignedMap&) = default;
};

/// Bone with normal . p > offset is not drawn: what lies behind it is looked into.
struct CutAway {
  Vec3 normal_in_bone{0.0, 0.0, 1.0};
  double offset_mm = 0.0;

  friend bool operator==(const CutAway&, const CutAway&) = default;
};

struct BoneInScene {
  const BoneMesh* mesh = nullptr;
  /// Of the bone; one look serves all its pieces.
  const BoneLook* look = nullptr;
  /// Built on mesh->solid; none: nothing is being cut.
  const simulator::SolidPatch* patch = nullptr;
  /// Another patch has another; never 0 where there is a patch.
  std::uint64_t patch_revision = 0;
  /// Of this piece.
  RigidTransform world_from_bone;
  /// Towards 0 it fades into the ground: a neighbour.
  double presence = 1.0;
  std::optional<SignedMap> map;
  std::optional<CutAway> cut_away;

  friend bool operator==(const BoneInScene&, const BoneInScene&) = default;
};

struct SawInScene {
  RigidTransform world_from_tool;
  simulator::Blade blade;
  bool is_running = false;
  /// Where in its swing the blade stands, [-1, 1]; counts only while it runs.
  double swing = 0.0;
  /// Of hub, neck and grip; towards 0 they are seen through wherever they are. The blade stays.
  double handpiece_presence = 1.0;

  friend bool operator==(const SawInScene&, const SawInScene&) = default;
};

/// The blade alone, translucent: the expert's.
struct BladeGhost {
  RigidTransform world_from_tool;
  simulator::Blade blade;
  Ink ink = Ink::Reference;

  friend bool operator==(const BladeGhost&, const BladeGhost&) = default;
};

/// A rectangle of a plane: its middle, z its normal. Seen edge on it would be a spike: there it
/// fades to what it cuts, its line on the bone with a tick along the normal (plane_fade.h).
struct PlaneGhost {
  RigidTransform world_from_plane;
  Vec2 half_mm{15.0, 12.0};
  Ink ink = Ink::Reference;
  /// Otherwise only its outline.
  bool is_filled = true;
  /// Its dashed line on the bone is drawn, too, within the rectangle.
  bool has_line = true;
  double line_pixels = 2.5;

  friend bool operator==(const PlaneGhost&, const PlaneGhost&) = default;
};

/// Where a plane meets the skins of all bones that are wholly present.
struct CuttingLine {
  /// z is the normal.
  RigidTransform world_from_plane;
  /// The line ends this far from the plane's origin, along its x and y; 0: it does not end there.
  Vec2 half_mm{0.0, 0.0};
  /// Beyond its ends it goes on faintly, so far.
  double faint_mm = 0.0;
  double width_pixels = 2.5;
  Ink ink = Ink::Accent;
  bool is_dashed = false;
  /// Length of a tick along the normal, where the line crosses the plane's x axis; 0: none.
  double tick_mm = 0.0;
  /// Towards 0 it is not seen.
  double presence = 1.0;

  friend bool operator==(const CuttingLine&, const CuttingLine&) = default;
};
/// Those of the planes are counted, too.
inline constexpr std::size_t lines_at_most = 8;

/// One chip of bone.
struct Chip {
  Vec3 place_mm{0.0, 0.0, 0.0};
  float size_mm = 0.15F;
  /// 0 dry and pale, 1 dark.
  float wetness = 0.0F;

  friend bool operator==(const Chip&, const Chip&) = default;
};

enum class MarkShape : std::uint8_t { Disc, Ring, Diamond, Triangle };

/// A mark at a place: a note, a landmark; some pixels large, always before everything.
struct Mark {
  Vec3 place_mm{0.0, 0.0, 0.0};
  double radius_pixels = 6.0;
  Ink ink = Ink::Accent;
  MarkShape shape = MarkShape::Disc;

  friend bool operator==(const Mark&, const Mark&) = default;
};

struct Scene {
  Ground ground = Ground::Dark;
  /// Where the ground is brightest, shares of the picture from the lower left.
  Vec2 light_place{0.5, 0.5};
  std::vector<BoneInScene> bones;
  std::optional<SawInScene> saw;
  std::optional<DriverInScene> driver;
  std::optional<ForcepsInScene> forceps;
  std::vector<ImplantInScene> implants;
  std::vector<HoleInScene> holes;
  std::vector<BladeGhost> blade_ghosts;
  std::vector<PlaneGhost> planes;
  /// At most lines_at_most, with those of the planes.
  std::vector<CuttingLine> lines;
  std::vector<Chip> chips;
  std::vector<Mark> marks;
  std::vector<ZoneInScene> zones;
  std::vector<HeldBone> held;
  std::vector<FreePiece> free_pieces;
  std::optional<ContactHalo> halo;

  friend bool operator==(const Scene&, const Scene&) = default;
};

}  // namespace hallux::ui
