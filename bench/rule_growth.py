"""`./dev bench rules`: whether what a rule does grows faster than the programs that it looks at.

Every example of every rule's page, good and bad, is repeated: as so many programs of one file, as so many parts of
one program, and as parts that may be skipped, with one of some other blocks behind each: two rules are slow together
that are quick alone. The number is doubled until a run of all rules takes long enough to be measured, and once more:
a ratio of 2 is linear. The memory behind the processor's caches makes up to 2.6 of it; beyond that the run fails and
names the page. It takes some fifteen minutes.
"""
import argparse
import concurrent.futures
import functools
import os
import re
import subprocess
import sys
import tempfile

from growth import folder_with, run

LIMIT = 2.6
ENOUGH = 0.3    # seconds of processor time
FIRST = 500     # copies
MOST = 64000
RUNS = 3        # where the first ones are too steep; the least counts
FURTHER = 1000  # from the sequence numbers of one copy to those of the next

# What stands behind each part, by language; N991 is free there.
OTHERS = {
    'fanuc': ['IF[#1EQ7]THEN#3000=1(X)', '/M99', '/M30', '#1=#2+5\n#1=#3+6', 'M98P9001', 'G65P9001A1.', 'GOTO#1\nN991',
              'WHILE[#1LT5]DO1\n#1=#1+1\nEND1', '#[#1]=#[#2+1]', '#150=#151+#3', 'IF[#1EQ#0]GOTO991\n#1=1\nN991',
              'G90G1X#1F100', 'IF[#1LE0]GOTO991\n#3=5/#1\nN991', '#150=#4003\nG#150', '#151=#5041'],
    'dinplus': ['IF #l1==7\nTHEN\nM0\nENDIF', '#l1=#l2+5\n#l1=#l3+6', 'L"S9001" V1', 'WHILE #l1<5\n#l1=#l1+1\nENDWHILE',
                'G41', 'G1 X#l1', '#g1=#l2', 'T1', 'INPUT("X",#l1)', 'IF NDEF(#l1)\nTHEN\n#l1=1\nENDIF'],
}


def examples(maclint, folder):
    """Name of the page, language and text of each example."""
    subprocess.run([maclint, 'rules', '--write-docs', folder], check=True, stdout=subprocess.DEVNULL)
    for page in sorted(os.listdir(folder)):
        with open(os.path.join(folder, page), encoding='utf-8') as file:
            text = file.read()
        for kind, language, example in re.findall(r'^## (Bad|Good) \((\w+)[^)]*\)\n\n```\n(.*?)```', text, re.M | re.S):
            yield f'{page.removesuffix(".md")} {kind.lower()}', language, example


def as_programs(text, _language, n):
    """So many copies, each with program numbers of its own; nothing where programs have none."""
    if not re.search(r'^O\d', text, re.M):
        return None
    numbered = re.compile(r'(?<![A-Z(])([OP])(\d{1,5})\b')
    return ''.join(numbered.sub(lambda found: f'{found[1]}{(int(found[2]) * n + i) % 10**8}', text) for i in range(n))


def parts_of(text, language):
    """Lines before the body of the first program, its body, and what comes after."""
    lines = text.strip('\n').split('\n')
    begins, ends = (r'(N\d+ *)?MACHINING', r'\bM30\b|^END|^SUBPROGRAM|\bRETURN\b') if language == 'dinplus' else (
        r'O\d', r'M30|M99|^O\d|^%')
    first = next((i + 1 for i, line in enumerate(lines) if re.match(begins, line)), 0)
    last = next((i for i, line in enumerate(lines) if i >= first and re.search(ends, line)), len(lines))
    return lines[:first], lines[first:last], lines[last:]


def as_one_program(text, language, n):
    """So many copies of the body; those of macro code with sequence numbers of their own."""
    head, body, tail = parts_of(text, language)
    if not body or (language == 'dinplus' and not head):
        return None
    copies = []
    numbered = re.compile(r'(^N|\bN|GOTO ?)(\d+)\b')
    for i in range(n):
        for line in body:
            copies.append(line if language == 'dinplus' else
                          numbered.sub(lambda found, i=i: f'{found[1]}{int(found[2]) + FURTHER * i}', line))
    return '\n'.join(head + copies + tail) + '\n'


def among_others(others, text, language, n):
    """So many copies of the body that may be skipped, and the other blocks behind each. Where it jumps to is in it."""
    head, body, tail = parts_of(text, language)
    if not body or (language == 'dinplus' and not head):
        return None
    if language == 'dinplus':
        return '\n'.join(head + (body + others.split('\n')) * n + tail) + '\n'
    targets = set(re.findall(r'(?<=GOTO)\d+', ''.join(body))) - set(re.findall(r'^N(\d+)', '\n'.join(body), re.M))
    part = ['/GOTO990'] + body + [f'N{target}' for target in sorted(targets)] + ['N990'] + others.split('\n')
    return as_one_program('\n'.join(head + part + ['M30', '%']), language, n)


def seconds(maclint, text, language):
    name = 'x.ncs' if language == 'dinplus' else 'x.nc'
    with folder_with({name: text}) as folder:
        return run(maclint, folder, name, 'concise', '--select', 'ALL')[0]


def growth(maclint, make, language):
    """Copies, seconds of so many and of twice as many."""
    n = FIRST
    once = seconds(maclint, make(n), language)
    while once < ENOUGH and n < MOST:
        n *= 2
        once = seconds(maclint, make(n), language)
    twice = seconds(maclint, make(2 * n), language)
    if twice > LIMIT * once:
        again = [(seconds(maclint, make(n), language), seconds(maclint, make(2 * n), language)) for _ in range(RUNS - 1)]
        once, twice = (min(first, *others) for first, *others in zip((once, twice), *again))
    return n, once, twice


def main():
    options = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    options.add_argument('--maclint', default='build/maclint', help='the executable')
    options.add_argument('--only', default='', help='only pages with this in their name')
    options.add_argument('--turn', type=int, default=0, help='another number: other blocks behind each part')
    options.add_argument('--jobs', type=int, default=1, help='runs side by side')
    chosen = options.parse_args()
    maclint = os.path.abspath(chosen.maclint)
    too_steep = measured = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(chosen.jobs) as pool:
        tasks = []
        for turn, (name, language, text) in enumerate(examples(maclint, folder), chosen.turn):
            if chosen.only not in name:
                continue
            others = OTHERS[language][turn % len(OTHERS[language])]
            for kind, make in (('programs', as_programs), ('one program', as_one_program),
                               ('behind ' + others.split('\n', maxsplit=1)[0], functools.partial(among_others, others))):
                if make(text, language, 1) is not None:
                    repeat = functools.partial(make, text, language)
                    tasks.append((name, kind, pool.submit(growth, maclint, repeat, language)))
        for name, kind, task in tasks:
            try:
                n, once, twice = task.result()
            except RuntimeError as error:
                print(f'{name:14}{kind:34}{error}', flush=True)
                too_steep += 1
                continue
            if twice < ENOUGH:
                continue
            measured += 1
            if twice > LIMIT * once:
                print(f'{name:14}{kind:34}{n:6} copies {once:6.2f} s, twice as many {twice:6.2f} s: '
                      f'{twice / once:.2f}  TOO STEEP', flush=True)
                too_steep += 1
    print(f'{len(tasks)} texts, {measured} of them long enough to be measured, {too_steep} too steep')
    return 1 if too_steep else 0


if __name__ == '__main__':
    sys.exit(main())
