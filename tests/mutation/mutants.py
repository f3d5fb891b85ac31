"""Where the code can be broken, and how: every place of a C++ text with one operator each, told by its text alone.

A line is looked at without its comments, strings and characters. Operators that the formatter writes between two
blanks are told from the angle brackets of templates by those blanks.
"""
import random
import re
from collections import defaultdict
from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    """One line of one file, written differently."""
    file: str  # from the root of the project
    line: int  # from 1
    kind: str
    before: str
    after: str

    def describe(self):
        return f'{self.file}:{self.line}: {self.kind}'


# Pairs of what is written and what is put there instead; the first group is replaced.
SWAPS = [
    ('relational', r' (<) (?!<)', '<='), ('relational', r' (<=) ', '<'),
    ('relational', r' (>) (?!>)', '>='), ('relational', r' (>=) ', '>'),
    ('relational', r' (==) ', '!='), ('relational', r' (!=) ', '=='),
    ('arithmetic', r'[\w\)\]] (\+) ', '-'), ('arithmetic', r'[\w\)\]] (-) ', '+'),
    ('arithmetic', r'[\w\)\]] (\*) ', '/'), ('arithmetic', r'[\w\)\]] (/) ', '*'),
    ('arithmetic', r' (\+=) ', '-='), ('arithmetic', r' (-=) ', '+='),
    ('arithmetic', r'(\+\+)\w', '--'), ('arithmetic', r'\bstd::(min)\b', 'max'),
    ('arithmetic', r'\bstd::(max)\b', 'min'), ('arithmetic', r' (%) ', '/'),
    ('logical', r' (&&) ', '||'), ('logical', r' (\|\|) ', '&&'),
    ('logical', r' (&) ', '|'), ('logical', r' (\|) ', '&'), ('logical', r' (\|=) ', '&='),
    ('logical', r'(?<=[\(\s])(!)(?=[\w\(\*])', ''),
    ('value', r'\b(true)\b', 'false'), ('value', r'\b(false)\b', 'true'),
    ('value', r'\b(any_of)\b', 'all_of'), ('value', r'\b(all_of)\b', 'any_of'),
    ('value', r'\b(none_of)\b', 'any_of'), ('value', r'\b(lower_bound)\(', 'upper_bound'),
    ('value', r'\b(upper_bound)\(', 'lower_bound'),
]
NUMBER = re.compile(r"(?<![\w.'])(\d+)(?:\.0)?(?![\w.'])")
CONDITION = re.compile(r'\b(if|while) \(')
STATEMENT = re.compile(r'^\s*(?!return\b|else\b|case\b|using\b|delete\b|goto\b|throw\b|if\b|for\b|while\b|do\b|const\b|auto\b|'
                       r'static|constexpr|template|struct|class|enum|friend|extern|default\b|public|private|assert)'
                       r'[\w:.\->\[\]\(\)\*\+]+(\(.*\)| [-+*/|&^]?= .*|\+\+|--);$|^\s*(\+\+|--)[\w.\->\[\]]+;$')
LEAVING = re.compile(r'^\s*(if \(.*\) )?(return\b.*|continue|break);$')
RETURNED = re.compile(r'\breturn ((?!\{\})[^;]+);$')
CHOICE = re.compile(r'\? ([\w.:\->\*]+(?:\(\w*\))?) : ([\w.:\->\*]+(?:\(\w*\))?)(?=[;,\)])')
ENUM = re.compile(r'\benum class (\w+)[^{;]*\{([^}]*)\}', re.S)


def blanked(text):
    """The text with every character of comments, strings, characters and preprocessor lines a blank."""
    out, at, size = [], 0, len(text)

    def blank(end):
        nonlocal at
        out.append(re.sub(r'[^\n]', ' ', text[at:end]))
        at = end

    while at < size:
        two = text[at:at + 2]
        if two == '//':
            end = text.find('\n', at)
            blank(size if end < 0 else end)
        elif two == '/*':
            end = text.find('*/', at)
            blank(size if end < 0 else end + 2)
        elif text[at] == '#' and not text[text.rfind('\n', 0, at) + 1:at].strip():
            end = text.find('\n', at)
            blank(size if end < 0 else end)
        elif text[at] == '"' or (text[at] == "'" and not (at and text[at - 1].isalnum())):
            quote, end = text[at], at + 1
            while end < size and text[end] != quote and text[end] != '\n':
                end += 2 if text[end] == '\\' else 1
            out.append(text[at])
            at += 1
            blank(min(end, size))
            if at < size:
                out.append(text[at])
                at += 1
        else:
            out.append(text[at])
            at += 1
    return ''.join(out)


