#!/usr/bin/env python3
"""Runs fuzz targets side by side, so many seconds each, and says what came of it; status 1 when one found a
defect, 2 when there is no such target.

usage: run.py --build BUILD [--jobs N] [--seconds N] [--seed N] [TARGET...]

What libFuzzer learns stays in BUILD/fuzz/corpus/TARGET for the next run, unless that has a seed, which is to find the
same each time; inputs that show a defect go to BUILD/fuzz/finds, the logs to BUILD/fuzz/log.
"""
import argparse
import base64
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
LIMITS = ("-timeout=60", "-rss_limit_mb=3072", "-max_len=4096", "-print_final_stats=1", "-verbosity=1")


def targets(wanted):
    known = sorted(path.stem for path in HERE.glob("*.cpp"))
    unknown = [name for name in wanted if name not in known]
    if unknown:
        print(f"fuzz: there is no target {', '.join(unknown)}; known are {', '.join(known)}", file=sys.stderr)
        sys.exit(2)
    return wanted or known


def as_text(find):
    """What makes the file again from the log: the files of a CI service's machine are gone with it."""
    return f"printf %s {base64.b64encode(find.read_bytes()).decode()} | base64 -d >{find.name}"


def run(name, arguments):
    """The verdict on one target and whether it found nothing."""
    work = arguments.build / "fuzz"
    corpus, finds, log = work / "corpus" / name, work / "finds", work / "log" / name
    if arguments.seed is not None:
        corpus = work / "seeded" / name
        shutil.rmtree(corpus, ignore_errors=True)
    for folder in (corpus, finds, log.parent):
        folder.mkdir(parents=True, exist_ok=True)
    command = [
        arguments.build / "sanitize" / f"fuzz_{name}",
        *LIMITS,
        f"-max_total_time={arguments.seconds}",
        *([f"-seed={arguments.seed}"] if arguments.seed is not None else []),
        f"-dict={work / 'words.dict'}",
        f"-artifact_prefix={finds / name}-",
        corpus,
        work / "seeds" / name,
    ]
    with log.open("wb") as out:
        status = subprocess.run(command, stdout=out, stderr=out, check=False).returncode
    text = log.read_text(encoding="utf-8", errors="replace")
    executed = re.search(r"number_of_executed_units: (\d+)", text)
    count = executed.group(1) if executed else "an unknown number of"
    if status == 0:
        return f"{name:16} {count} executions, no defect", True
    said = [line for line in text.splitlines() if re.search(r"DEFECT|ERROR|SUMMARY|runtime error|Test unit", line)]
    written = [pathlib.Path(path) for path in re.findall(r"Test unit written to (.+)$", text, re.M)]
    found = [as_text(path) for path in written if path.is_file()]
    if found:
        found.insert(0, f"This makes the file, which build/sanitize/fuzz_{name} FILE runs again:")
    return "\n    ".join([f"{name:16} DEFECT after {count} executions (log: {log})", *said, *found]), False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=lambda text: pathlib.Path(text).resolve(), required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--seed", type=int, help="what libFuzzer's dice begin with; by chance when it is left out")
    parser.add_argument("targets", nargs="*")
    arguments = parser.parse_args()
    names = targets(arguments.targets)
    shutil.rmtree(arguments.build / "fuzz/seeds", ignore_errors=True)
    subprocess.run([sys.executable, "-B", HERE / "seeds.py", arguments.build / "fuzz"], check=True)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(lambda name: run(name, arguments), names))
    for verdict, _ in results:
        print(verdict)
    sys.exit(0 if all(fine for _, fine in results) else 1)


main()
