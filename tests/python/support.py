"""What the tests of the module share: the command line beside it, and a folder that goes away."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["MIRRORBALL"]


def run_program(*words, cwd=None):
    """Runs `mirrorball` as a user does; raises with its own words where it fails."""
    done = subprocess.run([PROGRAM, *map(str, words)], cwd=cwd, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stdout


def error_of_program(*words):
    """The line that `mirrorball` ends with, without its name in front."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    if done.returncode == 0:
        raise AssertionError("mirrorball did not fail")
    return done.stderr.strip().removeprefix("mirrorball: ")


class FolderCase(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
