#!/usr/bin/env python3
"""Devices as a script meets them: the real program, hidapi and libusb before devices that are computed and served
(tests/support/served_bus). No device's firmware is anybody's: whatever boot stream it is sent makes it run."""

import json
import os
import pathlib
import shutil
import tempfile
import unittest
import unittest.mock

from hallux_command import (BAD_INPUT, CHECK_FAILED, DONE, NO_DISPLAY, PROGRAM, WRONG_USAGE, CommandTest, coarse_silver)
from inverse_service import InverseService

SERVED_BUS = os.environ["HALLUX_SERVED_BUS"]
RULES = pathlib.Path(os.environ["HALLUX_UDEV_RULES"])
# Of its exchanges: somebody who pulls a plug must have had time to open the device.
OPENED_S = 1.5
TRIES = 5
OF_A_BUSY_MACHINE = ("too_slow", "silent")


def some_firmware(words=3900):
    """A boot stream: key, head, one block of so many words, the end."""
    return (bytes([0xAA, 0x08]) + bytes(20) + words.to_bytes(2, "little") + bytes(4)
            + bytes(i * 31 % 256 for i in range(2 * words)) + bytes(2))


class DeviceTest(CommandTest):
    def tried_out(self, device, *options, fault, exchanges):
        """What `hallux devices test` answers, where it ends with this fault, or with none, after so many exchanges. A machine that
        is kept busy is too slow for a device now and then, or hears nothing of it in time: then it is tried again."""
        for _ in range(TRIES):
            answer = self.hallux("devices", "test", device, "--quiet", *options, "--json")
            found = answer.json().get("fault")
            if found == fault and answer.json()["exchanges"] >= exchanges or found not in (fault, *OF_A_BUSY_MACHINE):
                break
        self.assertEqual((answer.code, found), (CHECK_FAILED if fault else DONE, fault), answer)
        self.assertGreaterEqual(answer.json()["exchanges"], exchanges)
        return answer.json()


class ServedTest(DeviceTest):
    """`devices` are plugged in while the program runs; `later` is (seconds, what, device) each."""
    devices = ()
    later = ()

    def line(self, arguments):
        later = [str(word) for event in self.later for word in ("--at", *event)]
        return ["umockdev-wrapper", SERVED_BUS, *self.devices, *later, "--report", str(self.report_file()), "--",
                *super().line(arguments)]

    def report_file(self):
        return self.folder / "seen.json"

    def seen(self):
        """What the first device saw."""
        return json.loads(self.report_file().read_text())[0]

    def listed(self):
        return {device["id"]: device for device in self.ask("devices")["devices"]}

    def set_firmware(self, image=some_firmware()):
        file = self.folder / "falcon.bin"
        file.write_bytes(image)
        self.ask("devices", "set", "falcon", "firmware", file)
        return file

    def try_out(self, device, *options, fault=None, exchanges=0):
        return self.tried_out(device, *options, fault=fault, exchanges=exchanges)


