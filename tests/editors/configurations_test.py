"""What users copy into the configuration of editors that are not run here: it can be read, and names what the program has."""
import json
import pathlib
import re
import tomllib
import unittest
import xml.etree.ElementTree

EDITORS = pathlib.Path(__file__).resolve().parents[2] / "editors"
LANGUAGES = {"fanuc", "dinplus", "sinumerik"}
SINUMERIK = {"mpf", "spf", "arc", "cpf", "def"}


def toml(name):
    return tomllib.loads((EDITORS / name).read_text(encoding="utf-8"))


def relaxed(name):
    """JSON with comments on lines of their own."""
    return json.loads(re.sub(r"^\s*//.*$", "", (EDITORS / name).read_text(encoding="utf-8"), flags=re.M))


class ConfigurationsTest(unittest.TestCase):
    def test_helix(self):
        told = toml("helix/languages.toml")
        server = told["language-server"]["maclint"]
        self.assertEqual((server["command"], server["args"]), ("maclint", ["lsp"]))
        self.assertEqual({each["name"] for each in told["language"]}, LANGUAGES)
        self.assertEqual({each["name"] for each in told["grammar"]}, LANGUAGES)
        types = {each["name"]: each["file-types"] for each in told["language"]}
        self.assertEqual(set(types["sinumerik"]), SINUMERIK)

    def test_zed(self):
        told = toml("zed/extension.toml")
        server = told["language_servers"]["maclint"]
        self.assertEqual(set(server["language_ids"].values()), LANGUAGES)
        configured = {language: toml(f"zed/languages/{language}/config.toml") for language in LANGUAGES}
        self.assertEqual({each["name"] for each in configured.values()}, set(server["languages"]))
        self.assertEqual({name: each["grammar"] for name, each in configured.items()}, {name: name for name in LANGUAGES})
        self.assertEqual({each.lower() for each in configured["sinumerik"]["path_suffixes"]}, SINUMERIK)
        self.assertEqual(set(told["grammars"]), LANGUAGES)

    def test_kate(self):
        servers = relaxed("kate/lspclient.json")["servers"]
        self.assertEqual(set(servers), LANGUAGES)
        for name, server in servers.items():
            mode = xml.etree.ElementTree.parse(EDITORS / f"kate/{name}.xml").getroot()
            self.assertRegex(mode.get("name"), server["highlightingModeRegex"])
            self.assertEqual(server["command"], ["maclint", "lsp"])

    def test_notepad_plus_plus(self):
        servers = toml("notepad++/NppLspClient.toml")["lspservers"]
        self.assertEqual(set(servers), LANGUAGES)
        for name, server in servers.items():
            language = xml.etree.ElementTree.parse(EDITORS / f"notepad++/{name}.xml").getroot().find("UserLang")
            self.assertEqual((language.get("name"), server["args"]), (name, "lsp"))
            self.assertEqual(set(language.get("ext").split()) == SINUMERIK, name == "sinumerik")

    def test_sublime(self):
        client = relaxed("sublime/LSP.sublime-settings")["clients"]["maclint"]
        self.assertEqual(client["command"], ["maclint", "lsp"])
        scopes = {re.search(r"^scope: (\S+)$", path.read_text(encoding="utf-8"), re.M).group(1) for path in EDITORS.glob("sublime/*.sublime-syntax")}
        self.assertEqual(scopes, set(client["selector"].split(" | ")))


if __name__ == "__main__":
    unittest.main()
