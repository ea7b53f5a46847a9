#!/usr/bin/env python3
"""A person who never read the guide operates in the command's window under Xvfb: from signing in to the end, by the hints alone,
with mouse or keyboard. Time on the attempt's clock and wrong turns are printed. Of an operation that came to its end the score
must say that it was done: no gate on a deed is set off.

usage: novice_check.py HALLUX --card N|--scenario FILE --hand mouse|keyboard [--to-first-cut] [--seeds 1,2,3] [--limit S]
                       [--wrong-turns N] [--retell blank|exchanged] [--theme dark|light] [--scale 1.5] [--pictures FOLDER]
       novice_check.py HALLUX --flight --hand mouse|keyboard ...

With --scenario the person, who keeps the course, takes that file into it and publishes it, and then operates by it.

With --flight it is the first flight, as it is offered on the first start.

With hints blanked, or two of them exchanged, the person must fail.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import time

from novice import KeyboardHand, MouseHand, Novice
from operate_check import LOGIN, PASSWORD, come_in, has_cut
from window_check import opened_course, rows_of, wait_until

HANDS = {"mouse": MouseHand, "keyboard": KeyboardHand}
LIMIT_S, MOST_WRONG_TURNS, PATIENCE_S = 240, 3, 150.0
# The question at the end, and the gates that say what was not done.
FINISHED, DEEDS = "operate.ask_finish.act", ("piece_out", "wedge_closed", "eminence_out", "head_out", "head_shifted")
# So long somebody is misled.
MISLED_S = 90
# A machine without a GPU that does much else is slower than the attempt's clock.
SLOWEST = 4.0
OPPOSITES = (("Page up", "Page down"), ("away from you", "towards you"))


def blank(_words):
    return ""


def exchanged(words):
    """To push and to draw back mean each other."""
    for one, other in OPPOSITES:
        words = words.replace(one, "\0").replace(other, one).replace("\0", other)
    return words


RETELLINGS = {"": lambda words: words, "blank": blank, "exchanged": exchanged}


def publish(person, place, file):
    """Takes a scenario into the course and publishes it; its name."""
    name = json.loads(file.read_text())["name"]
    for button in ("nav.scenarios", "scenarios.import", "scenarios.file.path"):
        wait_until(button, lambda button=button: person.widgets().get(button, {}).get("enabled"), PATIENCE_S)
        person.click(button)
    person.type(str(file.resolve()))
    wait_until("a file to take in", lambda: person.widgets().get("scenarios.file.act", {}).get("enabled"), PATIENCE_S)
    person.click("scenarios.file.act")
    wait_until("its draft", lambda: is_state(place, name, "draft"), PATIENCE_S)
    wait_until("a draft to publish", lambda: person.widgets().get("scenarios.publish", {}).get("enabled"), PATIENCE_S)
    person.click("scenarios.publish")
    person.click("scenarios.question.act")
    wait_until("its proof", lambda: is_state(place, name, "published"), PATIENCE_S)
    return name


def is_state(place, name, state):
    return rows_of(place, "SELECT state FROM scenario_state JOIN scenario_version USING (scenario_version_id)"
                          f" WHERE name = '{name}' AND state = '{state}'")


def begin(person, number, name=""):
    """The operation of that card or that name, as practice: by what can be pressed on each page."""
    wait_until("the operations", lambda: person.widgets().get("nav.operations", {}).get("enabled"), PATIENCE_S)
    person.click("nav.operations")
    cards = wait_until("cards", lambda: sorted(name for name in person.widgets() if name.startswith("operations.card.")), PATIENCE_S)
    for button in (f"operations.card.{name}" if name else cards[number], "brief.begin"):
        wait_until(button, lambda button=button: person.widgets().get(button, {}).get("enabled"), PATIENCE_S)
        person.click(button)
    wait_until("the operation", lambda: "operate.begin" in person.widgets(), PATIENCE_S)
    view = person.widgets()["operate.view"]
    person.xdotool("mousemove", str(view["x"] + view["w"] // 2), str(view["y"] + view["h"] // 2))
    person.press("Return")
    wait_until("the running operation", lambda: "operate.pause" in person.widgets(), PATIENCE_S)


def enlarge(person, scale):
    """A tenth by each press, while it is operated."""
    def size():
        return person.widgets().get("operate.pause", {}).get("h")

    for _ in range(round(10 * (scale - 1))):
        before = size()
        person.press("ctrl+plus")
        wait_until("a larger scale", lambda before=before: size() not in (None, before), PATIENCE_S)


def take_off(person):
    """The first flight, as it is offered."""
    wait_until("the operations", lambda: person.widgets().get("nav.operations", {}).get("enabled"), PATIENCE_S)
    person.click("nav.operations")
    wait_until("the offer", lambda: "flight.offer.fly" in person.widgets(), PATIENCE_S)
    person.click("flight.offer.fly")
    wait_until("the flight", lambda: "flight.skip" in person.widgets(), PATIENCE_S)
    view = person.widgets()["operate.view"]
    person.xdotool("mousemove", str(view["x"] + view["w"] // 2), str(view["y"] + view["h"] // 2))


def scored(program, place):
    """The score of the only attempt, as the command tells it."""
    name = wait_until("a score", lambda: rows_of(place, "SELECT attempt.uuid FROM attempt JOIN score USING (attempt_id)"), PATIENCE_S)[0][0]
    asked = subprocess.run([program, "--json", "--data", place / "course", "--as", LOGIN, "score", name], input=PASSWORD + "\n",
                           capture_output=True, text=True, check=False, timeout=PATIENCE_S)
    if asked.returncode != 0:
        sys.exit(f"the score cannot be asked: {asked.stdout}{asked.stderr}")
    return json.loads(asked.stdout)


def is_operated(options, course, novice):
    """Finishes, and reads in the score whether what the operation is for was done."""
    if not novice.hand.choose(FINISHED, novice.screen):
        print("novice check: the question at the end was not answered")
        return False
    score = scored(options.hallux, course.place)
    deeds = {gate["name"]: gate["triggered"] for gate in score["gates"] if gate["name"] in DEEDS}
    print(f"novice check: score {score['score']:.1f}, gates on deeds {deeds}")
    return bool(deeds) and not any(deeds.values())


def attempt(options, seed):
    """(whether it came to its end, seconds on the attempt's clock, wrong turns)"""

    def prefer(course_folder):
        course_folder.mkdir()
        (course_folder / "window.json").write_text(json.dumps({"theme": options.theme}))

    with opened_course(options.hallux, pictures=options.pictures, prepare=prefer) as course:
        come_in(course.person)
        if options.flight:
            take_off(course.person)
        else:
            begin(course.person, options.card, options.scenario and publish(course.person, course.place, options.scenario))
            enlarge(course.person, options.scale)
        novice = Novice(course.person, HANDS[options.hand](course.person), seed, RETELLINGS[options.retell])

        def is_over(screen):
            if options.flight:
                return "flight.operations" in screen.widgets
            if options.to_first_cut:
                return has_cut(options.hallux, course.place)
            return FINISHED in screen.widgets

        begun = time.monotonic()
        limit_s = MISLED_S if options.retell else options.limit
        has_ended = novice.operate(is_over, limit_s, SLOWEST * limit_s)
        what = "flight" if options.flight else options.scenario.stem if options.scenario else f"card {options.card}"
        course.take_picture(f"{options.hand}-{what}-{seed}")
        print(f"novice check: {what}, {options.hand}, seed {seed}: {'over' if has_ended else 'not over'} after"
              f" {novice.clock_s()} s on the clock ({time.monotonic() - begun:.0f} s), {novice.wrong_turns.count} wrong turns")
        if has_ended and not (options.flight or options.to_first_cut):
            has_ended = is_operated(options, course, novice)
        return has_ended and novice.wrong_turns.count <= options.wrong_turns


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("hallux")
    parser.add_argument("--card", type=int, default=0)
    parser.add_argument("--scenario", type=pathlib.Path)
    parser.add_argument("--flight", action="store_true")
    parser.add_argument("--hand", choices=HANDS, default="keyboard")
    parser.add_argument("--to-first-cut", action="store_true")
    parser.add_argument("--seeds", default="")
    parser.add_argument("--limit", type=int, default=LIMIT_S, help="seconds of the attempt's clock")
    parser.add_argument("--wrong-turns", type=int, default=MOST_WRONG_TURNS)
    parser.add_argument("--retell", choices=RETELLINGS, default="")
    parser.add_argument("--theme", choices=("dark", "light"), default="dark")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--pictures", type=pathlib.Path)
    options = parser.parse_args()
    seeds = [int(each) for each in options.seeds.split(",") if each] or [None]
    failed = [seed for seed in seeds if attempt(options, seed) == bool(options.retell)]
    if failed:
        sys.exit(f"novice check: {'came to the end by wrong hints' if options.retell else 'failed'}, seeds {failed}")
    print("novice check: passed")


if __name__ == "__main__":
    main()
