"""What ./dev repairs shows of a repository that is made here, and that it runs nothing of a stranger's."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tests/tools"
HOSTILE = (ROOT / "tests/cli/hostile_repositories.cpp").read_text()
sys.path.insert(0, str(TOOLS))

import git_history  # noqa: E402

loader = importlib.machinery.SourceFileLoader("repairs", str(TOOLS / "repairs"))
repairs = importlib.util.module_from_spec(importlib.util.spec_from_loader("repairs", loader))
sys.modules["repairs"] = repairs
loader.exec_module(repairs)

DRILL = "%\nO9200(DEPTH)\nG0X#24\nG1Z[#26*2]F100\nM99\n%\n"
PART = "%\nO1000\nG65P9200X1.\nM30\n%\n"
LOOP = """%
O9100
IF[#100EQ1]GOTO20
WHILE[#1LT5]DO1
N10 G91 G1 X1. F100
N20 G0 X#1
#1=#1+1
END1
M99
%
"""


def finding(rule="MAC303", fingerprint="a", line=1, message="", allowed=False):
    return repairs.Finding(rule, fingerprint, "error", line, message, allowed)


class RegionsTest(unittest.TestCase):
    def test_are_the_lines_that_differ_but_for_their_ends(self):
        before = repairs.lines_of(b"A\r\nB\r\nC\r\nD\r\nE")
        after = repairs.lines_of(b"A \nX\nY\nC\nD\n\nE\n")
        regions = repairs.regions_between(before, after)
        self.assertEqual(regions, [(1, 2, 1, 3), (4, 4, 5, 6), (5, 5, 7, 8)])
        self.assertEqual(repairs.changed_blocks(before, after, regions), 2, "empty lines are no blocks")

    def test_of_files_that_differ_all_over_are_not_looked_for(self):
        self.assertIsNone(repairs.regions_between([b"G1"] * (repairs.MOST_LINES + 1), [b"G0"]))

    def test_say_which_line_stands_for_which(self):
        changed = repairs.ChangedFile(b"a", b"a", [(2, 3, 2, 5)], 3)
        self.assertTrue(changed.is_replaced(2, 2))
        self.assertTrue(changed.is_replaced(3, 5), "in what was put there")
        self.assertTrue(changed.is_replaced(4, 6))
        self.assertFalse(changed.is_replaced(4, 4), "another block by now")
        self.assertFalse(changed.is_replaced(2, 3))


class ComparedTest(unittest.TestCase):
    changed = repairs.ChangedFile(b"a", b"a", [(2, 3, 2, 5)], 3)

    def test_findings_are_the_same_by_fingerprint_message_or_block(self):
        for old, new in ((finding(fingerprint="a", line=1, message="x"), finding(fingerprint="a", line=9, message="y")),
                         (finding(fingerprint="a", line=1, message="x"), finding(fingerprint="b", line=9, message="x")),
                         (finding(fingerprint="a", line=4, message="x"), finding(fingerprint="b", line=6, message="y"))):
            self.assertEqual(repairs.compared(self.changed, [old], [new]), ([], [], [(old, new)]))

    def test_others_went_and_came(self):
        for old, new in ((finding(), finding("MAC501")), (finding(line=4, message="x"), finding(fingerprint="b", line=4, message="y"))):
            self.assertEqual(repairs.compared(self.changed, [old], [new]), ([old], [new], []))

    def test_one_of_two_that_are_alike_went(self):
        two = [finding(line=1), finding(line=2)]
        self.assertEqual(repairs.compared(self.changed, two, two[:1]), ([two[1]], [], [(two[0], two[0])]))

    def test_what_a_comment_allows_did_not_go(self):
        old, new = finding(), finding(allowed=True)
        self.assertEqual(repairs.compared(self.changed, [old], [new]), ([], [], [(old, new)]))
        self.assertEqual(repairs.compared(self.changed, [new], [old]), ([], [old], []))
        self.assertEqual(repairs.compared(self.changed, [new], [new]), ([], [], []))
        self.assertEqual(repairs.compared(self.changed, [new], []), ([], [], []))


class RenamesTest(unittest.TestCase):
    def test_go_to_the_file_that_has_most_in_common(self):
        texts = {b"a": b"1\n2\n3\n4", b"b": b"5\n6\n7\n8", b"x": b"1\n2\n3\n9", b"y": b"1\n2\n9\n8", b"z": b"0\n0\n0\n8"}
        self.assertEqual(repairs.renames([b"a", b"b"], [b"x", b"y", b"z"], texts), {b"x": b"a"})

    def test_are_not_looked_for_among_too_many(self):
        names = [b"%d" % number for number in range(200)]
        self.assertEqual(repairs.renames(names, names, dict.fromkeys(names, b"1")), {})


class PlainTest(unittest.TestCase):
    def test_shows_what_would_steer_a_terminal(self):
        self.assertEqual(repairs.plain("\x1b[2J O1\u202e"), "\\x1b[2J O1\\u202e")


def git(folder, *words):
    done = subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@x.invalid", "-c", "core.autocrlf=false", *words],
                          cwd=folder, capture_output=True, text=True, check=True)
    return done.stdout.strip()


@unittest.skipUnless(shutil.which("git"), "there is no git")
class RepositoryTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.beside = pathlib.Path(held.name).resolve()
        self.folder = self.beside / "shop"
        self.folder.mkdir()
        git(self.folder, "init", "-q")

    def commit(self, subject, files):
        for name, text in files.items():
            path = self.folder / name
            if text is None:
                path.unlink()
                with contextlib.suppress(OSError):
                    path.parent.rmdir()
            else:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(text if isinstance(text, bytes) else text.encode())
        git(self.folder, "add", "-A")
        git(self.folder, "commit", "-qm", subject)
        return git(self.folder, "rev-parse", "HEAD")

    def run_tool(self, *words):
        with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()) as errors:
            status = repairs.main([str(self.folder), "--maclint", os.environ.get("MACLINT", "/bin/false"), *words])
        return status, out.getvalue(), errors.getvalue()


class HistoryTest(RepositoryTest):
    def test_files_that_would_lie_outside_are_left_out(self):
        blob = subprocess.run(["git", "hash-object", "-w", "--stdin"], cwd=self.folder, input=b"X", capture_output=True, check=True)
        name = bytes.fromhex(blob.stdout.decode().strip())

        def tree(*entries):
            text = b"".join(b"%b %b\0%b" % (mode, path, each) for mode, path, each in entries)
            done = subprocess.run(["git", "hash-object", "-t", "tree", "-w", "--stdin", "--literally"], cwd=self.folder, input=text,
                                  capture_output=True, check=True)
            return bytes.fromhex(done.stdout.decode().strip())

        one = tree((b"100644", b"x.nc", name))
        all_of_them = tree((b"40000", b"..", one), (b"40000", b".GIT", one), (b"100644", b"../y.nc", name), (b"120000", b"link", name),
                           (b"100644", b"a", name), (b"40000", b"a", one), (b"100644", b"n" * 300, name))
        commit = git(self.folder, "commit-tree", "-m", "x", all_of_them.hex())
        history = git_history.History(self.folder)
        files = history.files(commit)
        self.assertEqual(set(files), {b"a", b"a/x.nc", b"n" * 300})
        folder = git_history.Folder(history, self.beside / "held")
        folder.become(files)
        self.assertEqual(sorted(path.name for path in (self.beside / "held").iterdir()), [".git", "a"])
        self.assertEqual(sorted(path.name for path in self.beside.iterdir()), ["held", "shop"])

    def test_a_folder_becomes_another_commit(self):
        first = self.commit("1", {"a/b.nc": "1", "c.nc": "2", "e": "3"})
        second = self.commit("2", {"a/b.nc": None, "c.nc": "5"})
        third = self.commit("3", {"a": "4"})
        history = git_history.History(self.folder)
        folder = git_history.Folder(history, self.beside / "held")
        wanted_of = {first: {"a/b.nc": "1", "c.nc": "2", "e": "3"}, second: {"c.nc": "5", "e": "3"}, third: {"a": "4", "c.nc": "5", "e": "3"}}
        for commit, wanted in [*wanted_of.items()] * 2:
            folder.become(history.files(commit))
            held = {str(path.relative_to(self.beside / "held")): path.read_text() for path in (self.beside / "held").rglob("*") if path.is_file()}
            self.assertEqual(held, wanted)

    def test_a_commit_has_its_day_and_its_subject(self):
        commit = git_history.Commit("c", b"tree 12\nauthor a <a> 5 +0000\ncommitter b <b> 86400 +0100\n\n\xc4 first\nsecond\n")
        self.assertEqual((commit.tree, commit.seconds, commit.subject), ("12", 86400, "\ufffd first"))
        self.assertEqual(git_history.Commit("c", b"").seconds, 0)

    def test_commits_since_a_day_or_a_revision(self):
        names = [self.commit(text, {"O1": text}) for text in "abc"]
        history = git_history.History(self.folder)
        self.assertEqual(history.pairs(None), [(names[2], names[1]), (names[1], names[0])])
        self.assertEqual(history.pairs("HEAD~1"), [(names[2], names[1])])
        self.assertEqual(len(history.pairs("2001-01-01")), 2)
        self.assertEqual(history.pairs("2999-01-01"), [])
        for wrong, why in (("nowhere", "rev-parse"), ("--output=x", "rev-parse"), ("2026-02-31", "no day '2026-02-31'")):
            with self.assertRaisesRegex(git_history.BadRepository, why):
                history.pairs(wrong)

    def test_what_git_is_asked_is_what_maclint_asks(self):
        refusals = (ROOT / "cli/gate/git_refusals.cpp").read_text()
        rows = re.search(r"read_by_git = std::to_array<std::string_view>\(\{(.*?)\}\);", refusals, re.S).group(1)
        self.assertEqual(git_history.READ_BY_GIT, re.findall(r'"([^"]+)"', rows))
        call = (ROOT / "cli/gate/git_call.cpp").read_text()
        self.assertEqual(git_history.SETTINGS, re.findall(r'"([^"]+)"', re.search(r"setting : \{(.*?)\}\)", call).group(1)))
        self.assertEqual(git_history.USERS_OWN, re.findall(r'"(\w+)"', re.search(r"request.paths = \{(.*?)\};", call).group(1)))
        settings = dict(re.findall(r'"(\w+)=(\w*)', re.search(r"request.set = \{(.*?)\};", call, re.S).group(1)))
        for key, value in settings.items():
            self.assertEqual(git_history.environment(self.folder)[key], value or str(self.beside), key)

    def test_special_files_are_refused(self):
        self.commit("x", {"O1": "x"})
        (self.beside / "secret").write_text("SECRET")
        shallow = self.folder / ".git/shallow"
        for make in (lambda: shallow.symlink_to(self.beside / "secret"), lambda: os.mkfifo(shallow)):
            make()
            with self.assertRaisesRegex(git_history.BadRepository, "shallow' is (a link that leads out|no file)"):
                git_history.History(self.folder)
            shallow.unlink()
        git_history.History(self.folder)
        with self.assertRaisesRegex(git_history.BadRepository, "holds no .git"):
            git_history.History(self.beside)

    def test_a_git_among_the_programs_is_not_run(self):
        own = self.folder / "git"
        own.write_text("#!/bin/sh\nexit 7\n")
        own.chmod(0o755)
        (self.beside / "link").mkdir()
        (self.beside / "link/git").symlink_to(own)
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = os.pathsep.join([".", str(self.folder), str(self.beside / "link"), path])
        self.assertEqual(git_history.git_outside_of(self.folder), shutil.which("git", path=path))


@unittest.skipUnless("MACLINT" in os.environ, "no executable is named")
class ToolTest(RepositoryTest):
    def records(self, *words):
        status, out, errors = self.run_tool("--json", *words)
        self.assertEqual((status, errors), (0, ""))
        report = json.loads(out)
        return {record["subject"]: record for record in report["commits"]}, report["summary"]

    def rules(self, record):
        return {what: [f"{entry['rule']}:{entry['line']}" for entry in record[what]] for what in ("went", "came", "stayed")}

    def test_shows_what_went_what_came_and_what_stayed(self):
        self.commit("first", {"O9100.nc": LOOP})
        self.commit("repair", {"O9100.nc": LOOP.replace("GOTO20", "GOTO9").replace("O9100\n", "O9100\n(FEEDS)\n").replace("WHILE", "N9 WHILE")})
        self.commit("back", {"O9100.nc": LOOP})
        told, summary = self.records()
        self.assertEqual(self.rules(told["repair"]), {"went": ["MAC303:3"], "came": [], "stayed": ["MAC501:6"]})
        self.assertEqual(self.rules(told["back"]), {"went": [], "came": ["MAC303:3"], "stayed": ["MAC501:5"]})
        self.assertEqual(told["repair"]["blocks"], 3)
        self.assertEqual((summary["went"], summary["came"], summary["stayed"]), (1, 1, 2))
        self.assertEqual(summary["rules"]["MAC303"], {"went": 1, "came": 1, "stayed": 0})

    def test_prints_80_columns_and_steers_no_terminal(self):
        self.commit("first", {"O9100.nc": LOOP})
        self.commit("repair \x1b[31m " + "long " * 30, {"O9100.nc": LOOP.replace("GOTO20", "GOTO99")})
        status, text, _ = self.run_tool()
        self.assertEqual(status, 0)
        self.assertRegex(text, r"(?m)^[0-9a-f]{10} \d{4}-\d\d-\d\d repair \\x1b\[31m long")
        self.assertRegex(text, r"(?m)^  went   O9100.nc:3: error\[MAC303\] Jump into a loop: ")
        self.assertRegex(text, r"(?m)^  came   O9100.nc:3: error\[MAC301\] ")
        self.assertRegex(text, r"1 commit with up to 10 changed blocks. Findings: 1 went, 1 came, 1 stayed.")
        self.assertLessEqual(max(map(len, text.splitlines())), 80)

    def test_a_program_is_seen_with_those_around_it(self):
        self.commit("first", {"O9200.nc": DRILL, "parts/O1000.nc": PART})
        self.commit("depth", {"O9200.nc": DRILL.replace("#26*2", "#24*2")})
        told, _ = self.records()
        # Of O9200 alone nothing is told: only the call shows that Z is left out.
        self.assertEqual(self.rules(told["depth"]), {"went": ["MAC210:4"], "came": [], "stayed": []})

    def test_a_renamed_program_is_compared_with_what_it_was(self):
        self.commit("first", {"O9100.nc": LOOP})
        self.commit("moved", {"O9100.nc": None, "loops/O9101.nc": LOOP.replace("GOTO20", "GOTO9").replace("WHILE", "N9 WHILE")})
        self.commit("only moved", {"loops/O9101.nc": None, "O9102.nc": LOOP.replace("GOTO20", "GOTO9").replace("WHILE", "N9 WHILE")})
        told, _ = self.records()
        self.assertEqual(list(told), ["moved"])
        self.assertEqual(told["moved"]["files"], [{"before": "O9100.nc", "after": "loops/O9101.nc", "blocks": 2}])
        self.assertEqual(self.rules(told["moved"]), {"went": ["MAC303:3"], "came": [], "stayed": ["MAC501:5"]})
        self.assertIn("loops/O9101.nc: 2 blocks, was O9100.nc", self.run_tool()[1])

    def test_only_blocks_of_programs_count(self):
        table = "".join(f"row {row}\n" for row in range(100))
        picture = b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 9
        self.commit("first", {"O9100.nc": LOOP})
        self.commit("one block", {"O9100.nc": LOOP.replace("GOTO20", "GOTO99"), "README.md": table, "O9100.png": picture, "O9101.nc": picture})
        self.commit("only text", {"README.md": "less\n"})
        self.commit("many blocks", {"O9100.nc": LOOP.replace("#1", "#2") + "(A)\n" * 20})
        self.commit("a new one", {"O9300.nc": PART.replace("1000", "9300")})
        told, _ = self.records()
        self.assertEqual(list(told), ["a new one", "one block"])
        self.assertEqual(told["one block"]["blocks"], 1)
        self.assertEqual([file["after"] for file in told["one block"]["files"]], ["O9100.nc"])
        self.assertEqual(list(self.records("--max-blocks", "4")[0]), ["one block"])
        self.assertEqual(list(self.records("--limit", "1")[0]), ["a new one"])
        self.assertTrue(self.records("--limit", "1")[1]["more"])
        self.assertFalse(self.records("--limit", "2")[1]["more"])

    def test_merges_are_left_out(self):
        self.commit("first", {"O9100.nc": LOOP, "O1": PART})
        git(self.folder, "checkout", "-qb", "side")
        self.commit("on the side", {"O1": PART.replace("X1.", "X2.")})
        git(self.folder, "checkout", "-q", "-")
        self.commit("here", {"O9100.nc": LOOP.replace("GOTO20", "GOTO99")})
        git(self.folder, "merge", "-q", "-m", "merged", "side")
        self.assertEqual(set(self.records()[0]), {"on the side", "here"})

    def test_a_comment_that_allows_repairs_nothing(self):
        self.commit("first", {"O9100.nc": LOOP})
        self.commit("allowed", {"O9100.nc": LOOP.replace("F100", "F100 (MACLINT ALLOW MAC501 - OURS)")})
        told, _ = self.records()
        self.assertEqual(self.rules(told["allowed"])["stayed"], ["MAC303:3", "MAC501:5"])
        self.assertTrue(told["allowed"]["stayed"][1]["allowed"])
        self.assertIn("(a comment allows it now)", " ".join(self.run_tool()[1].split()))

    def test_options_behind_two_dashes_go_to_maclint(self):
        self.commit("first", {"O9100.nc": LOOP})
        self.commit("repair", {"O9100.nc": LOOP.replace("GOTO20", "GOTO99")})
        self.assertEqual(self.rules(self.records("--", "--select", "MAC301")[0]["repair"]), {"went": [], "came": ["MAC301:3"], "stayed": []})
        configuration = self.beside / "own.json"
        configuration.write_text('{"ignore": ["MAC5"]}')
        named = os.path.relpath(configuration)
        self.assertEqual(self.rules(self.records("--", "--config", named)[0]["repair"])["stayed"], [])
        self.assertEqual(self.rules(self.records("--", f"--config={named}")[0]["repair"])["stayed"], [])

    def test_a_commit_that_maclint_cannot_read_is_named(self):
        self.commit("first", {"O9100.nc": LOOP, ".maclint.json": "{"})
        self.commit("repair", {"O9100.nc": LOOP.replace("GOTO20", "GOTO99")})
        status, text, _ = self.run_tool()
        self.assertEqual(status, 2)
        self.assertIn("not compared: maclint ended with status 2: ", " ".join(text.split()))
        self.assertEqual(self.run_tool("--", "--isolated")[0], 0)

    def test_what_fails_ends_with_status_2(self):
        self.assertEqual(self.run_tool()[0], 2, "there is no commit")
        shutil.rmtree(self.folder / ".git")
        status, _, errors = self.run_tool()
        self.assertEqual((status, errors), (2, f"repairs: '{self.folder}' holds no .git: name the folder of a repository that does\n"))


@unittest.skipUnless("MACLINT" in os.environ, "no executable is named")
class StrangerTest(RepositoryTest):
    """A repository whose settings, hooks and attributes all name a script: those with which maclint's own --since is tried."""

    def setUp(self):
        super().setUp()
        self.commit("first", {"O9100.nc": LOOP, ".gitattributes": "*.nc filter=x diff=x merge=x\n"})
        self.commit("repair", {"O9100.nc": LOOP.replace("GOTO20", "GOTO99")})
        self.mark, ran = self.beside / "mark", self.beside / "ran"
        ran.write_text(f'#!/bin/sh\necho "$0 $*" >> {self.mark}\n')
        ran.chmod(0o755)
        (self.beside / "all.attributes").write_text("*.nc filter=x diff=x merge=x\n")
        hooks = re.findall(r'"([a-z0-9-]+)"', HOSTILE[HOSTILE.index("hooks = "):HOSTILE.index("// clang-format on")])
        self.assertIn("post-checkout", hooks)
        (self.beside / "ran.hooks").mkdir()
        for place in (self.beside / "ran.hooks", self.folder / ".git/hooks"):
            for hook in hooks:
                shutil.copy(ran, place / hook)
        rows = re.findall(r'^    \{"([^"]+)", +"([^"]+)", +"[^"]+"\},', HOSTILE, re.M)
        settings = {key: value for key, value in rows if key != "core.worktree"}
        self.assertIn("core.fsmonitor", settings)
        names = {"$ran": str(ran), "$all": str(self.beside / "all"), "$mark": str(self.mark)}
        for key, value in settings.items():
            for name, meant in names.items():
                value = value.replace(name, meant)
            git(self.folder, "config", "--file", str(self.folder / ".git/config"), "--add", key, value)
        self.mark.unlink(missing_ok=True)

    def looked(self):
        return sorted((str(path), path.lstat().st_mtime_ns, path.lstat().st_size) for path in self.folder.rglob("*"))

    def test_runs_and_writes_nothing(self):
        before = self.looked()
        status, text, errors = self.run_tool()
        self.assertEqual((status, errors), (0, ""))
        self.assertIn("came   O9100.nc:3: error[MAC301]", text)
        self.assertFalse(self.mark.exists(), self.mark.exists() and self.mark.read_text())
        self.assertEqual(self.looked(), before)

    def test_has_what_another_git_runs(self):
        subprocess.run(["git", "log", "-p", "--ext-diff"], cwd=self.folder, capture_output=True, check=False)
        self.assertTrue(self.mark.exists(), "nothing of these settings would have been run anyway")

    def test_commands_in_the_environment_do_not_count(self):
        given = {"GIT_EXTERNAL_DIFF": "ran", "GIT_DIR": "/nowhere", "GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "core.fsmonitor",
                 "GIT_CONFIG_VALUE_0": str(self.beside / "ran"), "GIT_TRACE": str(self.mark), "GIT_EXEC_PATH": "/nowhere"}
        for key, value in given.items():
            os.environ[key] = value
            self.addCleanup(os.environ.pop, key)
        self.assertEqual(self.run_tool()[0], 0)
        self.assertFalse(self.mark.exists())

    def test_nothing_is_fetched(self):
        blob = git(self.folder, "rev-parse", "HEAD:O9100.nc")
        (self.folder / ".git/objects" / blob[:2] / blob[2:]).unlink()
        for key, value in (("core.repositoryFormatVersion", "1"), ("extensions.partialClone", "x"), ("remote.x.promisor", "true"),
                           ("remote.x.url", f"ext::{self.beside / 'ran'}")):
            git(self.folder, "config", "--file", str(self.folder / ".git/config"), key, value)
        self.mark.unlink(missing_ok=True)
        self.run_tool()
        self.assertFalse(self.mark.exists(), self.mark.exists() and self.mark.read_text())


if __name__ == "__main__":
    unittest.main()
