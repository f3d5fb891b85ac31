"""The script ./dev: its words, what it does again and what not, and which file clang-tidy reads for a header."""
import hashlib
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEV = (ROOT / "dev").read_text()
WORDS = set(re.search(r"^    build\) .*\n    (lint [\w |]*)\)", DEV, re.M).group(1).split(" | ")) | {"build", "help"}


def pages():
    """Texts that people read, and scripts that name words to them."""
    return [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("tests/mutation/*.md"), *ROOT.glob("tests/metamorphic/*.md"), *ROOT.glob(".ci/*"), *ROOT.glob("cmake/*"),
            *ROOT.glob("packaging/*.py"), ROOT / "CMakeLists.txt"]


class WordsTest(unittest.TestCase):
    def test_are_all_in_its_help_and_in_the_readme(self):
        usage = DEV[DEV.index("usage: ./dev"):DEV.index("\nHELP\n")]
        self.assertEqual(set(re.findall(r"^  ([a-z]+)\b", usage, re.M)) | {"tidy"}, WORDS)
        readme = (ROOT / "README.md").read_text()
        for word in WORDS:
            self.assertRegex(readme, rf"\./dev {word}\b|`{word}`", word)

    def test_are_those_that_the_pages_name(self):
        for page in pages():
            for word in re.findall(r"\./dev ([a-z]+)", page.read_text()):
                self.assertIn(word, WORDS, page.name)

    def test_release_does_all_that_the_gate_may_leave_out(self):
        left_out = set(re.findall(r"within \d+ \d+ \./dev ([a-z]+)", (ROOT / ".ci/run").read_text()))
        self.assertGreaterEqual(left_out, {"sanitize", "fuzz", "threads", "windows", "tidy"})
        steps = re.findall(r"^        step '[^']*' (\w+)", DEV, re.M)
        self.assertLessEqual(left_out, set(steps))
        self.assertEqual(steps[-1], "package", "packages hold what the steps before have built")


class PackagesTest(unittest.TestCase):
    def test_that_it_installs_stand_in_the_table_of_the_page(self):
        rows = DEV[DEV.index("packages='"):DEV.index("\n'\n")].splitlines()[1:]
        names = {row.split()[1] for row in rows if row}
        self.assertGreaterEqual(names, {"g++", "python3-venv", "wine64"})
        page = (ROOT / "docs/install.md").read_text().split("\n## Building in a copy of the repository\n")[1]
        table = "\n".join(line.split("|")[1] for line in page.splitlines() if line.startswith("| "))
        for name in names:
            self.assertRegex(table, rf"(?m)(^|[ ,]){re.escape(name)}($|[ ,])")


class CommandLineUnderWineTest(unittest.TestCase):
    def printed(self, function):
        done = subprocess.run(["bash", "-c", f". ./dev help >/dev/null\n{function}"], cwd=ROOT, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_runs_what_starts_the_executable(self):
        tests = self.printed("command_line_tests").split()
        for name in ("Executable.EndsWith0WithoutFindings", "BadBytes.UnclosedComment", "Faults.NoFileTakesTwoReports"):
            self.assertIn(name, tests)
        self.assertNotIn("Glob.EndsSoonWhateverThePatternIs", tests)

    def test_leaves_out_what_there_is_and_says_why(self):
        tests = self.printed("command_line_tests").split()
        lines = [line for line in (ROOT / "tests/windows/left_out").read_text().splitlines() if not line.startswith("#")]
        names = self.printed("left_out_under_wine").split()
        self.assertEqual(len(names), len(lines), "each line has a name and a reason")
        for name in names:
            self.assertTrue(any(re.fullmatch(name.replace("*", ".*"), test) for test in tests), name)
        left_out = re.compile(self.printed("left_out_under_wine | any_of").strip())
        self.assertTrue(left_out.fullmatch("Since.ConflictsHaveChanged"))
        # What is all about links and git stands aside; of the others most run.
        tests = [test for test in tests if test.split(".")[0] not in ("Backslash", "CheckedFolder", "Configurations", "Links", "Since")]
        self.assertLess(len([test for test in tests if left_out.fullmatch(test)]), len(tests) / 4)


class InCopyTest(unittest.TestCase):
    """In a folder with nothing but the script."""

    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        self.write("dev", DEV)

    def write(self, name, text=""):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def in_dev(self, script):
        done = subprocess.run(["bash", "-c", f". ./dev help >/dev/null\n{script}"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_of_a_header_without_a_source_tidy_takes_one_that_it_can_read(self):
        for name in ("analyzer/source/platform/windows/a.cpp", "cli/b.cpp"):
            self.write(name, '#include "analyzer/source/platform/a.hpp"\n')
        self.write("fuzz/c.cpp", '#include "fuzz/c_only.hpp"\n')
        subprocess.run("git init -q && git add . && git -c user.name=x -c user.email=x@x.invalid commit -qm x",
                       shell=True, cwd=self.folder, check=True)
        self.write("analyzer/source/platform/a.hpp")
        self.write("fuzz/c_only.hpp")
        changed = self.in_dev("changed_since HEAD").strip("\0").split("\0")
        self.assertEqual(changed, [str(self.folder.resolve() / name) for name in ("cli/b.cpp", "fuzz/c.cpp")])

    def release(self, package):
        """Runs the steps of a release, where each passes but for what `package` does for the packages."""
        step = f"#!/bin/sh\n[ $1 = package ] || exit 0\nmkdir -p build/packages && cd build/packages\n{package}\n"
        (self.folder / "step").write_text(step)
        return self.in_dev("cp step dev; chmod +x dev; status=0; word_release || status=$?; echo status $status").splitlines()

    def test_a_release_ends_with_the_files_to_publish_and_their_check_sums(self):
        lines = self.release("echo a >maclint.whl; sha256sum maclint.whl >SHA256SUMS")
        packages = (self.folder / "build/packages").resolve()
        sums = [f"  {hashlib.sha256((packages / name).read_bytes()).hexdigest()}  {name}" for name in ("maclint.whl", "SHA256SUMS")]
        self.assertEqual(lines[-4:], [f"to publish, from {packages}:", *sums, "status 0"])
        self.assertEqual((self.folder / "build/release.log").read_text().splitlines()[-2:], sums)

    def test_a_release_names_no_files_where_a_step_failed_or_a_sum_is_wrong(self):
        made = "echo a >maclint.whl; sha256sum maclint.whl >SHA256SUMS"
        for package, why in ((f"{made}; exit 1", "nothing is to be published before these pass"),
                             (f"{made}; echo b >maclint.whl", "SHA256SUMS does not go with the packages")):
            self.write("dev", DEV)
            lines = self.release(package)
            self.assertEqual(lines[-2:], [why, "status 1"])
            self.assertFalse([line for line in lines if line.startswith("to publish")])

    def test_what_pip_brings_is_fetched_once(self):
        script = "need() { :; }; quietly() { shift; echo \"$@\"; }; mkdir -p build/venv; fetch_sources"
        self.assertIn("pip install", self.in_dev(script))
        self.assertNotIn("pip install", self.in_dev(script))


if __name__ == "__main__":
    unittest.main()
