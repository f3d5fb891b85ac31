"""Fetches what maclint is built from besides its own files, for builds that take no header of the system.

pip fetches it, from the index it is set up for; sources.txt names versions and hashes. A folder then holds
include/nlohmann, include/CLI, tree-sitter/ and licences/.
"""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

LIST = pathlib.Path(__file__).with_name("sources.txt")


def first_comment(header: str) -> str:
    """The comment that a header begins with, without its slashes: CLI11 has its licence there."""
    lines = []
    for line in header.splitlines():
        if not line.startswith("//"):
            break
        lines.append(line[2:].strip())
    return "\n".join(lines) + "\n"


def members(archive: pathlib.Path):
    """Path and bytes of each file of a wheel or a source archive; the latter without its outermost folder."""
    if archive.suffix == ".whl":
        with zipfile.ZipFile(archive) as packed:
            for name in packed.namelist():
                yield pathlib.PurePosixPath(name), packed.read(name)
    else:
        with tarfile.open(archive) as packed:
            for member in packed:
                if member.isfile():
                    yield pathlib.PurePosixPath(*pathlib.PurePosixPath(member.name).parts[1:]), packed.extractfile(member).read()


def place(name: str, path: pathlib.PurePosixPath):
    """Where a file of the package `name` goes, or None: most of them are not needed."""
    parts = path.parts
    if name == "nlohmann_json" and parts[:2] == ("nlohmann_json", "include") and path.suffix == ".hpp":
        return pathlib.PurePosixPath(*parts[1:])
    if name == "nlohmann_json" and "licenses" in parts:
        return pathlib.PurePosixPath("licences/nlohmann-json.txt")
    if name == "tree_sitter" and parts[:3] == ("tree_sitter", "core", "lib"):
        return pathlib.PurePosixPath("tree-sitter", *parts[2:])
    if name == "tree_sitter" and parts == ("LICENSE",):
        return pathlib.PurePosixPath("licences/tree-sitter.txt")
    if name == "highspy" and parts[-1] == "CLI11.hpp":
        return pathlib.PurePosixPath("include/CLI/CLI.hpp")
    return None


def unpack(archives: pathlib.Path, folder: pathlib.Path) -> None:
    for archive in sorted(archives.iterdir()):
        name = archive.name.split("-" if archive.suffix == ".whl" else ".tar")[0].rsplit("-", 1)[0].replace("-", "_")
        for path, content in members(archive):
            wanted = place(name, path)
            if wanted is not None:
                target = folder / wanted
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
    header = folder / "include/CLI/CLI.hpp"
    (folder / "licences/cli11.txt").write_text(first_comment(header.read_text(encoding="utf-8")), encoding="utf-8")


def own_environment(environment) -> dict[str, str]:
    """Without what a pip that runs the build backend tells it: a pip below would take that for its own."""
    return {name: value for name, value in environment.items() if not name.startswith(("_PYPROJECT_HOOKS_", "PEP517_"))}


def missing(folder: pathlib.Path) -> list[str]:
    wanted = ["include/nlohmann/json.hpp", "include/CLI/CLI.hpp", "tree-sitter/lib/src/lib.c",
              "licences/nlohmann-json.txt", "licences/tree-sitter.txt"]
    return [path for path in wanted if not (folder / path).is_file()]


def fetch(folder: pathlib.Path) -> None:
    """Fills the folder; does nothing when it was filled from the same list before."""
    stamp = folder / "list.sha256"
    listed = hashlib.sha256(LIST.read_bytes() + pathlib.Path(__file__).read_bytes()).hexdigest()
    if stamp.is_file() and stamp.read_text() == listed:
        return
    with tempfile.TemporaryDirectory() as scratch:
        # Without build isolation: pip only asks the archives for their names, which takes no more than their build tools.
        subprocess.run([sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--require-hashes", "--no-build-isolation",
                        "--disable-pip-version-check", "--dest", scratch, "--requirement", str(LIST)],
                       check=True, stdout=sys.stderr, env=own_environment(os.environ))
        partial = folder.with_name(folder.name + ".partial")
        shutil.rmtree(partial, ignore_errors=True)
        partial.mkdir(parents=True)
        unpack(pathlib.Path(scratch), partial)
    if missing(partial):
        sys.exit(f"fetch_sources: the archives no longer hold {', '.join(missing(partial))}. See packaging/sources.txt.")
    (partial / "list.sha256").write_text(listed)
    shutil.rmtree(folder, ignore_errors=True)
    partial.rename(folder)


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=pathlib.Path)
    fetch(arguments.parse_args().folder)
