"""CONTRIBUTING.md names every question that a rule can ask, docs/architecture.md every room of them."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


QUERIES = ROOT / "analyzer/queries"


class QueriesTest(unittest.TestCase):
    def test_all_stand_in_the_table(self):
        rows = re.findall(r"^\| [^|]+ \| (`[^|]+`) \|$", (ROOT / "CONTRIBUTING.md").read_text(), re.M)
        named = [name for row in rows for name in re.findall(r"`([\w/]+\.hpp)`", row)]
        there = [path.relative_to(QUERIES).as_posix() for path in QUERIES.rglob("*.hpp")]
        self.assertEqual(sorted(named), sorted(there))

    def test_all_stand_in_a_room_that_the_architecture_names(self):
        text = (ROOT / "docs/architecture.md").read_text()
        named = re.findall(r"^\| `analyzer/queries/(\w+)/` \|", text, re.M)
        rooms = {path.parent.relative_to(QUERIES).as_posix() for path in QUERIES.rglob("*.?pp")}
        self.assertEqual(sorted(named), sorted(rooms))


if __name__ == "__main__":
    unittest.main()
