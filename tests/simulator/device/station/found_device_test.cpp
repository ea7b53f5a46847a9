#include "simulator/device/station/found_device.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

FoundDevice device(DeviceKind kind, std::string serial = {}, std::string bus_path = {}) {
  FoundDevice made;
  made.kind = kind;
  made.serial = std::move(serial);
  made.bus_path = std::move(bus_path);
  return made;
}

std::vector<std::string> ids_of(std::vector<FoundDevice> devices) {
  name_apart(devices);
  std::vector<std::string> ids;
  ids.reserve(devices.size());
  for (const FoundDevice& each : devices) ids.push_back(each.id);
  return ids;
}

TEST(FoundDevice, IsNamedAsShortlyAsItIsTold) {
  using Ids = std::vector<std::string>;
  EXPECT_EQ(ids_of({device(DeviceKind::Falcon, "A1"), device(DeviceKind::SpaceMouse, "B2")}),
            (Ids{"falcon", "space_mouse"}));
  EXPECT_EQ(ids_of({device(DeviceKind::Falcon, "A1"), device(DeviceKind::Falcon, "B2")}),
            (Ids{"falcon-A1", "falcon-B2"}));
  EXPECT_EQ(
      ids_of({device(DeviceKind::Falcon, "A1", "1-2"), device(DeviceKind::Falcon, "A1", "1-3"),
              device(DeviceKind::Falcon, "", "1-4"), device(DeviceKind::Falcon, "", "1-5")}),
      (Ids{"falcon-A1@1-2", "falcon-A1@1-3", "falcon@1-4", "falcon@1-5"}));
}

TEST(FoundDevice, KindsAreToldByNumberAndUse) {
  EXPECT_EQ(usb_kind(0x0403, 0xCB48)->kind, DeviceKind::Falcon);
  EXPECT_EQ(usb_kind(0x0403, 0x6001), nullptr) << "the same bridge in another thing";
  EXPECT_EQ(usb_kind(0x1451, 0x0402)->kind, DeviceKind::ForceDimension);
  EXPECT_EQ(usb_kind(0x2988, 0x0302)->kind, DeviceKind::Touch);
  EXPECT_EQ(hid_kind(0x16C0, 0x0486, {0xFFAB, 0x0200})->kind, DeviceKind::RawHidArm);
  EXPECT_EQ(hid_kind(0x16C0, 0x0486, {0xFFC9, 0x0004}), nullptr) << "another maker's board";
  EXPECT_EQ(hid_kind(0x256F, 0xC635, multi_axis_controller)->kind, DeviceKind::SpaceMouse);
  EXPECT_EQ(hid_kind(0x046D, 0xC077, {0x01, 0x02}), nullptr);
}

TEST(FoundDevice, IdsOfKindsAreKnown) {
  for (const DeviceKind kind : {DeviceKind::Mouse, DeviceKind::Falcon, DeviceKind::RawHidArm,
                                DeviceKind::Inverse3, DeviceKind::SpaceMouse, DeviceKind::Touch,
                                DeviceKind::ForceDimension, DeviceKind::FireWireOmni}) {
    EXPECT_EQ(facts_of(kind).kind, kind);
    EXPECT_EQ(kind_named(facts_of(kind).id), &facts_of(kind));
  }
  EXPECT_EQ(kind_named("falcons"), nullptr);
}

TEST(FoundDevice, WhatMustBeSetFirstIsTold) {
  EXPECT_EQ(trouble_with_settings(DeviceKind::Falcon, {}).trouble, DeviceTrouble::NoFirmware);
  DeviceSettings settings;
  settings.firmware = "/nowhere/falcon.bin";
  EXPECT_EQ(trouble_with_settings(DeviceKind::Falcon, settings),
            (TroubleReport{DeviceTrouble::BadFirmware, "/nowhere/falcon.bin",
                           "byte 0: No such file or directory"}));
  EXPECT_FALSE(trouble_with_settings(DeviceKind::RawHidArm, {}));
  settings.geometry_fault = "links.first_mm: must be above 0";
  EXPECT_EQ(trouble_with_settings(DeviceKind::RawHidArm, settings).trouble,
            DeviceTrouble::BadRecord);
}

TEST(StationSettings, ADevicesOwnComeBeforeItsKinds) {
  StationSettings settings;
  settings.devices["falcon"].motion_scale = 2.0;
  settings.devices["falcon-A1"].motion_scale = 0.5;
  EXPECT_EQ(settings.of("falcon-A1", "falcon").motion_scale, 0.5);
  EXPECT_EQ(settings.of("falcon-B2", "falcon").motion_scale, 2.0);
  EXPECT_FALSE(settings.of("space_mouse", "space_mouse").motion_scale);
}

TEST(StationSettings, APersonNeverFeelsMoreForceThanTheStationAllows) {
  DeviceSettings set;
  EXPECT_EQ(hold_of(set, {}).force_share, 1.0);
  EXPECT_EQ(hold_of(set, {1.5, 0.5}).force_share, 0.5);
  set.force_share = 0.25;
  set.motion_scale = 2.0;
  EXPECT_EQ(hold_of(set, {}).motion_scale, 2.0);
  EXPECT_EQ(hold_of(set, {1.5, 0.5}).motion_scale, 1.5);
  EXPECT_EQ(hold_of(set, {1.5, 0.5}).force_share, 0.25);
  EXPECT_EQ(hold_of(set, {1.5, 0.1}).force_share, 0.1);
}

}  // namespace
}  // namespace hallux::simulator
