"""Writes a Python wheel that holds one executable: pip puts it where scripts go."""
import argparse
import base64
import hashlib
import pathlib
import struct
import sys

from archive import EXECUTABLE, Entry, write_zip
from project_version import ROOT, version

TAGS = {
    "linux-x86_64": "py3-none-manylinux_2_17_x86_64.musllinux_1_1_x86_64",
    "linux-aarch64": "py3-none-manylinux_2_17_aarch64.musllinux_1_1_aarch64",
    "windows-x86_64": "py3-none-win_amd64",
}
MACHINES = {"linux-x86_64": 62, "linux-aarch64": 183}
SUMMARY = "Finds mistakes in NC programs before the control does"


def elf_fault(executable: bytes, machine: int) -> str | None:
    """Why an executable does not run on every Linux of the machine: it is for another one, or needs libraries."""
    if executable[:6] != b"\x7fELF\x02\x01":
        return "it is no 64-bit Linux executable"
    if struct.unpack_from("<H", executable, 18)[0] != machine:
        return "it is for another processor"
    headers, = struct.unpack_from("<Q", executable, 32)
    size, count = struct.unpack_from("<HH", executable, 54)
    kinds = {struct.unpack_from("<I", executable, headers + size * i)[0] for i in range(count)}
    return "it needs libraries of the system: it is not linked statically" if {2, 3} & kinds else None


def fault(executable: bytes, system: str) -> str | None:
    if system == "windows-x86_64":
        return None if executable[:2] == b"MZ" else "it is no Windows executable"
    return elf_fault(executable, MACHINES[system])


def tags(tag: str) -> list[str]:
    """py3-none-a.b stands for py3-none-a and py3-none-b."""
    python, abi, platforms = tag.split("-")
    return [f"{python}-{abi}-{platform}" for platform in platforms.split(".")]


def metadata() -> bytes:
    lines = ["Metadata-Version: 2.1", "Name: maclint", f"Version: {version()}", f"Summary: {SUMMARY}", "License: MIT",
             "Requires-Python: >=3.9", "Description-Content-Type: text/markdown", "",
             (ROOT / "docs/install.md").read_text(encoding="utf-8")]
    return "\n".join(lines).encode()


def record_row(entry: Entry) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(entry.content).digest()).rstrip(b"=").decode()
    return f"{entry.name},sha256={digest},{len(entry.content)}"


def entries(executable: bytes, system: str, licences: dict[str, bytes]) -> list[Entry]:
    name = f"maclint-{version()}"
    program = "maclint.exe" if system.startswith("windows") else "maclint"
    wheel = ["Wheel-Version: 1.0", "Generator: maclint", "Root-Is-Purelib: false"] + [f"Tag: {tag}" for tag in tags(TAGS[system])]
    found = [Entry(f"{name}.data/scripts/{program}", executable, EXECUTABLE), Entry(f"{name}.dist-info/METADATA", metadata()),
             Entry(f"{name}.dist-info/WHEEL", ("\n".join(wheel) + "\n").encode())]
    found += [Entry(f"{name}.dist-info/licenses/{title}", text) for title, text in sorted(licences.items())]
    rows = [record_row(entry) for entry in found] + [f"{name}.dist-info/RECORD,,"]
    return found + [Entry(f"{name}.dist-info/RECORD", ("\n".join(rows) + "\n").encode())]


def write_wheel(executable: pathlib.Path, system: str, licences: pathlib.Path | None, out: pathlib.Path) -> pathlib.Path:
    content = executable.read_bytes()
    why = fault(content, system)
    if why is not None:
        sys.exit(f"wheel: {executable} cannot go into a wheel for {system}: {why}.")
    texts = {"LICENSE": (ROOT / "LICENSE").read_bytes()}
    if licences is not None:
        texts.update({path.name: path.read_bytes() for path in licences.glob("*.txt")})
    path = out / f"maclint-{version()}-{TAGS[system]}.whl"
    write_zip(path, entries(content, system, texts))
    return path


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--executable", type=pathlib.Path, required=True)
    parser.add_argument("--system", choices=TAGS, required=True)
    parser.add_argument("--licences", type=pathlib.Path, help="folder with the licences of what is linked in")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."))
    given = parser.parse_args()
    print(write_wheel(given.executable, given.system, given.licences, given.out))
