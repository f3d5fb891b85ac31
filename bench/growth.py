"""`./dev bench growth`: how time and memory grow with programs made to hurt.

Each row makes one kind of program and doubles it until a run takes half a second of processor time, then measures
that size and the next three, each of them the least of three runs. Printed are what the largest took, the three
ratios from one size to the next, the ratio that would give the same growth each time, and that of the memory. A
ratio of 2 is linear; the run fails where the even one is above 2.2. The time is maclint's own; what the system took
(for files, and for memory, where a virtual machine pays much for the first touch of each page) stands beside it.
"""
import argparse
import contextlib
import os
import random
import resource
import subprocess
import sys
import tempfile

LIMIT = 2.2
ENOUGH = 0.5           # seconds of maclint's own processor time
SIZES = 4
RUNS = 3               # of each size; the least counts
MOST_SECONDS = 60


def lines(n, *texts):
    return ''.join(text.format(i=i, j=i + 1, k=i % 900 + 1) for i in range(1, n + 1) for text in texts)


def program(body, end='M30\n'):
    return '%\nO1\n' + body + end + '%\n'


def chain(operation, operands):
    return operation.join(f'[{operand}]' for operand in operands)


def ors(n, block, last='N9\n', first=0):
    """So many blocks with an OR of 120 comparisons each, which go on counting from `first` times the block's number."""
    return program(''.join(block.format(any=chain('OR', (f'#100EQ{i + first * k}' for i in range(120))), k=k)
                           for k in range(n)) + last)


def jumps_at_random(n):
    choose = random.Random(n)
    return program(lines(400, '#{k}=1\n') + ''.join(
        f'N{i}#{choose.randint(100, 499)}=#{choose.randint(100, 499)}+1\n'
        f'IF[#{choose.randint(500, 599)}EQ1]GOTO{choose.randint(1, n)}\n' for i in range(1, n + 1)))


def calls_at_random(n):
    choose = random.Random(n)
    return '%\n' + ''.join(f'O{i}\nM98P{choose.randint(1, n)}\nM98P{choose.randint(1, n)}\nM99\n'
                           for i in range(1, n + 1)) + '%\n'


def subprograms(n, first, each, last):
    return 'MACHINING\n' + first + 'M30\n' + ''.join(
        f'SUBPROGRAM "S{i}"\n' + each.format(i=i, j=i + 1) + 'RETURN\n' for i in range(n)) + last


def namesakes(n):
    files = {f'a{i}.nc': '%\nO100\nG91G1X1.F100\nM99\n%\n' for i in range(n)}
    files.update({f'b{i}.nc': f'%\nO{1000 + i}\nM98P100\nG1X1.\nM30\n%\n' for i in range(n)})
    return files


# name, first n, format of the report, what makes it (a text, or a text for each file's name); DIN PLUS by MACHINING
KINDS = [
    ('one long line', 500, 'text', lambda n: program(lines(n, 'G0X{i}.;GOTO99999;'))),
    ('labels of M99 P', 500, 'concise', lambda n: '%\nO1\n' + lines(n, 'N{i}M98P2\n') + 'M30\nO2\n' +
     lines(n, 'IF[#500EQ{i}]GOTO{i}\n') + 'M99\n' + lines(n, 'N{i}M99P{i}\n') + '%\n'),
    ('every program calls the first', 500, 'concise', lambda n: '%\n' + lines(n, 'O{i}\nM98P{j}\nM98P1\nM99\n') + '%\n'),
    ('a call of itself in each line', 4000, 'concise', lambda n: program(lines(n, 'M98P1\n'))),
    ('calls at random', 2000, 'concise', calls_at_random),
    ('programs of one number with callers', 250, 'concise', namesakes),
    ('jumps at random over 400 variables', 1000, 'concise', jumps_at_random),
    ('blocks that may be skipped', 10000, 'concise', lambda n: program(lines(n, '/G0X1\n'))),
    ('compensation and tools', 1000, 'concise', lambda n: 'MACHINING\n' + lines(n, 'G41\nT1\n') + 'M30\nEND\n'),
    ('findings with a path each', 2000, 'concise', lambda n: program(
        lines(n, 'IF[#500EQ1]GOTO7\n') + 'N7\n' + lines(n, '#{k}=#33\n'))),
    ('findings with a path each, SARIF', 2000, 'sarif', lambda n: program(
        lines(n, 'IF[#500EQ1]GOTO7\n') + 'N7\n' + lines(n, '#{k}=#33\n'))),
    ('computed jumps and labels', 1000, 'concise', lambda n: program(lines(n, 'N{i}GOTO#500\n'))),
    ('variables handed down along a chain', 250, 'concise', lambda n: subprograms(
        n, 'L"S0" V1\n', ''.join(f'#l{k}(200)\n' for k in range(1, 21)) + 'L"S{j}" V1\n',
        f'SUBPROGRAM "S{n}"\nRETURN\nEND\n')),
    ('programs without a block', 10000, 'concise', lambda n: '%\n' + lines(n, 'O{i}\n') + '%\n'),
    ('tests for vacancy', 2000, 'concise', lambda n: program(lines(n, '#{k}=1\nIF[#{k}EQ#0]GOTO9\n') + 'N9\n')),
    ('values saved and put back', 1000, 'concise', lambda n: program(lines(n, '#1=#4003\n#1=5\nG#1\n'), 'M99\n')),
    ('the same OR in each IF', 100, 'concise', lambda n: ors(n, 'IF[{any}]GOTO9\n')),
    ('another OR in each IF', 100, 'concise', lambda n: ors(n, 'IF[{any}]GOTO9\n', '#1=1\nN9G0X#1\n', first=120)),
    ('the same OR in each IF with THEN', 100, 'concise', lambda n: ors(n, 'IF[{any}]THEN#1={k}\n', 'N9G0X#1\n')),
    ('another OR in each IF with THEN', 100, 'concise', lambda n: ors(
        n, 'IF[{any}]THEN#1={k}\n', 'N9G0X#1\n', first=120)),
    ('the same OR in each WHILE', 50, 'concise', lambda n: ors(
        n, 'WHILE[{any}]DO1\n#100=#100+1\nEND1\n', 'N9G0X#1\n')),
    ('ORs of tests for vacancy', 100, 'concise', lambda n: program(
        ('IF[' + chain('OR', (f'#{100 + i}EQ#0' for i in range(120))) + ']GOTO9\n') * n + 'N9\n')),
    ('ORs that repeat their operand', 100, 'concise', lambda n: program(
        ('IF[' + chain('OR', ['#100EQ1'] * 120) + ']GOTO9\n') * n + 'N9\n')),
    ('the same IF in a row', 1000, 'concise', lambda n: program(lines(n, 'IF[#500EQ1]THEN#1={i}\n'))),
    ('each IF twice', 1000, 'concise', lambda n: program(
        lines(n, 'IF[#{k}EQ1]THEN#1={i}\nIF[#{k}EQ1]THEN#1={j}\n'))),
    ('conditional stores overwritten', 1000, 'concise', lambda n: program(
        lines(n, 'IF[#500EQ{i}]THEN#{k}=1\n') + lines(n, '#{k}=2\n'))),
    ('names that nothing sets', 10000, 'concise', lambda n: 'MACHINING\n' + lines(n, '#l1=#x{i}+1\n') + 'M30\nEND\n'),
    ('names that are set and read', 5000, 'concise', lambda n: program(
        lines(n, '#<NAME{i}>={i}\n') + lines(n, 'G0X#<NAME{i}>\n'))),
    ('calls of computed programs', 5000, 'concise', lambda n: '%\n' + lines(n, 'O{i}\nG65P#1A1\nM99\n') + '%\n'),
    ('stores through a variable', 5000, 'concise', lambda n: program(lines(n, '#[#{k}]=#[#{k}]+1\n'))),
    ('unknown words in a comment', 2000, 'concise', lambda n: program('(MACLINT ALLOW ' + lines(n, 'ZZ{i}Z ') + ')\n')),
]


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 1))


