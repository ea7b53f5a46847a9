"""What `hallux export` wrote of one attempt, as docs/data_format.md tells it ("Exported", "For who recomputes")."""

import csv
import functools
import json
import struct

from outsider.geometry import Plane, pose_from_matrix, pose_from_quanta

# docs/data_format.md, "For who recomputes": bits of a sample's status.
RUNNING, SAW_ON, IN_CONTACT, CUTTING, IN_KERF, IRRIGATED = (1 << bit for bit in range(6))
IN_BORE, DRIVE_ON, BORING = (1 << bit for bit in range(8, 11))
# The same: kinds of events.
STARTED, PLANE_FROZEN, BREAK_THROUGH, PIECE_REMOVED, STEP_DONE, FINISHED, HINGE_CLOSED, STEP_REOPENED = (
    1, 4, 6, 9, 10, 14, 17, 24)
FRAGMENT_PARTED, TOOL_CHOSEN, IMPLANT_TAKEN = 25, 29, 40
# Ticks that one line of the tape covers at most: what is further apart was not recorded between.
TICKS_PER_LINE = 3


class Sample:
    __slots__ = ("tick", "quanta", "force_mn", "status", "kerf")

    def __init__(self, row):
        self.tick, self.quanta, self.force_mn = row[1], row[2:9], row[9:12]
        self.status, self.kerf = row[12:]

    def world_from_tool(self):
        return pose_from_quanta(self.quanta)

    def force_newton(self):
        return tuple(millinewton / 1000 for millinewton in self.force_mn)


class Event:
    def __init__(self, row):
        self.tick, self.kind, self.subject, self.value = row[1:5]
        self.quanta = row[5:]

    def pose(self):
        return pose_from_quanta(self.quanta)


class TapeLine:
    __slots__ = ("tick", "place_mm", "covered")

    def __init__(self, row):
        self.tick, self.covered = row[1], row[10]
        self.place_mm = tuple(micrometres / 1000 for micrometres in row[2:5])


class Mesh:
    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles


def read_ply(file):
    """Binary, little-endian: doubles, then for each face a byte 3 and three indices."""
    content = file.read_bytes()
    header, _, body = content.partition(b"end_header\n")
    counts = {line.split()[1]: int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")}
    points = list(struct.iter_unpack("<3d", body[:24 * counts["vertex"]]))
    faces = struct.iter_unpack("<B3I", body[24 * counts["vertex"]:])
    return Mesh(points, [face[1:] for face in faces])


class Export:
    """The folder of one attempt."""

    def __init__(self, folder):
        self.folder = folder
        self.manifest = json.loads((folder / "manifest.json").read_text())
        self.scenario = json.loads(self.manifest["scenario"]["text"])
        self.plan = json.loads((folder / "plan.json").read_text())
        self.samples = [Sample(row) for row in self.rows("samples")]
        self.events = [Event(row) for row in self.rows("events")]
        self.bone_from_world = pose_from_matrix(self.plan["world_from_bone"]).inverse()
        # By place on the tray. Older programs knew one.
        self.blades = self.plan.get("blades") or [self.plan["blade"]]

    @functools.cached_property
    def fragments(self):
        return json.loads((self.folder / "fragments.json").read_text())

    @functools.cached_property
    def implants(self):
        return json.loads((self.folder / "implants.json").read_text())

    def mesh_as_cut(self, body):
        """Of an entry of fragments.json, where it was before anything moved."""
        points, triangles = [], []
        for mesh in (read_ply(self.folder / file) for file in body["files"]):
            triangles += [tuple(corner + len(points) for corner in triangle) for triangle in mesh.triangles]
            points += mesh.points
        return Mesh(points, triangles)

    def mesh_as_it_lies(self, body):
        pose, mesh = pose_from_matrix(body["pose"]), self.mesh_as_cut(body)
        return Mesh([pose.point(point) for point in mesh.points], mesh.triangles)

    def bodies_as_they_lie(self):
        return [self.mesh_as_it_lies(body) for body in self.fragments if not body["taken_out"]]

    def rows(self, name):
        with (self.folder / f"{name}.csv").open(newline="") as file:
            lines = csv.reader(file)
            next(lines)
            return [list(map(int, line)) for line in lines]

    @functools.cached_property
    def tape(self):
        return [TapeLine(row) for row in self.rows("tape")]

    @functools.cached_property
    def bone(self):
        return read_ply(self.folder / "bone.ply")

    @functools.cached_property
    def pieces(self):
        """Largest first."""
        files = sorted(self.folder.glob("piece-*.ply"), key=lambda file: int(file.stem.removeprefix("piece-")))
        return [read_ply(file) for file in files]

    @functools.cached_property
    def kerfs(self):
        """bone_from_kerf of each, by number: z is the kerf's normal."""
        return [event.pose() for event in self.events if event.kind == PLANE_FROZEN]

    @functools.cached_property
    def blades_of_kerfs(self):
        """The blade that began each, by number: the one in the hand, or last in it."""
        blade, begun = self.blades[0], []
        for event in self.events:
            if event.kind == TOOL_CHOSEN and event.subject < len(self.blades):
                blade = self.blades[event.subject]
            if event.kind == PLANE_FROZEN:
                begun.append(blade)
        return begun

    @functools.cached_property
    def tools(self):
        """The place on the tray of what is in the hand, sample by sample. An event of a tick acts before its sample."""
        chosen, place, places = self.events_of(TOOL_CHOSEN), 0, []
        for sample in self.samples:
            while chosen and chosen[0].tick <= sample.tick:
                place = chosen.pop(0).subject
            places.append(place)
        return places

    def bone_from_tool(self, sample):
        return self.bone_from_world.after(sample.world_from_tool())

    def tip_in_bone_mm(self, sample):
        """The middle of the tooth line."""
        return self.bone_from_world.point(tuple(micrometres / 1000 for micrometres in sample.quanta[:3]))

    def events_of(self, kind):
        return [event for event in self.events if event.kind == kind]

    def cut(self, name):
        return next(cut for cut in self.plan["cuts"] if cut["name"] == name)

    def planned_plane(self, name):
        cut = self.cut(name)
        return Plane(tuple(cut["normal"]), cut["offset_mm"])

    def ticks_covered(self, index):
        """The ticks that a sample stands for: those since the one before, where not more were missed than a line covers."""
        if index == 0:
            return 1
        since = self.samples[index].tick - self.samples[index - 1].tick
        return 1 if since > TICKS_PER_LINE else max(since, 0)

    def stretches(self, holds):
        """Longest runs (first, last) of indices of samples for which `holds(sample)`; a gap ends one."""
        runs, first = [], None
        for index, sample in enumerate(self.samples):
            is_gap = index > 0 and sample.tick - self.samples[index - 1].tick > TICKS_PER_LINE
            holds_here = holds(sample)
            if first is not None and (is_gap or not holds_here):
                runs.append((first, index - 1))
                first = None
            if holds_here and first is None:
                first = index
        return runs if first is None else [*runs, (first, len(self.samples) - 1)]
