"""Tries packages as their users do: unpacked, installed, run on a program with a finding and on one without."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import venv
import zipfile

from project_version import version

GOOD = "%\nO1000\nG0 X1.\nM30\n%\n"
BAD = "%\nO1001\nG0 X1.\nGOTO 99\nM30\n%\n"
INSTALLED = ["share/man/man1/maclint.1", "share/bash-completion/completions/maclint", "share/zsh/site-functions/_maclint",
             "share/fish/vendor_completions.d/maclint.fish", "share/maclint/maclint.schema.json",
             "share/maclint/grammars/fanuc/queries/highlights.scm", "share/maclint/grammars/dinplus/queries/highlights.scm",
             "share/maclint/grammars/sinumerik/queries/highlights.scm",
             "share/doc/maclint/LICENSE"] + [f"share/doc/maclint/licences/{name}.txt" for name in
                                             ("cli11", "nlohmann-json", "tree-sitter", "libstdc++", "glibc")]


def fail(message: str) -> None:
    sys.exit(f"trial: {message}")


def say(message: str) -> None:
    print(f"trial: {message}", file=sys.stderr)


def output(command: list, status: int = 0, **options) -> str:
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != status:
        fail(f"{command} ended with {done.returncode} instead of {status}:\n{done.stdout}{done.stderr}")
    return done.stdout


def broken_links(folder: pathlib.Path) -> list[str]:
    """Links of the pages below the folder that lead to no file."""
    found = []
    for page in sorted(folder.rglob("*.md")):
        for target in re.findall(r"\]\(([^)#]+)[^)]*\)", page.read_text(encoding="utf-8")):
            if not re.match(r"[a-z]+:", target) and not (page.parent / target).exists():
                found.append(f"{page.relative_to(folder)} links to {target}")
    return found


def try_pages(folder: pathlib.Path) -> None:
    if not (folder / "docs/use.md").is_file():
        fail(f"there is no docs/use.md in {folder}")
    broken = broken_links(folder)
    if broken:
        fail("; ".join(broken))


def try_program(command: list, folder: pathlib.Path) -> None:
    """The version, a program without and one with a finding; `folder` is where the command finds them."""
    if output(command + ["--version"]) != f"maclint {version()}\n":
        fail(f"{command} has another version than {version()}")
    (folder / "good.nc").write_text(GOOD)
    (folder / "bad.nc").write_text(BAD)
    output(command + ["check", "--isolated", "good.nc"], cwd=folder)
    found = output(command + ["check", "--isolated", "--format", "concise", "--quiet", "bad.nc"], status=1, cwd=folder)
    if "MAC301" not in found:
        fail(f"{command} finds no MAC301 but:\n{found}")


def try_archive(package: pathlib.Path, scratch: pathlib.Path) -> None:
    with tarfile.open(package) as packed:
        packed.extractall(scratch)
    folder = scratch / package.name.removesuffix(".tar.gz")
    lacking = [path for path in INSTALLED if not (folder / path).is_file()]
    if lacking:
        fail(f"{package.name} lacks {', '.join(lacking)}")
    try_pages(folder / "share/doc/maclint")
    emulator = ["qemu-aarch64"] if "aarch64" in package.name else []
    try_program(emulator + [folder / "bin/maclint"], scratch)


def try_debian(package: pathlib.Path, scratch: pathlib.Path) -> None:
    """lintian has no error; dpkg installs it into an empty root, in which it runs."""
    output(["lintian", "--fail-on", "error", package])
    root = scratch / "root"
    (root / "var/lib/dpkg/updates").mkdir(parents=True)
    (root / "var/lib/dpkg/info").mkdir()
    (root / "var/lib/dpkg/status").touch()
    output(["dpkg", f"--root={root}", "--force-not-root", "--log=/dev/null", "--install", package])
    if "ok installed" not in output(["dpkg-query", f"--admindir={root}/var/lib/dpkg", "--status", "maclint"]):
        fail(f"dpkg does not take {package.name} for installed")
    try_pages(root / "usr/share/doc/maclint")
    try_program([root / "usr/bin/maclint"], scratch)
    if os.geteuid() == 0:
        output(["chroot", root, "/usr/bin/maclint", "--version"])


def try_wheel(package: pathlib.Path, scratch: pathlib.Path) -> None:
    """pip takes it by its name from a folder, and the program stands where scripts do."""
    venv.create(scratch / "venv", with_pip=True)
    output([scratch / "venv/bin/python", "-m", "pip", "install", "--quiet", "--no-index", "--find-links", package.parent, "maclint"])
    try_program([scratch / "venv/bin/maclint"], scratch)


def try_foreign_wheel(package: pathlib.Path, scratch: pathlib.Path) -> None:
    """pip unpacks it for the system that it is for, which checks tags and RECORD as far as can be done here."""
    platform = package.stem.split("-")[-1].split(".")[0]
    output([sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--only-binary", ":all:", "--platform",
            platform, "--target", scratch / "target", "--find-links", package.parent, "maclint"])
    if not list((scratch / "target").rglob("bin/maclint*")):
        fail(f"{package.name} leaves no program")


def try_windows_zip(package: pathlib.Path, scratch: pathlib.Path) -> None:
    with zipfile.ZipFile(package) as packed:
        packed.extractall(scratch)
    try_pages(scratch / package.stem)
    program = scratch / package.stem / "maclint.exe"
    wine = shutil.which("wine")
    if wine is None:
        say("maclint.exe is not run: wine is not installed")
    else:
        try_program([wine, program], scratch)


def try_of(package: pathlib.Path):
    """The function that tries a package, or None for what is none."""
    if package.name.endswith(".tar.gz"):
        return try_archive
    if package.suffix == ".whl":
        return try_wheel if "linux" in package.stem and package.stem.endswith(os.uname().machine) else try_foreign_wheel
    return {".deb": try_debian, ".zip": try_windows_zip}.get(package.suffix)


def try_all(folder: pathlib.Path) -> None:
    output(["sha256sum", "--check", "--strict", "SHA256SUMS"], cwd=folder)
    for package in sorted(folder.iterdir()):
        attempt = try_of(package)
        if attempt is not None:
            with tempfile.TemporaryDirectory() as scratch:
                attempt(package, pathlib.Path(scratch))
            say(f"{package.name} works")


if __name__ == "__main__":
    try_all(pathlib.Path(sys.argv[1]).resolve())