def run(maclint, folder, name, form, *more):
    """Seconds of processor time of its own, those of the system for it, and megabytes."""
    command = [maclint, 'check', '--isolated', '--jobs', '1', '--format', form, *more]
    command += ['--dialect', 'dinplus' if name == 'x.ncs' else 'fanuc', '.']
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               preexec_fn=limits)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1):
        raise RuntimeError(f'maclint ended with {process.returncode}')
    return used.ru_utime, used.ru_stime, used.ru_maxrss / 1024


@contextlib.contextmanager
def folder_with(files):
    """A folder that holds the texts of programs by their names, as long as it is wanted."""
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(os.path.join(folder, '.git'))  # nothing outside is read
        for name, text in files.items():
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            with open(os.path.join(folder, name), 'w', encoding='latin-1', errors='replace', newline='') as file:
                file.write(text)
        yield folder


def measure(maclint, made, form):
    """The least of some runs: both seconds, megabytes, bytes of text. One run is enough to see that a size is too
    small."""
    files = made if isinstance(made, dict) else {'x.ncs' if made.startswith('MACHINING') else 'x.nc': made}
    with folder_with(files) as folder:
        first = run(maclint, folder, next(iter(files)), form)
        more = RUNS - 1 if first[0] >= ENOUGH else 0
        runs = [first] + [run(maclint, folder, next(iter(files)), form) for _ in range(more)]
    return min(runs) + (sum(map(len, files.values())),)


def sizes_of(maclint, n, make, form):
    """What is measured of so many sizes, each twice the one before."""
    found = []
    while len(found) < SIZES:
        now = measure(maclint, make(n), form)
        if found or now[0] >= ENOUGH:
            found.append(now)
        n *= 2
    return found


def main():
    options = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    options.add_argument('--maclint', default='build/maclint', help='the executable')
    options.add_argument('--only', default='', help='only kinds with this in their name')
    chosen = options.parse_args()
    maclint = os.path.abspath(chosen.maclint)
    too_steep = 0
    print(f'{"":38}{"kB":>7}{"s":>8}{"system":>8}{"MB":>7}   time from size to size   even  memory')
    for name, n, form, make in KINDS:
        if chosen.only not in name:
            continue
        try:
            sizes = sizes_of(maclint, n, make, form)
        except RuntimeError as error:
            print(f'{name:38}{error}')
            too_steep += 1
            continue
        steps = len(sizes) - 1
        ratios = '  '.join(f'{sizes[i + 1][0] / sizes[i][0]:.2f}' for i in range(steps))
        even, memory = ((sizes[-1][part] / sizes[0][part]) ** (1 / steps) for part in (0, 2))
        steep = even > LIMIT
        too_steep += steep
        seconds, system, megabytes, text = sizes[-1]
        print(f'{name:38}{text / 1e3:7.0f}{seconds:8.2f}{system:8.2f}{megabytes:7.0f}   {ratios:24}{even:.2f}  {memory:.2f}'
              f'{"  TOO STEEP" if steep else ""}', flush=True)
    return 1 if too_steep else 0


if __name__ == '__main__':
    sys.exit(main())
