#!/usr/bin/env python3
"""Puts one mistake at a time into a copy of the source and demands that a named test notices it.

usage: mutate.py [--check] [--jobs N] [NAME...]

The mutations stand in mutations.toml next to this file. The copy and its build are kept in out/mutate/, so that the next
run compiles only what changed. --check looks only whether every text is there to be replaced. Exit code: 0 when every
mutation was noticed, 1 when one was not, 2 when one cannot be made or a test fails without it.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COPY = ROOT / "out" / "mutate" / "source"
BUILD = COPY / "build"
TEST_SECONDS = 900  # a mutated program may run for ever


def stop(message):
    print(f"mutate: {message}", file=sys.stderr)
    sys.exit(2)


def read_mutations(names):
    with open(HERE / "mutations.toml", "rb") as file:
        mutations = tomllib.load(file)["mutation"]
    known = [m["name"] for m in mutations]
    if len(set(known)) < len(known):
        stop("two mutations have the same name")
    for name in names:
        if name not in known:
            stop(f"there is no mutation '{name}'; these are: {', '.join(known)}")
    return [m for m in mutations if not names or m["name"] in names]


def mutated_files(mutation, root):
    """The changed texts by file; stops when a text is not there exactly once."""
    texts = {}
    for edit in mutation["edit"]:
        path = root / edit["file"]
        if not path.is_file():
            stop(f"{mutation['name']}: there is no file {edit['file']}")
        text = texts.get(path) or path.read_text()
        count = text.count(edit["find"])
        if count != 1:
            stop(f"{mutation['name']}: in {edit['file']} this text occurs {count} times, not once:\n{edit['find']}")
        texts[path] = text.replace(edit["find"], edit["replace"])
    return texts


def copy_source():
    """The files that git knows or would add, as they are now. Unchanged ones keep their times: they are not rebuilt."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                            check=True, capture_output=True).stdout.decode().split("\0")
    wanted = {name for name in listed if name and (ROOT / name).is_file()}
    for name in wanted:
        source, target = ROOT / name, COPY / name
        if target.is_file() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)
        shutil.copymode(source, target)
    for target in COPY.rglob("*"):
        inside_build = target == BUILD or BUILD in target.parents
        if target.is_file() and not inside_build and str(target.relative_to(COPY)) not in wanted:
            target.unlink()


def run(command, what, **options):
    result = subprocess.run(command, cwd=COPY, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if result.returncode != 0:
        print(result.stdout)
        stop(what)


def build(target, jobs, what):
    if not (BUILD / "build.ninja").is_file():
        run(["cmake", "--preset", "release", "-DNETPOCKET_WORKBENCH=OFF"], "the copy cannot be configured")
    run(["cmake", "--build", str(BUILD), "-j", str(jobs), "--target", target], what)


def test_passes(mutation):
    """Whether the tests pass; stops when the filter names none."""
    environment = {k: v for k, v in os.environ.items() if k != "NETPOCKET_RENEW"}
    command = [str(BUILD / "tests" / mutation["target"]), f"--gtest_filter={mutation['test']}"]
    try:
        result = subprocess.run(command, cwd=COPY, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True, errors="replace", timeout=TEST_SECONDS)
    except subprocess.TimeoutExpired:
        return False, f"did not end in {TEST_SECONDS} s"
    if "Running 0 tests" in result.stdout:
        stop(f"{mutation['name']}: {mutation['target']} has no test {mutation['test']}")
    lines = [line for line in result.stdout.splitlines() if "Failure" in line or "[  FAILED  ]" in line]
    return result.returncode == 0, lines[-1].strip() if lines else f"ended with {result.returncode}"


def notices(mutation, jobs):
    """Whether the test passes on the source as it is and fails with the mutation."""
    build(mutation["target"], jobs, f"{mutation['target']} does not build")
    passes, how = test_passes(mutation)
    if not passes:
        stop(f"{mutation['name']}: {mutation['test']} fails without the mutation: {how}")
    texts = mutated_files(mutation, COPY)
    originals = {path: path.read_text() for path in texts}
    try:
        for path, text in texts.items():
            path.write_text(text)
        build(mutation["target"], jobs, f"{mutation['name']}: the mutated source does not build")
        passes, how = test_passes(mutation)
    finally:
        for path, text in originals.items():
            path.write_text(text)
    print(f"{'MISSED ' if passes else 'noticed'}  {mutation['name']}: {mutation['what']}\n"
          f"         {mutation['target']} {mutation['test']}: {'passes all the same' if passes else how}", flush=True)
    return not passes


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="look only whether every text is there")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the build")
    parser.add_argument("names", nargs="*", metavar="NAME", help="mutations; all when none is named")
    arguments = parser.parse_args()
    mutations = read_mutations(arguments.names)
    for mutation in mutations:
        mutated_files(mutation, ROOT)
    if arguments.check:
        print(f"{len(mutations)} mutations can be made")
        return 0
    copy_source()
    noticed = [notices(mutation, arguments.jobs) for mutation in mutations]
    print(f"{sum(noticed)} of {len(noticed)} mutations were noticed")
    return 0 if all(noticed) else 1


if __name__ == "__main__":
    sys.exit(main())
