"""Runs maclint on the changed programs, many in one run, and compares with the unchanged ones."""
import json
import os
import shutil
import subprocess
import sys
from collections import Counter, defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .plants import KINDS, RANK
from .shows import is_shown_elsewhere

SIZE = 100  # programs in one run
OTHER_CONTROL = 'MAC005'  # the program is for another control: its findings are withheld


class Judge:
    """Every mutant has a folder of its own, with the programs that its calls connect it with.

    Mutants of one program share a run: in each folder are the same programs, so that no call leads into another folder.
    """

    def __init__(self, maclint, folder, jobs):
        self.maclint, self.folder, self.jobs = maclint, folder, jobs
        shutil.rmtree(folder, ignore_errors=True)
        self.unchanged = {}

    def judge(self, corpora, plants, progress):
        """For each plant a verdict: 'found', 'only a note', 'missed', 'known before' or 'not linted', with the findings new."""
        together = defaultdict(list)
        for plant in plants:
            together[plant.path, plant.complete].append(plant)
        batches = [group[at:at + SIZE] for group in together.values() for at in range(0, len(group), SIZE)]
        verdicts = {}
        with ThreadPoolExecutor(self.jobs) as pool:
            work = pool.map(lambda item: self.judge_batch(corpora, *item), enumerate(batches))
            for count, (batch, judged) in enumerate(zip(batches, work)):
                verdicts.update({id(plant): verdict for plant, verdict in zip(batch, judged)})
                progress((count + 1) / len(batches))
        return [verdicts[id(plant)] for plant in plants]

    def judge_batch(self, corpora, number, batch):
        folder, complete = self.folder / f'batch{number}', batch[0].complete
        for index, plant in enumerate(batch):
            corpus, path = corpora[plant.path.parts[0]], Path(*plant.path.parts[1:])
            home = folder / f'm{index:04}'
            self.lay_out(corpus, path, home, complete)
            (home / path).unlink()
            (home / path).write_bytes(plant.text(corpus.files[path].lines).encode('latin-1'))
            for name, text in plant.added.items():
                (home / name).write_text(text)
        findings, skipped = self.run(folder, [f'm{index:04}/{path}' for index, plant in enumerate(batch)
                                              for path in [Path(*plant.path.parts[1:]), *plant.added]], complete)
        shutil.rmtree(folder)
        return [self.verdict(corpora, plant, findings.get(f'm{index:04}', []), f'm{index:04}/{Path(*plant.path.parts[1:])}' in skipped)
                for index, plant in enumerate(batch)]

    def lay_out(self, corpus, path, home, complete):
        (home / '.git').mkdir(parents=True)
        for neighbour in corpus.neighbours[path]:
            target, source = home / neighbour, self.original(corpus, neighbour)
            target.parent.mkdir(parents=True, exist_ok=True)
            os.link(source, target)
        if complete:
            (home / '.maclint.json').write_text('{"complete": true}\n')

    def original(self, corpus, path):
        """A copy of the unchanged file beside the mutants, so that folders can share it."""
        copy = self.folder / 'unchanged' / corpus.name / path
        if not copy.exists():
            copy.parent.mkdir(parents=True, exist_ok=True)
            part = copy.with_name(f'{copy.name}.{os.getpid()}.{id(copy)}')
            part.write_bytes(corpus.files[path].text.encode('latin-1'))
            part.rename(copy)
        return copy

    def run(self, folder, files, complete):
        """Findings by the first folder of their path, and the files that were not linted. Files are named, because
        maclint passes over unusual names in folders."""
        options = [] if complete else ['--isolated']
        done = subprocess.run([str(self.maclint), 'check', '--vendor', '--format', 'json', '--jobs', '1', '--no-timestamps', *options, '.', *files],
                              cwd=folder, capture_output=True, text=True, errors='replace')
        if not done.stdout:
            sys.exit(f'plant: maclint ended with status {done.returncode} on the programs in {folder}:\n{done.stderr[-2000:]}')
        report = json.loads(done.stdout)
        by_folder = {}
        for finding in report['findings']:
            home, _, path = finding['file'].partition('/')
            by_folder.setdefault(home, []).append((path, finding))
        return by_folder, {notice['file'] for notice in report['notices']}

    def before(self, corpora, plant):
        """The findings of the unchanged program and its neighbours."""
        key = plant.path, plant.complete
        if key not in self.unchanged:
            corpus, path = corpora[plant.path.parts[0]], Path(*plant.path.parts[1:])
            home = self.folder / 'before' / f'{abs(hash(key)):x}-{os.getpid()}-{id(plant)}'
            self.lay_out(corpus, path, home / 'm', plant.complete)
            findings, _ = self.run(home, [f'm/{path}'], plant.complete)
            shutil.rmtree(home)
            self.unchanged[key] = findings.get('m', [])
        return self.unchanged[key]

    def verdict(self, corpora, plant, findings, skipped):
        if skipped:
            return 'not linted', []
        kind, path = KINDS[plant.kind], str(Path(*plant.path.parts[1:]))
        corpus = corpora[plant.path.parts[0]]
        known = Counter(place for found in self.before(corpora, plant) for place in places(*found))
        if any(code == OTHER_CONTROL and file == path for code, file, _ in known):
            return 'not linted', []
        if any(code in kind.rules and file == path and line - 1 in plant.changes for code, file, line in known):
            return 'known before', []
        new = [(file, finding) for file, finding in findings if Counter(places(file, finding, plant)) - known]
        codes = [f"{finding['code']} {finding['severity']} line {finding['range']['start']['line']}" for _, finding in new]
        shown = corpus.shown(plant)
        wanted = [finding for file, finding in new if finding['code'] in kind.rules
                  and any(self.is_shown(corpus, plant, shown, place) for place in places(file, finding, plant))]
        if any(RANK[finding['severity']] >= RANK[plant.least] for finding in wanted):
            return 'found', codes
        return ('only a note' if wanted else 'missed'), codes

    @staticmethod
    def is_shown(corpus, plant, shown, place):
        """Whether the defect shows at the place of a finding."""
        _, file, line = place
        if file == str(Path(*plant.path.parts[1:])):
            return shown is None or line in shown
        if Path(file) in plant.added or shown is None:
            return True
        lines = corpus.files[Path(file)].lines
        return line <= len(lines) and is_shown_elsewhere(lines[line - 1], KINDS[plant.kind].group)


def places(path, finding, plant=None):
    """Where a finding speaks of a defect: its own place and the others that it names; lines are those of the unchanged
    program."""
    yield finding['code'], path, line_before(plant, path, finding['range']['start']['line'])
    for other in finding['related']:
        file = other['file'].partition('/')[2]
        yield finding['code'], file, line_before(plant, file, other['range']['start']['line'])


def line_before(plant, path, line):
    return plant.line_before(line) if plant and path == str(Path(*plant.path.parts[1:])) else line