class Listed(ServedTest):
    devices = ("falcon:serial=F1", "space_mouse", "arm")

    def test_each_stands_there_with_address_library_and_reason(self):
        found = self.listed()
        self.assertEqual(list(found), ["mouse", "falcon", "raw_hid_arm", "space_mouse"])
        falcon, mouse = found["falcon"], found["space_mouse"]
        self.assertEqual(falcon.keys(), {"id", "kind", "class", "name", "library", "address", "usable", "reason", "sentence",
                                         "mend"})
        self.assertEqual((falcon["kind"], falcon["class"], falcon["library"], falcon["address"]),
                         ("falcon", "arm3", "libusb", "/dev/bus/usb/001/002"))
        self.assertEqual((falcon["usable"], falcon["reason"]), (False, "no_firmware"))
        self.assertEqual(falcon["mend"], "hallux devices set falcon firmware FILE")
        self.assertEqual((mouse["class"], mouse["library"], mouse["address"], mouse["usable"], mouse["reason"]),
                         ("rate", "hidapi", "/dev/hidraw1", True, None))
        self.assertEqual((found["raw_hid_arm"]["class"], found["raw_hid_arm"]["usable"]), ("arm6", True))
        self.assertTrue(found["mouse"]["usable"])

    def test_libraries_say_their_versions(self):
        self.assertEqual(self.ask("devices")["libraries"].keys(), {"hidapi", "libusb", "libwebsockets"})

    def test_people_read_the_same(self):
        said = self.hallux("devices").out
        self.assertIn("Novint Falcon: it has no firmware of its own", said)
        self.assertIn("hallux devices set falcon firmware FILE", said)

    def test_a_firmware_makes_the_falcon_usable(self):
        self.set_firmware()
        self.assertTrue(self.listed()["falcon"]["usable"])

    def test_a_file_that_is_no_firmware_any_more_is_named_with_its_byte(self):
        file = self.set_firmware()
        file.write_bytes(b"\x7fELF")
        falcon = self.listed()["falcon"]
        self.assertEqual(falcon["reason"], "bad_firmware")
        self.assertIn(f"{file} is no firmware: byte 0", falcon["sentence"])

    def test_a_record_that_is_wrong_is_named_with_its_place(self):
        record = self.write("arm.json", json.dumps(ARM))
        self.ask("devices", "set", "raw_hid_arm", "geometry", record)
        self.assertTrue(self.listed()["raw_hid_arm"]["usable"])
        record.write_text(json.dumps({**ARM, "links": {**ARM["links"], "first_mm": -1}}))
        arm = self.listed()["raw_hid_arm"]
        self.assertEqual(arm["reason"], "bad_record")
        self.assertIn("links.first_mm", arm["sentence"])


ARM = {"name": "Bench arm",
       "links": {"base_mm": 80, "first_mm": 205, "second_mm": 245, "middle_mm": [220, 0, 80], "workspace_radius_mm": 100},
       "joints": {"capstan_mm": 10, "sector_mm": [160, 120, 120], "counts_per_turn": [2000] * 6, "direction": [1] * 6,
                  "at_rest": [0, 0, 6000, 0, 0, 0]},
       "motors": {"torque_newton_mm_per_ampere": [321, 60.3, 60.3], "current_ampere": 2, "force_newton": 5,
                  "continuous_force_newton": 2.5, "stiffness_newton_per_mm": 1, "damping_newton_s_per_mm": 0.008}}


class Several(ServedTest):
    devices = ("falcon:serial=A1", "falcon:serial=B2", "space_mouse:serial=S", "space_mouse:serial=S")

    def test_two_of_a_kind_are_told_by_serial_and_of_one_serial_by_their_socket(self):
        found = self.listed()
        self.assertLessEqual({"falcon-A1", "falcon-B2"}, found.keys())
        mice = [name for name in found if name.startswith("space_mouse-S@")]
        self.assertEqual(len(set(mice)), 2, found.keys())
        for mouse in mice:
            self.try_out(mouse, "--seconds", "0.5")
            lit = [device["lights"] for device in json.loads(self.report_file().read_text()) if device["name"] == "space_mouse"]
            self.assertEqual(sorted(lit), [[], [True, False]], "one of them, and not the other")


class Closed(ServedTest):
    devices = ("touch",)

    def test_one_whose_maker_keeps_its_protocol_closed_says_so_and_is_not_opened(self):
        touch = self.listed()["touch"]
        self.assertEqual((touch["usable"], touch["class"], touch["reason"]), (False, None, "closed_protocol"))
        self.assertIn("keeps its protocol closed", touch["sentence"])
        self.expect_refusal(NO_DISPLAY, ["keeps its protocol closed"], "devices", "test", "touch")
        self.expect_refusal(NO_DISPLAY, ["keeps its protocol closed"], "attempt", "silver", "--device", "touch", "--seconds", "1")


