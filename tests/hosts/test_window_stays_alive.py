# SPDX-License-Identifier: GPL-3.0-or-later
"""On a mesh of 1.3 million faces the window's thread is never busy for long, and what runs beside it can be given up."""
import re
import subprocess
import time
from pathlib import Path
from statistics import median

import pymeshlab
import pytest
from drawing_tool import MADE, Tool
from float_ply import write_ply
from meshlab_window import MeshLabWindow

# In frames of the host without the tool, which its thread computes as well: where the driver draws in software, as here, a
# frame of this mesh takes a tenth of a second on a common machine. So a slow machine is no failure.
MOST_FRAMES = 1.5
PATIENCE = 5.0  # with machines that are busy with other things: seconds by the clock per second of computing
CUT = "^1 curve cut: "
GIVEN_UP = '" was stopped, since the drawing tool ended'


@pytest.fixture(scope="module")
def large_sphere(tmp_path_factory):
    document = pymeshlab.MeshSet()
    document.create_sphere(radius=1, subdiv=8)
    mesh = document.current_mesh()
    return write_ply(tmp_path_factory.mktemp("meshes") / "sphere.ply", mesh.vertex_matrix(), mesh.face_matrix())


class Loop:
    """How long the main thread of a program stays away from its event loop, see loop_times.c."""

    def __init__(self, folder):
        library = folder / "loop_times.so"
        source = Path(__file__).with_name("loop_times.c")
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", source, "-o", library, "-ldl"], check=True)
        self._times = folder / "times"
        self.environment = {"LD_PRELOAD": str(library), "LOOP_TIMES": str(self._times)}
        self._since, self.frame = 0.0, 0.0

    def _stays(self):
        rows = [[float(word) for word in line.split()] for line in self._times.read_text().splitlines()]
        return [row for row in rows if row[0] - row[1] >= self._since]

    def begin(self):
        self._since = time.monotonic()

    def learn_frame(self):
        """Takes what the host's own frames cost from what happened since the beginning."""
        self.frame = median(computed for _, _, computed, frames in self._stays() if frames == 1)

    def longest(self):
        """Since the beginning: by the clock where no frame was shown, and of computing without frames."""
        stays = self._stays()
        seconds = max((stay for _, stay, _, frames in stays if frames == 0), default=0.0)
        return seconds, max((computed - frames * self.frame for _, _, computed, frames in stays), default=0.0)


@pytest.fixture(scope="module")
def driver_folder(tmp_path_factory):
    """Where the driver of OpenGL keeps what it compiles, in the first frame that needs it."""
    return str(tmp_path_factory.mktemp("driver"))


@pytest.fixture(params=["2020.09", "2025.07"])
def program(request, program_of):
    return program_of(request.param)


def make_layers(tool):
    tool.meshlab.key("Return")
    tool.meshlab.wait_for_log(MADE)
    tool.meshlab.wait_for_still_picture()


def cut(tool):
    tool.press("Cut")
    tool.wait_for_end()
    tool.meshlab.wait_for_log(CUT)
    tool.meshlab.wait_for_still_picture()


@pytest.fixture
def compiled(display, program, large_sphere, driver_folder):
    """All that is measured has been done once, so that the driver compiles nothing in the frames that are counted."""
    with MeshLabWindow(display, program, large_sphere, MESA_SHADER_CACHE_DIR=driver_folder) as meshlab:
        tool = Tool(meshlab)
        tool.wait_until_ready()
        tool.draw()
        tool.press("closed")
        meshlab.wait_for_still_picture()
        make_layers(tool)
        cut(tool)


@pytest.fixture
def drawn(display, program, large_sphere, driver_folder, tmp_path):
    """The tool with a closed curve on the large sphere, the loop, and what the start took of it."""
    loop = Loop(tmp_path)
    environment = loop.environment | {"MESA_SHADER_CACHE_DIR": driver_folder}
    with MeshLabWindow(display, program, large_sphere, **environment) as meshlab:
        loop.begin()
        tool = Tool(meshlab)
        tool.wait_until_ready()
        start = loop.longest
        tool.draw()
        tool.press("closed")
        meshlab.wait_for_still_picture()
        loop.learn_frame()
        yield tool, loop, start()


@pytest.mark.usefixtures("compiled")
def test_start_layers_and_cut_do_not_block(drawn):
    tool, loop, start = drawn
    longest = {"start": start}
    loop.begin()
    make_layers(tool)
    longest["layers"] = loop.longest()
    loop.begin()
    cut(tool)
    longest["cut"] = loop.longest()
    print(longest, loop.frame)
    most = MOST_FRAMES * loop.frame
    for what, (seconds, computed) in longest.items():
        assert computed < most and seconds < most * PATIENCE, (what, longest, loop.frame)


def test_a_cut_that_runs_is_given_up(drawn):
    tool, _, _ = drawn
    meshlab = tool.meshlab
    make_layers(tool)
    tool.press("Cut")
    tool.press("Cancel")
    time.sleep(5.0)  # more than a cut takes
    assert meshlab.layers() == 3  # the sphere, the curve and its tube
    tool.press("Cut")
    tool.press("Close")
    meshlab.wait_for_log(GIVEN_UP)
    tool.wait_for_end()
    assert not any(re.search(CUT, line) for line in meshlab.log())
    tool = Tool(meshlab, 2)
    tool.wait_until_ready()
    tool.press("Cut")
    meshlab.key("ctrl+q")
    meshlab.wait_for_window("^B-spline Curves$")  # curves are in no file
    meshlab.key("shift+Tab", "space")  # close without saving
    assert meshlab.exit_status() == 0
