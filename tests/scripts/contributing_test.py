"""CONTRIBUTING.md names every question that a rule can ask."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class QueriesTest(unittest.TestCase):
    def test_all_stand_in_the_table(self):
        rows = re.findall(r"^\| [^|]+ \| (`[^|]+`) \|$", (ROOT / "CONTRIBUTING.md").read_text(), re.M)
        named = [name for row in rows for name in re.findall(r"`(\w+\.hpp)`", row)]
        self.assertEqual(sorted(named), sorted(path.name for path in (ROOT / "analyzer/queries").glob("*.hpp")))


if __name__ == "__main__":
    unittest.main()