class Settings(CommandTest):
    def test_a_value_is_kept_beside_the_database_and_unset_again(self):
        self.ask("devices", "set", "falcon", "motion_scale", "1.5")
        kept = json.loads((self.data / "devices.json").read_text())
        self.assertEqual(kept, {"devices": {"falcon": {"motion_scale": 1.5}}})
        self.assertEqual((self.data / "devices.json").stat().st_mode & 0o777, 0o600)
        self.assertEqual(self.data.stat().st_mode & 0o777, 0o700, "people's data will lie there")
        self.ask("devices", "set", "falcon", "motion_scale", "")
        self.assertEqual(json.loads((self.data / "devices.json").read_text()), {"devices": {}})

    def test_what_cannot_be_set_is_refused_and_nothing_is_kept(self):
        for says, *words in (("is no device", "mouse", "motion_scale", "1"), ("is no device", "touch", "motion_scale", "1"),
                             ("is no device", "gold", "motion_scale", "1"), ("cannot be set for it", "space_mouse", "firmware", "x"),
                             ("from 0.25 to 4", "falcon", "motion_scale", "9"), ("from 0 to 1", "falcon", "force_share", "nan"),
                             ("No such file", "falcon", "firmware", "/nowhere.bin")):
            self.expect_refusal(BAD_INPUT, [says], "devices", "set", *words)
        self.assertFalse((self.data / "devices.json").exists())

    def test_a_file_that_somebody_spoiled_is_named(self):
        self.data.mkdir()
        for spoiled in ("{", '{"devices": []}', '{"devices": {"falcon": {"colour": "red"}}}', "[" * 100):
            (self.data / "devices.json").write_text(spoiled)
            self.expect_refusal(BAD_INPUT, ["devices.json"], "devices")

    def test_the_rules_are_the_file_that_is_installed(self):
        self.assertEqual(self.hallux("devices", "rules").out, RULES.read_text())


class WithoutRights(ServedTest):
    """Run by nobody, whom the system gives nothing."""
    devices = ("falcon:serial=F1,no-rights", "space_mouse:no-rights")
    program_user = {"user": "nobody", "group": "nogroup", "extra_groups": []} if os.geteuid() == 0 else {}

    def setUp(self):
        super().setUp()
        # Nobody may not look into every folder in which a program was built.
        public = tempfile.TemporaryDirectory(prefix="hallux-nobody-")
        self.addCleanup(public.cleanup)
        self.public = pathlib.Path(public.name)
        for program in (PROGRAM, SERVED_BUS):
            shutil.copy(program, self.public)
        for place in (self.public, self.folder, *self.untouched):
            place.chmod(0o777)
        self.data.mkdir()
        self.data.chmod(0o777)

    def line(self, arguments):
        copies = {program: str(self.public / pathlib.Path(program).name) for program in (PROGRAM, SERVED_BUS)}
        return [copies.get(word, word) for word in super().line(arguments)]

    def environment(self):
        # The passwords' library may lie where nobody may look.
        return {**{name: value for name, value in super().environment().items() if name != "LD_PRELOAD"},
                "TMPDIR": str(self.public)}

    def test_who_may_not_open_them_is_told_the_rule(self):
        found = self.listed()
        for device, node in (("falcon", "/dev/bus/usb/001/002"), ("space_mouse", "/dev/hidraw1")):
            self.assertEqual((found[device]["usable"], found[device]["reason"]), (False, "no_permission"), found[device])
            self.assertIn(f"may not open {node}", found[device]["sentence"])
            self.assertIn("hallux devices rules | sudo tee", found[device]["mend"])
        self.expect_refusal(NO_DISPLAY, ["may not open"], "devices", "test", "space_mouse")

    def test_with_the_rights_of_the_rule_they_are_usable(self):
        self.devices = ("falcon:serial=F1", "space_mouse")
        found = self.listed()
        self.assertTrue(found["space_mouse"]["usable"])
        self.assertEqual(found["falcon"]["reason"], "no_firmware")


