"""The examples of the guide, run as they stand."""

import pathlib
import subprocess
import sys
import unittest

import mirrorball
from support import FolderCase, run_program

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/python"


class Examples(FolderCase):
    def run_example(self, name, *words):
        done = subprocess.run([sys.executable, EXAMPLES / name, *map(str, words)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_exchange_with_openimageio(self):
        try:
            import OpenImageIO  # noqa: F401
        except ImportError:
            self.skipTest("OpenImageIO's Python module (python3-openimageio) is not installed")
        run_program("convert", "builtin:sky", "-o", self.folder / "probe.exr", "--to", "latlong", "--size", 64)
        self.run_example("openimageio_exchange.py")
        plain = mirrorball.prefilter(mirrorball.read_probe(self.folder / "probe.exr").map, "phong:50", to="latlong", size=64).map
        doubled = mirrorball.read_probe(self.folder / "shiny.exr").map
        self.assertLess(mirrorball.error_metrics(doubled, mirrorball.EnvironmentMap("latlong", 2 * plain.texels))["rel_rms"], 1e-5)

    def test_a_folder_two_at_a_time(self):
        (self.folder / "probes").mkdir()
        for name in ("a", "b", "c"):
            run_program("convert", "builtin:studio", "-o", self.folder / f"probes/{name}.hdr", "--to", "latlong", "--size", 32)
        self.run_example("filter_folder.py", "probes", "maps")
        self.assertEqual(sorted(file.name for file in (self.folder / "maps").iterdir()), ["a.exr", "b.exr", "c.exr"])

    def test_methods_compared(self):
        lines = self.run_example("compare_methods.py").splitlines()
        errors = {line.split()[0]: float(line.split()[2]) for line in lines}
        self.assertLess(errors["spectral"], 1e-5)
        self.assertLess(errors["spectral"], errors["importance"])

    def test_a_turntable(self):
        self.assertEqual(len(self.run_example("look_turntable.py", "out").splitlines()), 3)
        self.assertEqual(len(list((self.folder / "out").iterdir())), 3)


if __name__ == "__main__":
    unittest.main()
