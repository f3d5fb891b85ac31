"""`./dev bench growth`: time and memory on programs made to hurt, at n and 2n.

Each row makes one kind of program, doubles it until a run takes half a second or the text is long enough, doubles it
once more and prints how time and memory have grown. A ratio of 2 is linear; the run fails above 2.2, but not where
the longest text is done before half a second of processor time.
"""
import argparse
import os
import random
import resource
import subprocess
import sys
import tempfile

LIMIT = 2.2
ENOUGH = 0.5           # seconds of processor time
MOST_BYTES = 2_000_000
MOST_SECONDS = 60


def lines(n, *texts):
    return ''.join(text.format(i=i, j=i + 1, k=i % 900 + 1) for i in range(1, n + 1) for text in texts)


def program(body, end='M30\n'):
    return '%\nO1\n' + body + end + '%\n'


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
    ('unknown words in a comment', 2000, 'concise', lambda n: program('(MACLINT ALLOW ' + lines(n, 'ZZ{i}Z ') + ')\n')),
]


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 1))


def run(maclint, made, form):
    """Seconds of processor time, megabytes, bytes of text."""
    files = made if isinstance(made, dict) else {'x.ncs' if made.startswith('MACHINING') else 'x.nc': made}
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(os.path.join(folder, '.git'))  # nothing outside is read
        for name, text in files.items():
            with open(os.path.join(folder, name), 'w', encoding='latin-1', newline='') as file:
                file.write(text)
        command = [maclint, 'check', '--isolated', '--jobs', '1', '--format', form]
        command += ['--dialect', 'dinplus' if 'x.ncs' in files else 'fanuc', '.']
        process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   preexec_fn=limits)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1):
        raise RuntimeError(f'maclint ended with {process.returncode}')
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, sum(map(len, files.values()))


def main():
    options = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    options.add_argument('--maclint', default='build/maclint', help='the executable')
    options.add_argument('--only', default='', help='only kinds with this in their name')
    chosen = options.parse_args()
    maclint = os.path.abspath(chosen.maclint)
    too_steep = 0
    print(f'{"":38}{"kB":>7}{"s":>8}{"MB":>7}   time and memory from n to 2n')
    for name, n, form, make in KINDS:
        if chosen.only not in name:
            continue
        try:
            before = run(maclint, make(n), form)
            while True:
                n *= 2
                now = run(maclint, make(n), form)
                if before[0] >= ENOUGH or now[2] >= MOST_BYTES:
                    break
                before = now
        except RuntimeError as error:
            print(f'{name:38}{error}, n = {n}')
            too_steep += 1
            continue
        grown = now[0] / before[0], now[1] / before[1]
        steep = now[0] >= ENOUGH and grown[0] > LIMIT
        too_steep += steep
        print(f'{name:38}{now[2] / 1e3:7.0f}{now[0]:8.2f}{now[1]:7.0f}   {grown[0]:.2f}  {grown[1]:.2f}'
              f'{"  TOO STEEP" if steep else ""}', flush=True)
    return 1 if too_steep else 0


if __name__ == '__main__':
    sys.exit(main())
