#!/usr/bin/env python3
"""Breaks the analysis in one place after the other and sees whether a test fails: ./dev mutate.

Works on a copy of the sources in build/mutate; README.md beside this file says how.
"""
import argparse
import difflib
import json
import os
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from pathlib import Path

import mutants

FINDERS = 'finders'  # what rules alone ask: rules/*/*_finder.cpp
FOLDERS = ['dataflow', 'flow', 'queries', 'semantics', 'workspace', FINDERS]  # but for the last of analyzer/
# Folders of tests/ whose tests are the nearest to each of them; then come the rules', then all.
NEAREST = {
    'dataflow': ['dataflow', 'execution', 'semantics'],
    'flow': ['flow', 'dataflow'],
    'queries': ['queries', 'rules'],
    FINDERS: ['rules', 'queries'],
    'semantics': ['semantics', 'execution', 'dataflow'],
    'workspace': ['workspace'],
}
NEXT = ['rules', 'workspace', 'dataflow', 'execution']
NOT_COPIED = ('.git', 'build')  # folders of the root that begin so
TIMED = ['*LinearTime', '*TakesNoTime']  # tests that look at a clock fail by chance beside other work
MEMORY = 3 << 30  # bytes that a broken program may take
LEAST_KILLED = 0.9


def folder_of(file):
    """Which of the FOLDERS a file belongs to: 'flow' of analyzer/flow/graph.cpp."""
    first, second = Path(file).parts[:2]
    return FINDERS if first == 'rules' else second


def files_of(root):
    """All files of a checkout, without what a build leaves there."""
    for start in sorted(root.iterdir()):
        if not start.name.startswith(NOT_COPIED):
            yield from [start] if start.is_file() else sorted(p for p in start.rglob('*') if p.is_file())


def run(command, **options):
    return subprocess.run(command, text=True, errors='replace', capture_output=True, **options)


class Base:
    """The unchanged program, built once: everything that a mutant is linked with."""

    def __init__(self, root, folder, jobs):
        self.source, self.build = folder / 'source', folder / 'source' / 'build'
        self.jobs = jobs
        self.copy(root)
        self.make()
        self.load()

    def load(self):
        """The commands that compile each file and link the tests."""
        self.originals = {}  # object code of unchanged files, compiled as mutants are
        self.commands = {entry['file']: shlex.split(entry['command'])
                         for entry in json.loads((self.build / 'compile_commands.json').read_text())}
        listed = run(['ninja', '-C', str(self.build), '-t', 'commands', 'maclint_tests'], check=True).stdout
        link = [line for line in listed.splitlines() if ' -o maclint_tests ' in line][-1]
        self.link = shlex.split(re.search(r'&& (.* -o maclint_tests .*?) &&', link + ' &&').group(1))

    def copy(self, root):
        """Only what changed, so that the build of an earlier run serves again."""
        kept = set()
        (self.source / '.git').mkdir(parents=True, exist_ok=True)  # paths in reports are those in a repository
        for path in files_of(root):
            target = self.source / path.relative_to(root)
            kept.add(target)
            data = path.read_bytes()
            if target.exists() and target.read_bytes() == data:
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
        for path in files_of(self.source):
            if path not in kept:
                path.unlink()

    def make(self):
        linker = next((name for name in ('mold', 'lld', 'gold') if shutil.which('ld.' + name)), None)
        options = ['-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -D_GLIBCXX_ASSERTIONS', '-DMACLINT_BENCH=OFF',
                   '-DMACLINT_SHARED=none', '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON',
                   f'-DCMAKE_EXE_LINKER_FLAGS={"-fuse-ld=" + linker if linker else ""}']
        for command in (['cmake', '-S', str(self.source), '-B', str(self.build), '-G', 'Ninja', *options],
                        ['ninja', '-C', str(self.build), '-j', str(self.jobs), 'maclint_tests']):
            done = run(command)
            if done.returncode:
                sys.exit('mutate: the unchanged program cannot be built:\n' + done.stdout[-4000:] + done.stderr[-4000:])


class Suites:
    """Which test suites there are, in the order in which they are tried for a folder of the analyzer."""

    def __init__(self, tests, binary):
        self.by_folder = {}
        for path in sorted(tests.rglob('*.cpp')):
            names = re.findall(r'^(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),', path.read_text(errors='replace'), re.M)
            self.by_folder.setdefault(path.relative_to(tests).parts[0], set()).update(names)
        # Tests of the executable run another program, which is not broken; those of the structure read the sources.
        self.blind = set(self.by_folder.get('structure', ()))
        for path in tests.rglob('*.cpp'):
            text = path.read_text(errors='replace')
            if re.search(r'\brun_maclint', text):
                self.blind |= set(re.findall(r'^TEST(?:_F|_P)?\(\s*(\w+),', text, re.M))
        self.binary = binary

    def stages(self, folder):
        nearest = self.suites(NEAREST[folder])
        after = self.suites(NEXT) - nearest
        return [self.filter(nearest), self.filter(after), self.filter(None, nearest | after)]

    def suites(self, folders):
        return set().union(*(self.by_folder.get(folder, set()) for folder in folders)) - self.blind

    def filter(self, wanted, unwanted=frozenset()):
        def patterns(names):
            return ':'.join(pattern for name in sorted(names) for pattern in (f'{name}.*', f'*/{name}.*'))

        left_out = ':'.join(TIMED)
        if wanted is None:
            return f'*-{left_out}:{patterns(unwanted | self.blind)}'
        return f'{patterns(wanted)}-{left_out}' if wanted else None


