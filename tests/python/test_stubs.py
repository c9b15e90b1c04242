"""The type stubs name what the module has, and no more; everything is documented."""

import ast
import inspect
import pathlib
import unittest

import mirrorball

STUBS = ast.parse(pathlib.Path(mirrorball.__file__).with_name("__init__.pyi").read_text())


def parameters(function):
    """Names of a stub's parameters."""
    a = function.args
    return [p.arg for p in (*a.posonlyargs, *a.args, *a.kwonlyargs)]


class Stubs(unittest.TestCase):
    def stub_names(self, body):
        names = {}
        for node in body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                names[node.name] = node
        return names

    def test_the_module(self):
        stubs = {name for name in self.stub_names(STUBS.body) if not name.startswith("_")}
        self.assertEqual(stubs | {"__version__"}, set(mirrorball.__all__))

    def test_members_of_classes(self):
        for name, node in self.stub_names(STUBS.body).items():
            if not isinstance(node, ast.ClassDef) or name.startswith("_") or issubclass(getattr(mirrorball, name), Exception):
                continue
            has = {member for member in vars(getattr(mirrorball, name)) if not member.startswith("_")}
            self.assertEqual({m for m in self.stub_names(node.body) if not m.startswith("_")}, has, name)

    def test_parameters_have_the_names_of_the_module(self):
        checked = 0
        for name, node in self.stub_names(STUBS.body).items():
            functions = {f"{name}.{m}": n for m, n in self.stub_names(node.body).items()} if isinstance(node, ast.ClassDef) else {name: node}
            for path, function in functions.items():
                if not isinstance(function, ast.FunctionDef) or function.decorator_list[:1] and function.decorator_list[0].id == "property":
                    continue
                thing = mirrorball
                for part in path.split("."):
                    thing = getattr(thing, part, None)
                text = inspect.getdoc(thing) or ""
                if f"{function.name}(" not in text:
                    continue
                for parameter in parameters(function):
                    if parameter == "probe" and function.name == "prefilter":
                        continue  # each of its three forms has a name of its own
                    self.assertIn(f"{parameter}:", text, f"{path}: {parameter}")
                    checked += 1
        self.assertGreater(checked, 60)

    def test_keywords_of_reading_are_those_of_the_module(self):
        stub = next(node for node in STUBS.body if isinstance(node, ast.ClassDef) and node.name == "_Reading")
        stubs = {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
        with self.assertRaises(TypeError) as caught:
            mirrorball.read_probe("builtin:sky", nothing=1)
        self.assertEqual(stubs, set(str(caught.exception).split("is told by ")[1].split(", ")))

    def test_everything_says_what_it_is(self):
        for name in mirrorball.__all__:
            thing = getattr(mirrorball, name)
            if callable(thing) and not (inspect.isclass(thing) and issubclass(thing, Exception)):
                self.assertGreater(len(inspect.getdoc(thing) or ""), 20, name)


if __name__ == "__main__":
    unittest.main()
