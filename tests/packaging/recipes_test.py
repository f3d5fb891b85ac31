"""The recipes for CI services: what they run, run here, stops at a finding and leaves its reports."""
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RECIPES = sorted((ROOT / "docs/ci").iterdir()) + [ROOT / "action.yml"]
INPUTS = {"PATHS": ".", "OPTIONS": "--isolated", "REPORT": "maclint.sarif"}


def commands(recipe: pathlib.Path) -> list[str]:
    """The lines in which maclint lints, without the quotes and keys around them."""
    return re.findall(r"\b(maclint check[^'\n]*)", re.sub(r"(?m)^ *(#|//|description:).*$", "", recipe.read_text()))


class RecipesTest(unittest.TestCase):
    def setUp(self):
        program = os.environ.get("MACLINT")
        if not program:
            self.skipTest("MACLINT does not name an executable")
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin/maclint").symlink_to(program)
        (self.folder / "work").mkdir()

    def run_in_folder(self, command):
        path = f"{self.folder / 'bin'}:{os.environ['PATH']}"
        return subprocess.run(["bash", "-c", command], cwd=self.folder / "work", capture_output=True, text=True,
                              env={**os.environ, **INPUTS, "PATH": path})

    def test_each_lints_in_one_line(self):
        for recipe in RECIPES:
            self.assertEqual(len(commands(recipe)), 1, recipe.name)

    def test_each_is_told_what_to_install(self):
        for recipe in RECIPES:
            word, = re.findall(r"pip install --quiet (\"[^\n\"]*\")", recipe.read_text())
            if recipe.name == "action.yml":
                continue  # its default is the action itself
            done = subprocess.run(["sh", "-c", f"echo {word}"], env={"PATH": os.environ["PATH"]}, capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0, recipe.name)
            self.assertIn("say in MACLINT what pip installs", done.stderr)
            self.assertEqual(self.run_in_folder(f"MACLINT=a.whl; echo {word}").stdout, "a.whl\n")

    def test_each_fails_at_a_finding_and_leaves_what_the_service_reads(self):
        for recipe in RECIPES:
            command, = commands(recipe)
            for text, status in (("O1\nG0X1.\nM30\n", 0), ("O1\nGOTO9\nM30\n", 1)):
                (self.folder / "work/O1.nc").write_text(text)
                done = self.run_in_folder(command)
                self.assertEqual(done.returncode, status, f"{recipe.name}: {command}\n{done.stderr}")
                for report in re.findall(r"--output \S+?:(\S+)", command):
                    report = self.folder / "work" / os.path.expandvars(shlex.split(report.replace("$REPORT\"", INPUTS["REPORT"]))[0])
                    self.assertGreater(report.stat().st_size, 0, f"{recipe.name}: {report.name}")
                    report.unlink()


if __name__ == "__main__":
    unittest.main()
