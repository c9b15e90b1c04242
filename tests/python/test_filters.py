"""Filtering: the closed forms, the bytes of the command line, threads, progress and Ctrl-C."""

import os
import signal
import threading
import time
import unittest

import numpy as np

import mirrorball
from support import FolderCase, error_of_program, run_program


def uniform(value=1.0, height=16):
    return mirrorball.EnvironmentMap("latlong", np.full((height, 2 * height, 3), value, np.float32))


class Lobes(unittest.TestCase):
    def test_a_lobe_integrates_to_one(self):
        cosine = (np.arange(200000) + 0.5) / 200000
        for lobe in (mirrorball.Lobe.phong(50), mirrorball.Lobe.ggx(0.3), mirrorball.Lobe.diffuse(), mirrorball.Lobe.tabulated([0, 1, 3])):
            self.assertAlmostEqual(2 * np.pi * lobe.evaluate(cosine).mean(), 1.0, places=4, msg=repr(lobe))

    def test_coefficients_of_phong_have_their_closed_form(self):
        k = mirrorball.Lobe.phong(7).legendre(2)
        np.testing.assert_allclose(k, [1, 8 / 9, 7 / 10], rtol=1e-12)  # k_1 = (n+1)/(n+2), k_2 = k_0 n/(n+3)

    def test_words_are_those_of_reports(self):
        self.assertEqual(mirrorball.Lobe.parse("phong:50"), mirrorball.Lobe.phong(50))
        with self.assertRaises(ValueError):
            mirrorball.Lobe.parse("phong:x")
        with self.assertRaises(ValueError):
            mirrorball.Lobe.ggx(2)


