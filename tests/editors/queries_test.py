"""The queries of the grammars: each names nodes and fields that its grammar has, and tree-sitter takes them."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
GRAMMARS = sorted(path.parent for path in ROOT.glob("grammar/*/grammar.js"))
KINDS = {"highlights", "folds", "indents", "injections", "locals", "tags"}
TOKEN = re.compile(r'\s+|;[^\n]*|("(?:\\.|[^"\\])*"|[()\[\]]|@[\w.-]+|#[\w-]+[?!]|![a-z_]+|\w+:|[\w.-]+|[*+?])')

FANUC = "%\nO9100(HOLES)\n(X FIRST)\n#3=0\nN10IF[#1EQ0]M98P7\nG65P9200X#3\nG4P5\nWHILE[#3LT5]DO1\nEND1\nM99\n%\n"
DINPLUS = ('%shaft.nc\nPROGRAM HEAD\n#UNIT METRIC\nMACHINING\n[TWO\nLINES]\nN10 L"CHAMFER" LA40\nN15 #l1=2\nSUBPROGRAM "CHAMFER"\n'
           "N1 G1 X#__la\nRETURN\nEND\n")
SINUMERIK = ("%_N_COVER_MPF\n;FIRST\n;SIDE\nDEF INT ROWS=3\nDEFINE AXES AS X5\nN10 G0 X5\nFOR R1=1 TO ROWS\nDRILL_ROW(R1)\nENDFOR\nL20 P2\nDONE_:\nM30\n"
             "%_N_DRILL_ROW_SPF\nPROC DRILL_ROW(INT ROW) SAVE\nM17\n")
PROGRAMS = {"fanuc": FANUC, "dinplus": DINPLUS, "sinumerik": SINUMERIK}


class NodeTypes:
    """What node-types.json says: nodes, and which fields a node may have."""

    def __init__(self, rows):
        self.named = {row["type"]: set(row.get("fields", {})) for row in rows if row["named"]}
        self.anonymous = {row["type"] for row in rows if not row["named"]}
        self.fields = set().union(*self.named.values())


def wrong_names(query, types):
    """Names in a query that its grammar has not, and fields that a node cannot have."""
    wrong, open_nodes, expects_type, at = [], [], False, 0
    while at < len(query):
        match = TOKEN.match(query, at)
        if match is None:
            return [*wrong, f"unreadable: {query[at:at + 20]!r}"]
        at, token = match.end(), match.group(1)
        if token is None:
            continue
        if token in "([":
            open_nodes.append(None)
            expects_type = token == "("
            continue
        if token in ")]":
            if not open_nodes:
                return [*wrong, "a bracket closes nothing"]
            open_nodes.pop()
        elif token[0] == '"':
            # Strings of predicates are no nodes.
            if open_nodes[-1:] != ["#"] and json.loads(token) not in types.anonymous:
                wrong.append(token)
        elif token[0] == "#":
            open_nodes[-1] = "#"
        elif token[-1] == ":" or token[0] == "!":
            field, parent = token.strip("!:"), next((each for each in reversed(open_nodes) if each not in (None, "#")), None)
            if field not in (types.named.get(parent, types.fields) if parent else types.fields):
                wrong.append(f"{parent} {token}")
        elif token[0] not in "@*+?" and expects_type:
            open_nodes[-1] = token
            if token not in types.named and token not in ("_", "ERROR", "MISSING"):
                wrong.append(token)
        expects_type = False
    return wrong if not open_nodes else [*wrong, "a bracket is open"]


class NamesTest(unittest.TestCase):
    def test_are_those_of_the_grammar(self):
        for grammar in GRAMMARS:
            types = NodeTypes(json.loads((grammar / "src/node-types.json").read_text(encoding="utf-8")))
            queries = {path.stem: path for path in grammar.glob("queries/*.scm")}
            self.assertEqual(set(queries), KINDS, grammar.name)
            for path in queries.values():
                with self.subTest(f"{grammar.name}/{path.name}"):
                    self.assertEqual(wrong_names(path.read_text(encoding="utf-8"), types), [])

    def test_that_are_none_are_found(self):
        types = NodeTypes([{"type": "block", "named": True, "fields": {"name": {}}}, {"type": "word", "named": True}, {"type": "IF", "named": False}])
        good = '; (x)\n((block name: (word) @a . (_)? "IF") @b (#match? @b "^x:") (#eq? @a "y"))\n[(word) "IF"]+ @c\n(block !name)'
        self.assertEqual(wrong_names(good, types), [])
        for query, wrong in (("(blocks)", ["blocks"]), ('"THEN" @k', ['"THEN"']), ("(block nam: (word))", ["block nam:"]), ("(word name: (_))", ["word name:"]),
                             ("(word !name)", ["word !name"]), ("[(wrd) (word)]", ["wrd"]), ("(block", ["a bracket is open"]), ("(word))", ["a bracket closes nothing"]),
                             ("(word) = (word)", ["unreadable: '= (word)'"])):
            self.assertEqual(wrong_names(query, types), wrong, query)

    def test_each_language_is_told_of_its_queries(self):
        for grammar in GRAMMARS:
            told = json.loads((grammar / "tree-sitter.json").read_text(encoding="utf-8"))["grammars"][0]
            for kind in KINDS - {"folds", "indents"}:
                self.assertEqual(told[kind], f"queries/{kind}.scm")


def tree_sitter():
    done = subprocess.run(["tree-sitter", "--version"], capture_output=True, text=True, check=False) if shutil.which("tree-sitter") else None
    return done is not None and done.stdout.startswith("tree-sitter 0.25.10")


@unittest.skipUnless(tree_sitter(), "tree-sitter 0.25.10 is not installed (cargo install tree-sitter-cli --version 0.25.10 --locked)")
class TreeSitterTest(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)

    def printed(self, grammar, *words):
        """In a folder with a program; that language alone is known, for two take .nc."""
        name = grammar.name
        program = "x.mpf" if name == "sinumerik" else "x.nc"
        (self.folder / program).write_text(PROGRAMS[name])
        parsers = self.folder / name
        if not parsers.exists():
            parsers.mkdir()
            (parsers / f"tree-sitter-{name}").symlink_to(grammar)
            (self.folder / f"{name}.json").write_text(json.dumps({"parser-directories": [str(parsers)], "theme": {"keyword": 5, "label": 3, "error": 1}}))
        done = subprocess.run(["tree-sitter", words[0], "--config-path", str(self.folder / f"{name}.json"), *words[1:], program], cwd=self.folder,
                              capture_output=True, text=True, env=os.environ | {"XDG_CACHE_HOME": str(self.folder / "cache")}, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_takes_the_queries(self):
        every = {"folds": "fold", "indents": "indent.zero", "injections": "injection.content", "locals": "local.definition"}
        captured = {"fanuc": every | {"highlights": "keyword.repeat", "tags": "reference.call"},
                    "dinplus": every | {"highlights": "keyword.directive", "tags": "definition.function"},
                    "sinumerik": every | {"highlights": "keyword.repeat", "tags": "reference.call"}}
        for grammar in GRAMMARS:
            for kind in KINDS:
                with self.subTest(f"{grammar.name}/{kind}"):
                    printed = self.printed(grammar, "query", str(grammar / f"queries/{kind}.scm"))
                    # A capture of several lines is printed without its number and its text.
                    self.assertRegex(printed, rf"(- |capture: ){captured[grammar.name][kind]}, ")

    def test_colours_programs(self):
        told = {each.name: self.printed(each, "highlight", "--check") for each in GRAMMARS}
        self.assertIn("\x1b[38;5;05mWHILE\x1b[0m", told["fanuc"])
        self.assertIn("\x1b[38;5;03mN10\x1b[0m", told["fanuc"])
        self.assertIn("\x1b[38;5;05mMACHINING\x1b[0m", told["dinplus"])
        self.assertIn("\x1b[38;5;05mENDFOR\x1b[0m", told["sinumerik"])
        self.assertIn("\x1b[38;5;03mDONE_:\x1b[0m", told["sinumerik"])

    def test_lists_programs_and_calls(self):
        rows = {each.name: re.findall(r"^(.+?)\s+\| (\w+)\s+(def|ref) \((\d+)", self.printed(each, "tags"), re.M) for each in GRAMMARS}
        self.assertEqual(rows["fanuc"], [("O9100", "function", "def", "1"), ("P7", "call", "ref", "4"), ("P9200", "call", "ref", "5")])
        self.assertEqual([row for row in rows["dinplus"] if row[1] != "section"],
                         [("shaft.nc", "module", "def", "0"), ('"CHAMFER"', "call", "ref", "6"), ('"CHAMFER"', "function", "def", "8")])
        self.assertEqual([row[0] for row in rows["dinplus"] if row[1] == "section"], ["PROGRAM HEAD", "MACHINING", "SUBPROGRAM", "END"])
        self.assertEqual(rows["sinumerik"], [("AXES", "macro", "def", "4"), ("DRILL_ROW", "call", "ref", "7"), ("L20", "call", "ref", "9"), ("DONE_:", "label", "def", "10"),
                                             ("DRILL_ROW", "function", "def", "13")])


if __name__ == "__main__":
    unittest.main()
