"""What the manual of DIN PLUS demands: the table docs/dinplus.tsv, and the two programs of each statement."""
import dataclasses
import pathlib
import re

from verdicts import NONE, ROOT, BadTable, lines_of

TABLE = ROOT / "docs/dinplus.tsv"
PROGRAMS = ROOT / "tests/fixtures/dinplus/statements"
RULES = ROOT / "docs/rules"
COLUMNS = ["id", "chapter", "statement", "watched", "note", "lines"]
MISSING, NOT = "missing", "not"  # instead of rules: nothing reports it yet, and nothing is to report it
CODE = re.compile(r"\b(?:MAC|DIN|SIN)\d{3}(?:/[^\s,;)]+)?")
LONGEST = 250  # characters of a field: a cell of the page is to be read at a glance


@dataclasses.dataclass
class Statement:
    id: str
    chapter: str
    text: str
    watched: list  # codes, with the row where it is one of a table; or MISSING, or NOT, alone
    note: str  # of NOT the reason, else what else is known of the check
    lines: str  # of the manual

    @property
    def is_watched(self):
        return self.watched[0] not in (MISSING, NOT)


@dataclasses.dataclass
class Pair:
    """A program that breaks a statement, and one that differs from it in as little as possible and does not."""
    bad: str
    good: str


def problem_of(name, rules=RULES):
    """What is wrong with a code, or with a code and a row; None if there is such a rule, and it has such a row."""
    code, _, row = name.partition("/")
    page = rules / f"{code}.md"
    if not page.is_file():
        now = [other.stem for other in sorted(rules.glob("*.md"))
               if re.search(rf"Also known as [^.]*\b{re.escape(code)}\b", other.read_text(encoding="utf-8"))]
        return f"there is no rule '{code}'" + (f", it is a part of {now[0]}" if now else "")
    rows = page.read_text(encoding="utf-8").partition("\n## Rows\n")[2]
    if row and not re.search(rf"^\| {re.escape(row)} \|", rows, re.M):
        return f"{code} has no row '{row}'"
    return None


def read(table=TABLE, rules=RULES):
    """The statements in the order of the table; BadTable names the first row that is none."""
    found, chapters = {}, []
    for where, (name, chapter, text, watched, note, lines) in lines_of(table, COLUMNS):
        statement = Statement(name, chapter, text, watched.split(" "), note, lines)
        if not re.fullmatch(r"DP\d{3}", name) or name in found:
            raise BadTable(f"{where}: '{name}' is no new DPnnn")
        if chapter in chapters[:-1]:
            raise BadTable(f"{where}: the rows of '{chapter}' stand together")
        if lines != NONE and not re.fullmatch(r"\d+(-\d+)?(, \d+(-\d+)?)*", lines):
            raise BadTable(f"{where}: '{lines}' are no lines of the manual")
        if max(map(len, (text, note))) > LONGEST:
            raise BadTable(f"{where}: a text has {LONGEST} characters at most")
        if watched == NOT and note == NONE:
            raise BadTable(f"{where}: what is not checked has a reason")
        for code in [*(statement.watched if statement.is_watched else ()), *CODE.findall(note)]:
            if problem := problem_of(code, rules):
                raise BadTable(f"{where}: {problem}")
        chapters += [chapter] if chapter not in chapters else []
        found[name] = statement
    return list(found.values())


def pair_of(lines):
    """Lines begin as in a diff: '-' stands in the bad program only, '+' in the good one only, a blank in both."""
    return Pair(*("".join(f"{line[1:]}\n" for line in lines if line[0] in signs) for signs in (" -", " +")))


def read_programs(folder=PROGRAMS):
    """The pairs by the ids of their statements; '== DP009' begins each."""
    found = {}
    for path in sorted(folder.glob("*.diff")):
        pairs = {}
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if line.startswith("== "):
                name = line[3:]
                if name in found or name in pairs:
                    raise BadTable(f"{path}:{number}: {name} has two pairs of programs")
                pairs[name] = []
            elif line[:1] in (" ", "-", "+") and pairs:
                pairs[name].append(line)
            else:
                raise BadTable(f"{path}:{number}: a line begins with '== ', ' ', '-' or '+'")
        found |= {name: pair_of(lines) for name, lines in pairs.items()}
    return found


def write_programs(pairs, folder):
    """Into bad/DP009.nc and good/DP009.nc: side by side, for none of them calls a program of another file."""
    for side in ("bad", "good"):
        (folder / side).mkdir(parents=True, exist_ok=True)
        for name, pair in pairs.items():
            (folder / side / f"{name}.nc").write_text(getattr(pair, side), encoding="utf-8")


def is_told(code, findings):
    """A code stands for its rule with all its rows, a code with a row for that row alone."""
    return any(finding == code or finding.partition("/")[0] == code for finding in findings)


def problems(statements, pairs, bad, good):
    """What findings, by ids, of the bad programs and of the good ones contradict the table, and what to do about it."""
    known = {statement.id for statement in statements}
    found = [f"{name}: its programs have no row in {TABLE.name}" for name in pairs if name not in known]
    for statement in statements:
        if statement.id not in pairs:
            if statement.watched != [NOT]:
                found.append(f"{statement.id}: it wants a bad and a good program in {PROGRAMS.name}/")
            continue
        told = sorted(bad.get(statement.id, ()))
        if not statement.is_watched and told:
            found.append(f"{statement.id}: {' '.join(told)} reports its bad program: write that in place of "
                         f"'{statement.watched[0]}' in {TABLE.name}, then ./dev docs")
        if statement.is_watched:
            found += [f"{statement.id}: {code} does not report its bad program, but {' '.join(told) or 'nothing'} does"
                      for code in statement.watched if not is_told(code, told)]
        if wrong := sorted(good.get(statement.id, ())):
            found.append(f"{statement.id}: {' '.join(wrong)} reports its good program")
    return found
