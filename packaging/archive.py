"""Zip files whose bytes depend on nothing but what is in them: wheels, and the archive for Windows."""
import pathlib
import stat
import zipfile
from typing import NamedTuple

PLAIN = 0o644
EXECUTABLE = 0o755


class Entry(NamedTuple):
    """A file of an archive."""
    name: str
    content: bytes
    mode: int = PLAIN


def write_zip(path: pathlib.Path, entries: list[Entry]) -> None:
    """Writes the entries in their order, without times; whole or not at all."""
    partial = path.with_name(path.name + ".partial")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as packed:
        for entry in entries:
            info = zipfile.ZipInfo(entry.name, (1980, 1, 1, 0, 0, 0))
            info.create_system = 3  # Unix: pip and unzip then take the mode from the entry
            info.external_attr = (stat.S_IFREG | entry.mode) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(info, entry.content)
    partial.replace(path)


def entries_below(folder: pathlib.Path, prefix: str) -> list[Entry]:
    """All files of a folder, with their paths behind the prefix."""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    return [Entry(f"{prefix}/{path.relative_to(folder).as_posix()}", path.read_bytes()) for path in files]
