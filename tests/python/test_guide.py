"""The code of the guide's page, run as it stands there, one block after the other."""

import os
import pathlib
import re
import unittest

from support import FolderCase, run_program

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "python.md"


class Guide(FolderCase):
    def test_every_block_runs(self):
        run_program("convert", "builtin:studio", "-o", self.folder / "probe.hdr", "--to", "latlong", "--size", 64)
        blocks = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
        self.assertGreaterEqual(len(blocks), 4)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        (self.folder / "faces").mkdir()
        names = {}
        for block in blocks:
            exec(compile(block, str(PAGE), "exec"), names)
        for made in ("faces/px.exr", "shiny.exr", "look.png", "for-three"):
            self.assertTrue((self.folder / made).exists(), made)


if __name__ == "__main__":
    unittest.main()
