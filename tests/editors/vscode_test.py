"""The extension for Visual Studio Code against the program: its languages, file types and commands.

What needs the packages of npm, colours and the bundle, ./dev vscode tests.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXTENSION = ROOT / "editors/vscode"
CONTRIBUTES = json.loads((EXTENSION / "package.json").read_text(encoding="utf-8"))["contributes"]
LANGUAGES = {each["id"]: each for each in CONTRIBUTES["languages"]}
MACLINT = os.environ.get("MACLINT")
# A program of each language, and a rule that finds something in it.
PROGRAMS = {"fanuc": ("%\nO9101\nGOTO99\nM30\n%\n", "MAC301"),
            "dinplus": ('PROGRAM HEAD\n#UNIT METRIC\nMACHINING\nN10 L"CHAMFER" LA40\nN20 M30\nSUBPROGRAM "CHAMFER"\nN1 G1 X#__la Z#__lb\nRETURN\nEND\n',
                        "DIN330"),
            "sinumerik": ("%_N_COVER_MPF\nN10 G0 X5\nN20 GOTOF NOWHERE\nN30 M30\n", "MAC301")}


def node_is_there():
    if not shutil.which("node"):
        return False
    done = subprocess.run(["node", "-p", "process.versions.node"], capture_output=True, text=True, check=False)
    return int(done.stdout.split(".")[0] or 0) >= 20


class ManifestTest(unittest.TestCase):
    def setUp(self):
        if not MACLINT:
            self.skipTest("MACLINT names no executable")

    def codes(self, folder, *options):
        done = subprocess.run([MACLINT, "check", "--format", "json", "--fail-on", "never", *options, "."], cwd=folder, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {(finding["file"], finding["code"]) for finding in json.loads(done.stdout)["findings"]}

    def test_language_ids_are_dialects(self):
        for language, (text, code) in PROGRAMS.items():
            with self.subTest(language), tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "O1.nc").write_text(text)
                self.assertIn(code, {found for _, found in self.codes(folder, "--dialect", language)})
        self.assertEqual(set(LANGUAGES), set(PROGRAMS))

    def test_file_types_are_those_that_a_run_over_a_folder_opens(self):
        for language, contributed in LANGUAGES.items():
            text, code = PROGRAMS[language]
            with self.subTest(language), tempfile.TemporaryDirectory() as folder:
                names = {f"a{index}{extension}" for index, extension in enumerate(contributed["extensions"])}
                names |= {pattern.replace("[0-9]", str(digit)) for digit, pattern in enumerate(contributed.get("filenamePatterns", []), 1)}
                for name in names:
                    (pathlib.Path(folder) / name).write_text(text)
                found = {file for file, each in self.codes(folder, "--isolated") if each == code}
                self.assertEqual(found, names)

    def test_no_file_type_has_two_languages(self):
        extensions = [extension for each in LANGUAGES.values() for extension in each["extensions"]]
        self.assertEqual(len(extensions), len(set(extensions)))


class SourcesTest(unittest.TestCase):
    def test_addresses_of_pages_come_from_the_program(self):
        for path in [*EXTENSION.glob("src/*.js"), EXTENSION / "package.json"]:
            self.assertNotRegex(path.read_text(encoding="utf-8"), "https?://", path.name)

    def test_versions_are_exact(self):
        for name, version in json.loads((EXTENSION / "package.json").read_text())["devDependencies"].items():
            self.assertRegex(version, r"^\d+\.\d+\.\d+$", name)

    def test_no_setting_of_a_folder_names_what_is_started(self):
        for name, setting in CONTRIBUTES["configuration"]["properties"].items():
            if re.search("path|command|argument|environment", name, re.I):
                self.assertEqual(setting["scope"], "machine", name)

    def test_files_that_are_named_are_there(self):
        for each in [*(language["configuration"] for language in LANGUAGES.values()), *(grammar["path"] for grammar in CONTRIBUTES["grammars"])]:
            json.loads((EXTENSION / each).read_text(encoding="utf-8"))

    def test_every_command_is_registered(self):
        """And whatever else node can test without packages."""
        if not node_is_there():
            self.skipTest("node 20 or later is not installed (nodejs)")
        tests = [str(EXTENSION / f"test/{name}.test.js") for name in ("executable", "extension", "language_of_text")]
        done = subprocess.run(["node", "--test", *tests], env=os.environ | {"MACLINT_CORPUS": str(ROOT / "corpus")}, capture_output=True, text=True,
                              check=False, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("# skipped 0", done.stdout)


if __name__ == "__main__":
    unittest.main()
