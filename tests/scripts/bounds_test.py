"""docs/bounds.md names every bound on work with its number, and what happens beyond."""
import collections
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = [f"analyzer/{name}" for name in ("flow", "dataflow", "machine", "workspace", "queries", "execution", "program", "syntax",
                                           "source")] + ["rules"]
DECLARATION = re.compile(r"\bconstexpr\s+[\w:<>\s]+?\s(\w+\s*=(?!=)[^;]*);")
NAMED_LIKE_A_BOUND = re.compile(r"(most|longest|largest)(_\w+)?|(visits_before|work)_\w+")
NO_BOUNDS = "Numbers that are no bounds"
ROW = re.compile(r"\| `(\w+)` \(([\w./]+)\) \|" + r" ([^|]+) \|" * 4)
WIDEST = 160  # characters of a cell


def plain(number):
    """20'000 and 20,000 as 20000."""
    return re.sub(r"(?<=\d)[',](?=\d)", "", number.strip())


def constants_in(text):
    """Pairs of name and number."""
    for declared in DECLARATION.findall(text):
        for part in re.split(r",\s*(?=\w+\s*=)", declared):
            name, number = part.split("=", 1)
            yield name.strip(), plain(number)


def constants():
    """The numbers of each constant of the folders, by (file, name): some files use a name twice."""
    found = collections.defaultdict(set)
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.?pp")):
            for name, number in constants_in(path.read_text(encoding="utf-8")):
                found[path.relative_to(ROOT).as_posix(), name].add(number)
    return found


def sections_of(page):
    """Pairs of heading and text."""
    parts = re.split(r"^## (.*)\n", page, flags=re.M)
    return list(zip(parts[1::2], parts[2::2]))


def problems(page, there, rules):
    """What is wrong with the page, for constants as `constants` gives them and the codes of rules."""
    wrong, named = [], []
    for heading, text in sections_of(page):
        if heading == NO_BOUNDS:
            named += [(file, name) for name, file in re.findall(r"`(\w+)` \(([\w./]+)\)", text)]
            continue
        for line in text.splitlines():
            if not line.startswith("| `"):
                continue
            row = ROW.fullmatch(line)
            if row is None:
                wrong.append(f"is no row: {line}")
                continue
            key = (heading.strip("`") + row[2], row[1])
            named.append(key)
            numbers = {plain(number) for number in row[3].split(" and ")}
            if key in there and numbers != there[key]:
                wrong.append(f"{key[0]}: {row[1]} is {' and '.join(sorted(there[key]))}, the page says {row[3]}")
            wrong += [f"{key[0]}: {row[1]} has a cell of {len(cell)} characters" for cell in row.groups() if len(cell) >= WIDEST]
            wrong += [f"{key[0]}: {row[1]} names {code}, which is no rule" for code in re.findall(r"\b(?:MAC|DIN)\d+", line)
                      if code not in rules]
    wrong += [f"{file}: {name} is gone" for file, name in named if (file, name) not in there]
    wrong += [f"{file}: {name} is named {count} times" for (file, name), count in collections.Counter(named).items() if count > 1]
    wrong += [f"{file}: {name} is neither in a table nor among the {NO_BOUNDS.lower()}" for file, name in there
              if NAMED_LIKE_A_BOUND.fullmatch(name) and (file, name) not in named]
    return wrong


class PageTest(unittest.TestCase):
    def test_names_every_bound_with_its_number(self):
        there = constants()
        self.assertGreater(sum(NAMED_LIKE_A_BOUND.fullmatch(name) is not None for _, name in there), 100)
        rules = set(re.findall(r"/\* (\w+) \*/", (ROOT / "rules/registry.cpp").read_text(encoding="utf-8")))
        self.assertEqual(problems((ROOT / "docs/bounds.md").read_text(encoding="utf-8"), there, rules), [])


class ConstantsTest(unittest.TestCase):
    def test_are_read_one_by_one(self):
        text = """
            constexpr std::size_t most_nodes = 20'000; ///< of a program
            static constexpr int most_a = 64, most_b = 8;
            inline constexpr std::uintmax_t largest = std::numeric_limits<Offset>::max() - 1;
            constexpr bool operator==(Id a, Id b) { constexpr double most = 1e9; return a < most; }
            constexpr std::size_t work_for(const File&) { return most_work; }"""
        self.assertEqual(list(constants_in(text)),
                         [("most_nodes", "20000"), ("most_a", "64"), ("most_b", "8"),
                          ("largest", "std::numeric_limits<Offset>::max() - 1"), ("most", "1e9")])


class ProblemsTest(unittest.TestCase):
    THERE = {("analyzer/flow/graph.cpp", "most_nodes"): {"20000"}, ("rules/path.cpp", "most_steps"): {"12"},
             ("rules/path.cpp", "few"): {"3"}}
    PAGE = f"""# Bounds
## `analyzer/flow/`
| constant | number | what it counts | when there are more | rules |
|---|---|---|---|---|
| `most_nodes` (graph.cpp) | 20,000 | nodes | nothing is known | MAC301 |
## {NO_BOUNDS}
- Widths: `most_steps` (rules/path.cpp).
"""

    def problems(self, old="", new="", there=None):
        self.assertIn(old, self.PAGE)
        return problems(self.PAGE.replace(old, new) if old else self.PAGE, there or self.THERE, {"MAC301"})

    def test_are_none_where_all_is_named(self):
        self.assertEqual(self.problems(), [])

    def test_are_a_number_that_differs(self):
        self.assertEqual(self.problems("20,000", "2,000"), ["analyzer/flow/graph.cpp: most_nodes is 20000, the page says 2,000"])

    def test_are_a_bound_that_is_not_named(self):
        [row] = [line for line in self.PAGE.splitlines() if line.startswith("| `")]
        for old, name in ((row, "flow/graph.cpp: most_nodes"), ("`most_steps` (rules/path.cpp)", "rules/path.cpp: most_steps")):
            [problem] = self.problems(old)
            self.assertIn(f"{name} is neither in a table nor", problem)

    def test_are_a_bound_that_is_gone(self):
        self.assertEqual(self.problems("(graph.cpp)", "(walk.hpp)")[0], "analyzer/flow/walk.hpp: most_nodes is gone")
        self.assertEqual(self.problems(there={key: self.THERE[key] for key in list(self.THERE)[:1]}),
                         ["rules/path.cpp: most_steps is gone"])

    def test_are_a_bound_that_is_named_twice(self):
        self.assertEqual(self.problems("- Widths:", "- `most_steps` (rules/path.cpp),"), ["rules/path.cpp: most_steps is named 2 times"])

    def test_are_rows_that_cannot_be_read(self):
        self.assertIn("is no row: ", self.problems(" | MAC301 |", " |")[0])
        self.assertEqual(self.problems("MAC301", "MAC999"), ["analyzer/flow/graph.cpp: most_nodes names MAC999, which is no rule"])
        self.assertEqual(self.problems("nodes |", "n" * WIDEST + " |"), ["analyzer/flow/graph.cpp: most_nodes has a cell of 160 characters"])


if __name__ == "__main__":
    unittest.main()
