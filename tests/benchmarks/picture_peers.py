#!/usr/bin/python3
"""Times pictures of one run by netpocket, by F3D and by a plain VTK Python script, in turns on the same machine.

usage: picture_peers.py NETPOCKET RUN.h5     (under xvfb-run: the peers need a display, netpocket does not)

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


def report_start(best):
    print(f"\nFrom the start of the program to one PNG, best of {ROUNDS}: s, of processor time, ratios to netpocket")
    own = best["netpocket"]
    for name, times in best.items():
        print(f"  {name:<26}{times.wall:8.3f}{times.cpu:8.3f}{times.wall / own.wall:8.2f}{times.cpu / own.cpu:8.2f}")


def report_rates(series, start, frames):
    print(f"\nPictures drawn and written as PNG, without the start ({frames} pictures): a second, a second of processor time")
    for name, (times, first) in {name: (series[name], start[START_OF[name]]) for name in series}.items():
        wall, cpu = times.wall - first.wall, times.cpu - first.cpu
        print(f"  {name:<26}{(frames - 1) / wall:8.1f}{(frames - 1) / cpu:8.1f}")


START_OF = {"netpocket, plain": "netpocket", "netpocket, smoothed": "netpocket, smoothed",
            "VTK Python, plain": "plain VTK Python", "VTK Python, FXAA": "plain VTK Python"}


def main(netpocket, run):
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
        report_start(start)
        times = ",".join(f"{i / 50:g}" for i in range(frames))
        series = in_turns({
            "netpocket, plain": render + ["--times", times, "--supersampling", "1"],
            "netpocket, smoothed": render + ["--times", times],
            "VTK Python, plain": peer + [str(frames), "plain"],
            "VTK Python, FXAA": peer + [str(frames), "smooth"],
        })
        report_rates(series, start, frames)
        print(f"\nLoad average {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors")


if __name__ == "__main__":
    if len(sys.argv) == 5 and sys.argv[1] == "--plain":
        plain_vtk(sys.argv[2], int(sys.argv[3]), sys.argv[4] == "smooth")
    elif len(sys.argv) == 3:
        main(sys.argv[1], sys.argv[2])
    else:
        sys.exit(__doc__)
