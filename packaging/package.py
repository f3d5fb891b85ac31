"""Makes what ./dev package leaves in build/packages, from executables that are built, and tries each package."""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import trial
from archive import EXECUTABLE, Entry, entries_below, write_zip
from project_version import ROOT, version
from wheel_writer import fault, write_wheel


def run(*command, **options) -> None:
    subprocess.run([str(word) for word in command], check=True, stdout=sys.stderr, **options)


def pack(build: pathlib.Path, generators: str, out: pathlib.Path) -> None:
    """CPack's archives of a build; the date of the last commit stands in them, so that the same commit gives the same bytes."""
    date = subprocess.run(["git", "-C", str(ROOT), "log", "-1", "--format=%ct"], capture_output=True, text=True).stdout.strip()
    environment = {**os.environ, **({"SOURCE_DATE_EPOCH": date} if date else {})}
    with tempfile.TemporaryDirectory() as scratch:
        run("cpack", "-G", generators, "-B", scratch, "--config", build / "CPackConfig.cmake", env=environment)
        for package in pathlib.Path(scratch).iterdir():
            if package.is_file():
                shutil.move(str(package), out / package.name)


def stage(build: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    """What the build installs; gives the folder of its documents."""
    run("cmake", "--install", build, "--prefix", folder)
    return folder / "share/doc/maclint"


def windows_zip(executable: pathlib.Path, staged: pathlib.Path, licences: pathlib.Path | None, out: pathlib.Path) -> pathlib.Path:
    """The executable, and of the staged files what is the same on every system; not the licences of another system's libraries."""
    content = executable.read_bytes()
    why = fault(content, "windows-x86_64")
    if why is not None:
        sys.exit(f"package: {executable} cannot go into the archive for Windows: {why}.")
    name = f"maclint-{version()}-windows-x86_64"
    documents = staged / "share/doc/maclint"
    found = [Entry(f"{name}/maclint.exe", content, EXECUTABLE)]
    found += [Entry(f"{name}/{path.name}", path.read_bytes()) for path in sorted(documents.iterdir()) if path.is_file()]
    found += entries_below(documents / "docs", f"{name}/docs")
    found += entries_below(staged / "share/maclint", name)
    if licences is not None:
        found += entries_below(licences, f"{name}/licences")
    path = out / f"{name}.zip"
    write_zip(path, found)
    return path


def write_sums(out: pathlib.Path) -> None:
    packages = sorted(path for path in out.iterdir() if path.name.startswith("maclint") and path.is_file())
    rows = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in packages]
    (out / "SHA256SUMS").write_text("".join(rows))


def make(given: argparse.Namespace, out: pathlib.Path, scratch: pathlib.Path) -> None:
    pack(given.x86_64, "TGZ;DEB", out)
    documents = stage(given.x86_64, scratch / "x86_64")
    write_wheel(scratch / "x86_64/bin/maclint", "linux-x86_64", documents / "licences", out)
    if given.aarch64 is not None:
        pack(given.aarch64, "TGZ", out)
        documents = stage(given.aarch64, scratch / "aarch64")
        write_wheel(scratch / "aarch64/bin/maclint", "linux-aarch64", documents / "licences", out)
    if given.windows is not None:
        windows_zip(given.windows, scratch / "x86_64", given.windows_licences, out)
        write_wheel(given.windows, "windows-x86_64", given.windows_licences, out)
    write_sums(out)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--x86_64", type=pathlib.Path, required=True, metavar="BUILD", help="folder of the static build")
    parser.add_argument("--aarch64", type=pathlib.Path, metavar="BUILD", help="folder of the static build for ARM")
    parser.add_argument("--windows", type=pathlib.Path, metavar="EXE", help="maclint.exe")
    parser.add_argument("--windows-licences", type=pathlib.Path, metavar="DIR", help="licences of what maclint.exe holds")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    given = parser.parse_args()
    shutil.rmtree(given.out, ignore_errors=True)
    given.out.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as scratch:
        make(given, given.out.resolve(), pathlib.Path(scratch))
    trial.try_all(given.out.resolve())
    print(f"packages: {given.out}")


if __name__ == "__main__":
    main()
