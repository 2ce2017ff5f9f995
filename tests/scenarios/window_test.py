#!/usr/bin/python3
"""The window as a person uses it: on a virtual screen, by mouse and keys, judged by what is seen.

Usage: window_test.py PROGRAM SCENARIOS CASE, with CASE one of ripple, refusal, endurance, lost_device, no_display. Exit 77:
not judged, as Xvfb, xdotool or a Vulkan device is missing.
"""

import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

SKIPPED = 77
PATIENCE_S = 120  # for what a loaded machine takes seconds for


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def wait_until(holds, what):
    """Returns what `holds` returns once it is true."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        result = holds()
        if result:
            return result
        time.sleep(0.05)
    raise AssertionError(f"waited {PATIENCE_S} s for {what}")


class Screen:
    """An X server of 1280 x 800 pixels that draws into a file."""

    def __init__(self, folder):
        self.file = folder / "Xvfb_screen0"
        told, tell = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(tell), "-screen", "0", "1280x800x24", "-fbdir", folder, "-nolisten", "tcp",
             "-noreset"],
            pass_fds=[tell], stderr=subprocess.DEVNULL)
        os.close(tell)
        with os.fdopen(told) as answer:
            self.display = ":" + answer.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.display)

    def close(self):
        self.server.terminate()
        self.server.wait()

    def do(self, *command):
        """xdotool; returns what it prints."""
        return subprocess.run(["xdotool", *map(str, command)], env=self.environment, capture_output=True,
                              text=True).stdout.strip()

    def picture(self):
        """Red, green and blue, rows from the top down: an X window dump has numbers of 4 bytes, highest first."""
        data = self.file.read_bytes()
        header = struct.unpack(">25I", data[:100])
        start, width, height = header[0] + 12 * header[19], header[4], header[5]
        pixels = np.frombuffer(data, np.uint8, 4 * width * height, start).reshape(height, width, 4)
        return pixels[:, :, 2::-1].astype(int)


class View:
    """`waterlight view` on a screen."""

    def __init__(self, program, screen, arguments):
        self.screen = screen
        self.lines = []
        self.process = subprocess.Popen([program, "view", *map(str, arguments)], env=screen.environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.reader = threading.Thread(target=lambda: self.lines.extend(iter(self.process.stdout.readline, "")))
        self.reader.start()
        try:
            self.window = wait_until(self.find, "the window")
        except AssertionError:
            self.kill()
            raise

    def find(self):
        self.require_alive()
        found = self.screen.do("search", "--onlyvisible", "--name", "waterlight$").split()
        return found[0] if found else None

    def require_alive(self):
        if self.process.poll() is not None:
            self.reader.join()
            raise AssertionError(f"view ended with {self.process.returncode}: {''.join(self.lines)}")

    def resident_mib(self):
        """None of a process that has just ended."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        found = re.search(r"VmRSS:\s+(\d+)", status)
        return int(found.group(1)) / 1024 if found else None

    def shown(self):
        """Pictures so far, as the progress of --frames says."""
        found = [re.search(r"picture (\d+)", line) for line in self.lines]
        return max([int(match.group(1)) for match in found if match], default=0)

    def place(self):
        """Upper left corner and size on the screen."""
        words = self.screen.do("getwindowgeometry", "--shell", self.window)
        values = dict(line.split("=") for line in words.splitlines())
        return [int(values[key]) for key in ("X", "Y", "WIDTH", "HEIGHT")]

    def picture(self):
        x, y, width, height = self.place()
        return self.screen.picture()[y:y + height, x:x + width]

    def end(self):
        """Waits for its end by itself; returns its exit and what it said."""
        self.process.wait(PATIENCE_S)
        self.reader.join()
        return self.process.returncode, "".join(self.lines)

    def kill(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
        self.process.wait()


def read_png(file):
    """Red, green and blue, rows from the top down."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1].astype(int)


SMALL = ["--set", "domain.cells=[128,96]", "--set", "caustics.floor.pixels=[128,96]", "--backend", "cpu"]
CALM = ["--set", "waves.source=[]", "--set", "light.elevation_deg=90"]


def change(before, after):
    """How much colours have changed, levels of 255, as means of 7 x 7 pixels: fine lines between tiles flicker."""
    difference = np.abs(after - before).max(axis=2).astype(float)
    sums = np.pad(difference, ((4, 3), (4, 3))).cumsum(0).cumsum(1)
    return (sums[7:, 7:] - sums[:-7, 7:] - sums[7:, :-7] + sums[:-7, :-7]) / 49


def ring(before, after, at):
    """The most that has changed 20 to 140 pixels from a place, in the one of eight directions with the least of it."""
    changes = change(before, after)
    y, x = np.mgrid[:changes.shape[0], :changes.shape[1]]
    distance = np.hypot(x - at[0], y - at[1])
    octant = ((np.arctan2(y - at[1], x - at[0]) + np.pi) / (np.pi / 4)).astype(int) % 8
    around = (20 < distance) & (distance < 140)
    return min(changes[around & (octant == n)].max() for n in range(8))


def far(before, after, at):
    """The mean of what has changed farther than 250 pixels from a place."""
    changes = change(before, after)
    y, x = np.mgrid[:changes.shape[0], :changes.shape[1]]
    return changes[np.hypot(x - at[0], y - at[1]) > 250].mean()


LEAST = 6.0  # levels, of a ring that is seen
STEPS = 18   # of a thirtieth of a second


def judge_ring(before, after, at, what):
    near, beyond = ring(before, after, at), far(before, after, at)
    print(f"{what}: {near:.2f} levels in every direction round the click, {beyond:.2f} far from it")
    assert near > LEAST, f"{what}: no ring: a change of {near:.2f} levels in one direction"
    assert beyond < 0.1 * near, f"{what}: far from the click, {beyond:.2f} levels have changed"


def test_ripple(program, scenarios, screen, folder):
    shot = folder / "shot.png"
    view = View(program, screen, [scenarios / "pool.toml", *SMALL, *CALM, "--size", "900x600", "--validate",
                                  "--screenshot", shot])
    try:
        x0, y0, width, height = view.place()
        assert (width, height) == (900, 600), (width, height)
        at = (600, 300)

        def shot_by_key(key):
            shot.unlink(missing_ok=True)
            screen.do("key", key)
            wait_until(lambda: view.require_alive() or shot.exists(), "the screenshot by " + key)
            return read_png(shot)

        def settled():
            """The screenshot once nothing moves any more."""
            shots = [shot_by_key("F2"), shot_by_key("p")]
            while (shots[-1] != shots[-2]).any():
                shots.append(shot_by_key("F2"))
            return shots[-1]

        water = np.s_[:, 400:]  # of the screen, without the panel, whose numbers change
        wait_until(lambda: view.picture()[at[1], at[0]].max() > 0, "the first picture")
        screen.do("key", "space")
        # A right drag downwards takes the camera above the water, where the light on the floor lies below its wave.
        screen.do("mousemove", x0 + at[0], y0 + 100, "mousedown", 3)
        for y in range(100, 500, 20):
            screen.do("mousemove", x0 + at[0], y0 + y)
        screen.do("mouseup", 3, "mousemove", x0 + at[0], y0 + at[1])
        own_before, before = settled(), view.picture()
        screen.do("mousemove", x0 + 200, y0 + 22, "click", 1, "key", "period")
        assert change(own_before, settled()).max() < LEAST, "a click on the panel has gone through to the water"
        screen.do("mousemove", x0 + at[0], y0 + at[1], "click", 1)
        for _ in range(STEPS):
            screen.do("key", "period")
        own_after, after = settled(), view.picture()
        screen.do("key", "Escape")
        code, said = view.end()
        assert code == 0, f"exit {code}: {said}"
        judge_ring(before[water], after[water], (at[0] - 400, at[1]), "on the screen")
        judge_ring(own_before, own_after, at, "in the screenshot")
    finally:
        view.kill()


CELLS_FIELD = (60, 476)      # of the panel, in a window that has room for it
WARNING = (255, 140, 89)     # the colour of what is refused


def test_refusal(program, scenarios, screen, folder):
    """Typing 0 cells brings the line that says what is allowed, and the water goes on."""
    view = View(program, screen, [scenarios / "pool.toml", *SMALL, "--size", "1270x790", "--validate"])
    try:
        x0, y0, _, _ = view.place()

        def warned():
            return (np.abs(view.picture()[:, :400] - WARNING).max(axis=2) < 20).sum()

        wait_until(lambda: view.picture()[:, :400].max() > 200, "the panel")
        assert warned() == 0, "a warning before anything was done"
        screen.do("mousemove", x0 + CELLS_FIELD[0], y0 + CELLS_FIELD[1], "click", "--repeat", 2, "--delay", 80, 1)
        time.sleep(0.5)
        screen.do("key", "ctrl+a")
        screen.do("type", "0")
        screen.do("key", "Return")
        wait_until(lambda: view.require_alive() or warned() > 100, "the line that says what is allowed")
        before = view.picture()[:, 400:]
        wait_until(lambda: change(before, view.picture()[:, 400:]).max() > LEAST, "water that goes on")
        screen.do("key", "Escape")
        code, said = view.end()
        assert code == 0, f"exit {code}: {said}"
    finally:
        view.kill()


def test_endurance(program, scenarios, screen, folder):
    frames = 1000
    # A heap that gives back at once what is freed: else the holes that windows of other sizes leave are 20 MiB more or less.
    screen.environment.update(MALLOC_MMAP_THRESHOLD_="131072", MALLOC_TRIM_THRESHOLD_="131072")
    view = View(program, screen,
                [scenarios / "pool.toml", *SMALL, "--size", "320x240", "--validate", "--frames", frames])
    manager = subprocess.Popen(["openbox"], env=screen.environment, stderr=subprocess.DEVNULL) \
        if shutil.which("openbox") else None
    hide, show = ("windowminimize", "windowactivate") if manager else ("windowunmap", "windowmap")
    early, late = [], []  # MiB while the first and the last 300 pictures are shown
    hidden = 0
    try:
        n = 0
        while view.process.poll() is None:
            n += 1
            shown = view.shown()
            if not 300 < shown < frames - 300:
                (early if shown <= 300 else late).append(view.resident_mib() or 0)
            if n % 40 == 20:
                screen.do(hide, view.window)
                time.sleep(0.3)
                screen.do(show, view.window)
                hidden += 1
            else:
                screen.do("windowsize", view.window, 240 + 57 * (n % 8), 200 + 43 * (3 * n % 8))
            time.sleep(0.05)
        code, said = view.end()
        assert code == 0, f"exit {code}: {said}"
        assert early and late and hidden > 0, (early, late, hidden, said)
        before, after = max(early), max(late)
        print(f"resident at most {before:.1f} MiB up to 300 pictures, {after:.1f} MiB of the last 300; {n} sizes, "
              f"hidden {hidden} times")
        assert after < before + 4, f"memory grows: from {before:.1f} to {after:.1f} MiB in 700 pictures"
    finally:
        view.kill()
        if manager:
            manager.terminate()
            manager.wait()


def test_lost_device(program, scenarios, screen, folder):
    """By a layer that loses the device; $WATERLIGHT_LAYERS is where it is."""
    screen.environment.update(VK_LAYER_PATH=os.environ["WATERLIGHT_LAYERS"],
                              VK_INSTANCE_LAYERS="VK_LAYER_WATERLIGHT_lost_device", WATERLIGHT_LOST_AFTER="40")
    result = subprocess.run([program, "view", scenarios / "pool.toml", *SMALL, "--size", "320x240"],
                            env=screen.environment, capture_output=True, text=True, timeout=PATIENCE_S)
    assert result.returncode == 3 and "the Vulkan device was lost" in result.stderr, result


def test_no_display(program, scenarios):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    result = subprocess.run([program, "view", scenarios / "pool.toml"], env=environment, capture_output=True, text=True)
    assert result.returncode == 3, result
    assert result.stderr == ("waterlight: cannot open a window: no display (DISPLAY and WAYLAND_DISPLAY are not set); "
                             "`waterlight run` renders without one\n"), result.stderr


def main():
    program, scenarios, case = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    if case == "no_display":
        return test_no_display(program, scenarios)
    for tool in ("Xvfb", "xdotool"):
        if not shutil.which(tool):
            skip(f"there is no {tool}")
    if "vulkan  " not in subprocess.run([program, "devices"], capture_output=True, text=True).stdout:
        skip("there is no Vulkan device")
    with tempfile.TemporaryDirectory(prefix="waterlight window ") as name:
        folder = pathlib.Path(name)
        screen = Screen(folder)
        try:
            cases = {"ripple": test_ripple, "refusal": test_refusal, "endurance": test_endurance,
                     "lost_device": test_lost_device}
            cases[case](program, scenarios, screen, folder)
        finally:
            screen.close()


if __name__ == "__main__":
    main()
