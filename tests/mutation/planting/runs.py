"""Asks maclint_runs whether a changed program does the same as the unchanged one."""
import subprocess
import tempfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .plants import KINDS

READ_ALONE = ('spelling', 'forms', 'DIN PLUS', 'SINUMERIK')  # how groups begin whose plants no control runs
LEFT_OVER = ('incremental-left', 'mode-left', 'feed-left', 'speed-left', 'cancel-removed')  # defects by what is left at the end
SAME = 'the runs do the same'
SAME_STATE = 'the runs leave the same modal state'
UNREACHED = 'no path leads to it'
SHOWN_BY_RUNS = (SAME, SAME_STATE, UNREACHED)


def needs_runs(plant):
    return not KINDS[plant.kind].group.startswith(READ_ALONE)


class Runs:
    """What the executor shows of plants."""

    def __init__(self, program, folder, jobs):
        self.program, self.folder, self.jobs = program, folder, jobs

    def look(self, corpora, plants, original, progress):
        """For each plant (why it is none by its runs, or ''; what they show). `original`: gives a corpus' file."""
        together = defaultdict(list)
        for plant in plants:
            if needs_runs(plant):
                together[plant.path].append(plant)
        found = {}
        with ThreadPoolExecutor(self.jobs) as pool:
            work = pool.map(lambda group: self.ask(corpora, group, original), together.values())
            for count, (group, answers) in enumerate(zip(together.values(), work)):
                found.update((id(plant), answer) for plant, answer in zip(group, answers))
                progress((count + 1) / len(together))
        return [(reason(plant, found[id(plant)]), found[id(plant)]) if id(plant) in found else ('', '') for plant in plants]

    def ask(self, corpora, plants, original):
        corpus, path = corpora[plants[0].path.parts[0]], Path(*plants[0].path.parts[1:])
        files = [f'{name}={original(corpus, name)}' for name in [path, *(other for other in corpus.neighbours[path] if other != path)]]
        with tempfile.TemporaryDirectory(dir=self.folder) as home:
            questions = []
            for number, plant in enumerate(plants):
                changed = Path(home) / f'{number}'
                changed.write_bytes(plant.text(corpus.files[path].lines).encode('latin-1'))
                more = [f'+{name}={self.write(Path(home) / f"{number}-{at}", text)}' for at, (name, text) in enumerate(plant.added.items())]
                lines = ','.join(str(line + 1) for line in sorted(plant.changes))
                added = ','.join(f'{line + 1}:{text.count(chr(10))}' for line, text in sorted(plant.changes.items()) if '\n' in text)
                questions.append('\t'.join([str(path), str(changed), lines, added, *files, *more]))
            done = subprocess.run([str(self.program)], input='\n'.join(questions) + '\n', capture_output=True, text=True, errors='replace')
        answers = done.stdout.splitlines()
        return answers + [f'unknown: maclint_runs ended with status {done.returncode}'] * (len(plants) - len(answers))

    @staticmethod
    def write(path, text):
        path.write_text(text)
        return path


def reason(plant, answer):
    """Why a plant is no defect: its runs show nothing else. What they do not come to stays one."""
    shown = answer.split()
    numbers = dict(part.split('=') for part in shown if '=' in part)
    touched = int(numbers.get('touching', 0))
    if shown[:1] == ['unknown'] or shown[:1] == ['unknown:']:
        return ''
    if not touched:
        return UNREACHED if 'unreachable' in shown else 'a block before it cannot be read' if 'unreadable' in shown else ''
    if 2 * int(numbers['led']) < int(numbers['lines']):
        return ''  # too little of the program was run
    if (KINDS[plant.kind].group == 'saved state' or plant.kind in LEFT_OVER) and 'codes' not in shown:
        return SAME_STATE
    return '' if {'values', 'codes', 'variables'} & set(shown) else SAME
