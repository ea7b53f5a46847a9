"""All metrics of an attempt that an export tells, by (metric, cut, hinge, zone, fragment or implant), and why the others are
left out."""

from outsider.bones import wrong_bones_count
from outsider.entries import restarts_count
from outsider.export import HINGE_CLOSED
from outsider.faces import closing_metrics, counting, cut_metrics, faces_of_cuts, kerfs_of_cuts, piece_metrics, wedge_metrics
from outsider.fixation import fixation_metrics, is_unknown
from outsider.movement import movement_metrics
from outsider.order import step_order
from outsider.work import force_metrics, saw_metrics, time_metrics
from outsider.zones import zone_metrics

# An export holds the blade's poses, and not what they opened: that is a field, of which docs/cutting.md says how it is stamped.
OPENED = "asks for the field that the blade opened, not only for the walls that it left"
APART = "of a fragment asks for the distances of all that was sawn on it from the other bodies, point by point"
TAKEN = "asks for a wire or screw that was to be taken out again: an export tells of those that are there"
LEFT_OUT = {
    "hot_s": "asks for the model of heat (docs/haptics.md), followed over the fields of the kerfs",
    "necrotic_mm3": "asks for the model of heat (docs/haptics.md), followed over the fields of the kerfs",
    "joint_margin_mm": OPENED,
    "hinge_mm": OPENED,
    "hinge_lost": OPENED,
    "over_cut_mm": OPENED + "; of a cut for its section of the bone as it was left before",
    "piece_out": "asks for the bone between the faces, which a program tells that cuts solids",
    # Of a hinge both are computed: its faces are planes.
    "contact_share": APART,
    "gap_mm": APART,
    "path_ratio": "asks for the plan's strokes, which an export does not tell",
}


def why_left_out(export, metric, subject):
    """Nothing of what is computed."""
    return TAKEN if is_unknown(export, subject) else LEFT_OUT.get(metric)


def recomputed(export):
    """Of a cut without a wall on a piece, and of what needs such a cut, there is nothing: where it was left unfinished, the
    program measures it where the blade opened bone, which an export does not tell."""
    found = force_metrics(export) | saw_metrics(export) | time_metrics(export)
    found |= movement_metrics(export) | zone_metrics(export)
    kerfs = kerfs_of_cuts(export)
    found["step_order", ""] = step_order(export, kerfs)
    found["wrong_bones_count", ""] = wrong_bones_count(export)
    faces = faces_of_cuts(export, kerfs)
    found["restarts_count", ""] = restarts_count(export, faces)
    for cut, made in faces.items():
        if counting(made):
            found |= cut_metrics(export, cut, made, faces)
    for hinge in export.plan["hinges"]:
        first, second = (counting(faces[hinge[key]]) for key in ("first_cut", "second_cut"))
        if first and second:
            found |= wedge_metrics(export, hinge, first[0], second[0])
        found |= closing_metrics(export, hinge, first, second)
        found["wedge_closed", hinge["name"]] = 1 if export.events_of(HINGE_CLOSED) else 0
    return found | piece_metrics(export, faces) | fixation_metrics(export)
