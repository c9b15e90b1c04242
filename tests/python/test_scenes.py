"""Scenes, sphere maps, materials, reports: what the command line makes, as values."""

import json
import unittest

import numpy as np

import mirrorball
from support import FolderCase, error_of_program, run_program


class Scenes(FolderCase):
    def scene(self):
        scene = mirrorball.Scene("builtin:studio", "car-paint")
        scene["view.width"], scene["view.height"] = 96, 64
        return scene

    def test_fields_are_read_and_set_by_their_paths(self):
        scene = mirrorball.Scene()
        scene["material.specular.exponent"] = 123.5
        scene["map.parameterization"] = "octahedral"
        scene["material.specular.color"] = (0.5, 0.25, np.float32(0.125))
        self.assertEqual(scene["material.specular.exponent"], 123.5)
        self.assertEqual(scene["map"]["parameterization"], "octahedral")
        self.assertEqual(scene["material.specular.color"], [0.5, 0.25, 0.125])
        with self.assertRaisesRegex(ValueError, "material.specular.exponent"):
            scene["material.specular.exponent"] = -1
        with self.assertRaisesRegex(ValueError, "the scene has no such field"):
            scene["material.shine"]
        self.assertEqual(scene["material.specular.exponent"], 123.5)

    def test_a_material_that_is_none_has_the_words_of_the_command_line(self):
        with self.assertRaises(ValueError) as caught:
            mirrorball.Scene("builtin:sky", "glossy")
        self.assertEqual("--" + str(caught.exception),
                         error_of_program("render", "--probe", "builtin:sky", "--material", "glossy", "-o", self.folder / "x.png"))

    def test_every_field_of_the_list_is_there(self):
        scene = mirrorball.Scene()
        for field in mirrorball.Scene.fields():
            scene[field["path"]]

    def test_a_scene_comes_back_from_its_file(self):
        scene = self.scene()
        scene.save(self.folder / "a.mirrorball")
        self.assertEqual(mirrorball.Scene.load(self.folder / "a.mirrorball").to_dict(), scene.to_dict())
        self.assertEqual(json.loads((self.folder / "a.mirrorball").read_text()), scene.to_dict())

    def test_a_picture_is_the_command_lines(self):
        scene = self.scene()
        scene.save(self.folder / "a.mirrorball")
        run_program("render", self.folder / "a.mirrorball", "-o", self.folder / "a.exr")
        scene.save_picture(self.folder / "b.exr")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())
        picture = scene.render()
        self.assertEqual(picture.shape, (64, 96, 4))
        display = scene.render(display=True)
        self.assertTrue(0 <= display.min() and display.max() <= 1)
        self.assertGreater(picture[..., :3].std(), 0)

    def test_the_plan_says_what_is_left_out(self):
        stages = mirrorball.Scene().plan()
        self.assertTrue(any(stage["left_out"] for stage in stages))

    def test_exports_are_the_command_lines(self):
        scene = mirrorball.Scene("builtin:sky")
        files = scene.export_for("filament", self.folder / "a", size=32, name="sky")["files"]
        run_program("export", "builtin:sky", "--for", "filament", "--size", 32, "--name", "sky", "-o", self.folder / "b")
        self.assertTrue(files)
        for file in files:
            self.assertEqual(file.read_bytes(), (self.folder / "b" / file.name).read_bytes(), file.name)

    def test_presets_are_the_command_lines(self):
        self.assertEqual(mirrorball.presets(), json.loads(run_program("presets", "--json")))


class SphereMaps(FolderCase):
    def test_a_preset_is_painted_as_the_command_line_does(self):
        painted = mirrorball.SphereMap.preset("cold-warm")
        run_program("paint", "cold-warm", "-o", self.folder / "a.exr", "--size", 32)
        painted.write(self.folder / "b.exr", 32)
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())
        self.assertEqual(painted.evaluate(32).shape[:2], (32, 32))
        self.assertEqual([level.shape[0] for level in painted.levels(32)], [32, 16, 8, 4, 2, 1])

    def test_a_document_comes_back_from_its_text(self):
        painted = mirrorball.SphereMap.preset("cold-warm")
        again = mirrorball.SphereMap.from_json(painted.to_json())
        np.testing.assert_array_equal(again.evaluate(16), painted.evaluate(16))
        with self.assertRaises(ValueError):
            mirrorball.SphereMap.preset("none")


class Materials(unittest.TestCase):
    def test_reciprocity(self):
        brdf = mirrorball.Brdf("ggx:alpha=0.3,ior=1.5")
        rng = np.random.default_rng(4)
        light, view = np.abs(rng.normal(size=(2, 50, 3)))
        np.testing.assert_allclose(brdf.evaluate(light, view), brdf.evaluate(view, light), rtol=1e-9)

    def test_values_are_the_command_lines(self):
        line = run_program("brdf", "ward:alpha=0.2", "--eval", "30,0,40,180")
        t = np.radians([30, 40])
        value = mirrorball.Brdf("ward:alpha=0.2").evaluate([np.sin(t[0]), 0, np.cos(t[0])], [-np.sin(t[1]), 0, np.cos(t[1])])
        np.testing.assert_allclose(value, [float(word) for word in line.split()], rtol=1e-8)

    def test_albedo_stays_below_one(self):
        for view in (0, 45, 80):
            self.assertLess(max(mirrorball.Brdf("ggx:alpha=0.5").albedo(view)), 1.0001)


class Reports(FolderCase):
    def test_a_report_is_written_and_returned(self):
        report = mirrorball.report(["builtin:studio"], self.folder / "r", lobes="phong:50", methods=["spectral"], size=8, quick=True)
        self.assertTrue((self.folder / "r" / "report.html").exists())
        self.assertEqual(report, {**json.loads((self.folder / "r" / "report.json").read_text()), **report})

    def test_a_diagnosis_is_the_doctors(self):
        path = self.folder / "map.exr"
        run_program("filter", "builtin:sky", "-o", path, "--lobe", "ggx", "--mips", "--to", "cube", "--size", 16)
        self.assertEqual(mirrorball.diagnose(str(path)), json.loads(run_program("doctor", path, "--json")))


if __name__ == "__main__":
    unittest.main()
