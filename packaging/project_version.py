"""The version, which stands in CMakeLists.txt alone."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent


def version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(maclint VERSION ([0-9.]+)", text, re.MULTILINE).group(1)
