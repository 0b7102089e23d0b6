#!/usr/bin/python3
"""Times pictures of one run by netpocket, by F3D and by a plain VTK Python script, in turns on the same machine.

usage: picture_peers.py NETPOCKET RUN.h5 RESULTS.md     (under xvfb-run: the peers need a display, netpocket does not)

All draw 1280x720. The peers read the VTP series that netpocket exports, draw lines and bodies with the defaults of VTK and
know no labels; netpocket draws its whole scene from the recording. Needs the Debian packages f3d, python3-vtk9 and xvfb.
"""

import glob
import os
import resource
import subprocess
import sys
import tempfile
import time
from typing import NamedTuple

ROUNDS = 7
SERIES = 40  # frames


class Times(NamedTuple):
    wall: float  # s
    cpu: float  # s, of the program and what it started


def times_of(command):
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return Times(wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def plain_vtk(folder, count, smooth):
    """The peer: reads, draws and writes each frame of the series."""
    import vtk

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetUseFXAA(smooth)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(1280, 720)
    window.AddRenderer(renderer)
    readers = []
    for part in ("lines", "bodies"):
        reader = vtk.vtkXMLPolyDataReader()
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(reader.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.2, 0.2, 0.25)
        renderer.AddActor(actor)
        readers.append((reader, part))
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    for frame in range(count):
        for reader, part in readers:
            reader.SetFileName(f"{folder}/{part}_{frame:04}.vtp")
        if frame == 0:
            renderer.ResetCamera()
        window.Render()
        grabber.Modified()
        writer.SetFileName(f"{folder}/plain_{frame:04}.png")
        writer.Write()


def in_turns(contestants):
    """The best of each contestant's times over the rounds, after one to warm up: what others do on the machine only adds."""
    best = {name: Times(float("inf"), float("inf")) for name in contestants}
    for turn in range(ROUNDS + 1):
        for name, command in contestants.items():
            now = times_of(command)
            if turn > 0:
                best[name] = Times(min(best[name].wall, now.wall), min(best[name].cpu, now.cpu))
    return best


def start_table(best):
    own = best["netpocket"]
    rows = [f"| {name} | {t.wall:.3f} | {t.cpu:.3f} | {t.wall / own.wall:.2f} | {t.cpu / own.cpu:.2f} |"
            for name, t in best.items()]
    return ["## From the start of the program to one PNG", "",
            "| program | s | s of processor time | x netpocket | x its processor time |", "| --- | --- | --- | --- | --- |",
            *rows]


def rate_table(series, start, frames):
    rows = []
    for name, times in series.items():
        wall, cpu = times.wall - start[START_OF[name]].wall, times.cpu - start[START_OF[name]].cpu
        rows.append(f"| {name} | {(frames - 1) / wall:.1f} | {(frames - 1) / cpu:.1f} |")
    return [f"## Pictures drawn and written as PNG, without the start ({frames} pictures)", "",
            "| program | a second | a second of processor time |", "| --- | --- | --- |", *rows]


def heading():
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()
    return ["# Pictures by netpocket and by others", "",
            "Written by `./dev bench`: 1280x720, one second of case 1, the best of several rounds in turns. Other programs on the",
            "machine make the times longer and the seconds of processor time less so.", "",
            f"- commit {commit or 'unknown'}, {time.strftime('%Y-%m-%d', time.gmtime())}",
            f"- {os.cpu_count()} processors, load average at the end {os.getloadavg()[0]:.1f}"]


START_OF = {"netpocket, plain": "netpocket", "netpocket, smoothed": "netpocket, smoothed",
            "VTK Python, plain": "plain VTK Python", "VTK Python, FXAA": "plain VTK Python"}


def measure(netpocket, run):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([netpocket, "export", run, "--vtp", folder, "--quiet"], check=True)
        frames = min(SERIES, len(glob.glob(f"{folder}/lines_*.vtp")))
        render = [netpocket, "render", run, "--backend", "osmesa", "--quiet", "-o", f"{folder}/out"]
        peer = ["/usr/bin/python3", os.path.abspath(__file__), "--plain", folder]
        start = in_turns({
            "netpocket": render + ["--times", "0", "--supersampling", "1"],
            "netpocket, smoothed": render + ["--times", "0"],
            "F3D": ["f3d", f"{folder}/lines_0000.vtp", "--resolution=1280,720", f"--output={folder}/f3d.png"],
            "plain VTK Python": peer + ["1", "plain"],
        })
        times = ",".join(f"{i / 50:g}" for i in range(frames))
        series = in_turns({
            "netpocket, plain": render + ["--times", times, "--supersampling", "1"],
            "netpocket, smoothed": render + ["--times", times],
            "VTK Python, plain": peer + [str(frames), "plain"],
            "VTK Python, FXAA": peer + [str(frames), "smooth"],
        })
    return ["", *start_table(start), "", *rate_table(series, start, frames)]


def main(netpocket, run, results):
    tables = measure(netpocket, run)
    text = "\n".join(heading() + tables) + "\n"
    print(text, end="")
    with open(results, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    if len(sys.argv) == 5 and sys.argv[1] == "--plain":
        plain_vtk(sys.argv[2], int(sys.argv[3]), sys.argv[4] == "smooth")
    elif len(sys.argv) == 4:
        main(*sys.argv[1:])
    else:
        sys.exit(__doc__)
