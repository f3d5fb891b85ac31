#!/usr/bin/env python3
"""Makes seeds and the dictionary of the fuzz targets: from our own corpora, and from the outer one where it is.

usage: seeds.py FOLDER [SHARED]   writes FOLDER/seeds/TARGET/* and FOLDER/words.dict
"""
import json
import pathlib
import random
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LONGEST = 2048  # bytes of a seed: a fuzzer changes small inputs more often
MOST_OF_OTHERS = 60  # programs of the outer corpus, chosen evenly: all seeds are run before the first change
MOST_OF_OURS = 120

# What each target reads.
TEXTS = {
    "source": ("fanuc", "dinplus", "sinumerik"),
    "fanuc_reader": ("fanuc",),
    "dinplus_reader": ("dinplus",),
    "sinumerik_reader": ("sinumerik",),
    "lanes": ("fanuc", "dinplus"),
    "reports": ("fanuc", "dinplus"),
    "suppressions": ("fanuc", "dinplus"),
}


def small_files(folder):
    files = sorted(path for path in folder.rglob("*") if path.is_file()) if folder.is_dir() else []
    texts = (path.read_bytes() for path in files)
    return [text for text in texts if 0 < len(text) <= LONGEST]


def evenly(texts, most):
    return texts[:: max(1, -(-len(texts) // most))]


def programs(shared):
    """The texts of each language."""
    fixtures = ROOT / "tests/fixtures"
    corpora = {
        "fanuc": [ROOT / "corpus/fanuc", fixtures / "bad-input"],
        "dinplus": [ROOT / "corpus/dinplus", fixtures / "dinplus/bad-input"],
        "sinumerik": [ROOT / "corpus/sinumerik"],
    }
    others = {
        "fanuc": [shared / "corpus/fanuc-macro", shared / "corpus/fanuc-plain"],
        "dinplus": [shared / "reference/dinplus-examples", shared / "reference/seed-programs"],
        "sinumerik": [shared / "corpus/sinumerik", shared / "cases/sinumerik-seed"],
    }
    texts = {}
    for language, folders in corpora.items():
        own = evenly([text for folder in folders for text in small_files(folder)], MOST_OF_OURS)
        foreign = [text for folder in others[language] for text in small_files(folder)]
        texts[language] = own + evenly(foreign, MOST_OF_OTHERS)
    return texts


def configurations():
    """Those that stand in the tests and on the pages, and the keys one by one."""
    sources = [*(ROOT / "tests/cli").glob("*.cpp"), *(ROOT / "docs").glob("*.md")]
    text = "\n".join(path.read_text(encoding="utf-8") for path in sources)
    raw = re.findall(r'R"\((\{.*?\})\)"', text, re.S) + re.findall(r"^```\w*\n(\{.*?^\})\n```", text, re.S | re.M)
    return [one.encode() for one in raw]


def sessions():
    """Messages of a language client, framed: each alone, and all in a row."""
    text = {"textDocument": {"uri": "untitled:O1.nc", "languageId": "fanuc", "version": 1, "text": "O1\nGOTO9\nM30\n"}}
    part = {"range": {"start": {"line": 1, "character": 0}, "end": {"line": 1, "character": 4}}, "text": "X"}
    messages = [
        {"id": 1, "method": "initialize", "params": {"capabilities": {"general": {"positionEncodings": ["utf-8"]}}}},
        {"method": "initialized", "params": {}},
        {"method": "textDocument/didOpen", "params": text},
        {"method": "textDocument/didChange", "params": {"textDocument": {"uri": "untitled:O1.nc", "version": 2}, "contentChanges": [part]}},
        {"id": 2, "method": "textDocument/codeAction", "params": {"textDocument": {"uri": "untitled:O1.nc"}, "range": part["range"]}},
        {"id": 3, "method": "workspace/executeCommand", "params": {"command": "maclint.explain", "arguments": ["MAC301"]}},
        {"method": "$/cancelRequest", "params": {"id": 3}},
        {"method": "textDocument/didClose", "params": {"textDocument": {"uri": "untitled:O1.nc"}}},
        {"id": 4, "method": "shutdown", "params": None},
        {"method": "exit"},
    ]
    bodies = [json.dumps({"jsonrpc": "2.0", **message}).encode() for message in messages]
    framed = [b"Content-Length: %d\r\n\r\n%s" % (len(body), body) for body in bodies]
    return [*framed, b"".join(framed), b"Content-Length: x\r\n\r\n" + framed[0]]


def words():
    """Strings of the grammars, the tables and the readers of directives and configurations."""
    sources = [
        *ROOT.glob("grammar/*/grammar.js"),
        *ROOT.glob("analyzer/dialect/*/*.cpp"),
        *ROOT.glob("analyzer/dialect/detect/*.cpp"),
        ROOT / "cli/filter/directive.cpp",
        ROOT / "cli/config/load.cpp",
    ]
    found = {"%\n", "\r\n", "\n~~~~\n", "#1=", "GOTO1", "O1\n", "N1", "M30\n", "\0", "\u009b", "\u202e", "\ufeff"}
    for path in sources:
        text = re.sub(r"^\s*(//|#include).*$", "", path.read_text(encoding="utf-8"), flags=re.M)
        found.update(re.findall(r"""["']([^"'\\\n]{1,24})["']""", text))
    return sorted(found)


def escaped(word):
    return "".join(
        chr(byte) if 0x20 <= byte < 0x7F and byte not in b'"\\' else f"\\x{byte:02x}" for byte in word.encode()
    )


def write(folder, texts):
    folder.mkdir(parents=True, exist_ok=True)
    for number, text in enumerate(texts):
        (folder / f"{number:04}").write_bytes(text)


def main():
    folder = pathlib.Path(sys.argv[1])
    shared = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT.parent / "shared"
    texts = programs(shared)
    for target, languages in TEXTS.items():
        write(folder / "seeds" / target, [text for language in languages for text in texts[language]])
    write(folder / "seeds/configuration", configurations())
    write(folder / "seeds/lsp_reader", sessions())
    dice = random.Random(1)
    write(folder / "seeds/executor", [dice.randbytes(200 + 20 * i) for i in range(60)])
    (folder / "words.dict").write_text("".join(f'"{escaped(word)}"\n' for word in words()), encoding="ascii")


main()
