"""Maps as values: layouts, arrays without copies, lookups."""

import math
import re
import unittest

import numpy as np

import mirrorball
from support import FolderCase, error_of_program, run_program

KINDS = ["latlong", "cube", "sphere", "angular", "paraboloid", "octahedral"]


class Maps(FolderCase):
    def test_solid_angles_sum_to_the_sphere(self):
        for kind in KINDS:
            angles = mirrorball.EnvironmentMap.empty(kind, 16).solid_angles()
            self.assertAlmostEqual(angles.sum(), 4 * math.pi, places=10, msg=kind)

    def test_directions_are_unit_vectors_and_a_lookup_there_gives_the_texel(self):
        for kind in KINDS:
            map = mirrorball.EnvironmentMap.empty(kind, 8)
            map.texels[...] = np.random.default_rng(1).random(map.texels.shape, dtype=np.float32)
            directions = map.directions()
            np.testing.assert_allclose(np.linalg.norm(directions, axis=-1), 1.0, atol=1e-12)
            inside = map.solid_angles() > 0.999 * np.median(map.solid_angles()[map.solid_angles() > 0])
            if kind in ("latlong", "cube", "octahedral"):  # every texel's center lies on the map
                inside[...] = True
                np.testing.assert_allclose(map.radiance(directions)[inside], map.texels[inside], atol=2e-6, err_msg=kind)

    def test_axes_are_where_the_guide_says(self):
        axes = mirrorball.read_probe("builtin:axes").map
        latlong = mirrorball.reproject(axes, "latlong", 64)
        middle = latlong.texels[31:33, 63:65].mean(axis=(0, 1))
        np.testing.assert_allclose(latlong.radiance([0, 0, 1]), middle, rtol=1e-5)  # +Z in the middle
        np.testing.assert_allclose(latlong.radiance([0, 1, 0]), latlong.texels[0].mean(axis=0), rtol=0.05)  # +Y at the top

    def test_texels_are_the_maps_own_memory(self):
        map = mirrorball.EnvironmentMap.empty("cube", 4)
        self.assertEqual(map.texels.shape, (24, 4, 3))
        self.assertEqual(map.texels.dtype, np.float32)
        view = np.asarray(map)
        map.texels[5, 1] = (1, 2, 3)
        np.testing.assert_array_equal(view[5, 1], (1, 2, 3))
        self.assertTrue(np.shares_memory(view, map.texels))

    def test_an_array_keeps_its_map_alive(self):
        texels = mirrorball.read_probe("builtin:studio").map.texels
        total = float(texels.sum())
        for _ in range(20):
            mirrorball.EnvironmentMap.empty("latlong", 256).texels[...] = 7
        self.assertEqual(float(texels.sum()), total)

    def test_lookups_take_any_shape_type_and_stride(self):
        map = mirrorball.read_probe("builtin:sky").map
        directions = np.random.default_rng(2).normal(size=(5, 4, 3))
        reference = map.radiance(directions)
        self.assertEqual(reference.shape, (5, 4, 3))
        np.testing.assert_array_equal(map.radiance(directions[::-1, ::2]), reference[::-1, ::2])
        np.testing.assert_array_equal(map.radiance(10 * directions), reference)
        np.testing.assert_allclose(map.radiance(directions.astype(np.float32)), reference, rtol=1e-4)
        self.assertEqual(map.radiance([0, 1, 0]).shape, (3,))

    def test_arrays_of_other_types_become_maps(self):
        texels = (np.arange(8 * 16 * 3) % 7).reshape(8, 16, 3)
        map = mirrorball.EnvironmentMap("latlong", texels)
        np.testing.assert_array_equal(map.texels, texels)
        np.testing.assert_array_equal(mirrorball.EnvironmentMap("latlong", texels[:, ::-1]).texels, texels[:, ::-1])

    def test_a_wrong_shape_says_what_it_should_be(self):
        with self.assertRaisesRegex(mirrorball.InvalidArgument, r"texels: a latlong map of size 8 has the shape \[8, 16, 3\]"):
            mirrorball.EnvironmentMap("latlong", np.zeros((8, 8, 3)))
        with self.assertRaisesRegex(ValueError, "kind: 'cubic' is no parameterization; choose one of latlong, cube"):
            mirrorball.EnvironmentMap.empty("cubic", 4)
        with self.assertRaisesRegex(ValueError, r"directions: must be an array \[..., 3\]; its shape is \[2\]"):
            mirrorball.EnvironmentMap.empty("cube", 4).radiance([0.0, 1.0])

    def test_mean_radiance_is_weighted_by_solid_angle(self):
        map = mirrorball.read_probe("builtin:sky").map
        weights = map.solid_angles()[..., None]
        np.testing.assert_allclose(map.mean_radiance(), (map.texels * weights).sum(axis=(0, 1)) / (4 * math.pi), rtol=1e-6)

    def test_conversion_writes_the_bytes_of_the_command_line(self):
        run_program("convert", "builtin:studio", "-o", self.folder / "a.exr", "--to", "cube", "--size", 32, "--yaw", 30)
        map = mirrorball.reproject(mirrorball.read_probe("builtin:studio").map, "cube", 32, yaw=30)
        files = mirrorball.write_map(self.folder / "b.exr", map)
        self.assertEqual([str(file) for file in files], [str(self.folder / "b.exr")])
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_levels_write_the_bytes_of_the_command_line(self):
        run_program("convert", "builtin:studio", "-o", self.folder / "a.exr", "--to", "cube", "--size", 16, "--mips", "--half")
        levels = mirrorball.mip_levels(mirrorball.reproject(mirrorball.read_probe("builtin:studio").map, "cube", 16))
        mirrorball.write_map(self.folder / "b.exr", levels, half=True)
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_files_of_others_are_read(self):
        run_program("convert", "builtin:studio", "-o", self.folder / "picture.png", "--to", "latlong", "--size", 16)
        self.assertEqual(mirrorball.read_probe(self.folder / "picture.png").map.kind, "latlong")

    def test_files_are_read_as_the_keywords_say(self):
        run_program("convert", "builtin:sky", "-o", self.folder / "probe.exr", "--to", "latlong", "--size", 32)
        run_program("convert", "builtin:sky", "-o", self.folder / "cube.exr", "--to", "cube", "--size", 16)
        plain = mirrorball.read_probe(self.folder / "probe.exr").map.texels
        # A mirrored X swaps left and right of the latlong, whose middle is +Z; a turn by 90 degrees about Y is a quarter of its columns.
        mirrored = mirrorball.read_probe(self.folder / "probe.exr", mirror="x").map.texels
        np.testing.assert_allclose(mirrored, plain[:, ::-1], rtol=1e-5)
        turned = mirrorball.read_probe(self.folder / "probe.exr", rotate=(90, 0, 0)).map
        for same in ("90,0,0", np.array([90.0, 0.0, 0.0]), (math.cos(math.pi / 4), 0, math.sin(math.pi / 4), 0)):
            np.testing.assert_allclose(mirrorball.read_probe(self.folder / "probe.exr", rotate=same).map.texels, turned.texels, rtol=1e-4)
        np.testing.assert_allclose(turned.texels, np.roll(plain, -16, axis=1), rtol=1e-4)
        # Faces in another order in the file are other directions.
        cube = mirrorball.read_probe(self.folder / "cube.exr", "cube").map.texels.reshape(6, 16, 16, 3)
        swapped = mirrorball.read_probe(self.folder / "cube.exr", "cube", faces="nx px py ny pz nz").map.texels.reshape(6, 16, 16, 3)
        np.testing.assert_array_equal(swapped, cube[[1, 0, 2, 3, 4, 5]])
        # A part is named by its number or by its name, and there is one alone in this file.
        np.testing.assert_array_equal(mirrorball.read_probe(self.folder / "probe.exr", part=0).map.texels, plain)
        with self.assertRaisesRegex(mirrorball.InvalidArgument, "part"):
            mirrorball.read_probe(self.folder / "probe.exr", part=7)
        # sRGB values are decoded: IEC 61966-2-1 at values above its straight part.
        decoded = mirrorball.read_probe(self.folder / "probe.exr", color_space="srgb").map.texels
        high = (plain > 0.05) & (plain < 1)
        np.testing.assert_allclose(decoded[high], ((plain[high] + 0.055) / 1.055) ** 2.4, rtol=1e-4)

    def test_keywords_of_reading_are_those_of_scenes_and_of_the_command_line(self):
        fields = {field["path"].removeprefix("probe.") for field in mirrorball.Scene.fields() if field["path"].startswith("probe.")}
        fields = (fields - {"source", "yaw", "exposure", "parameterization"}) | {"kind"}
        with self.assertRaises(TypeError) as caught:
            mirrorball.read_probe("builtin:sky", layers="beauty")
        self.assertEqual(set(str(caught.exception).split("is told by ")[1].split(", ")), fields)
        options = {option.replace("-", "_") for option in re.findall(r"--([a-z-]+)", run_program("info", "--help"))}
        self.assertLessEqual((fields - {"kind"}) | {"from"}, options)
        for field in fields:
            self.assertRegex(mirrorball.read_probe.__doc__, rf"\n  {field}: \w")
        for keywords, words in [({"mirror": "w"}, "mirror: "), ({"kind": "ball"}, "kind: "),
                                ({"rotate": (1, 2)}, "rotate: "), ({"fit": 3}, "fit: "), ({"horizontal_angle": 500}, "horizontal_angle: ")]:
            with self.assertRaisesRegex(mirrorball.InvalidArgument, words):
                mirrorball.read_probe("builtin:sky", **keywords)

    def test_errors_have_the_words_of_the_command_line(self):
        missing = self.folder / "none.hdr"
        with self.assertRaises(mirrorball.FileError) as caught:
            mirrorball.read_probe(missing)
        self.assertEqual(str(caught.exception), error_of_program("info", missing))
        self.assertIsInstance(caught.exception, OSError)
        with self.assertRaises(mirrorball.InvalidArgument):
            mirrorball.write_map(self.folder / "map.xyz", mirrorball.EnvironmentMap.empty("cube", 4))


if __name__ == "__main__":
    unittest.main()