class Falcon(ServedTest):
    devices = ("falcon",)

    def setUp(self):
        super().setUp()
        self.set_firmware()

    def test_is_loaded_homed_and_exchanged_with(self):
        answer = self.try_out("falcon", "--seconds", "2.5", exchanges=1000)
        self.assertEqual((answer["bad_packets"], answer["homed"]), (0, True))
        self.assertEqual(answer["greatest_force_newton"], 0.0)
        self.assertGreater(answer["rate_hz"], 200)
        self.assertLess(0, answer["round_trip_us"]["p50"])
        self.assertTrue(self.seen()["runs"])
        self.assertEqual(self.seen()["motors"], [0, 0, 0])

    def test_one_that_runs_already_is_not_loaded_again(self):
        self.devices = ("falcon:loaded",)
        self.try_out("falcon", "--seconds", "0.2")

    def test_a_wall_is_felt_where_it_was_asked_for(self):
        self.devices = ("falcon:loaded",)
        answer = self.try_out("falcon", "--seconds", "2", "--wall", "0.5")
        self.assertGreater(answer["greatest_force_newton"], 0.2)
        self.assertLessEqual(answer["greatest_force_newton"], 6.0)
        self.assertEqual(self.seen()["motors"], [0, 0, 0], "nothing is left")

    def test_one_that_nobody_brings_home_says_how(self):
        self.devices = ("falcon:loaded,unhomed",)
        answer = self.try_out("falcon", "--home-within", "1", fault="not_homed")
        self.assertEqual((answer["homed"], answer["greatest_force_newton"]), (False, 0.0))
        self.assertIn("pull the grip out fully", self.hallux("devices", "test", "falcon", "--home-within", "1").out)

    def test_silence_and_rubbish_leave_no_force(self):
        self.devices = ("falcon:loaded",)
        for what, fault in (("silent", "silent"), ("garbled", "garbled")):
            with self.subTest(fault=fault):
                self.later = ((OPENED_S, what, "falcon"),)
                answer = self.try_out("falcon", "--seconds", "6", "--wall", "0.5", fault=fault)
                self.assertLessEqual(answer["zero_after_packets"], 5)
                self.assertEqual(self.seen()["motors"], [0, 0, 0])

    def test_longer_answers_harm_nobody(self):
        self.devices, self.later = ("falcon:loaded",), ((OPENED_S, "long", "falcon"),)
        self.try_out("falcon", "--seconds", "3")

    def test_pulled_out_it_is_unplugged(self):
        self.devices, self.later = ("falcon:loaded",), ((OPENED_S, "pull", "falcon"),)
        answer = self.try_out("falcon", "--seconds", "6", fault="unplugged")
        self.assertLessEqual(answer["zero_after_packets"], 5)

    def test_pulled_out_while_it_is_loaded_it_is_unplugged(self):
        self.later = ((0.25, "pull", "falcon"),)
        self.try_out("falcon", fault="unplugged")

    def test_a_wrong_echo_is_told(self):
        self.devices = ("falcon:wrong-echo=500",)
        self.try_out("falcon", fault="wrong_echo")

    def test_one_that_another_program_has_is_told(self):
        self.devices = ("falcon:loaded,taken",)
        self.try_out("falcon", fault="busy")
        self.expect_refusal(NO_DISPLAY, ["another program has it", "fuser -v"], "attempt", "silver", "--device", "falcon",
                            "--seconds", "1")

    def test_one_that_is_not_there_says_so(self):
        self.devices = ("space_mouse",)
        self.expect_refusal(NO_DISPLAY, ["is not plugged in", "hallux devices"], "devices", "test", "falcon")


class SpaceMouse(ServedTest):
    def test_is_lit_while_it_is_used_and_heard(self):
        for device in ("space_mouse", "space_mouse:older"):
            with self.subTest(device=device):
                self.devices = (device,)
                answer = self.try_out("space_mouse", "--seconds", "2", exchanges=500)
                self.assertEqual(answer["bad_packets"], 0)
                self.assertEqual(self.seen()["lights"], [True, False])

    def test_pulled_out_it_is_unplugged(self):
        self.devices, self.later = ("space_mouse",), ((OPENED_S, "pull", "space_mouse"),)
        self.try_out("space_mouse", "--seconds", "6", fault="unplugged")


class Arm(ServedTest):
    devices = ("arm:pressed",)

    def test_is_calibrated_by_its_button_and_exchanged_with(self):
        answer = self.try_out("raw_hid_arm", "--seconds", "2", exchanges=1000)
        self.assertEqual((answer["bad_packets"], answer["homed"]), (0, True))

    def test_one_that_nobody_calibrates_says_how(self):
        self.devices = ("arm",)
        answer = self.try_out("raw_hid_arm", "--home-within", "1", fault="not_calibrated")
        self.assertEqual((answer["homed"], answer["greatest_force_newton"]), (False, 0.0))
        self.assertIn("hold its button", self.hallux("devices", "test", "raw_hid_arm", "--home-within", "1").out)

    def test_silence_and_rubbish_are_told(self):
        for what in ("silent", "garbled"):
            with self.subTest(fault=what):
                self.later = ((2.5, what, "arm"),)
                answer = self.try_out("raw_hid_arm", "--seconds", "8", "--wall", "0.3", fault=what)
                self.assertLessEqual(answer["zero_after_packets"], 5)
                self.assertEqual(self.seen()["motors"], [0, 0, 0])


