"""fuzz/run.py with a target that is none: what it is told, and what is said of its finds."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIND = bytes(range(256)) * 3
TARGET = """#!PYTHON
import pathlib, sys
print(*sys.argv[1:], sep="\\n")
if DEFECT != 0:
    prefix, = (word.split("=", 1)[1] for word in sys.argv if word.startswith("-artifact_prefix="))
    pathlib.Path(prefix + "crash-1").write_bytes(bytes(range(256)) * 3)
    print(f"artifact_prefix='{prefix}'; Test unit written to {prefix}crash-1")
sys.exit(DEFECT)
"""


class FuzzRunTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory(prefix="with blanks ")
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name).resolve()

    def run_target(self, defect, *options):
        path = self.folder / "sanitize/fuzz_source"
        path.parent.mkdir(exist_ok=True)
        path.write_text(TARGET.replace("PYTHON", sys.executable).replace("DEFECT", str(defect)))
        path.chmod(0o755)
        done = subprocess.run([sys.executable, "-B", ROOT / "fuzz/run.py", "--build", self.folder, *options, "source"],
                              capture_output=True, text=True)
        self.assertEqual(done.stderr, "")
        return done.returncode, done.stdout

    def words_of_target(self):
        return (self.folder / "fuzz/log/source").read_text().splitlines()

    def test_the_log_holds_a_find_as_the_line_that_makes_its_file(self):
        before = self.folder / "fuzz/finds/source-crash-1"  # a find of an earlier run counts like a new one
        before.parent.mkdir(parents=True)
        before.touch()
        status, out = self.run_target(77)
        self.assertEqual(status, 1)
        self.assertIn("DEFECT", out)
        line = re.search(r"^ *(printf .*)$", out, re.M).group(1)
        subprocess.run(["sh", "-c", line], cwd=self.folder, check=True)
        self.assertEqual((self.folder / "source-crash-1").read_bytes(), FIND)

    def test_what_finds_nothing_passes_and_has_begun_with_configurations_of_the_pages(self):
        status, out = self.run_target(0)
        self.assertEqual(status, 0)
        self.assertIn("no defect", out)
        seeds = [path.read_text() for path in (self.folder / "fuzz/seeds/configuration").iterdir()]
        self.assertTrue([text for text in seeds if text.startswith("{") and '"per-file-ignores"' in text and '"extends": "../shop.json"' in text])

    def test_a_seed_goes_to_the_target_and_begins_with_nothing_learned(self):
        kept = self.folder / "fuzz/corpus/source/learned"
        kept.parent.mkdir(parents=True)
        kept.touch()
        self.run_target(0)
        self.assertIn(str(kept.parent), self.words_of_target())
        self.assertFalse([word for word in self.words_of_target() if word.startswith("-seed")])
        self.run_target(0, "--seed", "7")
        self.assertIn("-seed=7", self.words_of_target())
        self.assertNotIn(str(kept.parent), self.words_of_target())
        self.assertTrue(kept.is_file())


if __name__ == "__main__":
    unittest.main()
