"""The tool that switches exemptions off: which it takes, and what it counts."""
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "tests/tools"
sys.path.insert(0, str(TOOLS))

loader = importlib.machinery.SourceFileLoader("ablate", str(TOOLS / "ablate"))
ablate = importlib.util.module_from_spec(importlib.util.spec_from_loader("ablate", loader))
loader.exec_module(ablate)

NAMES = ["MAC209/handed-on", "MAC209/speed", "MAC718/last-case"]
WAITING = "O9319(WAIT)\nN1 IF[#890EQ1]GOTO2\nG4 P500\nGOTO1\nN2 M99\n"


class ChosenTest(unittest.TestCase):
    def test_are_all_or_those_of_rules_or_single_ones_in_any_case(self):
        self.assertEqual(ablate.chosen_from(NAMES, []), NAMES)
        self.assertEqual(ablate.chosen_from(NAMES, ["mac209", "MAC209/speed"]), NAMES[:2])
        self.assertEqual(ablate.chosen_from(NAMES, ["MAC718/LAST-CASE"]), NAMES[2:])
        with self.assertRaisesRegex(ValueError, "no exemption 'MAC7'"):
            ablate.chosen_from(NAMES, ["MAC7"])


class ChangesTest(unittest.TestCase):
    before = {("a.nc", 3, "MAC209"): "warning: x", ("a.nc", 5, "MAC209"): "warning: y"}
    after = {("a.nc", 3, "MAC209"): "warning: z", ("b.nc", 1, "MAC209"): "note: w"}

    def test_are_what_comes_and_what_goes_with_its_verdict(self):
        judged = {("a.nc", 5, "MAC209"): "true"}
        self.assertEqual(ablate.changes(self.before, self.after, judged, pathlib.Path("x/macro")),
                         [("+", "no verdict", "macro/b.nc:1: MAC209 note: w"),
                          ("-", "true", "macro/a.nc:5: MAC209 warning: y")])

    def test_are_counted_by_their_verdicts(self):
        row = ablate.row_of("MAC209/speed", [("+", "no verdict", ""), ("+", "false", ""), ("-", "true", "")])
        self.assertRegex(row, r"^MAC209/speed +2 come \(1 false, 1 no verdict\) +1 go \(1 true\)$")


@unittest.skipUnless("MACLINT" in os.environ, "no executable is named")
class ToolTest(unittest.TestCase):
    def printed(self, *words):
        sys.argv = ["ablate", os.environ["MACLINT"], "--programs", "/nowhere", *words]
        with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()):
            status = ablate.main()
        return status, out.getvalue()

    def test_shows_what_one_exemption_holds_back(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "O9319.nc").write_text(WAITING)
            status, text = self.printed("--findings", "--also", folder, "MAC319/waits-for-others")
        self.assertRegex(text, r"MAC319/waits-for-others +\d+ come")
        self.assertIn("O9319.nc:4: MAC319 error: Endless loop", text)
        self.assertEqual(status, 0)

    def test_refuses_a_word_that_names_none(self):
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as refused:
            self.printed("MAC319/waits")
        self.assertEqual(refused.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
