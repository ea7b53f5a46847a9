/// What the record of an attempt has opened and left so far: kerfs, bores, implants, and the
/// fragments that they are in. Follows all that a step says, as everybody does who follows the
/// record. Inside this corner only.
#pragma once

#include <span>

#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/hole/bore_set.h"
#include "simulator/cutting/hole/implant_set.h"

namespace hallux::simulator {

class FollowedRecord {
 public:
  /// Takes all its memory here.
  FollowedRecord(const Tray& tray, const FragmentPoses& fragments)
      : kerfs_(tray, fragments), bores_(tray), implants_(tray) {}

  const KerfSet& kerfs() const noexcept { return kerfs_; }
  const BoreSet& bores() const noexcept { return bores_; }
  const ImplantSet& implants() const noexcept { return implants_; }
  const FragmentPoses& fragments() const noexcept { return kerfs_.fragments(); }
  const Tray& tray() const noexcept { return kerfs_.tray(); }

  /// errors  false where one of them refuses it
  bool apply(const CutEvent& event) noexcept {
    return kerfs_.apply(event) && bores_.apply(event, fragments()) &&
           implants_.apply(event, fragments());
  }
  /// The kerfs that rose.
  std::span<const RisenKerf> apply(const ToolSample& sample) noexcept {
    bores_.apply(sample, fragments());
    return kerfs_.apply(sample);
  }
  void make_tiles_ready(std::size_t ahead, std::size_t at_once) noexcept {
    kerfs_.make_tiles_ready(ahead, at_once);
  }

 private:
  KerfSet kerfs_;
  BoreSet bores_;
  ImplantSet implants_;
};

}  // namespace hallux::simulator
