#include "simulator/device/passivity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hallux::simulator {
namespace {

/// 1 N/mm, and a damper of at most 0.02 N s/mm.
constexpr PassivitySettings device{.spring_newton_per_mm = 1.0, .damping_newton_s_per_mm = 0.02};

HandleMotion moved(double way_mm) { return {{way_mm, 0.0, 0.0}, 0.001}; }
Vec3 along_x(double newton) { return {newton, 0.0, 0.0}; }

TEST(Passivity, CountsTheForceThatActed) {
  EnergyAccount account;
  note_made(account, along_x(-1.5));
  kept_passive(account, device, moved(0.2), along_x(-2.0));
  EXPECT_DOUBLE_EQ(account.energy_millijoule, 0.3) << "1.5 N held against over 0.2 mm";
}

/// A device whose forces are sent an exchange later and act a tick after that.
constexpr PassivitySettings late = [] {
  PassivitySettings settings = device;
  settings.exchanges_until_sent = settings.transport_ticks = 1;
  return settings;
}();

/// -1, -2 and -3 N, a tick each, while nothing moves.
void tell_three(EnergyAccount& account) {
  for (const double newton : {-1.0, -2.0, -3.0}) {
    kept_passive(account, late, moved(0.0), along_x(newton));
    note_made(account, along_x(newton));
  }
}

TEST(Passivity, KnowsThatAForceComesLater) {
  EnergyAccount account;
  tell_three(account);
  kept_passive(account, late, moved(0.1), along_x(-4.0));
  EXPECT_DOUBLE_EQ(account.energy_millijoule, 0.1) << "the oldest of three";
}

TEST(Passivity, CountsWhatActedInEachTickOfALineOfThree) {
  EnergyAccount account;
  tell_three(account);
  // The device was told -2 N before these three ticks: in the first of them the -1 N before that
  // still act.
  kept_passive(account, late, {{0.3, 0.0, 0.0}, 0.003}, along_x(-4.0));
  EXPECT_DOUBLE_EQ(account.energy_millijoule, 0.1 * (1.0 + 2.0 + 2.0));
}

TEST(Passivity, DampsWhatWouldComeBackUnpaid) {
  EnergyAccount account;
  const Vec3 given = kept_passive(account, device, moved(-0.1), along_x(-1.0));
  // The force pulls along the motion and nothing was put in: 0.375 + 0.1 mJ are missing, of 0.02 x
  // 100 x 0.1 = 0.2 mJ a tick.
  EXPECT_DOUBLE_EQ(given.x, -1.0 + 0.02 * 100.0);
}

TEST(Passivity, DampsNoMoreThanIsMissing) {
  EnergyAccount account;
  account.energy_millijoule = 0.375 + 0.1 - 0.05;
  const Vec3 given = kept_passive(account, device, moved(-0.1), along_x(-1.0));
  EXPECT_NEAR(given.x, -1.0 + 0.05 / 0.1, 1.0e-12) << "0.05 mJ over 0.1 mm";
}

TEST(Passivity, LeavesAPaidForceAlone) {
  EnergyAccount account;
  account.energy_millijoule = 0.5;
  EXPECT_EQ(kept_passive(account, device, moved(-0.1), along_x(-1.0)), along_x(-1.0));
}

TEST(Passivity, WhatIsSawnDoesNotPayForWhatComesLater) {
  EnergyAccount account;
  for (int tick = 0; tick < 1000; ++tick) {
    kept_passive(account, device, moved(0.01), along_x(-2.0));
    note_made(account, along_x(-2.0));
  }
  EXPECT_LE(account.energy_millijoule, 2.0 * 2.0 * 2.0 / 2.0) << "twice what the spring may hold";
  kept_passive(account, device, moved(0.01), along_x(0.0));
  EXPECT_LE(account.energy_millijoule, 0.0) << "out of contact there is no store";
}

TEST(Passivity, ADebtIsKeptOverAShortBounceAndForgottenAfterTheContact) {
  EnergyAccount account;
  account.energy_millijoule = -0.8;
  for (int tick = 0; tick < 100; ++tick) kept_passive(account, device, moved(0.0), along_x(0.0));
  EXPECT_DOUBLE_EQ(account.energy_millijoule, -0.8);
  for (int tick = 0; tick < 150; ++tick) kept_passive(account, device, moved(0.0), along_x(0.0));
  EXPECT_EQ(account.energy_millijoule, 0.0);
}

TEST(Passivity, AHandleThatHardlyMovesIsNotDamped) {
  EnergyAccount account;
  account.energy_millijoule = -5.0;
  EXPECT_EQ(kept_passive(account, device, moved(0.0009), along_x(1.0)), along_x(1.0));
}

}  // namespace
}  // namespace hallux::simulator