class Inverse(DeviceTest):
    def serve(self, **how):
        """The station asks this service from now on."""
        service = InverseService(**how)
        self.addCleanup(service.close)
        self.ask("devices", "set", "inverse3", "service_port", str(service.port))
        return service

    def listed(self):
        return {device["id"]: device for device in self.ask("devices")["devices"]}

    def try_out(self, *options, fault=None, exchanges=0):
        return self.tried_out("inverse3", *options, fault=fault, exchanges=exchanges)

    def test_it_is_listed_as_its_service_names_it(self):
        service = self.serve()
        found = self.listed()
        self.assertEqual(list(found), ["mouse", "inverse3"])
        self.assertEqual([found["inverse3"][key] for key in ("kind", "class", "library", "address", "usable", "reason")],
                         ["inverse3", "arm3", "libwebsockets", f"ws://127.0.0.1:{service.port}", True, None])
        service.arms = ("049D", "1234")
        self.assertEqual(list(self.listed()), ["mouse", "inverse3-049D", "inverse3-1234"])

    def test_it_is_exchanged_with_under_both_words_for_a_force(self):
        for keys, version in ((("vector",), "3.5.0"), (("values",), "3.1.1"), (("values",), "3.5.0"), (("vector",), None)):
            with self.subTest(keys=keys, version=version):
                service = self.serve(keys=keys, version=version)
                answer = self.try_out("--seconds", "2", "--wall", "0.5", exchanges=1000)
                self.assertEqual((answer["bad_packets"], answer["homed"]), (0, True))
                self.assertGreater(service.greatest, 0.2)
                self.assertLessEqual(service.greatest, 6.0)
                self.assertAlmostEqual(answer["own_force_scale"], 1.0, delta=0.1)
                self.assertEqual(service.force_left(), 0.0)

    def test_messages_in_pieces_are_put_together(self):
        self.serve(fault="fragments")
        self.try_out("--seconds", "0.5")

    def test_silence_rubbish_and_a_service_that_goes_leave_no_force(self):
        for what, fault in (("silent", "silent"), ("garbled", "garbled"), ("long", "garbled"), ("deep", "garbled"),
                            ("nan", "garbled"), ("gone", "service_gone")):
            with self.subTest(fault=what):
                service = self.serve(fault=what, fault_after=300)
                answer = self.try_out("--seconds", "6", "--wall", "0.5", fault=fault)
                self.assertLessEqual(answer["zero_after_packets"], 5)
                if what != "gone":
                    self.assertEqual(service.force_left(), 0.0)

    def test_one_that_understands_no_word_is_told(self):
        self.serve(keys=())
        self.try_out("--seconds", "6", "--wall", "0.5", fault="service_version")

    def test_uncalibrated_it_is_given_no_force(self):
        service = self.serve(calibrated=False)
        self.try_out("--home-within", "0.5", "--wall", "0.5", fault="not_calibrated")
        self.assertEqual(service.greatest, 0.0)

    def test_what_cannot_be_used_says_why(self):
        for how, reason, word in (({"version": "3.0.5"}, "service_version", "(3.0)"), ({"kind": "minverse"}, "wrong_model", "(minverse)"),
                                  ({"first": '{"inverse3": {"049D": {}}}'}, "service_version", "(3.0)"),
                                  ({"first": "[" * 1000}, "service_version", "no list of devices")):
            with self.subTest(**how):
                self.serve(**how)
                found = self.listed()["inverse3"]
                self.assertEqual((found["usable"], found["reason"]), (False, reason))
                self.assertIn(word, found["sentence"])
                self.expect_refusal(NO_DISPLAY, [word], "devices", "test", "inverse3")

    def test_without_its_service_only_who_asks_is_told(self):
        self.serve().close()
        found = self.listed()["inverse3"]
        self.assertEqual((found["usable"], found["reason"]), (False, "no_service"))
        self.assertIn("service_port PORT", found["mend"])
        self.ask("devices", "set", "inverse3", "service_port", "")
        self.assertNotIn("inverse3", self.listed())
        self.expect_refusal(NO_DISPLAY, ["its service does not answer"], "devices", "test", "inverse3")
        self.expect_refusal(NO_DISPLAY, ["its service does not answer"], "attempt", "silver", "--device", "inverse3", "--seconds", "1")

    def test_an_attempt_is_recorded_with_its_own_scale(self):
        self.serve()
        answer = self.ask("attempt", self.write("coarse.json", coarse_silver()), "--device", "inverse3", "--seconds", "1", "--quiet")
        device = answer["quality"]["device"]
        self.assertEqual((device["kind"], device["class"], device["library"]), ("inverse3", "arm3", "libwebsockets"))
        self.assertIn("own_force_scale", device)
        self.assertIsNone(device["calibration_age_s"], "it was calibrated before anybody looked")
        self.assertIs(self.ask("replay", answer["attempt"])["identical"], True)

    def test_no_proxy_is_asked_for_what_is_on_this_machine(self):
        self.serve()
        with unittest.mock.patch.dict(os.environ, {"http_proxy": "http://127.0.0.1:9", "https_proxy": "http://127.0.0.1:9"}):
            self.assertTrue(self.listed()["inverse3"]["usable"])

    def test_a_port_belongs_to_the_service_and_not_to_one_arm(self):
        self.expect_refusal(BAD_INPUT, ["set it for inverse3"], "devices", "set", "inverse3-049D", "service_port", "2000")

    def test_a_port_that_is_none_is_refused(self):
        for port in ("80", "70000", "2000.5", "x"):
            self.expect_refusal(BAD_INPUT, ["from 1024 to 65535"], "devices", "set", "inverse3", "service_port", port)


