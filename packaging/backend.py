"""The build backend of pyproject.toml: scikit-build-core, given the sources that a machine with no more than a compiler lacks."""
import os
import shutil
import sys

import fetch_sources
from project_version import ROOT
from scikit_build_core import build as core
from scikit_build_core.build import (build_sdist, get_requires_for_build_sdist, get_requires_for_build_wheel,
                                     prepare_metadata_for_build_wheel)

__all__ = ["build_sdist", "build_wheel", "get_requires_for_build_sdist", "get_requires_for_build_wheel",
           "prepare_metadata_for_build_wheel"]

SOURCES = ROOT / "build" / "sources"


def require_compiler() -> None:
    if not any(shutil.which(name) for name in (os.environ.get("CXX", "").split(" ")[0], "c++", "g++", "clang++") if name):
        sys.exit("maclint is built from its source here, and there is no C++ compiler. Install g++ 12 or clang 15, or later "
                 "(Debian: apt-get install g++), or install one of the packages that docs/install.md names.")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    require_compiler()
    fetch_sources.fetch(SOURCES)
    settings = {"cmake.define.MACLINT_HEADERS": str(SOURCES / "include"),
                "cmake.define.MACLINT_TREE_SITTER": str(SOURCES / "tree-sitter"), **(config_settings or {})}
    return core.build_wheel(wheel_directory, settings, metadata_directory)
