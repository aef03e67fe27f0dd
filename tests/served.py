# SPDX-License-Identifier: Apache-2.0
"""Starts `epura serve` for tests, and speaks HTTP to it, with the standard library alone."""
import contextlib
import http.client
import json
import signal
import socket
import subprocess
import urllib.parse

FOREIGN = {"Origin": "http://evil.example", "Sec-Fetch-Site": "cross-site"}


class Served:
    """A server, ended with the `with` block."""

    def __init__(self, epura, *arguments):
        self.process = subprocess.Popen([epura, "serve", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True, restore_signals=True,
                                        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.url = self.process.stdout.readline().rstrip("\n")
        address = urllib.parse.urlsplit(self.url)
        self.port = address.port
        self.path = address.path
        self.origin = f"http://127.0.0.1:{self.port}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()

    def end(self, number=signal.SIGINT):
        """Exit code and messages after a signal."""
        self.process.send_signal(number)
        err = self.process.communicate(timeout=10)[1]
        return self.process.returncode, err

    def request(self, path, method="GET", headers=None, body=None):
        """Status, headers and body of a reply; `path` is below the token unless it begins with a slash."""
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)) as connection:
            connection.request(method, path if path.startswith("/") else self.path + path, body, headers or {})
            reply = connection.getresponse()
            return reply.status, dict(reply.getheaders()), reply.read()

    def ask(self, resource, projection, page="test"):
        """Status and body for a projection; JSON is read."""
        query = urllib.parse.urlencode({"page": page, "projection": projection})
        status, headers, body = self.request(f"{resource}?{query}")
        return status, json.loads(body) if headers["Content-Type"] == "application/json" else body

    def raw(self, text, wait=10):
        """What comes back for these bytes until the connection is closed."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=wait) as connection:
            with contextlib.suppress(OSError):  # the server may refuse, and close, before it has read all
                connection.sendall(text)
                connection.shutdown(socket.SHUT_WR)
            reply = b""
            with contextlib.suppress(ConnectionError, TimeoutError):
                while part := connection.recv(65536):
                    reply += part
            return reply
