"""On which bones cuts were begun: docs/metrics.md, "How the work was done", row `wrong_bones_count`."""

import bisect

from outsider.export import FRAGMENT_PARTED, PLANE_FROZEN


def bones_of_fragments(export):
    """The bones are the first fragments; each that parted is of the bone of the one that it was of."""
    bones = [export.plan["bone"], *(bone["name"] for bone in export.plan.get("further_bones", []))]
    for parted in export.events_of(FRAGMENT_PARTED):
        bones.append(bones[parted.value])
    return bones


def wrong_bones_count(export):
    """A cut was begun where the blade was in its kerf from the kerf's first tick on."""
    bones = bones_of_fragments(export)
    planned = {cut.get("bone", export.plan["bone"]) for cut in export.plan["cuts"]}
    ticks = [sample.tick for sample in export.samples]
    count = 0
    for kerf, frozen in enumerate(export.events_of(PLANE_FROZEN)):
        place = bisect.bisect_left(ticks, frozen.tick)
        is_begun = place < len(ticks) and export.samples[place].kerf == kerf
        count += is_begun and bones[frozen.value] not in planned
    return count