class Worker:
    """Compiles, links and tests one mutant after the other in a folder of its own."""

    def __init__(self, base, suites, folder):
        self.base, self.suites, self.folder = base, suites, folder
        folder.mkdir(parents=True, exist_ok=True)
        self.limits = {}

    def compile(self, file, text):
        """The object code of the file with this text, or None when it is no C++."""
        path = self.folder / Path(file).name
        path.write_text(text)
        out = path.with_suffix('.o')
        command = list(self.base.commands[str(self.base.source / file)])
        command = command[1:] if Path(command[0]).name == 'ccache' else command
        command[command.index('-o') + 1] = str(out)
        command[command.index('-c') + 1] = str(path)
        command += ['-w', f'-fmacro-prefix-map={self.folder}=.']
        done = run(command, cwd=self.base.build)
        return out.read_bytes() if done.returncode == 0 else None

    def judge(self, mutant):
        """'no C++', 'equal', 'survived' or 'killed', with the test that failed."""
        text = (self.base.source / mutant.file).read_text()
        if mutant.file not in self.base.originals:
            self.base.originals[mutant.file] = self.compile(mutant.file, text)
        lines = text.split('\n')
        lines[mutant.line - 1] = mutant.after
        code = self.compile(mutant.file, '\n'.join(lines))
        if code is None:
            return 'no C++', ''
        if code == self.base.originals[mutant.file]:
            return 'equal', ''
        tests = self.build_tests(mutant)
        for stage in self.suites.stages(folder_of(mutant.file)):
            failed = stage and self.test(tests, stage)
            if failed:
                return 'killed', failed
        return 'survived', ''

    def build_tests(self, mutant):
        """The mutant's object stands before the libraries, so that theirs is not taken."""
        out = self.folder / 'tests'
        command = list(self.base.link)
        command[command.index('-o') + 1] = str(out)
        library = next(i for i, word in enumerate(command) if word.endswith('.a'))
        command.insert(library, str((self.folder / Path(mutant.file).name).with_suffix('.o')))
        run(command, cwd=self.base.build, check=True)
        return out

    def test(self, tests, stage):
        """The first test that fails, or nothing."""
        command = [str(tests), f'--gtest_filter={stage}', '--gtest_fail_fast']
        process = subprocess.Popen(command, cwd=self.base.source, text=True, errors='replace', stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, preexec_fn=bounded, start_new_session=True)
        try:
            output, _ = process.communicate(timeout=self.limits.get(stage, 600))
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            return last_begun(output) + ' (too slow)'
        failed = re.search(r'^\[  FAILED  \] ([\w./]+)', output, re.M)
        if process.returncode and not failed:
            return last_begun(output) + f' (ended with status {process.returncode})'
        return failed.group(1) if failed else ''

    def measure(self):
        """How long the tests of the unchanged program take, which must all pass."""
        tests = self.base.build / 'maclint_tests'
        for folder in FOLDERS:
            for stage in self.suites.stages(folder):
                if stage is None or stage in self.limits:
                    continue
                began = time.monotonic()
                failed = self.test(tests, stage)
                if failed:
                    sys.exit(f'mutate: a test of the unchanged program fails: {failed}')
                self.limits[stage] = 10 + 5 * (time.monotonic() - began)


def bounded():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def last_begun(output):
    begun = re.findall(r'^\[ RUN      \] ([\w./]+)', output, re.M)
    return begun[-1] if begun else 'no test begun'


def judge_all(order, workers, count, seconds):
    """Verdicts of the first `count` mutants in the order that are C++ and change the code, and of those in between."""
    verdicts, lock, began = [None] * len(order), threading.Lock(), time.monotonic()
    state = {'next': 0}

    def work(worker):
        while True:
            with lock:
                judged = sum(1 for verdict in verdicts if verdict and verdict[0] in ('killed', 'survived'))
                if judged >= count or state['next'] >= len(order) or time.monotonic() - began > seconds:
                    return
                index = state['next']
                state['next'] += 1
            verdict = worker.judge(order[index])
            with lock:
                verdicts[index] = verdict
                print(f'{time.monotonic() - began:6.0f} s  {verdict[0]:8}  {order[index].describe()}  {verdict[1]}',
                      file=sys.stderr, flush=True)

    threads = [threading.Thread(target=work, args=(worker,)) for worker in workers]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    results, judged = [], 0
    for mutant, verdict in zip(order, verdicts):
        if verdict is None or judged >= count:
            break
        judged += verdict[0] in ('killed', 'survived')
        results.append((mutant, *verdict))
    return results


