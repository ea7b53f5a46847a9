/// How well the teeth of a saw are seen along its blade.
#pragma once

#include <array>
#include <span>

#include "ui/render/scene/camera.h"
#include "ui/screens/pictures/contact_halo.h"

namespace hallux::ui {

/// Share of the tooth line that bones hide from one who looks along the blade, by BladeSight. Bone
/// that is only touched hides nothing; the handpiece is no bone: it is drawn faint where it is in
/// the way.
std::array<double, blade_sight_count> hidden_along_blade(std::span<const BoneSurface> bones,
                                                         const RigidTransform& world_from_tool,
                                                         const simulator::Blade& blade) noexcept;

/// How present the handpiece is for one who looks from there: faint where it is looked over.
double handpiece_presence_from(const RigidTransform& world_from_tool,
                               const Vec3& eye_in_world_mm) noexcept;

}  // namespace hallux::ui
