# SPDX-License-Identifier: GPL-3.0-or-later
"""An X server without a screen, with OpenGL and a window manager, for programs that need a window."""
import io
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from PIL import Image

# Machines that are busy with other things are slow; nothing waits longer than this for one thing.
PATIENCE_SECONDS = 120.0


def wait_until(condition, what, seconds=PATIENCE_SECONDS, interval=0.1):
    """The first true value of condition(). Raises TimeoutError saying what did not come."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise TimeoutError(f"waited {seconds:g} s for {what}")
        time.sleep(interval)


class VirtualDisplay:
    """Use it in a `with` statement: everything that it started ends with it."""

    PROGRAMS = ("Xvfb", "openbox", "xdotool", "import")

    def __init__(self, width=1280, height=1200):
        self.width, self.height = width, height
        self.environment = None
        self._processes = []
        self._manager = None
        self._folder = None

    @classmethod
    def missing_programs(cls):
        return [name for name in cls.PROGRAMS if shutil.which(name) is None]

    def __enter__(self):
        self._folder = Path(tempfile.mkdtemp(prefix="display-"))
        (self._folder / "runtime").mkdir(mode=0o700)
        try:
            number = self._start_server()
            self.environment = {
                **os.environ,
                "DISPLAY": f":{number}",
                "HOME": str(self._folder),  # no settings of whoever runs this
                "XDG_RUNTIME_DIR": str(self._folder / "runtime"),
                "XDG_CACHE_HOME": str(self._folder / "cache"),
                "XDG_CONFIG_HOME": str(self._folder / "config"),
                "XDG_DATA_HOME": str(self._folder / "data"),
                "LIBGL_ALWAYS_SOFTWARE": "1",
                "LC_ALL": "C.UTF-8",
            }
            self.keep_managed()
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_):
        self._end()

    @property
    def home(self):
        return self._folder

    def start(self, command, output=subprocess.DEVNULL, **environment):
        """Starts a program on this display; it ends at the latest with the display."""
        process = subprocess.Popen(
            [str(word) for word in command], stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
            cwd=self._folder, env={**self.environment, **environment}, start_new_session=True,
        )
        self._processes.append(process)
        return process

    def keep_managed(self):
        """Starts the window manager where none runs: without one windows are not maximised, and all later tests would fail."""
        if self._manager is None or self._manager.poll() is not None:
            with open(self._folder / "openbox.log", "ab") as log:
                self._manager = self.start(["openbox"], output=log)
            wait_until(lambda: self.xdotool("get_num_desktops"), "the window manager")

    def state_of_manager(self):
        """Whether the window manager runs, and what it said."""
        ended = self._manager.poll()
        state = "runs" if ended is None else f"ended with {ended}"
        return f"the window manager {state}: {(self._folder / 'openbox.log').read_text(errors='replace')!r}"

    def run(self, command, timeout=300, cwd=None, **environment):
        """Runs a program on this display to its end."""
        return subprocess.run(
            [str(word) for word in command], cwd=cwd or self._folder, env={**self.environment, **environment},
            stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", timeout=timeout,
        )

    def xdotool(self, *words):
        """The words that xdotool answers with; none where it fails (it does where a search finds nothing)."""
        return self.run(["xdotool", *words], timeout=60).stdout.split()

    def picture(self):
        """What the display shows, as an RGB image."""
        command = ["import", "-silent", "-window", "root", "png:-"]
        done = subprocess.run(command, env=self.environment, capture_output=True, check=True, timeout=60)
        return Image.open(io.BytesIO(done.stdout)).convert("RGB")

    def _start_server(self):
        reading, writing = os.pipe()
        command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{self.width}x{self.height}x24",
                   "+extension", "GLX", "-nolisten", "tcp"]
        self._processes.append(subprocess.Popen(
            command, pass_fds=[writing], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, start_new_session=True,
        ))
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()  # comes when the server is ready, or empty when it ends
        if not number:
            raise RuntimeError("Xvfb did not start")
        return number

    def _end(self):
        for process in reversed(self._processes):
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self._processes.clear()
        shutil.rmtree(self._folder, ignore_errors=True)