def read_explanations(path):
    """(file, the line as it is, the line as it would be) to the reason why nobody minds."""
    reasons, file, lines = {}, None, {}
    for text in path.read_text().splitlines() if path.exists() else []:
        if text.startswith('## '):
            file = text[3:].strip()
        elif text.startswith(('    - ', '    + ')):
            lines[text[4]] = text[6:].strip()
        elif text.strip() and len(lines) == 2:
            reasons[file, lines['-'], lines['+']] = text.strip()
            lines = {}
    return reasons


def key_of(mutant):
    return mutant.file, mutant.before.strip(), mutant.after.strip()


def difference(mutant):
    return ''.join(f'{line}\n' for line in difflib.ndiff([mutant.before.strip()], [mutant.after.strip()])
                   if not line.startswith('?'))


def report(results, reasons, seed, seconds):
    counts = Counter(verdict for _, verdict, _ in results)
    judged = counts['killed'] + counts['survived']
    share = counts['killed'] / judged if judged else 1.0
    survivors = [mutant for mutant, verdict, _ in results if verdict == 'survived']
    unexplained = [m for m in survivors if key_of(m) not in reasons]
    lines = ['# Mutants', '',
             f'Seed {seed}, {seconds:.0f} s. {judged} mutants: {counts["killed"]} killed ({100 * share:.1f} %), '
             f'{counts["survived"]} survived, {len(unexplained)} of them without an explanation. '
             f'Left out: {counts["equal"]} with equal object code, {counts["no C++"]} that are no C++.', '']
    lines += ['| folder | killed | survived |', '|---|---|---|']
    for folder in FOLDERS:
        own = Counter(v for m, v, _ in results if folder_of(m.file) == folder)
        lines.append(f'| {folder} | {own["killed"]} | {own["survived"]} |')
    lines += ['', '| kind | killed | survived |', '|---|---|---|']
    for kind in sorted({m.kind for m, _, _ in results}):
        own = Counter(v for m, v, _ in results if m.kind == kind)
        lines.append(f'| {kind} | {own["killed"]} | {own["survived"]} |')
    lines += ['', '## Survivors', '']
    for mutant in survivors:
        reason = reasons.get(key_of(mutant), '**not explained**')
        lines += [mutant.describe(), '', '```diff', difference(mutant).rstrip('\n'), '```', '', reason, '']
    lines += ['## Killed', '']
    lines += [f'- {m.describe()}: `{m.after.strip()}` by {test}' for m, verdict, test in results if verdict == 'killed']
    return '\n'.join(lines) + '\n', lines[2], share, len(unexplained)


def main():
    parser = argparse.ArgumentParser(prog='./dev mutate', description=__doc__.splitlines()[0])
    parser.add_argument('--count', type=int, default=300, help='mutants to judge (default: 300)')
    parser.add_argument('--seed', type=int, default=1, help='of the sample (default: 1)')
    parser.add_argument('--folder', choices=FOLDERS, action='append', help='only of this folder of analyzer/, or of the finders of rules')
    parser.add_argument('--file', action='append', help='only of this file, as in analyzer/flow/graph.cpp')
    parser.add_argument('--jobs', type=int, default=2, help='mutants at a time (default: 2)')
    parser.add_argument('--minutes', type=float, default=28, help='begin no mutant after this time (default: 28)')
    options = parser.parse_args()

    began = time.monotonic()
    root = Path(__file__).resolve().parents[2]
    folder = root / 'build' / 'mutate'
    folder.mkdir(parents=True, exist_ok=True)
    base = Base(root, folder, options.jobs)
    suites = Suites(base.source / 'tests', base.build / 'maclint_tests')
    workers = [Worker(base, suites, folder / f'worker{i}') for i in range(options.jobs)]
    workers[0].measure()
    for worker in workers[1:]:
        worker.limits = workers[0].limits

    texts = {str(path.relative_to(base.source)): path.read_text()
             for path in sorted([*(base.source / 'analyzer').rglob('*.[ch]pp'),
                                *(base.source / 'rules').rglob('*_finder.[ch]pp')])}
    enums = mutants.enums_of(texts.values())
    files = [file for file in texts if folder_of(file) in (options.folder or FOLDERS) and file.endswith('.cpp')
             and (not options.file or file in options.file)]
    found = [mutant for file in files for mutant in mutants.mutants_of(file, texts[file], enums)]
    order = mutants.sample(found, options.seed, folder_of)
    seconds = max(0.0, options.minutes * 60 - (time.monotonic() - began))
    results = judge_all(order, workers, options.count, seconds)
    text, summary, share, unexplained = report(results, read_explanations(Path(__file__).with_name('survivors.md')),
                                               options.seed, time.monotonic() - began)
    (folder / 'report.md').write_text(text)
    print(summary)
    print(f'The report is in {(folder / "report.md").relative_to(root)}.')
    return 0 if share >= LEAST_KILLED else 1


if __name__ == '__main__':
    sys.exit(main())
