"""Order of the steps: docs/metrics.md, "How the work was done", row `step_order`."""

from outsider.export import CUTTING, FINISHED, HINGE_CLOSED, PIECE_REMOVED, STEP_DONE
from outsider.faces import SAWN


def last_tick(events):
    return max((event.tick for event in events), default=None)


def first_cutting_tick(export, kerfs):
    sawn = [sample.tick for sample in export.samples if sample.status & CUTTING and sample.kerf in kerfs]
    return min(sawn, default=None)


def removed_tick(export, done):
    """The last piece that was taken out; where steps say what they come after, before the step was done."""
    removed = export.events_of(PIECE_REMOVED)
    if export.scenario["format"] == 1:
        return last_tick(removed)
    return None if done is None else last_tick(event for event in removed if event.tick <= done)


def step_tick(export, index, kerfs_of_cut):
    """When a step was carried out; nothing where it was not. What has no event of its own by *Done*."""
    step = export.scenario["steps"][index]
    done = last_tick(event for event in export.events_of(STEP_DONE) if event.subject == index)
    if step["kind"] in SAWN:
        return first_cutting_tick(export, kerfs_of_cut[step["cut"]])
    if step["kind"] == "remove":
        return removed_tick(export, done)
    if step["kind"] in ("close", "finish"):
        return last_tick(export.events_of({"close": HINGE_CLOSED, "finish": FINISHED}[step["kind"]]))
    return done


def step_order(export, kerfs_of_cut):
    steps = export.scenario["steps"]
    ticks = [step_tick(export, index, kerfs_of_cut) for index in range(len(steps))]
    return order_of_chain(ticks) if export.scenario["format"] == 1 else order_of_ordered(steps, ticks)


def order_of_chain(ticks):
    """No step is required twice, so the longest common subsequence is the longest rising one."""
    longest = []
    for index, tick in enumerate(ticks):
        before = [longest[other] for other in range(index) if ticks[other] is not None and tick is not None and
                  ticks[other] <= tick]
        longest.append(0 if tick is None else 1 + max(before, default=0))
    return max(longest) / len(ticks)


def order_of_ordered(steps, ticks):
    """Where steps say what they come after: the most that were carried out without one before what it needs. "Sooner,
    and needs" is an order, so these are what a greatest matching of the wrong pairs leaves (Dilworth)."""
    required = [index for index in range(len(steps)) if is_required(steps, ticks, index)]
    done = sum(ticks[index] is not None for index in required)
    return (done - greatest_matching(wrong_pairs(steps, ticks))) / len(required)


def is_required(steps, ticks, index):
    """Not what is optional and was passed over, nor an alternative in whose place another one was carried out; of
    alternatives of which none was, the first."""
    if ticks[index] is not None:
        return True
    group = steps[index].get("one_of")
    others = [other for other in range(len(steps)) if other != index and group and steps[other].get("one_of") == group]
    return not steps[index].get("optional") and not any(ticks[other] is not None or other < index for other in others)


def needs_of(steps, index, known):
    """All that the step cannot be done without: of a group what all of its alternatives need."""
    if index not in known:
        needed = set()
        for name in steps[index]["after"]:
            named = [other for other, step in enumerate(steps) if name in (step["id"], step.get("one_of"))]
            needed |= set.intersection(*(needs_of(steps, other, known) | {other} for other in named))
        known[index] = needed
    return known[index]


def wrong_pairs(steps, ticks):
    """Of each step those that it needs and that were carried out later."""
    known = {}
    return [[later for later in needs_of(steps, sooner, known)
             if ticks[sooner] is not None and ticks[later] is not None and ticks[sooner] < ticks[later]]
            for sooner in range(len(steps))]


def greatest_matching(pairs):
    """By augmenting paths."""
    matched = {}

    def match(sooner, tried):
        for later in pairs[sooner]:
            if later in tried:
                continue
            tried.add(later)
            if later not in matched or match(matched[later], tried):
                matched[later] = sooner
                return True
        return False

    return sum(match(sooner, set()) for sooner in range(len(pairs)))
