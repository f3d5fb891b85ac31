"""A session with the executable as an editor has it: over its standard input and output."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

JUMP = "%\nO9100\nGOTO 99\nM30\n%\n"


class LspTest(unittest.TestCase):
    def setUp(self):
        program = os.environ.get("MACLINT")
        if not program:
            self.skipTest("MACLINT does not name an executable")
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = pathlib.Path(held.name)
        (self.folder / ".git").mkdir()
        (self.folder / ".git/HEAD").write_text("")
        self.server = subprocess.Popen([program, "lsp", "--stdio"], cwd=self.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(self.server.stdout.close)
        self.addCleanup(self.server.kill)

    def send_bytes(self, text):
        self.server.stdin.write(text)
        self.server.stdin.flush()

    def send(self, method, params, **more):
        body = json.dumps({"jsonrpc": "2.0", "method": method, "params": params, **more}).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))

    def next(self, is_wanted):
        while True:
            length = 0
            while (line := self.server.stdout.readline().strip()):
                length = int(line.split(b":")[1])
            self.assertGreater(length, 0, "the server has ended")
            message = json.loads(self.server.stdout.read(length))
            if is_wanted(message):
                return message

    def test_findings_come_and_rubbish_is_answered_once(self):
        uri = (self.folder / "O9100.nc").as_uri()
        self.send("initialize", {"capabilities": {}, "rootUri": self.folder.as_uri()}, id=1)
        self.assertIn("codeActionProvider", self.next(lambda m: m.get("id") == 1)["result"]["capabilities"])
        self.send("initialized", {})
        self.send_bytes(b"GET / HTTP/1.1\r\n\r\n\r\n\r\n")
        self.assertEqual(self.next(lambda m: "error" in m)["error"]["code"], -32700)
        self.send("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "fanuc", "version": 1, "text": JUMP}})
        found = self.next(lambda m: m.get("method") == "textDocument/publishDiagnostics")["params"]
        self.assertEqual((found["uri"], [d["code"] for d in found["diagnostics"]]), (uri, ["MAC301"]))
        self.send("shutdown", None, id=2)
        self.assertIsNone(self.next(lambda m: m.get("id") == 2)["result"])
        self.send("exit", None)
        self.server.stdin.close()
        self.assertEqual(self.server.wait(timeout=30), 0)

    def test_a_client_that_goes_away_ends_it(self):
        self.send("initialize", {"capabilities": {}}, id=1)
        self.server.stdin.close()
        self.assertEqual(self.server.wait(timeout=30), 1)


if __name__ == "__main__":
    unittest.main()
