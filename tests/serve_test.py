#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`epura serve` as clients see it, friendly and hostile ones: serve_test.py EPURA PLUGINS.

PLUGINS is the folder with a folder for each plugin that goes wrong.
"""
import concurrent.futures
import contextlib
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from claims import check, failures, same  # noqa: E402
from served import FOREIGN, Served  # noqa: E402

EPURA, PLUGINS = (os.path.abspath(argument) for argument in sys.argv[1:3])


def box(at, size, first):
    corners = [[at[a] + size * (i >> a & 1) for a in range(3)] for i in range(8)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    return ("".join("v {} {} {}\n".format(*c) for c in corners) +
            "".join("f " + " ".join(str(c + first - 1) for c in face) + "\n" for face in faces))


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def drawn(*arguments):
    subprocess.run([EPURA, "draw", "box.obj", *arguments, "-o", "drawn.svg"], check=True, stderr=subprocess.DEVNULL)
    with open("drawn.svg", "rb") as file:
        return file.read()


def children(process):
    with open(f"/proc/{process}/task/{process}/children", encoding="ascii") as file:
        return [int(word) for word in file.read().split()]


def is_running(process):
    try:
        with open(f"/proc/{process}/stat", encoding="ascii") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def test_address(server):
    check("one line with a token", re.fullmatch(r"http://127\.0\.0\.1:\d+/[0-9a-f]{32}/", server.url), server.url)
    with open("/proc/net/tcp", encoding="ascii") as table:
        places = [line.split()[1] for line in table if line.split()[3] == "0A"]  # listening
    here = f"{server.port:04X}"
    same("it listens on the loopback address alone", [p for p in places if p.endswith(":" + here)], ["0100007F:" + here])
    with open("/proc/net/tcp6", encoding="ascii") as table:
        check("and not in IPv6", not any(line.split()[1].endswith(":" + here) and line.split()[3] == "0A" for line in table))
    with Served(EPURA, "box.obj") as other:
        check("tokens differ", other.path != server.path)


def test_admission(server):
    for path in ("/", "/favicon.ico", "/view?projection=isometric", server.path[:-1], server.path[:-2] + "/",
                 server.path[:-2] + ("1/" if server.path[-2] != "1" else "2/"), "//", server.path.upper(),
                 "/" + 32 * "0" + "/", "/?token=" + server.path.strip("/")):
        same(f"without the token: {path}", server.request(path)[0], 403)
    same("with the token", server.request("")[0], 200)
    for headers in ({"Host": "evil.example"}, {"Host": f"localhost:{server.port}"}, {"Host": "127.0.0.1"},
                    {"Host": f"127.0.0.1:{server.port}.evil.example"}, {"Origin": "http://evil.example"},
                    {"Origin": "null"}, {"Origin": f"http://127.0.0.1:{server.port + 1}"},
                    {"Sec-Fetch-Site": "cross-site"}, {"Sec-Fetch-Site": "same-site"}, FOREIGN):
        same(f"with {headers}", server.request("view?projection=isometric", headers=headers)[0], 403)
    own = {"Origin": server.origin, "Sec-Fetch-Site": "same-origin"}
    same("from its own page", server.request("view?projection=isometric", headers=own)[0], 200)
    line = f"GET {server.path} HTTP/1.1\r\n"
    for hosts in ("", "Host: evil.example\r\n" + f"Host: 127.0.0.1:{server.port}\r\n"):
        reply = server.raw((line + hosts + "\r\n").encode())
        check(f"with the hosts {hosts!r}", reply.startswith((b"HTTP/1.1 403", b"HTTP/1.1 400")), reply[:60])


def test_methods_and_sizes(server):
    for method in ("POST", "PUT", "DELETE", "HEAD", "OPTIONS", "TRACE", "PATCH", "FROB"):
        status, headers, _ = server.request("view?projection=isometric", method)
        same(f"{method}", (status, headers.get("Allow")), (405, "GET"))
    same("a body", server.request("", body=b"x" * 100)[0], 413)
    check("an endless body", server.request("", "POST", {"Content-Length": str(10**15)}, b"x")[0] in (405, 413))
    long = server.raw(f"GET {server.path}view?projection={'x' * 10**6} HTTP/1.1\r\n".encode())
    check("a long address", long == b"" or re.match(rb"HTTP/1\.1 (414|431|400)", long), long[:60])
    many = "".join(f"X-{i}: {'x' * 100}\r\n" for i in range(10000))
    many = server.raw(f"GET {server.path} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n{many}\r\n".encode())
    check("many headers", many == b"" or re.match(rb"HTTP/1\.1 (413|431|400)", many), many[:60])
    for noise in (b"\0" * 1000, b"GET\r\n\r\n", b"\xff\xfe\xfd\r\n\r\n", b"GET / HTTP/9.9\r\n\r\n", b"\r\n" * 1000):
        reply = server.raw(noise, 2)
        check(f"noise {noise[:8]}", b" 200 " not in reply, reply[:60])
    same("and it still answers", server.request("")[0], 200)


def test_slow_clients(server):
    def connected():
        return socket.create_connection(("127.0.0.1", server.port), timeout=60)

    slow = [connected() for _ in range(100)]
    start = time.monotonic()
    for i, connection in enumerate(slow):
        with contextlib.suppress(OSError):  # those that came first have been hung up on
            connection.sendall(b"GET /aaaa"[:1 + i % 9])
    same("the page beside 100 clients that send slowly", server.request("")[0], 200)
    check("at once", time.monotonic() - start < 5)
    for connection in slow:
        connection.close()
    # Between two bytes there is never the silence after which a connection ends by itself.
    start = time.monotonic()
    with connected() as trickling, contextlib.suppress(ConnectionError):
        trickling.settimeout(1)
        while time.monotonic() - start < 30:
            trickling.sendall(b"G")
            with contextlib.suppress(TimeoutError):
                if trickling.recv(1) == b"":
                    break
    check("a head that never ends", time.monotonic() - start < 20, time.monotonic() - start)


def test_no_files(server):
    for path in ("../../etc/passwd", "..%2f..%2fetc%2fpasswd", "/etc/passwd", "%2e%2e/box.obj", "box.obj", "model/",
                 "view/", "drawing/box.obj", "%00", "model%00", "%00model"):
        status, _, body = server.request(path if path.startswith("/") else server.path + path)
        check(f"no file for {path}", status in (403, 404) and b"root:" not in body, status)
    # A projection is one word of the command that draws.
    for projection in ("--output=stolen.svg", "isometric --output stolen.svg", "isometric\n--output=stolen.svg",
                       "../box", "/etc/passwd", "isometric:from=", "", "x" * 4000, "\u202e", "%00"):
        for resource in ("view", "drawing"):
            status, reply = server.ask(resource, projection)
            check(f"{resource} of {projection[:40]!r}", status == 400 and reply["error"], (status, reply))
    check("nothing was written", not os.path.exists("stolen.svg"))


def test_replies(server):
    status, headers, page = server.request("")
    same("the page", (status, headers["Content-Type"]), (200, "text/html; charset=utf-8"))
    policy = headers["Content-Security-Policy"]
    check("its policy", re.fullmatch(r"default-src 'none'; script-src 'sha256-[^']+'; style-src 'sha256-[^']+'; img-src blob: data:; "
                                     "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'", policy), policy)
    check("no path of this machine in it", os.getcwd().encode() not in page)
    for resource in ("", "model", "view?projection=front", "drawing?projection=front", "nothing"):
        headers = server.request(resource)[1]
        for name, value in {"Cache-Control": "no-store", "X-Content-Type-Options": "nosniff",
                            "Referrer-Policy": "no-referrer", "Cross-Origin-Resource-Policy": "same-origin"}.items():
            same(f"{name} of {resource}", headers.get(name), value)
        check(f"no other site may read {resource}", "Access-Control-Allow-Origin" not in headers)
    for projection in ("isometric", "two-point:azimuth=70,above=1", "cabinet:angle=30", "phigs"):
        projection = projection.replace(",", ":")
        same(f"{projection}, to the byte", server.ask("drawing", projection), (200, drawn("--projection", projection)))
    status, view = server.ask("view", "two-point")
    same("steps of a perspective", [step["symbol"] for step in view["steps"]], ["VOM", "N_per", "M_per", "M_wv"])
    status, reply = server.ask("view", "two-point:azimut=70")
    same("a misspelt parameter", (status, reply["error"]), (400, "two-point:azimut: no such parameter"))
    same("for a drawing, too", server.ask("drawing", "isometrc")[1]["error"].split("\n")[:1], ["isometrc: no such projection"])


def test_options():
    options = ["--hidden", "dashed", "--sheet", "A3", "--portrait", "--scale", "2:1", "--title", "It's <b>", "--edges", "contour,crease"]
    with Served(EPURA, "box.obj", *options, "--projection", "cavalier:angle=60") as server:
        same("a drawing with options", server.ask("drawing", "cavalier:angle=60"),
             (200, drawn(*options, "--projection", "cavalier:angle=60")))
        same("its sheet", server.ask("view", "cavalier")[1]["paper"], [297, 420])


def endless():
    """A server whose drawings by the projection `plain` do not end by themselves."""
    return ["box.obj", "--plugin-path", os.path.join(PLUGINS, "hangs-when-asked")]


def processes_while_drawing(server):
    """Those of the model and of a drawing, which has just been requested."""
    until = time.monotonic() + 20
    while len(children(server.process.pid)) < 2 and time.monotonic() < until:
        time.sleep(0.01)
    processes = children(server.process.pid)
    check("a model and a drawing have processes", len(processes) == 2, processes)
    return processes


def test_limits():
    with Served(EPURA, *endless(), "--job-time", "0.2") as server:
        status, reply = server.ask("drawing", "plain")
        check("a drawing that takes too long", status == 503 and "0.2 s" in reply["error"], (status, reply))
    write("large.obj", "".join(box((i % 7 * 1.01, i % 11 * 1.02, i % 13 * 1.03), 20, 8 * i + 1) for i in range(120)))
    with Served(EPURA, "large.obj", "--job-memory", "50") as server:
        status, reply = server.ask("drawing", "isometric")
        check("a drawing that is too large", status in (400, 500) and reply["error"], (status, reply))
        same("other requests", server.request("")[0], 200)


def test_newer_requests():
    with Served(EPURA, *endless()) as server, concurrent.futures.ThreadPoolExecutor() as pool:
        old = pool.submit(server.ask, "drawing", "plain", "one page")
        drawing = processes_while_drawing(server)
        begun = time.monotonic()
        new = pool.submit(server.ask, "drawing", "isometric:from=left-back", "one page")
        status, reply = old.result()
        same("an older request of one page", (status, reply["error"]), (409, "a newer request has taken its place"))
        print(f"  taken back after {time.monotonic() - begun:.2f} s")
        check("its process is gone", not all(is_running(child) for child in drawing), drawing)
        same("the newer one", new.result()[0], 200)
    with Served(EPURA, "box.obj") as server, concurrent.futures.ThreadPoolExecutor() as pool:
        nameless = [pool.submit(server.ask, "drawing", f"cabinet:angle={angle}", "") for angle in (30, 40, 50, 60)]
        same("requests that name no page", [request.result()[0] for request in nameless], 4 * [200])


def test_several_clients(server):
    angles = range(30, 60, 3)
    with concurrent.futures.ThreadPoolExecutor(16) as pool:
        drawings = [pool.submit(server.ask, "drawing", f"cabinet:angle={angle}", f"page {angle}") for angle in angles]
        views = [pool.submit(server.ask, "view", f"cabinet:angle={angle}", f"page {angle}") for angle in angles]
        for angle, drawing in zip(angles, drawings):
            same(f"page {angle}", drawing.result(), (200, drawn("--projection", f"cabinet:angle={angle}")))
        same("a view for each", len({str(view.result()) for view in views}), len(angles))
    # Who connects and says nothing keeps nobody waiting.
    silent = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(30)]
    for connection in silent[:15]:
        connection.sendall(b"GET /")
    begun = time.monotonic()
    same("beside silent clients", server.request("view?projection=front")[0], 200)
    check("at once", time.monotonic() - begun < 2)
    for connection in silent:
        connection.close()


def test_plugins():
    for folder in ("crashes-when-asked", "hangs-when-asked"):
        with Served(EPURA, "box.obj", "--plugin-path", os.path.join(PLUGINS, folder)) as server:
            status, reply = server.ask("view", "plain")
            check(f"a plugin that {folder}", status == 400 and "plain" in reply["error"], (status, reply))
            same("another one afterwards", server.ask("view", "front")[0], 200)
    with Served(EPURA, "box.obj", "--plugin-path", os.path.join(PLUGINS, "good")) as server:
        same("a stranger's plugin", server.ask("view", "every-type:point=1,2,3")[1]["VRP"], [1, 2, 3])


def test_end():
    for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
        with Served(EPURA, *endless()) as server:
            with socket.create_connection(("127.0.0.1", server.port)) as connection:
                connection.sendall(f"GET {server.path}drawing?projection=plain HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode())
                processes = processes_while_drawing(server)
                begun = time.monotonic()
                same("the end by a signal", server.end(number), (code, "epura: cancelled\n"))
                check("at once", time.monotonic() - begun < 2)
            until = time.monotonic() + 10  # they are killed, but a busy machine takes its time
            while any(is_running(process) for process in processes) and time.monotonic() < until:
                time.sleep(0.01)
            check("no process is left", not any(is_running(process) for process in processes), processes)


def test_refusals(server):
    def refused(*arguments):
        run = subprocess.run([EPURA, "serve", *arguments], capture_output=True, text=True, timeout=60)
        return run.returncode, run.stderr

    code, message = refused("box.obj", "--port", str(server.port))
    check("a port in use", code == 4 and f"--port {server.port}" in message and "another program" in message and "hint" in message, message)
    write("scene.toml", "")
    for arguments, word in ((("scene.toml",), "scene file"), (("-",), "name a file"), (("missing.obj",), "missing.obj"),
                            (("box.obj", "--port", "80"), "--port"), (("box.obj", "--projection", "isometrc"), "isometric"),
                            (("box.obj", "--views", "front"), "--views"), ((), "models")):
        code, message = refused(*arguments)
        check(f"refused: {arguments}", code in (2, 3) and word in message, (code, message))


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write("box.obj", box((0, 0, 0), 10, 1) + box((5, 5, 5), 15, 9))
        with Served(EPURA, "box.obj") as server:
            for test in (test_address, test_admission, test_methods_and_sizes, test_slow_clients, test_no_files, test_replies,
                         test_several_clients, test_refusals):
                test(server)
                check(f"the server lives after {test.__name__}", server.process.poll() is None)
        for test in (test_options, test_limits, test_newer_requests, test_plugins, test_end):
            test()
        os.chdir("/")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
