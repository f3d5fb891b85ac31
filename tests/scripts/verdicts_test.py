"""The tables of verdicts, what is made from them, and the tools that do it."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tests/tools"
sys.path.insert(0, str(TOOLS))
import verdicts  # noqa: E402

RULES = {"MAC301": verdicts.Record(pathlib.Path("a.cpp"), "error", "high"),
         "MAC604": verdicts.Record(pathlib.Path("b.cpp"), "note", "low")}


def tool(name):
    loader = importlib.machinery.SourceFileLoader(name, str(TOOLS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def row(author="anna", file="O1.nc", line="5", rule="MAC301", severity="error", verdict="true", count="1", build="-", why="N5 is gone"):
    return [author, file, line, rule, severity, verdict, count, build, why]


def count_of(number, verdict="true", author="several", **fields):
    return row(author, "-", "-", verdict=verdict, count=str(number), **fields)


class TablesTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def write(self, rows, counts="yes", folder="-"):
        for name, lines in (("sets", [verdicts.SET_COLUMNS, ["shop", counts, "9", folder, "Programs of a shop."]]),
                            ("shop", [verdicts.COLUMNS, *rows])):
            (self.folder / f"{name}.tsv").write_text("".join("\t".join(line) + "\n" for line in lines))

    def read(self, *rows, **fields):
        self.write(rows, **fields)
        return verdicts.read(self.folder, RULES)

    def measured(self, *rows, **fields):
        return verdicts.measured(self.read(*rows, **fields), RULES)

    def refused(self, *rows):
        with self.assertRaises(verdicts.BadTable) as caught:
            self.read(*rows)
        return str(caught.exception)


class ReadingTest(TablesTest):
    def test_takes_findings_and_counts(self):
        [programs] = self.read(row(), count_of(12, "noise", why="nobody would act"))
        self.assertEqual([(entry.place, entry.count) for entry in programs.rows], [(("O1.nc", 5, "MAC301"), 1), (("-", 0, "MAC301"), 12)])

    def test_names_the_row_that_is_none(self):
        for bad, reason in ((row(rule="MAC999"), "no rule 'MAC999'"), (row(severity="grave"), "no severity 'grave'"),
                            (row(verdict="maybe"), "no verdict 'maybe'"), (row(line="-"), "a finding has a file and a line"),
                            (row(line="five"), "'five' is no line"), (count_of(0), "'0' is no count"),
                            (row(count="2"), "a row with a file is one finding"), (row(verdict="false", why="-"), "needs a reason"),
                            (row()[:-1], "9 fields"), (row(why=""), "9 fields")):
            with self.subTest(bad=bad):
                message = self.refused(row(file="O0.nc"), bad)
                self.assertIn(reason, message)
                self.assertIn("shop.tsv:3", message)

    def test_takes_one_verdict_for_a_finding(self):
        self.assertIn("O1.nc:5 has two rows for MAC301", self.refused(row(), row(verdict="false")))

    def test_wants_a_row_for_each_table(self):
        self.write([row()])
        (self.folder / "lost.tsv").write_text("\t".join(verdicts.COLUMNS) + "\n")
        with self.assertRaisesRegex(verdicts.BadTable, "no row for lost"):
            verdicts.read(self.folder, RULES)

    def test_gives_back_what_it_wrote(self):
        sets = self.read(row(), count_of(3))
        before = (self.folder / "shop.tsv").read_text()
        verdicts.write_rows(sets[0], self.folder)
        self.assertEqual((self.folder / "shop.tsv").read_text(), before)


class PrecisionTest(TablesTest):
    def level(self, true, noise, author="several", **fields):
        rows = [count_of(true, author=author, **fields), count_of(noise, "noise", author=author, **fields)]
        return self.measured(*[entry for entry in rows if entry[6] != "0"])[fields.get("rule", "MAC301")].level

    def test_goes_by_the_share_of_the_decided(self):
        for true, noise, level in ((95, 5, "very-high"), (94, 6, "high"), (80, 20, "high"), (79, 21, "medium"), (50, 50, "medium"),
                                   (49, 51, "low"), (0, 5, "low")):
            self.assertEqual(self.level(true, noise), level, (true, noise))

    def test_leaves_the_unsure_out(self):
        measured = self.measured(count_of(5), count_of(50, "unsure", why="no manual says"))["MAC301"]
        self.assertEqual((measured.level, measured.basis.decided), ("very-high", 5))

    def test_wants_five_findings_of_two_authors(self):
        self.assertIsNone(self.level(4, 0))
        self.assertIsNone(self.level(9, 0, author="anna"))
        both = self.measured(count_of(4, author="anna"), count_of(1, author="bert"))
        self.assertEqual(both["MAC301"].level, "very-high")
        unsure = self.measured(count_of(5, author="anna"), count_of(1, "unsure", author="bert", why="no manual says"))
        self.assertIsNone(unsure["MAC301"].level)

    def test_rests_on_errors_and_warnings_or_of_a_note_on_notes(self):
        notes = self.measured(count_of(9, "noise", severity="note", why="meant"), count_of(5, severity="warning"))
        self.assertEqual(notes["MAC301"].level, "very-high")
        self.assertEqual(self.level(1, 9, rule="MAC604", severity="note"), "low")

    def test_passes_sets_that_do_not_count(self):
        self.assertEqual(self.measured(count_of(9), counts="no"), {})

    def test_names_what_is_too_low(self):
        def too_low(*rows):
            sets = self.read(*rows)
            written = tool("write_precision").page(sets, RULES)
            return written.partition("To be mended: ")[2].partition("\n")[0]

        noise = {"verdict": "noise", "why": "meant"}
        self.assertEqual(too_low(count_of(8), count_of(2, **noise)), "")
        self.assertEqual(too_low(count_of(7), count_of(2, **noise)), "errors of [MAC301](rules/MAC301.md) (77 %).")
        notes = [count_of(5, severity="note"), count_of(5, severity="note", **noise)]
        self.assertEqual(too_low(*notes), "")
        self.assertEqual(too_low(*notes, count_of(1, severity="note", **noise)), "notes of [MAC301](rules/MAC301.md) (45 %).")
        self.assertEqual(too_low(count_of(4, **noise)), "")

    def test_is_held_against_the_records(self):
        sets = self.read(count_of(9))
        self.assertEqual(tool("write_precision").wrong_records(sets, RULES),
                         ["a.cpp: MAC301 is measured very-high, its record says high"])


class WrittenTest(unittest.TestCase):
    def test_page_table_and_records_are_what_the_tables_say(self):
        done = subprocess.run([sys.executable, "-B", TOOLS / "write_precision", "--check"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_are_written_again_and_checked_without_writing(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        writer = tool("write_precision")
        page, table = writer.PAGE.read_text(), writer.TABLE.read_text()
        writer.PAGE, writer.TABLE = pathlib.Path(held.name) / "precision.md", pathlib.Path(held.name) / "measured.cpp"
        writer.PAGE.write_text("by hand\n")
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(writer.main(["--check"]), 1)
        self.assertEqual(said.getvalue().count("./dev docs writes it"), 2)
        self.assertEqual(writer.PAGE.read_text(), "by hand\n")
        self.assertFalse(writer.TABLE.exists())
        self.assertEqual((writer.main([]), writer.PAGE.read_text(), writer.TABLE.read_text()), (0, page, table))

    def test_records_are_those_of_the_registry(self):
        registry = (ROOT / "rules/registry.cpp").read_text()
        self.assertGreater(len(verdicts.records()), 100)
        for code in verdicts.records():
            self.assertIn(f"/* {code} */", registry)
        self.assertEqual(len(verdicts.records()), registry.count("    RULE("))


class ComparisonTest(TablesTest):
    def test_prints_what_is_gone_new_or_of_another_severity(self):
        [programs] = self.read(row(), row(file="O2.nc"), row(file="O3.nc"), count_of(3))
        lines, kept = tool("compare_verdicts").compare(
            programs, {("O1.nc", 5, "MAC301"): ("error", "a"), ("O2.nc", 5, "MAC301"): ("warning", "b"), ("O4.nc", 1, "MAC604"): ("note", "c")})
        self.assertEqual(lines, ["severity shop: O2.nc:5: MAC301 was error and is warning", "gone     shop: O3.nc:5: MAC301 (true: N5 is gone)",
                                 "new      shop: O4.nc:1: MAC604 note: c"])
        self.assertEqual([(entry.file, entry.severity) for entry in kept], [("O1.nc", "error"), ("O2.nc", "warning"), ("-", "error")])

    def test_reads_the_findings_of_a_build(self):
        maclint = self.folder / "maclint"
        report = {"findings": [{"file": "./O1.nc", "range": {"start": {"line": 5}}, "code": "MAC301", "severity": "error", "message": "a"}]}
        maclint.write_text(f"#!/bin/sh\ncat <<'END'\n{json.dumps(report)}\nEND\nexit 1\n")
        maclint.chmod(0o755)
        self.assertEqual(tool("compare_verdicts").findings_of(str(maclint), self.folder), {("O1.nc", 5, "MAC301"): ("error", "a")})


if __name__ == "__main__":
    unittest.main()
