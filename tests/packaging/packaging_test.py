"""What packages are made of, without building one: python3 -m unittest discover -s tests/packaging -p '*_test.py'."""
import base64
import csv
import hashlib
import io
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "packaging"))

import archive  # noqa: E402
import fetch_sources  # noqa: E402
import package  # noqa: E402
import project_version  # noqa: E402
import trial  # noqa: E402
import wheel_writer  # noqa: E402


def elf(machine=62, kinds=(1,)):
    """The beginning of an executable with program headers of these kinds."""
    header = b"\x7fELF\x02\x01\x01" + bytes(9) + struct.pack("<HHI", 2, machine, 1) + bytes(8)
    header += struct.pack("<QQ", 64, 0) + bytes(6) + struct.pack("<HHHHH", 56, len(kinds), 0, 0, 0)
    return header + b"".join(struct.pack("<I", kind) + bytes(52) for kind in kinds)


class InFolder(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        return path


class WheelTest(InFolder):
    def wheel(self, content=elf(), system="linux-x86_64"):
        self.write("licences/zlib.txt", b"zlib's licence")
        return wheel_writer.write_wheel(self.write("maclint", content), system, self.folder / "licences", self.folder)

    def test_its_name_says_for_what_it_is(self):
        version = project_version.version()
        self.assertEqual(self.wheel().name, f"maclint-{version}-py3-none-manylinux_2_17_x86_64.musllinux_1_1_x86_64.whl")
        self.assertEqual(self.wheel(b"MZ", "windows-x86_64").name, f"maclint-{version}-py3-none-win_amd64.whl")

    def test_holds_one_program_that_may_be_run(self):
        with zipfile.ZipFile(self.wheel()) as packed:
            scripts = [info for info in packed.infolist() if ".data/scripts/" in info.filename]
        self.assertEqual([info.filename for info in scripts], [f"maclint-{project_version.version()}.data/scripts/maclint"])
        self.assertEqual(scripts[0].external_attr >> 16, 0o100755)

    def test_record_has_the_hash_and_the_size_of_every_file(self):
        with zipfile.ZipFile(self.wheel()) as packed:
            record = next(name for name in packed.namelist() if name.endswith("/RECORD"))
            rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(packed.read(record).decode()))}
            self.assertEqual(sorted(rows), sorted(packed.namelist()))
            self.assertEqual(rows.pop(record), ["", ""])
            for name, (digest, size) in rows.items():
                content = packed.read(name)
                encoded = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
                self.assertEqual((digest, size), (f"sha256={encoded}", str(len(content))), name)

    def test_has_a_tag_for_each_platform_and_the_licences(self):
        with zipfile.ZipFile(self.wheel()) as packed:
            text = {name.split(".dist-info/")[-1]: packed.read(name).decode() for name in packed.namelist() if "dist-info" in name}
        self.assertIn("\nTag: py3-none-manylinux_2_17_x86_64\nTag: py3-none-musllinux_1_1_x86_64\n", text["WHEEL"])
        self.assertIn("\nVersion: " + project_version.version() + "\n", text["METADATA"])
        self.assertEqual(text["licenses/zlib.txt"], "zlib's licence")
        self.assertIn("MIT License", text["licenses/LICENSE"])

    def test_equal_files_give_equal_bytes(self):
        first = self.wheel().read_bytes()
        (self.folder / "maclint").unlink()
        self.assertEqual(self.wheel().read_bytes(), first)

    def test_refuses_what_would_not_run_everywhere(self):
        for content, why in ((elf(kinds=(1, 3)), "not linked statically"), (elf(kinds=(1, 2)), "not linked statically"),
                             (elf(machine=183), "another processor"), (b"#!/bin/sh\n", "no 64-bit Linux executable")):
            with self.assertRaisesRegex(SystemExit, why):
                self.wheel(content)
        with self.assertRaisesRegex(SystemExit, "no Windows executable"):
            self.wheel(elf(), "windows-x86_64")


class WindowsArchiveTest(InFolder):
    def test_holds_the_program_documents_and_data_in_one_folder(self):
        self.write("stage/share/doc/maclint/LICENSE", b"MIT")
        self.write("stage/share/doc/maclint/licences/glibc.txt", b"not in it")
        self.write("stage/share/doc/maclint/docs/rules/MAC001.md", b"a page")
        self.write("stage/share/maclint/maclint.schema.json", b"{}")
        self.write("licences/cli11.txt", b"BSD")
        path = package.windows_zip(self.write("maclint.exe", b"MZ"), self.folder / "stage", self.folder / "licences", self.folder)
        name = f"maclint-{project_version.version()}-windows-x86_64"
        self.assertEqual(path.name, name + ".zip")
        with zipfile.ZipFile(path) as packed:
            self.assertEqual(packed.namelist(), [f"{name}/{file}" for file in ("maclint.exe", "LICENSE", "docs/rules/MAC001.md",
                                                                               "maclint.schema.json", "licences/cli11.txt")])

    def test_refuses_another_system_s_program(self):
        with self.assertRaisesRegex(SystemExit, "no Windows executable"):
            package.windows_zip(self.write("maclint.exe", elf()), self.folder, None, self.folder)


