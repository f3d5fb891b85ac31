"""The tables of verdicts in docs/verdicts: how they are read, and what a rule's precision is by them."""
import collections
import dataclasses
import fractions
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ["author", "file", "line", "rule", "severity", "verdict", "count", "build", "why"]
SET_COLUMNS = ["set", "counts", "programs", "folder", "about"]
VERDICTS = ("true", "noise", "false", "unsure")
SEVERITIES = ("error", "warning", "note")
NONE = "-"

# How a share becomes a precision: at least so many per cent of the decided findings are true.
LEVELS = (("very-high", 95), ("high", 80), ("medium", 50), ("low", 0))
# With fewer decided findings, or of fewer authors, a share says nothing: the precision stays what the rule's author
# estimated. "several" stands for authors who were not counted one by one.
ENOUGH_FINDINGS = 5
ENOUGH_AUTHORS = 2
SEVERAL = "several"


# What is under it, of a rule and a severity with enough verdicts, is to be mended, in per cent.
FEWEST_TRUE = {"error": 80, "warning": 80, "note": 50}


class BadTable(Exception):
    """A table that cannot be used; the text says where and why."""


@dataclasses.dataclass
class ProgramSet:
    name: str
    counts: bool  # towards the precision of rules
    programs: str
    folder: str
    about: str
    rows: list


@dataclasses.dataclass
class Row:
    author: str
    file: str
    line: int
    rule: str
    severity: str
    verdict: str
    count: int
    build: str
    why: str

    @property
    def is_finding(self):
        """Of one finding, whose place is known, and no count of many."""
        return self.file != NONE

    @property
    def place(self):
        return self.file, self.line, self.rule

    def written(self):
        line = str(self.line) if self.is_finding else NONE
        return "\t".join([self.author, self.file, line, self.rule, self.severity, self.verdict, str(self.count), self.build,
                          self.why])


@dataclasses.dataclass
class Record:
    """What the record of a rule says of it."""
    source: pathlib.Path
    severity: str
    precision: str


@dataclasses.dataclass
class Tally:
    verdicts: collections.Counter
    authors: set  # of the decided ones

    @property
    def decided(self):
        return sum(self.verdicts[verdict] for verdict in VERDICTS if verdict != "unsure")

    @property
    def share(self):
        """Of the decided ones that are true, in per cent, exactly."""
        return fractions.Fraction(100 * self.verdicts["true"], self.decided)

    @property
    def is_enough(self):
        several = ENOUGH_AUTHORS if SEVERAL in self.authors else 0
        return self.decided >= ENOUGH_FINDINGS and max(len(self.authors), several) >= ENOUGH_AUTHORS

    @property
    def level(self):
        return next(name for name, least in LEVELS if self.share >= least)


def records(root=ROOT):
    """The rules by their codes, as their sources have them."""
    found = {}
    field = r'\.{0} = {1}::(\w+)'
    for source in sorted((root / "rules").rglob("*.cpp")):
        text = source.read_text(encoding="utf-8")
        for code in re.finditer(r'\.code = "((?:MAC|DIN|SIN)\d{3})"', text):
            severity = re.compile(field.format("severity", "Severity")).search(text, code.end())
            precision = re.compile(field.format("precision", "Precision")).search(text, code.end())
            if severity and precision:
                found[code[1]] = Record(source.relative_to(root), severity[1], precision[1].replace("_", "-"))
    return found


def lines_of(path, columns):
    lines = path.read_text(encoding="utf-8").splitlines()
    if not lines or lines[0].split("\t") != columns:
        raise BadTable(f"{path}:1: the columns are to be {', '.join(columns)}, with tabs between them")
    for number, line in enumerate(lines[1:], 2):
        fields = line.split("\t")
        if len(fields) != len(columns) or "" in fields:
            raise BadTable(f"{path}:{number}: a row has {len(columns)} fields with tabs between them, '{NONE}' for none")
        yield f"{path}:{number}", fields


def positive(text, what, where):
    if not re.fullmatch(r"[1-9]\d*", text):
        raise BadTable(f"{where}: '{text}' is no {what}")
    return int(text)


def row_of(where, fields, rules):
    author, file, line, rule, severity, verdict, count, build, why = fields
    for value, known, what in ((rule, rules, "rule"), (severity, SEVERITIES, "severity"), (verdict, VERDICTS, "verdict")):
        if value not in known:
            raise BadTable(f"{where}: there is no {what} '{value}'")
    if (file == NONE) != (line == NONE):
        raise BadTable(f"{where}: a finding has a file and a line, a count has neither")
    if file != NONE and count != "1":
        raise BadTable(f"{where}: a row with a file is one finding")
    if why == NONE and verdict != "true":
        raise BadTable(f"{where}: what is not true needs a reason")
    return Row(author, file, 0 if line == NONE else positive(line, "line", where), rule, severity, verdict,
               positive(count, "count", where), build, why)


def read(folder=ROOT / "docs/verdicts", rules=None):
    """The sets of programs with their rows, in the order of sets.tsv; BadTable names the first row that is none."""
    rules = records() if rules is None else rules
    sets = []
    for where, (name, counts, programs, below, about) in lines_of(folder / "sets.tsv", SET_COLUMNS):
        if counts not in ("yes", "no"):
            raise BadTable(f"{where}: whether the set counts is 'yes' or 'no'")
        rows = [row_of(*line, rules) for line in lines_of(folder / f"{name}.tsv", COLUMNS)]
        twice = [place for place, times in collections.Counter(row.place for row in rows if row.is_finding).items() if times > 1]
        if twice:
            raise BadTable(f"{folder / name}.tsv: {twice[0][0]}:{twice[0][1]} has two rows for {twice[0][2]}")
        sets.append(ProgramSet(name, counts == "yes", programs, below, about, rows))
    unnamed = {path.stem for path in folder.glob("*.tsv")} - {"sets"} - {programs.name for programs in sets}
    if unnamed:
        raise BadTable(f"{folder}/sets.tsv has no row for {', '.join(sorted(unnamed))}")
    return sets


def write_rows(programs, folder=ROOT / "docs/verdicts"):
    lines = ["\t".join(COLUMNS), *(row.written() for row in programs.rows)]
    (folder / f"{programs.name}.tsv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def tally(rows):
    counted = Tally(collections.Counter(), set())
    for row in rows:
        counted.verdicts[row.verdict] += row.count
        if row.verdict != "unsure":
            counted.authors.add(row.author)
    return counted


def counting_rows(sets):
    return [row for programs in sets if programs.counts for row in programs.rows]


@dataclasses.dataclass
class Measured:
    """What was read of a rule: its errors and warnings, its notes, and which of the two its precision rests on."""
    alarms: Tally
    notes: Tally
    basis: Tally

    @property
    def level(self):
        """None: the precision is the one that the rule's author estimated."""
        return self.basis.level if self.basis.is_enough else None


def measured(sets, rules):
    """By their codes the rules of which findings were read. A rule that is a note by itself is measured on its notes,
    any other on its errors and warnings: where it only has a note to give, it knows less."""
    of_rule = collections.defaultdict(list)
    for row in counting_rows(sets):
        of_rule[row.rule].append(row)
    result = {}
    for code in sorted(of_rule):
        notes = tally(row for row in of_rule[code] if row.severity == "note")
        alarms = tally(row for row in of_rule[code] if row.severity != "note")
        result[code] = Measured(alarms, notes, notes if rules[code].severity == "note" else alarms)
    return result
