#!/usr/bin/env python3
"""Plants defects in whole programs, one in one place at a time, and counts what maclint finds: ./dev plant.

planting.md beside this file says how. (mutate.py breaks maclint itself; this breaks what maclint reads.)
"""
import argparse
import random
import shutil
import sys
import time
from collections import defaultdict
from pathlib import Path

from planting import report
from planting.judge import Judge
from planting.plants import KINDS
from planting.reduce import Reducer
from planting.runs import Runs, needs_runs
from planting.workspace import Corpus

REDUCED = 1  # misses of a group that are made small
ROOT = Path(__file__).resolve().parents[2]


def corpora_of(root, shared):
    """Our own clean programs, and those of others beside the project where they are."""
    found = [Corpus.read(root / 'corpus' / language / 'good', name, language)
             for language, name in (('fanuc', 'own'), ('dinplus', 'own-dinplus'), ('sinumerik', 'own-sinumerik'))]
    for folder, name, language in (('fanuc-macro', 'macros', 'fanuc'), ('fanuc-plain', 'plain', 'fanuc'), ('dinplus', 'dinplus', 'dinplus')):
        if (shared / 'corpus' / folder).is_dir():
            found.append(Corpus.read(shared / 'corpus' / folder, name, language))
        elif language == 'fanuc':
            print(f'plant: {shared / "corpus" / folder} is not there: its programs are left out', file=sys.stderr)
    return found


def chosen(plants, options):
    """Those of a class in a file, or in a half of the authors, that are planted: a sample that depends on the seed alone."""
    by_kind = defaultdict(list)
    for plant in plants:
        by_kind[plant.kind, plant.path if options.each_file else plant.half].append(plant)
    picked = []
    limit = options.each_file or options.sample
    for key, group in sorted(by_kind.items(), key=lambda item: (item[0][0], str(item[0][1]))):
        order = random.Random(f'{options.seed} {key[0]} {key[1]}')
        picked += order.sample(group, limit) if limit and len(group) > limit else group
    if options.each_file and options.sample:
        return chosen(picked, argparse.Namespace(each_file=0, sample=options.sample, seed=options.seed))
    return picked


def smallest(corpora, results, reducer):
    """For each group of misses the smallest program that the first ones can be reduced to."""
    examples = {}
    for cause, group in report.miss_groups(results).items():
        for plant, _ in sorted(group, key=lambda miss: len(corpus_file(corpora, miss[0]).lines))[:REDUCED]:
            lines = reducer.smallest(corpora[plant.path.parts[0]], plant)
            if lines and (cause not in examples or len(lines) < len(examples[cause][0])):
                examples[cause] = lines, plant.difference()
    return examples


def corpus_file(corpora, plant):
    return corpora[plant.path.parts[0]].files[Path(*plant.path.parts[1:])]


def copied(path, folder):
    shutil.copy2(path, folder / path.name)
    return (folder / path.name).resolve()


def main():
    parser = argparse.ArgumentParser(prog='./dev plant', description=__doc__.splitlines()[0])
    parser.add_argument('--sample', type=int, default=400, metavar='N',
                        help='no more than N places of a class in a half of the authors (default: 400; 0: all)')
    parser.add_argument('--each-file', type=int, default=0, metavar='N', help='no more than N places of a class in a file')
    parser.add_argument('--class', dest='classes', action='append', choices=KINDS, metavar='CLASS', help='only this class')
    parser.add_argument('--corpus', action='append', help='only this one: own, own-dinplus, own-sinumerik, macros, plain, dinplus')
    parser.add_argument('--half', choices=('tune', 'hold'), help='only the programs of this half of the authors')
    parser.add_argument('--file', action='append', help='only programs with this in their path')
    parser.add_argument('--smallest', action='store_true', help='show the smallest program for each group of misses')
    parser.add_argument('--seed', type=int, default=1, help='of the samples (default: 1)')
    parser.add_argument('--maclint', type=Path, default=ROOT / 'build' / 'maclint', help='the executable (default: build/maclint)')
    parser.add_argument('--runs', type=Path, default=ROOT / 'build' / 'maclint_runs', help='what compares runs (default: build/maclint_runs)')
    parser.add_argument('--shared', type=Path, default=ROOT.parent / 'shared', help='the folder with programs of others')
    parser.add_argument('--jobs', type=int, default=2, help='runs at a time (default: 2)')
    parser.add_argument('--output', type=Path, default=ROOT / 'build' / 'planting', help='the folder for the reports')
    options = parser.parse_args()

    began = time.monotonic()
    corpora = {corpus.name: corpus for corpus in corpora_of(ROOT, options.shared) if not options.corpus or corpus.name in options.corpus}
    found = [plant for corpus in corpora.values() for path in corpus.files
             if options.half in (None, corpus.half(path)) for plant in corpus.plants(path)
             if (not options.classes or plant.kind in options.classes)
             and (not options.file or any(part in str(plant.path) for part in options.file))]
    picked = chosen(found, options)
    options.output.mkdir(parents=True, exist_ok=True)
    maclint = copied(options.maclint, options.output)  # a build may replace it meanwhile
    runs = copied(options.runs, options.output) if any(map(needs_runs, picked)) else None
    judge = Judge(maclint, options.output.resolve() / 'programs', options.jobs)

    def progress(done):
        if sys.stderr.isatty():
            print(f'\r{100 * done:3.0f} %', end='' if done < 1 else '\n', file=sys.stderr, flush=True)

    judge.folder.mkdir(parents=True, exist_ok=True)
    for plant, (reason, shown) in zip(picked, Runs(runs, judge.folder, options.jobs).look(corpora, picked, judge.original, progress)):
        plant.harmless, plant.shown = reason or plant.harmless, shown
    harmless = [plant for plant in picked if plant.harmless]
    plants = [plant for plant in picked if not plant.harmless]
    results = [(plant, *verdict) for plant, verdict in zip(plants, judge.judge(corpora, plants, progress))]
    examples = smallest(corpora, results, Reducer(maclint, judge.folder)) if options.smallest else {}
    shutil.rmtree(judge.folder, ignore_errors=True)
    maclint.unlink()
    if runs:
        runs.unlink()
    text = report.markdown(results, harmless, examples, options.seed, time.monotonic() - began)
    (options.output / 'report.md').write_text(text)
    (options.output / 'report.json').write_text(report.as_json(results, harmless, options.seed))
    print(report.summary(results))
    print(f'The report is in {options.output / "report.md"}.')
    return 0 if report.passes(results) else 1


if __name__ == '__main__':
    sys.exit(main())