class Operated(ServedTest):
    devices = ("falcon:loaded",)

    def operate(self, seconds):
        self.set_firmware()
        return self.ask("attempt", self.write("coarse.json", coarse_silver()), "--device", "falcon", "--seconds", seconds,
                        "--quiet")

    def test_an_attempt_is_recorded_replays_identical_and_names_its_device(self):
        answer = self.operate(2)
        device = answer["quality"]["device"]
        self.assertEqual((device["kind"], device["class"], device["library"], device["motion_scale"]),
                         ("falcon", "arm3", "libusb", 1.0))
        self.assertGreater(device["packets"], 200)
        self.assertGreater(device["round_trip_us"]["p99"], 0)
        self.assertGreater(device["calibration_age_s"], 1.0)
        self.assertEqual(answer["quality"]["force_scale"], 0.18)
        self.assertIs(self.ask("replay", answer["attempt"])["identical"], True)
        self.assertEqual(self.query("SELECT device_class, pacing FROM attempt"), [("arm3", "real_time")])

    def test_pulled_out_midway_it_pauses_and_goes_on_when_it_is_there_again(self):
        self.later = ((4, "pull", "falcon"), (5, "plug", "falcon"))
        answer = self.operate(7)
        self.assertGreaterEqual(answer["quality"]["pauses"], 1)
        self.assertGreaterEqual(answer["quality"]["faulted_ticks"], 100)
        self.assertIs(self.ask("replay", answer["attempt"])["identical"], True)

    def test_it_may_come_back_in_another_socket(self):
        self.devices = ("falcon:serial=A1,loaded", "falcon:serial=A1,loaded,absent")
        self.later = ((4, "pull", "0"), (5, "plug", "1"))
        answer = self.operate(7)
        self.assertGreaterEqual(answer["quality"]["pauses"], 1)
        first, second = json.loads(self.report_file().read_text())
        self.assertGreater(second["packets"], 200, "it went on where it is now")
        self.assertGreater(first["packets"], 200)
        self.assertIs(self.ask("replay", answer["attempt"])["identical"], True)

    def test_how_long_must_be_said(self):
        self.expect_refusal(WRONG_USAGE, ["--seconds"], "attempt", "silver", "--device", "falcon")
        self.expect_refusal(WRONG_USAGE, ["--device ID"], "attempt", "silver", "--seconds", "2")
        self.expect_refusal(NO_DISPLAY, ["is not plugged in"], "attempt", "silver", "--device", "space_mouse", "--seconds", "2")


if __name__ == "__main__":
    unittest.main()