class PagesTest(InFolder):
    def test_with_links_that_lead_nowhere_are_found(self):
        self.write("docs/a.md", b"[b](b.md#x) [c](../c.md) [here](#x) [net](https://x.invalid/a) [gone](gone.md#x)")
        self.write("docs/b.md", b"")
        self.write("c.md", b"[folder](docs) [d](docs/d.md)")
        self.assertEqual(trial.broken_links(self.folder), ["c.md links to docs/d.md", "docs/a.md links to gone.md"])

    def test_that_are_installed_lead_to_what_is_installed(self):
        program = os.environ.get("MACLINT")
        if not program:
            self.skipTest("MACLINT does not name an executable")
        subprocess.run(["cmake", "--install", pathlib.Path(program).parent, "--prefix", self.folder], check=True, stdout=subprocess.DEVNULL)
        trial.try_pages(self.folder / "share/doc/maclint")


class SumsTest(InFolder):
    def test_are_those_of_the_packages_and_of_nothing_else(self):
        self.write("maclint-1.zip", b"a")
        self.write("notes.txt", b"b")
        package.write_sums(self.folder)
        self.assertEqual((self.folder / "SHA256SUMS").read_text(), hashlib.sha256(b"a").hexdigest() + "  maclint-1.zip\n")


class SourcesTest(InFolder):
    def test_each_is_of_one_version_and_known_by_its_hash(self):
        rows = [row for row in fetch_sources.LIST.read_text().splitlines() if row and not row.startswith(("#", "--no-binary"))]
        self.assertEqual(len(rows), 3)
        for row in rows:
            self.assertRegex(row, r"^[a-z-]+==[0-9.]+ --hash=sha256:[0-9a-f]{64}$")

    def test_takes_from_an_archive_only_what_is_needed(self):
        place = lambda name, path: fetch_sources.place(name, pathlib.PurePosixPath(path))
        self.assertEqual(str(place("nlohmann_json", "nlohmann_json/include/nlohmann/json.hpp")), "include/nlohmann/json.hpp")
        self.assertEqual(str(place("tree_sitter", "tree_sitter/core/lib/src/lib.c")), "tree-sitter/lib/src/lib.c")
        self.assertEqual(str(place("highspy", "extern/cli11/CLI11.hpp")), "include/CLI/CLI.hpp")
        self.assertIsNone(place("highspy", "highs/Highs.h"))
        self.assertIsNone(place("tree_sitter", "setup.py"))

    def test_are_fetched_by_a_pip_that_knows_nothing_of_the_one_above(self):
        given = {"PATH": "/bin", "PIP_INDEX_URL": "x", "_PYPROJECT_HOOKS_BACKEND_PATH": "packaging", "PEP517_BACKEND_PATH": "y"}
        self.assertEqual(fetch_sources.own_environment(given), {"PATH": "/bin", "PIP_INDEX_URL": "x"})

    def test_a_licence_is_the_comment_that_a_header_begins_with(self):
        self.assertEqual(fetch_sources.first_comment("// A\n//\n// B\n\n#pragma once\n// C\n"), "A\n\nB\n")


class VersionTest(unittest.TestCase):
    def test_grammars_have_that_of_the_project(self):
        for path in sorted(ROOT.glob("grammar/*/tree-sitter.json")):
            self.assertEqual(json.loads(path.read_text())["metadata"]["version"], project_version.version(), path)

    def test_has_a_section_of_the_changelog_that_is_read_in_a_minute(self):
        sections = re.split(r"^## \[([^\]]+)\].*\n", (ROOT / "CHANGELOG.md").read_text(), flags=re.M)
        lines = dict(zip(sections[1::2], sections[2::2]))[project_version.version()].strip().splitlines()
        self.assertLessEqual(len(lines), 60)
        self.assertEqual(sections[1], "Unreleased")

    def test_is_that_of_the_python_project(self):
        text = (ROOT / "pyproject.toml").read_text()
        pattern = re.search(r"^regex = '(.*)'$", text, re.MULTILINE).group(1)
        found = re.search(pattern, (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
        self.assertEqual(found.group("value"), project_version.version())


class HookTest(unittest.TestCase):
    pattern = re.search(r"^  files: (.*)$", (ROOT / ".pre-commit-hooks.yaml").read_text(), re.MULTILINE).group(1)

    def test_takes_every_extension_that_maclint_reads_in_folders(self):
        code = (ROOT / "analyzer/dialect/detect.cpp").read_text()
        listed = re.search(r"extensions\[\] = \{(.*?)\}", code, re.DOTALL).group(1)
        extensions = set(re.findall(r'"(\w+)"', listed)) - {"txt", "h", "def", "arc"}  # in a repository these are seldom programs
        self.assertGreater(len(extensions), 15)
        for extension in extensions:
            self.assertRegex(f"mill/part.{extension}", self.pattern)
            self.assertRegex(f"PART.{extension.upper()}", self.pattern)

    def test_takes_names_of_programs_in_any_case_and_no_others(self):
        for name in ("O9010", "mill/o0001", "O9010_TORUS", "o12 (A)", "nc40", "mill/1234"):
            self.assertRegex(name, self.pattern)
        for name in ("README.md", "a.h", "notes.txt", "mill/PO12", "O9010.bak", "O9010TORUS", "nc", "nc40a", "123456789",
                     "tools/run.sh"):
            self.assertNotRegex(name, self.pattern)


class CommandLineTest(unittest.TestCase):
    def test_a_wheel_is_refused_with_the_reason_and_no_traceback(self):
        done = subprocess.run([sys.executable, str(ROOT / "packaging/wheel_writer.py"), "--executable", __file__, "--system",
                               "linux-x86_64"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"^wheel: .* cannot go into a wheel for linux-x86_64: it is no 64-bit Linux executable\.\n$")


if __name__ == "__main__":
    unittest.main()
