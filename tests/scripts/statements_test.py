"""What the manual of DIN PLUS demands (docs/dinplus.tsv): its page, and the programs of each statement, which are linted."""
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tests/tools"
sys.path.insert(0, str(TOOLS))
import statements  # noqa: E402

ROW = ["DP001", "Loops", "A loop ends.", "MAC319", "-", "19801"]
PAIR = statements.Pair("WHILE 1==1\n", "WHILE #l1<5\n")


def findings_of(folder, *options):
    """By the names of the programs below a folder: what is reported of each, rows with their rule."""
    done = subprocess.run([os.environ["MACLINT"], "check", "--isolated", "--dialect", "dinplus", "--format", "json",
                           "--max-findings", "all", *options, folder], capture_output=True, text=True)
    report = json.loads(done.stdout)
    found = collections.defaultdict(set)
    for finding in report["findings"]:
        name = finding["code"] + (f"/{finding['row']}" if finding.get("row") else "")
        found[pathlib.Path(finding["file"]).stem].add(name)
    return report["summary"]["files"], found


class ProgramsTest(unittest.TestCase):
    def test_are_reported_by_what_the_table_says_and_by_nothing_where_it_says_so(self):
        if not os.environ.get("MACLINT"):
            self.skipTest("MACLINT does not name an executable")
        pairs = statements.read_programs()
        with tempfile.TemporaryDirectory() as held:
            folder = pathlib.Path(held)
            statements.write_programs(pairs, folder)
            read, bad = findings_of(folder / "bad")
            also_read, good = findings_of(folder / "good", "--select", "ALL")
        self.assertEqual((read, also_read), (len(pairs), len(pairs)))
        self.assertEqual(statements.problems(statements.read(), pairs, bad, good), [])


class TableTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        (self.folder / "MAC319.md").write_text("# MAC319\n\nOn by default. Also known as DIN406, DIN405.\n")
        (self.folder / "MAC576.md").write_text("# MAC576\n\n| G4.P | is no row |\n\n## Rows\n\n| G4.F | at most 999 |\n")

    def read(self, *rows):
        path = self.folder / "table.tsv"
        path.write_text("".join("\t".join(fields) + "\n" for fields in (statements.COLUMNS, *rows)))
        return statements.read(path, self.folder)

    def test_is_read(self):
        [first, second] = self.read(ROW, ["DP002", "Loops", "G4 waits.", "MAC576/G4.F MAC319", "-", "7, 9-12"])
        self.assertEqual((first.id, first.watched, first.is_watched), ("DP001", ["MAC319"], True))
        self.assertEqual(second.watched, ["MAC576/G4.F", "MAC319"])
        self.assertFalse(self.read(ROW[:3] + ["missing", "-", "-"])[0].is_watched)

    def test_names_the_row_that_is_none(self):
        for fields, reason in (({0: "DP1"}, "'DP1' is no new DPnnn"), ({0: "DP000"}, "'DP000' is no new DPnnn"),
                               ({3: "MAC999"}, "there is no rule 'MAC999'"), ({3: "missed"}, "there is no rule 'missed'"),
                               ({3: "DIN405"}, "there is no rule 'DIN405', it is a part of MAC319"),
                               ({3: "MAC319 MAC576/G4.P"}, "MAC576 has no row 'G4.P'"),
                               ({4: "a row (MAC576/G4.P), too"}, "MAC576 has no row 'G4.P'"), ({3: "not"}, "has a reason"),
                               ({2: "a" * 251}, "250 characters"), ({5: "l.7"}, "'l.7' are no lines"), ({4: ""}, "6 fields")):
            with self.subTest(reason), self.assertRaisesRegex(statements.BadTable, f"table.tsv:3: .*{reason}"):
                self.read(["DP000", *ROW[1:]], [fields.get(place, field) for place, field in enumerate(ROW)])

    def test_keeps_a_chapter_together(self):
        with self.assertRaisesRegex(statements.BadTable, "rows of 'Loops' stand together"):
            self.read(ROW, ["DP002", "Calls", *ROW[2:]], ["DP003", *ROW[1:]])

    def test_the_page_is_what_the_table_says(self):
        done = subprocess.run([sys.executable, "-B", TOOLS / "write_dinplus", "--check"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class PairsTest(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as held:
            (pathlib.Path(held) / "loops.diff").write_text(text)
            return statements.read_programs(pathlib.Path(held))

    def test_are_told_apart_by_how_their_lines_begin(self):
        self.assertEqual(self.read("== DP001\n MACHINING\n-N1 M3\n+N1 M4\n END\n== DP002\n-[ ]\n"),
                         {"DP001": statements.Pair("MACHINING\nN1 M3\nEND\n", "MACHINING\nN1 M4\nEND\n"),
                          "DP002": statements.Pair("[ ]\n", "")})

    def test_are_one_a_statement_and_hold_nothing_else(self):
        for text in ("== DP001\n== DP001\n", " N1 M3\n", "== DP001\nN1 M3\n", "== DP001\n\n"):
            with self.subTest(text), self.assertRaises(statements.BadTable):
                self.read(text)


class ProblemsTest(unittest.TestCase):
    def problems(self, watched, bad=(), good=(), pairs=None):
        statement = statements.Statement("DP001", "Loops", "A loop ends.", watched.split(), "-", "-")
        return statements.problems([statement], {"DP001": PAIR} if pairs is None else pairs, {"DP001": set(bad)}, {"DP001": set(good)})

    def test_are_none_where_rule_or_row_reports_the_bad_program_alone(self):
        self.assertEqual(self.problems("MAC319", ["MAC319", "MAC718"]), [])
        self.assertEqual(self.problems("MAC576", ["MAC576/G4.F"]), [])
        self.assertEqual(self.problems("MAC576/G4.F", ["MAC576/G4.F"]), [])
        self.assertEqual(self.problems("missing"), [])
        self.assertEqual(self.problems("not", pairs={}), [])

    def test_name_what_does_not_report(self):
        self.assertEqual(self.problems("MAC319"), ["DP001: MAC319 does not report its bad program, but nothing does"])
        self.assertEqual(self.problems("MAC576/G4.F MAC319", ["MAC576/G4.P", "MAC319"]),
                         ["DP001: MAC576/G4.F does not report its bad program, but MAC319 MAC576/G4.P does"])

    def test_say_what_to_write_where_something_reports_by_now(self):
        for watched in ("missing", "not"):
            self.assertEqual(self.problems(watched, ["MAC576/G4.F"]),
                             ["DP001: MAC576/G4.F reports its bad program: write that in place of "
                              f"'{watched}' in dinplus.tsv, then ./dev docs"])

    def test_name_what_reports_the_good_program(self):
        self.assertEqual(self.problems("missing", good=["MAC319"]), ["DP001: MAC319 reports its good program"])

    def test_want_programs_for_what_can_be_checked_and_a_row_for_programs(self):
        self.assertEqual(self.problems("missing", pairs={}), ["DP001: it wants a bad and a good program in statements/"])
        self.assertEqual(self.problems("missing", pairs={"DP001": PAIR, "DP009": PAIR}),
                         ["DP009: its programs have no row in dinplus.tsv"])


if __name__ == "__main__":
    unittest.main()
