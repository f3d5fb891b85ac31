"""Reports in JSON are what docs/report.schema.json says, and have nothing that it does not name."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

try:
    import jsonschema
except ImportError:  # python3-jsonschema is not installed everywhere
    jsonschema = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = json.loads((ROOT / "docs/report.schema.json").read_text(encoding="utf-8"))
# A finding that counts, one that a comment allows and one that an exemption holds back, with a path and with fixes.
PROGRAM = ("%\nO9100\n#1=0.1\nIF[#1EQ0.3]GOTO5\nGOTO 99\nGOTO 98(MACLINT ALLOW MAC301 - LATER)\nN5 G91 G0 X1.\nG1 X#2\n"
           "(MACLINT ALLOW MAC303 - GONE)\nM99\n%\n")


class ReportSchemaTest(unittest.TestCase):
    def setUp(self):
        self.program = os.environ.get("MACLINT")
        if not self.program or jsonschema is None:
            self.skipTest("there is no jsonschema, or MACLINT does not name an executable")
        self.validator = jsonschema.Draft7Validator(SCHEMA)

    def report(self, *options, folder):
        done = subprocess.run([self.program, "check", "--format", "json", *options], cwd=folder, capture_output=True, check=False)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads(done.stdout)

    def expect_valid(self, report):
        wrong = [f"{'/'.join(map(str, error.absolute_path))}: {error.message}" for error in self.validator.iter_errors(report)]
        self.assertEqual(wrong[:5], [])

    def test_the_schema_is_one(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)

    def test_reports_of_the_corpus_are_valid(self):
        report = self.report("--select", "ALL", "--show-withheld", "--statistics", "corpus", folder=ROOT)
        self.assertGreater(len(report["findings"]), 100)
        self.expect_valid(report)

    def test_reports_with_all_kinds_of_findings_are_valid(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "O9100.nc").write_text(PROGRAM)
            subprocess.run([self.program, "--quiet", "--write-baseline", "known.json", "--select", "MAC301", "."], cwd=path,
                           capture_output=True, check=False)
            report = self.report("--baseline", "known.json", folder=path)
            self.assertTrue(report["known"] and report["suppressed"] and report["findings"])
            self.assertTrue(any(finding["fix"] for finding in report["findings"]))
            self.assertTrue(any("alarm" in finding for finding in report["known"]))
            self.expect_valid(report)

    def test_a_key_that_nobody_described_is_seen(self):
        report = self.report("--no-timestamps", "corpus", folder=ROOT)
        report["findings"][0]["colour"] = "red"
        self.assertFalse(self.validator.is_valid(report))


if __name__ == "__main__":
    unittest.main()
