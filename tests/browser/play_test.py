#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plays with the page of `epura serve` in a browser: play_test.py EPURA ELEMENT PLUGINS."""
import base64
import json
import math
import os
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
import chromium  # noqa: E402
from claims import check, failures, same  # noqa: E402
from served import Served  # noqa: E402

EPURA, STRANGERS = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[3]), "good")
BRACKET = os.path.join(os.path.dirname(os.path.dirname(HERE)), "samples", "models", "bracket.obj")
ROUNDING = 1e-9  # mm on the page

# Every projection with its defaults, and with values far from them.
VALUES = {
    "auxiliary": ["direction=1,-2,0.5"],
    "isometric": ["from=left-back", "foreshortened=false:below=true"],
    "dimetric": ["from=right-back"],
    "trimetric": ["x-angle=40:y-angle=12", "x-angle=5:y-angle=60"],
    "cavalier": ["angle=30", "angle=-125"],
    "cabinet": ["angle=63.4", "angle=200"],
    "planometric": ["angle=30", "angle=17:height=0.6667"],
    "oblique": ["angle=75:ratio=0.3", "angle=-20:ratio=3"],
    "one-point": ["right=-2:above=3"],
    "two-point": ["azimuth=70:distance=1", "azimuth=-30:above=-0.7"],
    "three-point": ["azimuth=10:elevation=60", "azimuth=130:elevation=-20"],
    "look-at": ["eye=200,-300,150", "eye=200,-300,150:ref=10,20,30:fovy=30"],
    "frustum": ["eye=10,-400,90"],
    "observer": ["o=-250,-300,200"],
    "phigs": ["prp=20,10,500", "kind=parallel:vpn=1,-2,1:prp=50,20,100", "vpn=2,-1,1:window=-60,-40,70,80:prp=0,0,400"],
    "vanishing-points": ["x=-300,40:y=250,40"],
}


