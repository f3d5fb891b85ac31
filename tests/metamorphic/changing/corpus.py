"""The programs that are changed."""
import random
import re
from pathlib import Path

from .text import Program

MOST_BYTES = 200_000
NO_PROGRAMS = {'.md', '.json', '.txt', '.tsv', '.sh', '.py'}
EXAMPLE = re.compile(r'^## (?:Bad|Good) \((\w+)[^)\n]*\)\n\n```\n(.*?\n)```$', re.MULTILINE | re.DOTALL)
# Below the folder that is beside the project.
SHARED = ('corpus/fanuc-macro', 'corpus/fanuc-plain', 'reference/dinplus-examples', 'reference/seed-programs', 'cases/alarms',
          'cases/dinplus-manual', 'cases/dinplus-missed', 'cases/lathe-words', 'cases/plain', 'cases/repairs', 'cases/silent',
          'cases/wrong-today')


def programs_of(root, shared, language_of):
    """All programs of both corpora that maclint takes for one of the two languages, with paths below one folder.

    `language_of(texts)` says which it takes each for, by path: short fragments could be either."""
    folders = [(root / 'corpus', 'own')] + [(shared / name, name.rsplit('/', 1)[1]) for name in SHARED]
    texts = {Path(name) / path.relative_to(folder): path.read_bytes().decode('latin-1') for folder, name in folders
             for path in sorted(folder.rglob('*')) if path.is_file() and is_program(path)}
    texts |= examples_of(root / 'docs' / 'rules')
    languages = language_of(texts)
    return [Program(path, languages[path], text) for path, text in texts.items() if languages.get(path) in ('fanuc', 'dinplus')]


def examples_of(pages):
    """The programs that the pages of the rules show: each rule speaks of one at least."""
    texts = {}
    for page in sorted(pages.glob('[MD][AI][CN][0-9]*.md')):
        for number, (language, text) in enumerate(EXAMPLE.findall(page.read_bytes().decode('latin-1'))):
            if language not in ('fanuc', 'dinplus'):
                continue
            texts[Path('rules') / page.stem / f"{number}{'.ncs' if language == 'dinplus' else '.nc'}"] = text
    return texts


def is_program(path):
    return path.suffix.lower() not in NO_PROGRAMS and path.name != 'README' and path.stat().st_size <= MOST_BYTES


def drawn(programs, count, seed):
    """So many of them, the same number of each language where there are enough."""
    rng = random.Random(seed)
    groups = [[program for program in programs if program.language == language] for language in ('dinplus', 'fanuc')]
    picked = []
    for left, group in zip((2, 1), sorted(groups, key=len)):
        wanted = min(len(group), (count - len(picked)) // left)
        picked += rng.sample(group, wanted)
    return sorted(picked, key=lambda program: program.path)
