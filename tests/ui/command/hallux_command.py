"""A fresh place for each test to run the `hallux` program in, and the worlds that the tests share.

HOME, XDG_DATA_HOME and the working directory are folders that must still be empty when the test ends: with --data, the
program touches that directory and the named output only.
"""

import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["HALLUX_PROGRAM"]
SILVER = pathlib.Path(os.environ["HALLUX_SILVER"])
# Where the operations lie as they are shipped.
SHIPPED = pathlib.Path(os.environ["HALLUX_SHIPPED"])
ATTEMPT_KIB_AT_MOST = 300_000_000 // 1024
DONE, CHECK_FAILED, WRONG_USAGE, BAD_INPUT, REFUSED, INTERRUPTED, STORAGE, NO_DISPLAY = range(8)


def greatest_kib():
    """Resident memory of the largest program that was run and has ended."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss


def coarse_scenario(name):
    """An operation of format 1 with a bone that is built in a moment."""
    scenario = json.loads(SILVER.with_name(f"{name}.json").read_text())
    scenario["patient"]["edge_mm"] = 1
    return scenario


def coarse_silver(**changes):
    """The same of the first; `changes` go into its first cut's face."""
    scenario = coarse_scenario("silver")
    scenario["cuts"][0]["face"].update(changes)
    return scenario


class Answer:
    """What one run of the program gave back."""

    def __init__(self, done):
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr

    def json(self):
        return json.loads(self.out)

    def __str__(self):
        return f"exit {self.code}\nstdout: {self.out}\nstderr: {self.err}"


class CommandTest(unittest.TestCase):
    # Who runs the program, as subprocess takes it; whoever runs the tests.
    program_user = {}
    patience_s = 120

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="hallux-command-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.data = self.folder / "data"
        self.untouched = [self.folder / name for name in ("home", "xdg", "here")]
        for place in self.untouched:
            place.mkdir()

    def tearDown(self):
        for place in self.untouched:
            self.assertEqual(list(place.rglob("*")), [], "touched outside --data and the named output")

    def environment(self):
        home, xdg, _ = self.untouched
        without_display = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        return {**without_display, "HOME": str(home), "XDG_DATA_HOME": str(xdg)}

    def line(self, arguments):
        return [PROGRAM, *map(str, arguments), "--data", str(self.data)]

    def hallux(self, *arguments, stdin=""):
        """Runs `hallux ARGUMENTS --data DIR`."""
        return Answer(subprocess.run(self.line(arguments), input=stdin, capture_output=True, text=True,
                                     timeout=self.patience_s, cwd=self.untouched[2], env=self.environment(),
                                     **self.program_user))

    def start(self, *arguments):
        """The same without waiting; ended with the test at the latest."""
        process = subprocess.Popen(self.line(arguments), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, cwd=self.untouched[2], env=self.environment())
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def kib_at_most(self, *arguments):
        """Resident memory of one run that ends well, where it was most."""
        process = subprocess.Popen(self.line(arguments), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, cwd=self.untouched[2], env=self.environment())
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, DONE, arguments)
        return used.ru_maxrss

    def run_into(self, stream, *arguments):
        """Runs it with its answer led into `stream`; returns exit code and stderr."""
        done = subprocess.run(self.line(arguments), stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.PIPE,
                              text=True, timeout=120, cwd=self.untouched[2], env=self.environment())
        return done.returncode, done.stderr

    def run_with_room(self, file_bytes, *arguments):
        """Runs it where no file can grow beyond `file_bytes`, which is how a full disk looks to a program."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))
        return Answer(subprocess.run(self.line(arguments), stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                     timeout=120, cwd=self.untouched[2], env=self.environment(), preexec_fn=limit,
                                     restore_signals=False))

    def ask(self, *arguments, stdin="", code=DONE):
        """The one JSON value that `hallux ARGUMENTS --json` answers with."""
        answer = self.hallux(*arguments, "--json", stdin=stdin)
        self.assertEqual(answer.code, code, answer)
        return answer.json()

    def expect_refusal(self, code, says, *arguments, stdin=""):
        """One sentence on stderr that holds every text of `says`, with --json the same as one value on stdout and else nothing,
        and the exit code."""
        answer = self.hallux(*arguments, "--quiet", stdin=stdin)
        self.assertEqual(answer.code, code, answer)
        if "--json" in arguments:
            self.assertEqual(answer.json()["error"]["code"], code, answer)
        else:
            self.assertEqual(answer.out, "", answer)
        lines = answer.err.splitlines()
        self.assertEqual(len(lines), 1, answer)
        self.assertTrue(lines[0].startswith("hallux: "), answer)
        for text in says:
            self.assertIn(text, lines[0])

    def write(self, name, text):
        file = self.folder / name
        file.write_text(text if isinstance(text, str) else json.dumps(text))
        return file

    def database(self):
        return self.data / "hallux.db"

    def alter(self, statement, values=()):
        """Changes the database behind the program's back; returns how many rows."""
        with sqlite3.connect(self.database()) as connection:
            changed = connection.execute(statement, values).rowcount
        connection.close()
        return changed

    def query(self, statement, values=()):
        connection = sqlite3.connect(f"file:{self.database()}?mode=ro", uri=True)
        try:
            return connection.execute(statement, values).fetchall()
        finally:
            connection.close()

    def stored(self):
        """What is kept, by content: each file of the data directory but SQLite's working files."""
        return {str(file.relative_to(self.data)): hashlib.sha256(file.read_bytes()).hexdigest()
                for file in sorted(self.data.rglob("*"))
                if file.is_file() and file.suffix not in (".db-wal", ".db-shm")}


class RecordedTest(CommandTest):
    """Each test has a data directory with one closed attempt of the scripted expert; it is made once."""

    @classmethod
    def setUpClass(cls):
        cls.shelf = tempfile.TemporaryDirectory(prefix="hallux-shelf-")
        cls.addClassCleanup(cls.shelf.cleanup)
        cls.shelf_folder = pathlib.Path(cls.shelf.name)
        scenario = cls.shelf_folder / "coarse.json"
        scenario.write_text(json.dumps(coarse_silver()))
        done = subprocess.run([PROGRAM, "attempt", str(scenario), "--hand", "expert", "--seed", "1", "--json",
                               "--data", str(cls.shelf_folder / "data")],
                              capture_output=True, text=True, timeout=120)
        cls.recorded = Answer(done)
        if done.returncode != DONE:
            raise AssertionError(f"the attempt that the tests share failed: {cls.recorded}")

    def setUp(self):
        super().setUp()
        shutil.copytree(self.shelf_folder / "data", self.data)
        self.attempt = self.recorded.json()["attempt"]
