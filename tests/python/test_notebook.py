# SPDX-License-Identifier: GPL-3.0-or-later
"""A Picker as notebooks show it: the page of its frame in headless Chromium, clicked and dragged in, and photographed."""
import asyncio
import base64
import io
import json
import os
import re
import shutil
import subprocess
from contextlib import asynccontextmanager
from pathlib import Path

import bspline_curve
import numpy as np
import pytest
from PIL import Image

for name in ("pyvista", "trame_pyvista", "trame_vuetify", "ipywidgets", "nest_asyncio2", "aiohttp"):
    pytest.importorskip(name)
CHROMIUM = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
pytestmark = [pytest.mark.slow, pytest.mark.skipif(CHROMIUM is None, reason="needs chromium")]
SIZE = 900, 640
SECONDS = 60  # until a page must have come, on a busy machine


class Page:
    """A page of Chromium, by its debugging protocol."""

    def __init__(self, socket):
        self.socket, self.count = socket, 0

    async def call(self, method, **parameters):
        self.count += 1
        await self.socket.send_json({"id": self.count, "method": method, "params": parameters})
        while True:
            answer = json.loads((await asyncio.wait_for(self.socket.receive(), SECONDS)).data)
            if answer.get("id") == self.count:
                assert "error" not in answer, answer
                return answer["result"]

    async def mouse(self, kind, place, pressed=0):
        x, y = place
        button = {"button": "left", "clickCount": 1} if kind != "mouseMoved" or pressed else {}
        await self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, buttons=pressed, **button)
        await asyncio.sleep(0.15)

    async def click(self, place):
        await self.mouse("mouseMoved", place)
        await self.mouse("mousePressed", place, 1)
        await self.mouse("mouseReleased", place)

    async def drag(self, *places):
        await self.mouse("mouseMoved", places[0])
        await self.mouse("mousePressed", places[0], 1)
        for place in places[1:]:
            await self.mouse("mouseMoved", place, 1)
        await self.mouse("mouseReleased", places[-1])

    async def evaluate(self, expression):
        return (await self.call("Runtime.evaluate", expression=expression, returnByValue=True))["result"].get("value")

    async def until(self, expression):
        for _ in range(10 * SECONDS):
            value = await self.evaluate(expression)
            if value:
                return value
            await asyncio.sleep(0.1)
        raise AssertionError(f"never came true on the page: {expression}")

    async def picture(self):
        data = (await self.call("Page.captureScreenshot"))["data"]
        return Image.open(io.BytesIO(base64.b64decode(data))).convert("RGB")


@asynccontextmanager
async def opened(address, profile):
    import aiohttp

    options = ["--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-port=0", f"--user-data-dir={profile}",
               f"--window-size={SIZE[0]},{SIZE[1]}", "--no-first-run", address]
    with subprocess.Popen([CHROMIUM, *options], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as chromium:
        try:
            port = profile / "DevToolsActivePort"
            for _ in range(10 * SECONDS):
                if port.exists() and port.read_text().strip():
                    break
                await asyncio.sleep(0.1)
            number = port.read_text().split()[0]
            async with aiohttp.ClientSession() as session:
                async with session.get(f"http://127.0.0.1:{number}/json") as answer:
                    pages = [each for each in await answer.json() if each["type"] == "page"]
                async with session.ws_connect(pages[0]["webSocketDebuggerUrl"], max_msg_size=0) as socket:
                    yield Page(socket)
        finally:
            chromium.terminate()


VIEW = """(() => {
  const image = document.querySelector("img[src^='blob:'], img[src^='data:image/j'], .pa-0 img, canvas");
  if (!image) return null;
  const box = image.getBoundingClientRect();
  return box.width > 100 ? [box.left, box.top, box.width, box.height] : null;
})()"""


def place_of(picker, box, point):
    """Where a point of the mesh is on the page."""
    renderer = picker.plotter.renderer
    renderer.SetWorldPoint(*point, 1)
    renderer.WorldToDisplay()
    x, y = renderer.GetDisplayPoint()[:2]
    width, height = picker.plotter.render_window.GetSize()
    return box[0] + x / width * box[2], box[1] + (1 - y / height) * box[3]


def red(picture):
    r, g, b = np.moveaxis(np.asarray(picture).astype(int), 2, 0)
    return ((r > 130) & (g < 90) & (b < 90)).sum()


async def drawn_in_a_page(mesh, picks, folder):
    import pyvista

    picker = bspline_curve.Picker(mesh, plotter=pyvista.Plotter(notebook=True))
    picker.plotter.view_xy()
    widget = picker.show()
    address = re.search(r'src="([^"]+)"', widget.value)[1]
    pictures = {}
    async with opened(address, folder / "profile") as page:
        box = await page.until(VIEW)
        await asyncio.sleep(2)  # the size of the view goes to and fro
        box = await page.evaluate(VIEW)
        pictures["empty"] = await page.picture()
        for pick in picks:
            await page.click(place_of(picker, box, pick))
        await asyncio.sleep(1)
        pictures["clicked"] = await page.picture()
        clicked = picker.curves
        start = place_of(picker, box, clicked[0].picks[2])
        await page.drag(start, (start[0], start[1] - 20), (start[0], start[1] - 40), (start[0], start[1] - 60))
        await asyncio.sleep(1)
        pictures["dragged"] = await page.picture()
        dragged = picker.curves
        button = await page.evaluate(
            "(() => { const b = [...document.querySelectorAll('button')].find(b => b.textContent.trim() === 'Close');"
            " const r = b.getBoundingClientRect(); return [r.left + r.width / 2, r.top + r.height / 2]; })()"
        )
        await page.click(button)
        await asyncio.sleep(1)
        pictures["closed"] = await page.picture()
        closed = picker.curves
        views = [np.array(picker.plotter.camera.position)]
        beside = box[0] + 0.04 * box[2], box[1] + 0.92 * box[3]
        await page.drag(beside, *((beside[0] + step, beside[1] - step / 2) for step in (40, 80, 120)))
        await asyncio.sleep(1)
        pictures["turned"] = await page.picture()
        views.append(np.array(picker.plotter.camera.position))
        assert all(np.array_equal(now.picks, before.picks) for now, before in zip(picker.curves, closed, strict=True))
    picker.plotter.close()
    return clicked, dragged, closed, views, pictures


def test_curves_are_clicked_and_dragged_in_a_browser_and_the_view_is_turned(mesh, picks, tmp_path):
    clicked, dragged, closed, (before, after), pictures = asyncio.run(drawn_in_a_page(mesh, picks, tmp_path))
    kept = Path(os.environ.get("BSPLINE_CURVE_PICTURES", tmp_path))  # to look at them
    for name, picture in pictures.items():
        picture.save(kept / f"notebook-{name}.png")
    [curve] = clicked
    assert np.abs(curve.picks[:, :2] - picks[:, :2]).max() < 0.03  # a pixel or two
    [moved] = dragged
    assert moved.picks[2, 1] - curve.picks[2, 1] > 0.1
    np.testing.assert_array_equal(np.delete(moved.picks, 2, 0), np.delete(curve.picks, 2, 0))
    assert closed[0].closed and len(closed) == 1
    assert red(pictures["empty"]) < 50 < 500 < red(pictures["clicked"]) < red(pictures["closed"])
    assert np.linalg.norm(after - before) > 0.1 * np.linalg.norm(before) and red(pictures["turned"]) > 300
    assert (np.asarray(pictures["turned"]) != np.asarray(pictures["closed"])).any(-1).mean() > 0.05
