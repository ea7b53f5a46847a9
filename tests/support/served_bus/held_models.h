/// Modelled devices with an arm's mass and a hand: what their motors do moves the grip, and their
/// encoders say where it is. A millisecond passes with each packet.
#pragma once

#include "simulator/device/modelled/arm_model.h"
#include "simulator/device/raw_hid_arm/arm_geometry.h"
#include "tests/support/served_bus/falcon_model.h"
#include "tests/support/served_bus/hid_models.h"

namespace hallux::tests {

/// The grip in the device's frame, from the middle of its workspace.
struct HeldGrip {
  simulator::ArmState arm;
  simulator::ArmTraits traits;
  simulator::HandGrip hand;
  /// The least of what the motors took beyond what they gave, so far: below 0, they gave energy.
  double least_of_motors_millijoule = 0.0;

  void pass(const Vec3& force_newton);
};

/// Homed and running. Borrows both for as long as the model is used.
void hold(FalconModel& falcon, HeldGrip& grip, double counts_per_newton_metre);
/// Near the middle of its workspace, whose place becomes the grip's.
void hold(ArmModel& board, HeldGrip& grip, const simulator::ArmGeometry& geometry);

}  // namespace hallux::tests