class Filters(FolderCase):
    def test_a_white_furnace_stays_white(self):
        for lobe in ("phong:30", "ggx:0.2", "diffuse"):
            map = mirrorball.prefilter(uniform(), lobe, size=8).map
            np.testing.assert_allclose(map.texels, 1.0, atol=1e-5, err_msg=lobe)

    def test_filtering_writes_the_bytes_of_the_command_line(self):
        run_program("convert", "builtin:sky", "-o", self.folder / "probe.hdr", "--to", "latlong", "--size", 64)
        probe = self.folder / "probe.hdr"
        source = mirrorball.Source(mirrorball.read_probe(probe).map)
        for name, options, arguments in [
            ("phong", ["--lobe", "phong", "--exponent", "50"], {"lobe": "phong:50"}),
            ("diffuse", ["--lobe", "diffuse", "--half"], {"lobe": mirrorball.Lobe.diffuse()}),
            ("chain", ["--lobe", "ggx", "--mips"], {"mips": True}),
            ("law", ["--law", "filament", "--levels", "4"], {"law": "filament", "levels": 4}),
        ]:
            plain = self.folder / f"{name}.exr"
            run_program("filter", probe, "-o", plain, "--to", "cube", "--size", 16, *options)
            for other, filtered in [
                ("file", mirrorball.prefilter(probe, to="cube", size=16, **arguments)),
                ("source", mirrorball.prefilter(source, to="cube", size=16, **arguments)),
            ]:
                made = self.folder / f"{name}_{other}.exr"
                filtered.write(made, half="--half" in options)
                self.assertEqual(made.read_bytes(), plain.read_bytes(), f"{name} from {other}")

    def test_a_file_is_read_as_the_command_line_reads_it(self):
        run_program("convert", "builtin:sky", "-o", self.folder / "cube.exr", "--to", "cube", "--size", 16)
        probe = self.folder / "cube.exr"
        for name, options, keywords in [
            ("turned", ["--rotate", "33,10,-5", "--yaw", 20], {"rotate": (33, 10, -5), "yaw": 20}),
            ("mirrored", ["--mirror", "x", "--from", "cube"], {"mirror": "x", "kind": "cube"}),
            ("swapped", ["--faces", "nx px py ny pz nz:90", "--color-space", "srgb"],
             {"faces": "nx px py ny pz nz:90", "color_space": "srgb"}),
        ]:
            plain, made = self.folder / f"{name}.exr", self.folder / f"{name}_python.exr"
            run_program("filter", probe, "-o", plain, "--to", "cube", "--size", 8, "--lobe", "phong", "--exponent", 20, *options)
            mirrorball.prefilter(probe, "phong:20", to="cube", size=8, **keywords).write(made)
            self.assertEqual(made.read_bytes(), plain.read_bytes(), name)
        with self.assertRaises(TypeError):
            mirrorball.prefilter(uniform(), "phong:20", mirror="x")  # a map is read already

    def test_a_spectrum_is_filtered_as_the_command_line_does(self):
        run_program("convert", "builtin:sky", "-o", self.folder / "probe.hdr", "--to", "latlong", "--size", 64)
        whole = self.folder / "whole.spectrum"
        run_program("spectrum", self.folder / "probe.hdr", "-o", whole, "--degree", 100, "--bright", 20)
        run_program("filter", whole, "-o", self.folder / "a.exr", "--lobe", "phong", "--exponent", 10, "--to", "cube", "--size", 8,
                    "--tolerance", 1e-3)
        mirrorball.prefilter(whole, "phong:10", to="cube", size=8, tolerance=1e-3).write(self.folder / "b.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_the_result_says_how_it_was_made(self):
        filtered = mirrorball.prefilter(mirrorball.read_probe("builtin:sky").map, "phong:50", size=16, tolerance=1e-3)
        self.assertEqual(filtered.method, "spectral")
        self.assertGreater(filtered.band_limit, 0)
        self.assertTrue(0 < filtered.predicted_error <= 1e-3)
        self.assertEqual(filtered.lobes, ["phong:50"])
        self.assertTrue(any("filter" in stage["name"] or "spectrum" in stage["name"] for stage in filtered.stages))

    def test_the_reference_agrees_within_the_tolerance(self):
        probe = mirrorball.reproject(mirrorball.read_probe("builtin:sky").map, "latlong", 32)
        truth = mirrorball.prefilter(probe, "phong:20", size=8, method="reference").map
        map = mirrorball.prefilter(probe, "phong:20", size=8, tolerance=1e-4).map
        self.assertLessEqual(mirrorball.error_metrics(map, truth)["rel_rms"], 1e-4)
        self.assertEqual(mirrorball.error_metrics(truth, truth), {k: 0.0 for k in mirrorball.error_metrics(map, truth)})

    def test_errors_have_the_words_of_the_command_line(self):
        with self.assertRaisesRegex(ValueError, "lobe: is missing"):
            mirrorball.prefilter(uniform(), size=8)
        with self.assertRaisesRegex(ValueError, "tolerance: must lie in"):
            mirrorball.prefilter(uniform(), "diffuse", tolerance=float("nan"))
        with self.assertRaises(ValueError) as caught:
            mirrorball.prefilter("builtin:sky", "phong:50", size=8, method="sh9")
        self.assertEqual(
            str(caught.exception),
            error_of_program("filter", "builtin:sky", "-o", self.folder / "x.exr", "--lobe", "phong", "--exponent", 50, "--to", "cube",
                             "--size", 8, "--method", "sh9"))
        with self.assertRaises(TypeError):
            mirrorball.prefilter(uniform(), 5)

    def test_nothing_changes_with_threads(self):
        source = mirrorball.read_probe("builtin:sky").map
        one, two = (mirrorball.prefilter(source, "ggx:0.1", size=16, threads=n).map for n in (1, 2))
        self.assertEqual(one, two)


class Working(unittest.TestCase):
    """The interpreter is free while work is done."""

    def slow(self, **options):
        probe = mirrorball.reproject(mirrorball.read_probe("builtin:sky").map, "latlong", 64)
        return mirrorball.prefilter(probe, "phong:5", size=48, method="reference", **options)

    def test_other_threads_run_meanwhile(self):
        done = threading.Event()
        worker = threading.Thread(target=lambda: (self.slow(threads=1), done.set()))
        worker.start()
        turns = 0
        while not done.wait(0.001):
            turns += 1
        worker.join()
        self.assertGreater(turns, 20)

    def test_progress_goes_from_nothing_to_all(self):
        seen = []
        self.slow(progress=seen.append)
        self.assertEqual(seen, sorted(seen))
        self.assertTrue(0 <= seen[0] < 0.5 and seen[-1] == 1.0, (seen[0], seen[-1]))

    def test_what_progress_raises_stops_the_work(self):
        def stop(share):
            raise RuntimeError("enough")

        start = time.process_time()
        with self.assertRaisesRegex(RuntimeError, "enough"):
            self.slow(progress=stop)
        self.assertLess(time.process_time() - start, 60)
        with self.assertRaisesRegex(TypeError, "progress: must be None or a function"):
            self.slow(progress=3)

    def test_ctrl_c_stops_the_work(self):
        def interrupt():
            time.sleep(0.3)
            os.kill(os.getpid(), signal.SIGINT)

        probe = mirrorball.EnvironmentMap("latlong", np.random.default_rng(3).random((1024, 2048, 3), dtype=np.float32))
        threading.Thread(target=interrupt).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):  # whole, this sum takes minutes
            mirrorball.prefilter(probe, "phong:1", size=256, method="reference")
        self.assertLess(time.monotonic() - start, 60)

    def test_filters_of_one_source_wait_for_each_other(self):
        source = mirrorball.Source(mirrorball.read_probe("builtin:sky").map)
        alone = mirrorball.prefilter(source, "phong:50", size=16).map
        results = []
        threads = [threading.Thread(target=lambda: results.append(mirrorball.prefilter(source, "phong:50", size=16).map)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 4)
        self.assertTrue(all(result == alone for result in results))


if __name__ == "__main__":
    unittest.main()
