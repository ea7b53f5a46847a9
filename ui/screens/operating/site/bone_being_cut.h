/// The bone while it is operated on, for the picture: a thread that follows the feed of the loop
/// and never feeds anything back.
///
///     feed of the loop --> LiveCut --> patch of the kerf at hand --> newest picture
///                             |        on a fragment that stands still
///                             |--> another kerf, a fragment that parted or lost a piece: a mesh
///                             |    of its own, and where each fragment lies
///                             |--> wires, screws and holes
///                             |--> pieces that came free: meshes for their outlines
///                             '--> the section in the blade's plane, at most 20 times a second
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/jobs/live_cut.h"
#include "ui/jobs/live_attempt.h"
#include "ui/render/scene/scene.h"
#include "ui/screens/operating/site/metal_in_bone.h"
#include "ui/screens/operating/site/site_survey.h"
#include "ui/screens/pictures/blade_section.h"
#include "ui/screens/pictures/contact_halo.h"

namespace hallux::ui {

/// The picture of a bone before anything was cut; a job's work.
struct BonePicture {
  BoneLook look;
  std::shared_ptr<const BoneMesh> mesh;
  /// Over the mesh's solid: the case's own.
  std::shared_ptr<const simulator::Bvh> tree;
};

/// By bone.
using BonePictures = std::vector<BonePicture>;

/// errors  Cancelled
BonePictures pictures_of(const std::shared_ptr<const PreparedCase>& prepared_case,
                         const std::filesystem::path& data_directory,
                         const Progress& progress = {});

/// A fragment as it is shown, without what the kerf at hand takes; borrowed.
struct FragmentSurface {
  const BoneMesh* mesh = nullptr;
  const simulator::Bvh* tree = nullptr;
  RigidTransform world_from_fragment;
};

/// When a section is to be made anew: often enough to be live, not more often than its plane moved
/// or its kerf grew.
class SectionClock {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `opened` is another where the kerf has opened more.
  bool is_due(const RigidTransform& bone_from_plane, std::uint64_t opened, Time now);

 private:
  std::optional<RigidTransform> bone_from_plane_;
  std::uint64_t opened_ = 0;
  Time last_;
};

class BoneBeingCut {
 public:
  /// The bones of any loop that is watched. Borrows case and watch; nobody else may take its feed.
  /// name    of the attempt, for the names of its pictures
  BoneBeingCut(std::string name, const PreparedCase& prepared_case, simulator::AttemptWatch& watch,
               BonePictures pictures);
  ~BoneBeingCut();
  BoneBeingCut(const BoneBeingCut&) = delete;
  BoneBeingCut& operator=(const BoneBeingCut&) = delete;

  /// Adds the bone to the scene as it is known now; borrowed until the next call.
  /// thread  window
  void add_to(Scene& scene);
  /// Adds the pieces that are to be taken out; borrowed likewise.
  /// needs   add_to was called in this frame
  /// thread  window
  void add_free_pieces(Scene& scene) const;
  /// What lies in the plane of the kerf at hand, or of the blade while it is away from it, in the
  /// frame of the first bone; null before the loop's first step.
  /// thread  window
  std::shared_ptr<const KerfSection> section();
  /// What is known of the site; null before the loop's first step.
  /// thread  window
  std::shared_ptr<const SiteFacts> site();
  /// The fragments as rays find them, without what the kerf at hand takes; borrowed likewise.
  /// needs   add_to was called in this frame
  /// thread  window
  std::vector<BoneSurface> surfaces() const;
  /// Nothing where there is none of that number. Borrowed likewise.
  /// needs   add_to was called in this frame
  /// thread  window
  std::optional<FragmentSurface> fragment(std::int32_t number) const;
  /// What happened since the last call.
  /// thread  window
  std::vector<simulator::CutEvent> take_events();
  /// Whether the bone is shown as the last of the feed left it, with nothing waiting.
  bool is_up_to_date() const noexcept { return is_up_to_date_.load(std::memory_order_acquire); }
  /// The picture stands still, for want of memory; the attempt does not.
  bool has_failed() const noexcept { return has_failed_.load(std::memory_order_acquire); }

 private:
  struct Body {
    std::shared_ptr<const BoneMesh> mesh;
    std::shared_ptr<const simulator::Bvh> tree;
    /// Of its bone.
    const BoneLook* look = nullptr;
  };
  struct PieceMesh {
    std::int32_t id = 0, fragment = 0;
    std::shared_ptr<const BoneMesh> mesh;
  };
  /// The newest picture.
  struct Shown {
    /// By fragment; nothing of one that is out of the wound.
    std::vector<std::optional<Body>> bodies;
    std::vector<RigidTransform> world_from_fragments;
    /// On the body of that fragment.
    simulator::SolidPatch patch;
    std::size_t patched = 0;
    /// 0: no patch.
    std::uint64_t patch_revision = 0;
    std::vector<PieceMesh> free_pieces;
    MetalShown metal;
  };

  void run(const std::stop_token& stop);
  void show_feed(const std::stop_token& stop);
  bool take_feed();
  void note(const simulator::CutEvent& event);
  void bring_up_to_date();
  void show_base(simulator::PatchBase base);
  void show_patch();
  void show_fragment(const simulator::DueFragment& due);
  void show_free_pieces(const std::vector<simulator::FreedPiece>& pieces);
  void show_places();
  const BoneLook& look_of(std::int32_t fragment) const noexcept;
  Body lit_body(const simulator::CutSolid& solid, std::shared_ptr<const simulator::Bvh> tree,
                const BoneLook& look);
  std::uint64_t next_mesh_id();
  std::int32_t fragment_to_section() const;
  void renew_section();
  void renew_site();

  const std::string name_;
  const RigidTransform world_from_bone_;
  const BonePictures pictures_;
  simulator::AttemptWatch& watch_;
  // the thread's
  simulator::LiveCut cut_;
  /// By fragment, as it is shown without the patch.
  std::vector<std::optional<Body>> bodies_;
  simulator::SolidPatch patch_;
  std::uint64_t next_revision_ = 1;
  int meshes_ = 0;
  /// Of the newest sample; nothing before the first.
  std::optional<RigidTransform> world_from_tool_;
  MetalInBone metal_;
  SectionClock section_clock_;
  SiteSurvey survey_;
  // between the two
  std::mutex turn_;
  Shown newest_;
  std::vector<simulator::CutEvent> events_;
  std::shared_ptr<const KerfSection> section_;
  std::shared_ptr<const SiteFacts> site_;
  std::atomic<bool> is_up_to_date_{true}, has_failed_{false};
  // the window's
  Shown drawn_;
  std::shared_ptr<const SiteFacts> drawn_site_;
  /// Last: joined before any of it goes.
  std::jthread thread_;
};

}  // namespace hallux::ui