def enums_of(texts):
    """Name of each enum class to its members; names given twice are left out."""
    found, twice = {}, set()
    for text in texts:
        for name, body in ENUM.findall(blanked(text)):
            members = [re.match(r'\s*(\w+)', part) for part in body.split(',')]
            if name in found:
                twice.add(name)
            found[name] = [member.group(1) for member in members if member]
    return {name: members for name, members in found.items() if name not in twice and len(members) > 1}


def closing(line, opening):
    depth = 0
    for at in range(opening, len(line)):
        depth += {'(': 1, ')': -1}.get(line[at], 0)
        if depth == 0:
            return at
    return None


def mutants_of_line(line, code, enums, begins):
    """All (kind, line as it would be) of one line; `code` is the line without comments and strings, `begins` says
    whether a statement may begin with it."""
    for kind, pattern, replacement in SWAPS:
        for match in re.finditer(pattern, code):
            yield kind, line[:match.start(1)] + replacement + line[match.end(1):]
    for match in NUMBER.finditer(code):
        for step in (1, -1):
            number = str(int(match.group(1)) + step)
            yield 'constant', line[:match.start(1)] + number + line[match.end(1):]
    for match in CONDITION.finditer(code):
        opening = match.end() - 1
        end = closing(code, opening)
        inside = line[opening + 1:end] if end else ''
        if ';' not in inside and inside and not re.match(r'(const|auto)\b', inside) and ' = ' not in inside:
            yield 'condition', line[:opening] + '(!(' + inside + '))' + line[end + 1:]
    stripped = code.strip()
    indent = line[:len(line) - len(line.lstrip())]
    balanced = stripped.count('(') == stripped.count(')') and stripped.count('{') == stripped.count('}')
    if begins and balanced and STATEMENT.match(code.rstrip()):
        yield 'statement', indent + ';'
    if begins and balanced and LEAVING.match(code.rstrip()):
        yield 'statement', indent + ';'
    match = RETURNED.search(code.rstrip())
    if balanced and match:
        yield 'value', line[:match.start(1)] + '{}' + line[match.end(1):]
    for match in CHOICE.finditer(code):
        one, other = line[match.start(1):match.end(1)], line[match.start(2):match.end(2)]
        yield 'branch', line[:match.start(1)] + other + ' : ' + one + line[match.end(2):]
    if not stripped.startswith('case '):
        for match in re.finditer(r'\b(\w+)::(\w+)\b', code):
            members = enums.get(match.group(1), [])
            if match.group(2) in members:
                other = members[(members.index(match.group(2)) + 1) % len(members)]
                yield 'branch', line[:match.start(2)] + other + line[match.end(2):]


def mutants_of(file, text, enums):
    lines, codes = text.split('\n'), blanked(text).split('\n')
    previous = ''
    for index, (line, code) in enumerate(zip(lines, codes)):
        if code.strip().startswith(('static_assert', 'using ', 'namespace', 'template', 'assert(', '//')):
            continue
        seen = set()
        begins = previous.endswith((';', '{', '}', ':', ')', 'else')) or not previous
        previous = code.strip() or previous
        for kind, after in mutants_of_line(line, code, enums, begins):
            if after != line and after not in seen:
                seen.add(after)
                yield Mutant(file, index + 1, kind, line, after)


def sample(mutants, seed, folder_of):
    """All mutants in an order of which every beginning is stratified.

    A folder comes as often as it has mutants, a kind within a folder as often as every other, as long as there are
    any. The order depends on the seed and on the mutants alone."""
    strata = defaultdict(list)
    for mutant in mutants:
        strata[folder_of(mutant.file), mutant.kind].append(mutant)
    chance = random.Random(seed)
    for key in sorted(strata):
        strata[key].sort(key=lambda m: (m.file, m.line, m.after))
        chance.shuffle(strata[key])
    sizes = defaultdict(int)
    for (folder, _), members in strata.items():
        sizes[folder] += len(members)
    taken, order = defaultdict(int), []
    kinds = {folder: sorted(kind for f, kind in strata if f == folder) for folder in sizes}
    turn = defaultdict(int)
    for _ in range(sum(sizes.values())):
        folder = min((f for f in sizes if taken[f] < sizes[f]), key=lambda f: ((taken[f] + 1) / sizes[f], f))
        while True:
            kind = kinds[folder][turn[folder] % len(kinds[folder])]
            turn[folder] += 1
            if strata[folder, kind]:
                break
        taken[folder] += 1
        order.append(strata[folder, kind].pop())
    return order
