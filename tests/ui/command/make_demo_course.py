#!/usr/bin/env python3
"""The simulated course that several tests look at: make_demo_course.py FOLDER.

`hallux demo` makes FOLDER/data anew, with one attempt of each trainee; its answer is kept in FOLDER/answer.json, what it said
besides in FOLDER/said.txt.
"""

import pathlib
import shutil
import subprocess
import sys

from hallux_command import PROGRAM


def main():
    folder = pathlib.Path(sys.argv[1])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    done = subprocess.run([PROGRAM, "demo", "--attempts", "1", "--json", "--data", str(folder / "data")],
                          capture_output=True, text=True, timeout=500)
    (folder / "answer.json").write_text(done.stdout)
    (folder / "said.txt").write_text(done.stderr)
    if done.returncode != 0:
        sys.exit(f"no course was made: exit {done.returncode}\n{done.stderr}")


if __name__ == "__main__":
    main()