def drawn(request, format):
    run = subprocess.run([EPURA, "draw", BRACKET, "--plugin-path", STRANGERS, "--projection", request, "-o", "-", "--format",
                          format], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return run.stdout


def wait_until(browser, expression, seconds=20):
    end = time.monotonic() + seconds
    while not browser.evaluate(expression):
        if time.monotonic() > end:
            check(f"within {seconds} s: {expression}", False, text(browser, "status"))
            return
        time.sleep(0.02)


def command(request):
    return f"epura draw {BRACKET} --plugin-path={STRANGERS} --projection {request} -o bracket.svg"


def text(browser, name):
    return browser.evaluate(f"document.getElementById({name!r}).textContent")


def is_exact(browser):
    return browser.evaluate("!document.getElementById('drawing').hidden")


def centre(browser, selector):
    return browser.evaluate(f"""(() => {{
        const box = document.querySelector({selector!r}).getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2];
    }})()""")


def choose(browser, name):
    browser.evaluate(f"""(() => {{
        document.getElementById('parameters').firstElementChild?.setAttribute('data-old', '');
        const list = document.getElementById('projection');
        list.value = {name!r};
        list.dispatchEvent(new Event('change'));
    }})()""")
    wait_until(browser, f"epura.view.projection === {name!r} && !document.querySelector('[data-old]')")


def move(browser, selector, value):
    """As a hand does: the slider is focused and its value set."""
    browser.evaluate(f"""(() => {{
        const slider = document.querySelector({selector!r});
        slider.value = {value!r};
        slider.dispatchEvent(new Event('input', {{bubbles: true}}));
    }})()""")


def painted(browser):
    """The wireframe as the screen has it."""
    return browser.evaluate("document.getElementById('wires').toDataURL()")


def test_first_sight(browser, server):
    wait_until(browser, "!document.getElementById('drawing').hidden")
    same("heading", browser.evaluate("document.querySelector('h1').textContent"), "bracket.obj")
    same("projections of the list", browser.evaluate("document.querySelectorAll('#projection option').length"),
         browser.evaluate("JSON.parse(document.getElementById('data').textContent).model.projections.length"))
    check("every control has a name", browser.evaluate("""[...document.querySelectorAll('input, select, button')].every(
        control => control.labels?.length || control.getAttribute('aria-label') || control.textContent.trim())"""))
    check("the sheet is described", "bracket.obj, isometric" in browser.evaluate(
        "document.getElementById('paper').getAttribute('aria-label')"))
    same("no address of the page leaves it", browser.evaluate(
        "fetch('https://example.com/').then(() => 'sent', () => 'refused')"), "refused")
    browser.events = [event for event in browser.events if "example.com" not in json.dumps(event)]


def test_points(browser, server):
    """What the browser calculates is what the program draws."""
    names = browser.evaluate("[...document.querySelectorAll('#projection option')].map(option => option.value)")
    check("all projections of the project", len(names) >= 22, names)
    browser.evaluate("document.getElementById('resting').checked && document.getElementById('resting').click()")
    worst = compared = 0
    for name in names:
        if name == "every-type":  # shows a slice of the model only
            continue
        for values in ["", *VALUES.get(name, [])]:
            request = name + (":" + values if values else "")
            json_of_drawing = json.loads(drawn(request, "json"))
            status, view = server.ask("view", request)
            same(f"view of {request}", status, 200)
            # The page's own functions, with this view in place of the one that it shows.
            answer = browser.evaluate(f"""(async () => {{
                await epura.show({request!r});
                return [epura.points, Object.entries(epura.matrices), epura.view.projection];
            }})()""")
            same(f"the page shows {name}", answer[2], name)
            points, matrices = answer[0], dict(answer[1])
            for step in [*view["steps"], {"symbol": "product", "matrix": view["product"]}]:
                for mine, other in zip(matrices[step["symbol"]], step["matrix"]):
                    check(f"{step['symbol']} of {request}", abs(mine - other) <= 1e-12 * max(1, abs(other)), (mine, other))
            found = 0
            for segment in json_of_drawing["views"][0]["segments"]:
                for end, t, place in zip(segment["edge"], segment["t"], (segment["from"], segment["to"])):
                    if t != (0 if end == segment["edge"][0] else 1):
                        continue
                    far = math.dist(points[end], place)
                    worst = max(worst, far)
                    found += 1
                    check(f"vertex {end} of {request}", far <= ROUNDING, far)
            check(f"ends in {request}", found > 20, found)
            compared += found
    print(f"{compared} ends compared, at most {worst:.1e} mm away")


def test_slider(browser, server):
    browser.go(server.url)
    choose(browser, "two-point")
    before, points = painted(browser), browser.evaluate("epura.points")
    move(browser, "#p-azimuth-range", "70")
    same("the number follows", browser.evaluate("document.getElementById('p-azimuth').value"), "70")
    check("the wireframe is shown while it moves", not is_exact(browser))
    wait_until(browser, "epura.matrices.VOM[0] < 0.5")
    browser.settle()
    check("the wireframe moves", painted(browser) != before and browser.evaluate("epura.points") != points)
    wait_until(browser, "!document.getElementById('drawing').hidden")
    same("the command", text(browser, "command"), command("two-point:azimuth=70"))
    same("the exact drawing is that of the command", browser.evaluate("epura.drawing"),
         drawn("two-point:azimuth=70", "svg").decode())
    check("it takes the place of the wireframe", browser.evaluate("""(() => {
        const [a, b] = ['drawing', 'paper'].map(id => document.getElementById(id).getBoundingClientRect());
        return a.width > 300 && a.width === b.width && a.height === b.height && a.x === b.x && a.y === b.y;
    })()"""))


def test_keyboard(browser, server):
    choose(browser, "two-point")
    browser.evaluate("document.querySelector('#p-azimuth-range').focus()")
    value = "Number(document.getElementById('p-azimuth').value)"
    first = browser.evaluate(value)
    browser.key("ArrowRight", code="ArrowRight", windowsVirtualKeyCode=39)
    check("an arrow key moves a slider", browser.evaluate(value) > first, browser.evaluate(value))
    browser.evaluate("document.querySelector('#p-above-range').focus()")
    browser.key("Home", code="Home", windowsVirtualKeyCode=36)
    same("the first value", browser.evaluate("document.getElementById('p-above').value"),
         browser.evaluate("document.querySelector('#p-above-range').min"))
    browser.evaluate("document.getElementById('p-azimuth').select()")
    browser.type("25")
    slider = browser.evaluate("Number(document.querySelector('#p-azimuth-range').value)")
    check("a number moves the slider, to the next of its steps", abs(slider - 25) <= 1, slider)
    browser.evaluate("document.getElementById('p-azimuth').select()")
    browser.type("400")
    same("a value beyond the table is marked",
         browser.evaluate("document.getElementById('p-azimuth').getAttribute('aria-invalid')"), "true")
    check("and not asked for", "azimuth=25" in text(browser, "command"), text(browser, "command"))
    for _ in range(2):
        browser.click(*centre(browser, "legend button:not([disabled])"))
    same("back to the default", browser.evaluate(value), 40)
    same("of the command, too", text(browser, "command"), command("two-point"))


def test_refusal(browser, server):
    choose(browser, "trimetric")
    for name in ("x-angle", "y-angle"):
        move(browser, f"#p-{name}-range", "80")
    wait_until(browser, "document.getElementById('status').classList.contains('wrong')")
    check("the sentence of the projection", "the sum of x-angle and y-angle" in text(browser, "status"), text(browser, "status"))
    browser.evaluate("document.getElementById('reset').click()")
    wait_until(browser, "!document.getElementById('drawing').hidden")
    check("good again", not browser.evaluate("document.getElementById('status').classList.contains('wrong')"))
    browser.events = [event for event in browser.events if "400" not in json.dumps(event.get("params", {}).get("entry", ""))]


def test_stranger(browser, server):
    """A plugin that nobody told the page about, with a parameter of each type."""
    choose(browser, "every-type")
    same("its fields", browser.evaluate("[...document.querySelectorAll('#parameters fieldset')].map(field => "
                                        "field.querySelectorAll('input[type=range], select').length)"), [2, 1, 3, 1, 1, 4])
    browser.evaluate("""(() => {
        const list = document.getElementById('p-word');
        list.value = 'double';
        list.dispatchEvent(new Event('change', {bubbles: true}));
    })()""")
    check("a choice in the command", "every-type:word=double" in text(browser, "command"), text(browser, "command"))


def test_matrices(browser, server):
    browser.evaluate("document.getElementById('matrices').parentElement.open = true")
    wait_until(browser, "document.querySelectorAll('#matrices caption').length > 3")
    check("steps in the seeds' notation", "VOM" in text(browser, "matrices") and "M_wv" in text(browser, "matrices"))


def test_end(browser, server):
    """An answer of the server that comes late does not take back that it has ended."""
    browser.evaluate("""(() => {
        const ask = fetch, late = new Promise(give => window.giveAnswer = give);
        window.fetch = async (resource, options) => {
            const answer = await ask(resource, options);
            if (resource.startsWith('view')) {
                window.isAnswered = true;
                await late;
            }
            return answer;
        };
        document.getElementById('reset').click();
    })()""")
    wait_until(browser, "window.isAnswered")
    same("the server ends", server.end(), (130, "epura: cancelled\n"))
    browser.evaluate("document.getElementById('exact').click()")
    wait_until(browser, "document.getElementById('status').classList.contains('wrong')")
    browser.evaluate("giveAnswer()")
    browser.settle()
    check("the page says so", "does not answer" in text(browser, "status"), text(browser, "status"))


def main():
    chromium.expect()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with Served(EPURA, BRACKET, "--plugin-path", STRANGERS) as server, chromium.Browser() as browser:
            browser.go(server.url)
            for test in (test_first_sight, test_points, test_slider, test_keyboard, test_refusal, test_stranger, test_matrices):
                test(browser, server)
                for complaint in browser.complaints(server.origin):
                    check(test.__name__ + " without complaints", False, complaint)
                browser.events = []
            test_end(browser, server)
        os.chdir("/")
    print(f"{len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
