#!/usr/bin/python3
"""Times pictures of one run by netpocket, by F3D and by a plain VTK Python script, in turns on the same machine.

usage: picture_peers.py NETPOCKET RUN.h5     (under xvfb-run: the peers need a display, netpocket does not)

All draw 1280x720. The peers read the VTP series that netpocket exports, draw lines and bodies with the defaults of VTK and
know no labels; netpocket draws its whole scene from the recording. Prints medians over the rounds and the ratio to
netpocket. Needs the Debian packages f3d, python3-vtk9 and xvfb.
"""

import glob
import os
import statistics
import subprocess
import sys
import tempfile
import time

ROUNDS = 5
SERIES = 40  # frames


def seconds(command):
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - start


def plain_vtk(folder, count, smooth, write):
    """The peer: reads, draws and, unless told not to, writes each frame of the series."""
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
        if write:
            grabber.Modified()
            writer.SetFileName(f"{folder}/plain_{frame:04}.png")
            writer.Write()


def median(values):
    return statistics.median(values)


def in_turns(contestants):
    """Each contestant's times over the rounds; one warm-up."""
    times = {name: [] for name in contestants}
    for _ in range(ROUNDS + 1):
        for name, command in contestants.items():
            times[name].append(seconds(command))
    return {name: values[1:] for name, values in times.items()}


def report(title, unit, values, reference):
    print(f"\n{title}")
    for name, value in values.items():
        print(f"  {name:<34}{value:9.3f} {unit}   {value / values[reference]:6.2f} x netpocket")


def main(netpocket, run):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([netpocket, "export", run, "--vtp", folder, "--quiet"], check=True)
        frames = min(SERIES, len(glob.glob(f"{folder}/lines_*.vtp")))
        me = ["/usr/bin/python3", os.path.abspath(__file__)]
        out = f"{folder}/out"
        render = [netpocket, "render", run, "--backend", "osmesa", "--quiet", "-o", out]
        start = in_turns({
            "netpocket": render + ["--times", "0", "--supersampling", "1"],
            "netpocket, smoothed": render + ["--times", "0"],
            "F3D": ["f3d", f"{folder}/lines_0000.vtp", "--resolution=1280,720", f"--output={folder}/f3d.png"],
            "plain VTK Python": me + ["--plain", folder, "1", "plain", "write"],
        })
        report("From the start of the program to one PNG", "s", {n: median(t) for n, t in start.items()}, "netpocket")
        times = ",".join(f"{i / 50:g}" for i in range(frames))
        series = in_turns({
            "netpocket, plain": render + ["--times", times, "--supersampling", "1"],
            "netpocket, smoothed": render + ["--times", times],
            "VTK Python, plain": me + ["--plain", folder, str(frames), "plain", "write"],
            "VTK Python, FXAA": me + ["--plain", folder, str(frames), "smooth", "write"],
        })
        first = {"netpocket, plain": "netpocket", "netpocket, smoothed": "netpocket, smoothed",
                 "VTK Python, plain": "plain VTK Python", "VTK Python, FXAA": "plain VTK Python"}
        rates = {name: (frames - 1) / max(median(t) - median(start[first[name]]), 1e-9) for name, t in series.items()}
        print(f"\nFrames drawn and written as PNG a second, without the start ({frames} frames)")
        for name, rate in rates.items():
            print(f"  {name:<34}{rate:9.1f} /s")


if __name__ == "__main__":
    if len(sys.argv) == 6 and sys.argv[1] == "--plain":
        plain_vtk(sys.argv[2], int(sys.argv[3]), sys.argv[4] == "smooth", sys.argv[5] == "write")
    elif len(sys.argv) == 3:
        main(sys.argv[1], sys.argv[2])
    else:
        sys.exit(__doc__)
