"""CONTRIBUTING.md is short and leads to the pages behind it; docs/queries.md names every question that a rule can ask,
docs/architecture.md every room of them."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
QUERIES = ROOT / "analyzer/queries"


class ContributingTest(unittest.TestCase):
    TEXT = (ROOT / "CONTRIBUTING.md").read_text()

    def test_has_two_pages(self):
        self.assertLessEqual(len(self.TEXT.splitlines()), 110)

    def test_leads_to_pages_that_are_there(self):
        links = re.findall(r"\]\(([^)#]+)", self.TEXT)
        self.assertGreater(len(links), 5)
        for link in links:
            self.assertTrue((ROOT / link).is_file(), link)


class QueriesTest(unittest.TestCase):
    def test_all_stand_in_the_table(self):
        section = re.search(r"^## The queries\n(.*?)^## ", (ROOT / "docs/queries.md").read_text(), re.M | re.S).group(1)
        rows = re.findall(r"^\| [^|]+ \| (`[^|]+`) \|$", section, re.M)
        named = [name for row in rows for name in re.findall(r"`([\w/]+\.hpp)`", row)]
        there = [path.relative_to(QUERIES).as_posix() for path in QUERIES.rglob("*.hpp")]
        self.assertEqual(sorted(named), sorted(there))

    def test_all_stand_in_a_room_that_the_architecture_names(self):
        text = (ROOT / "docs/architecture.md").read_text()
        named = re.findall(r"^\| `analyzer/queries/(\w+)/` \|", text, re.M)
        rooms = {path.parent.relative_to(QUERIES).as_posix() for path in QUERIES.rglob("*.?pp")}
        self.assertEqual(sorted(named), sorted(rooms))

    def test_cells_of_the_architecture_are_short(self):
        rows = [line for line in (ROOT / "docs/architecture.md").read_text().splitlines() if line.startswith("|")]
        self.assertGreater(len(rows), 40)
        for row in rows:
            self.assertLess(max(map(len, row.split("|"))), 200, row)


if __name__ == "__main__":
    unittest.main()
