"""maclint.exe under Wine: the same findings as on Linux, and what only Windows has.

MACLINT_EXE and MACLINT are the executables for Windows and for this system, WINE starts programs for Windows.
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
EXE = os.environ["MACLINT_EXE"]
HERE = os.environ["MACLINT"]
WINE = os.environ.get("WINE", "wine")
JUMP = "%\nO1001 (BAD)\nG0 X1.\nGOTO 99\nM30\n%\n"  # MAC301 on line 4


def run(executable, arguments, folder, text=None, **variables):
    words = [WINE, executable] if str(executable).endswith(".exe") else [executable]
    environment = {**os.environ, "WINEDEBUG": "-all", "LC_ALL": "C.UTF-8", **variables}
    source = {"input": text} if text is not None else {"stdin": subprocess.DEVNULL}
    return subprocess.run(words + arguments, cwd=folder, env=environment, capture_output=True, check=False, timeout=600, **source)


class WindowsTest(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="maclint-")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        (self.folder / ".git").mkdir()
        (self.folder / ".git/HEAD").write_text("")

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        return path

    def windows(self, *arguments, text=None):
        return run(EXE, list(arguments), self.folder, text)

    def concise(self, *arguments):
        """Findings as "file:line"."""
        done = self.windows("check", "--format", "concise", "--quiet", *arguments)
        self.assertIn(done.returncode, (0, 1), done.stderr.decode())
        return [":".join(line.split(":")[:2]) for line in done.stdout.decode().splitlines()]

    def same_as_here(self, *arguments, text=None, folder=None):
        """Both executables end with one status and print the same bytes; gives these."""
        there = run(EXE, list(arguments), folder or self.folder, text)
        here = run(HERE, list(arguments), folder or self.folder, text)
        self.assertEqual(there.stderr.decode(), here.stderr.decode())
        self.assertEqual(there.stdout.decode(), here.stdout.decode())
        self.assertEqual(there.returncode, here.returncode)
        return there.stdout


class Findings(WindowsTest):
    def test_over_the_corpus_in_every_format_with_threads(self):
        for form in ("text", "concise", "json", "sarif"):
            with self.subTest(form):
                out = self.same_as_here("check", "--format", form, "--isolated", "--no-timestamps", "--select", "ALL",
                                        "--jobs", "4", "corpus", folder=ROOT)
                self.assertGreater(len(out), 10_000)

    def test_do_not_depend_on_how_many_threads_look(self):
        outs = set()
        for jobs in ("1", "2", "8"):
            done = run(EXE, ["check", "--format", "json", "--isolated", "--no-timestamps", "--jobs", jobs, "corpus"], ROOT)
            self.assertEqual(done.returncode, 1, done.stderr.decode())
            self.assertGreater(len(done.stdout), 10_000)
            outs.add(done.stdout)
        self.assertEqual(len(outs), 1)

    def test_in_texts_with_the_line_ends_and_the_end_mark_of_dos(self):
        self.write("O1001.nc", JUMP.replace("GOTO 99", "IF[#500EQ1]GOTO99").replace("\n", "\r\n").replace("M30", "(\x1a\x1a)\r\nN5 GOTO 98\r\nM30") + "\x1a")
        out = self.same_as_here("check", "--format", "concise", "O1001.nc").decode()
        self.assertIn("O1001.nc:4:12: error[MAC301]", out)
        self.assertIn("The same in 1 more place: line 6.", out)
        self.same_as_here("check", "--format", "json", "--no-timestamps", "O1001.nc")
        self.same_as_here("check", "--format", "concise", "-", text=(self.folder / "O1001.nc").read_bytes())

    def test_of_rules_and_pages(self):
        self.same_as_here("rules", "--format", "json")
        self.same_as_here("explain", "MAC303")


class Names(WindowsTest):
    name = "würfel Größe.nc"

    def test_beyond_ascii_and_with_blanks(self):
        self.write(self.name, JUMP)
        self.write("ценa/日本.nc", JUMP)
        for path in (self.name, ".", "ценa"):
            for form in ("concise", "json", "sarif"):
                self.same_as_here("check", "--format", form, "--no-timestamps", path)
        self.assertEqual(self.concise(self.name), [self.name + ":4"])

    def test_beyond_ascii_for_reports_and_configurations(self):
        self.write("Größe/a.nc", JUMP)
        self.write("Größe/.maclint.json", '{"per-file-ignores": {"a.nc": ["MAC301"]}, "extends": "..\\\\größer.json"}')
        self.write("größer.json", '{"ignore": ["MAC302"]}')
        self.assertEqual(self.concise("Größe"), [])
        done = self.windows("check", "--output", "json:Größe/Prüfung.json", "--isolated", "Größe")
        self.assertEqual(done.returncode, 1, done.stderr.decode())
        report = (self.folder / "Größe/Prüfung.json").read_bytes()
        self.assertNotIn(b"\r", report)
        self.assertEqual(json.loads(report)["findings"][0]["file"], "Größe/a.nc")
        self.assertEqual(sorted(os.listdir(self.folder / "Größe")), [".maclint.json", "Prüfung.json", "a.nc"])

    def test_with_backslashes_are_shown_with_slashes(self):
        self.write("sub/a.nc", JUMP)
        self.assertEqual(self.concise("sub\\a.nc"), ["sub/a.nc:4"])
        self.assertEqual(self.concise("sub\\"), ["sub/a.nc:4"])
        self.assertEqual(self.concise("sub\\a.nc", "sub/../SUB/A.nc"), ["sub/a.nc:4"])

    def test_of_folders_with_a_backslash_before_the_last_quote(self):
        self.write("sub x/a.nc", JUMP)
        self.assertEqual(self.concise('sub x"'), ["sub x/a.nc:4"])

    def test_of_a_drive_with_a_backslash_before_the_last_quote(self):
        prefix = pathlib.Path(os.environ.get("WINEPREFIX") or pathlib.Path.home() / ".wine")
        self.windows("--version")  # makes the prefix where there is none
        drive = prefix / "dosdevices/q:"
        drive.symlink_to(self.folder)
        self.addCleanup(drive.unlink)
        self.write("inner/a.nc", JUMP)
        self.write("b.nc", JUMP)
        found = run(EXE, ["--format", "concise", "--quiet", 'Q:"'], self.folder / "inner")
        self.assertEqual(len(found.stdout.splitlines()), 2, found)

    def test_with_a_drive(self):
        self.write("a.nc", JUMP)
        path = "Z:" + str(self.folder / "a.nc").replace("/", "\\")
        self.assertEqual(self.concise(path)[0].split(":")[0], "Z")
        self.write("inner/.git/HEAD", "")
        outside = run(EXE, ["check", "--format", "sarif", path], self.folder / "inner")
        uris = [artifact["location"]["uri"] for artifact in json.loads(outside.stdout)["runs"][0]["artifacts"]]
        self.assertEqual(uris, ["file:///Z:" + str(self.folder / "a.nc")])

    def test_that_the_shell_leaves_to_the_program(self):
        for name in ("a.nc", "B.NC", "c.tap", "sub/d.nc", self.name):
            self.write(name, JUMP)
        self.assertEqual(self.concise("*.nc"), ["B.NC:4", "a.nc:4", self.name + ":4"])
        self.assertEqual(self.concise("s*\\?.nc"), ["sub/d.nc:4"])
        none = self.windows("check", "*.xyz")
        self.assertEqual(none.returncode, 2)
        self.assertIn("'*.xyz': cannot be read: there is no such file".replace("'", ""), none.stderr.decode())

    def test_of_more_than_260_characters(self):
        below = "/".join(["a-folder-with-a-long-name-%02d" % i for i in range(12)])
        self.write(below + "/a.nc", JUMP)
        self.assertGreater(len(below), 300)
        for path in (below + "/a.nc", below, ".", str(self.folder / below), below.replace("/", "\\") + "\\*.nc"):
            found = self.concise(path)
            self.assertEqual(len(found), 1, path)
            self.assertTrue(found[0].endswith(below + "/a.nc:4"), found)
        report = below + "/report-with-a-name-that-has-some-length.json"
        self.assertEqual(self.windows("check", "--quiet", "--output", "json:" + report, below).returncode, 1)
        self.assertEqual(json.loads((self.folder / report).read_text())["findings"][0]["range"]["start"]["line"], 4)


class Outcomes(WindowsTest):
    def test_of_a_missing_file_a_folder_without_programs_and_wrong_usage(self):
        for arguments in (["gone.nc"], ["--no-such-option"], ["--config", "gone.json", "."], ["chekc"]):
            self.same_as_here("check", *arguments)
        self.same_as_here("--version")
        # How help is laid out is the affair of the library, of which the system may have another version.
        options = [set(re.findall(r"--[a-z][a-z-]+", run(executable, ["--help"], self.folder).stdout.decode()))
                   for executable in (EXE, HERE)]
        self.assertIn("--baseline", options[0])
        self.assertEqual(*options)

    def test_of_asking_windows_for_the_details_of_the_program(self):
        version = self.windows("--version").stdout.decode().split()[1]
        content = pathlib.Path(EXE).read_bytes()
        for name in ("FileVersion", "ProductVersion"):
            self.assertIn(f"{name}\0".encode("utf-16-le"), content)
            value = content.split(f"{name}\0".encode("utf-16-le"))[1].lstrip(b"\0")
            self.assertTrue(value.startswith(f"{version}\0".encode("utf-16-le")), name)

    def test_of_standard_input(self):
        self.same_as_here("check", "--format", "concise", "--stdin-filename", "x.nc", "-", text=JUMP.encode())

    def test_of_reports_that_cannot_be_written(self):
        self.write("a.nc", JUMP)
        report = self.write("report.json", "old")
        report.chmod(0o444)
        done = self.windows("check", "--output", "json:report.json", "a.nc")
        self.assertEqual(done.returncode, 2)
        self.assertIn("report.json: cannot be written", done.stderr.decode())
        self.assertEqual(report.read_text(), "old")
        over = self.windows("check", "--output", "json:A.NC", "a.nc")
        self.assertIn("which is one of the files to check", over.stderr.decode())
        self.assertEqual((self.folder / "a.nc").read_text(), JUMP)
        self.assertEqual(sorted(os.listdir(self.folder)), [".git", "a.nc", "report.json"])

    def test_of_a_report_where_standard_output_goes(self):
        self.write("a.nc", JUMP)
        shutil.copy(EXE, self.folder / "maclint.exe")
        for report in ("out.json", f"..\\{self.folder.name}\\out.json"):
            done = run("cmd.exe", ["/c", f"maclint.exe --output json:{report} a.nc > out.json"], self.folder)
            self.assertEqual(done.returncode, 2, done.stderr.decode())
            self.assertIn("where standard output goes, too", done.stderr.decode())
            self.assertEqual((self.folder / "out.json").read_bytes(), b"")

    def test_of_a_report_to_no_device(self):
        self.write("a.nc", JUMP)
        self.assertEqual(self.windows("check", "--quiet", "--output", "json:NUL", "a.nc").returncode, 1)
        self.assertEqual(sorted(os.listdir(self.folder)), [".git", "a.nc"])

    def test_of_git_is_asked_of_what_the_path_leads_to_and_of_nothing_in_the_repository(self):
        self.write("a.nc", JUMP)
        program = pathlib.Path(EXE).read_bytes()  # as git it says that it knows no such option
        self.write("git.exe", program)
        beside = self.write("tools/maclint.exe", program)
        self.write("tools/git.exe", program)
        for path in ("", ".", "tools"):
            done = run(beside, ["--since", "HEAD", "a.nc"], self.folder, WINEPATH=path)
            self.assertIn("no git is found here", done.stderr.decode(), path)
            self.assertEqual(done.returncode, 2)
        for path in ("Z:{}\\tools", "C:\\nowhere;Z:{}\\tools\\"):
            path = path.format(str(self.folder).replace("/", "\\"))
            done = run(EXE, ["--since", "HEAD", "a.nc"], self.folder, WINEPATH=path)
            self.assertIn("--since cannot ask git about", done.stderr.decode(), path)
            self.assertIn("--no-optional-locks", done.stderr.decode(), path)

    def test_of_a_link_that_leads_back(self):
        self.write("a.nc", JUMP)
        (self.folder / "back").symlink_to(self.folder)
        self.assertEqual(self.concise("."), ["a.nc:4"])


if __name__ == "__main__":
    unittest.main()
