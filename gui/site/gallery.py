"""The gallery: every scenario run, with a sheet of pictures, a video and its numbers."""

from __future__ import annotations

import concurrent.futures
import json
import pathlib
import subprocess
import tomllib

from reference_pages import output_of, table


def run_scenario(program: str, scenario: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    """Leaves NAME.h5, NAME.png and NAME.mp4 in the folder; what is newer than scenario and program is kept."""
    recording = folder / f"{scenario.stem}.h5"
    newest = max(scenario.stat().st_mtime, pathlib.Path(program).stat().st_mtime)
    video = recording.with_suffix(".mp4")
    if video.exists() and video.stat().st_mtime > newest:
        return recording
    subprocess.run([program, "run", str(scenario), "-o", str(recording), "--overwrite", "--quiet"], check=True)
    end = json.loads(output_of(program, "info", str(recording), "--json"))["simulated_seconds"]
    times = ",".join(f"{end * part:.2f}" for part in (0, 0.2, 0.35, 0.5, 0.7, 0.99))
    subprocess.run([program, "render", str(recording), "--times", times, "--sheet", str(recording.with_suffix(".png")),
                    "--panel-size", "420x420", "--columns", "3", "--quiet"], check=True)
    subprocess.run([program, "render", str(recording), "--fps", "12", "--size", "640x480", "--video", str(video), "--quiet"], check=True)
    return recording


def number(value: float | None, unit: str) -> str:
    return "-" if value is None else f"{value:.3g} {unit}".rstrip()


def numbers_of(program: str, recording: pathlib.Path) -> list[str]:
    run = json.loads(output_of(program, "info", str(recording), "--json"))
    force, error = run["peak_force"], run["energy_error"]
    largest = max((abs(force[axis]) for axis in "xyz"), default=0.0)
    rows = [["caught", run["capture"]], ["first contact", number(run.get("first_contact_time"), "s")],
            ["largest contact force along an axis", number(largest, "N")],
            ["energy error", "-" if error is None else f"{100 * error:.2g} %"],
            ["model", f"{run['elements']} elements, {run['steps']} steps"],
            ["speed", f"{run['simulated_seconds'] / run['wall_seconds']:.1f} times real time where this page was made"]]
    return table(["", ""], rows)


def gallery_page(program: str, scenarios: pathlib.Path, stage: pathlib.Path, jobs: int) -> tuple[str, list[pathlib.Path]]:
    """The page, and the recordings behind it."""
    folder = stage / "gallery"
    folder.mkdir(exist_ok=True)
    files = sorted(scenarios.glob("*.toml"))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        recordings = list(pool.map(lambda file: run_scenario(program, file, folder), files))
    page = ["# Gallery", "", "All scenarios that come with Netpocket, each run and drawn by it. Copy one as the start of your own.", ""]
    for file, recording in zip(files, recordings, strict=True):
        scenario = tomllib.loads(file.read_text())
        page += [f"## {file.stem}", "", scenario.get("description", "").strip().rstrip(".") + ".", "",
                 f"![Moments of {file.stem}](gallery/{file.stem}.png)", "", f"```{{video}} gallery/{file.stem}.mp4", "```", "",
                 *numbers_of(program, recording), ""]
    return "\n".join(page), recordings
