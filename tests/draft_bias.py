#!/usr/bin/env python3
"""The bias of drafts against the fine mesh, from the folder of scenarios/studies/draft_bias.toml.

usage: tests/draft_bias.py STUDY_FOLDER engine/scenario/draft_bias.h scenarios/DRAFT.md

Each capture was run twice with the same draws. Means are those of the differences, draft minus fine. Intervals are 1.96
standard errors of these means; of the probability, where hardly any capture differs, the longer side of Newcombe's
interval for paired proportions (method 10 of Newcombe 1998,
doi:10.1002/(SICI)1097-0258(19981130)17:22<2635::AID-SIM954>3.0.CO;2-C).
"""

import csv
import math
import sys

HEADER = """#pragma once
// Bias of drafts against the fine mesh. Written by `./dev draft-bias`; not to be edited.

namespace netpocket {{

// Mean of draft minus fine over the same captures, and half the width of its 95 % interval.
struct MeasuredBias {{
  double mean, half_width;
}};

struct DraftBias {{
  int captures;
  MeasuredBias probability;    // of capture
  MeasuredBias first_contact;  // s
  MeasuredBias impulse;        // size of the impulse on the target, as a part of its mean
}};

inline constexpr DraftBias kDraftBias = {{
    .captures = {captures},
    .probability = {{{probability}}},
    .first_contact = {{{first_contact}}},
    .impulse = {{{impulse}}},
}};

}}  // namespace netpocket
"""


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def mean(values):
    return sum(values) / len(values)


def half_width(values):
    m = mean(values)
    return 1.96 * math.sqrt(sum((v - m) ** 2 for v in values) / (len(values) - 1) / len(values))


def quantile(values, fraction):
    return sorted(values)[round(fraction * (len(values) - 1))]


def impulse(row):
    return math.sqrt(sum(float(row[f"impulse_{axis}_Ns"]) ** 2 for axis in "xyz"))


def wilson(count, of):
    z = 1.96
    part, root = count / of, z * math.sqrt(count / of * (1 - count / of) / of + (z / (2 * of)) ** 2)
    return tuple((part + z * z / (2 * of) + sign * root) / (1 + z * z / of) for sign in (-1, 1))


def paired_bias(pairs):
    """Difference of two proportions of the same captures, (fine, draft) each, and the longer side of its interval."""
    n = len(pairs)
    both, neither = sum(f and d for f, d in pairs), sum(not f and not d for f, d in pairs)
    fine, draft = sum(f for f, _ in pairs), sum(d for _, d in pairs)
    spread = math.sqrt(fine * (n - fine) * draft * (n - draft))
    shared = both * neither - (fine - both) * (draft - both)
    phi = max(shared - n / 2, min(shared, 0)) / spread if spread > 0 else 0
    (l_f, u_f), (l_d, u_d) = wilson(fine, n), wilson(draft, n)
    down = (draft / n - l_d, u_f - fine / n)
    up = (u_d - draft / n, fine / n - l_f)
    sides = [math.sqrt(a * a - 2 * phi * a * b + b * b) for a, b in (down, up)]
    return (draft - fine) / n, max(sides)


def bias(values, unit=1.0):
    return mean(values) / unit, half_width(values) / unit


def main():
    folder, header_path, page_path = sys.argv[1:4]
    runs = {(row["point"], row["variant"]): row for row in read(f"{folder}/study.csv")}
    seconds = {(row["point"], row["variant"]): float(row["cpu_s"]) for row in read(f"{folder}/study_timings.csv")}
    points = sorted({int(point) for point, _ in runs})
    pairs = [tuple(runs[str(p), v] for v in ("fine", "draft")) for p in points]
    lost = [p for p in pairs if any(row["captured"] not in ("yes", "no") for row in p)]
    pairs = [p for p in pairs if p not in lost]

    captured = [(f["captured"] == "yes", d["captured"] == "yes") for f, d in pairs]
    touching = [(float(f["first_contact_s"]), float(d["first_contact_s"])) for f, d in pairs
                if f["first_contact_s"] and d["first_contact_s"]]
    one_touches = sum(bool(f["first_contact_s"]) != bool(d["first_contact_s"]) for f, d in pairs)
    impulses = [(impulse(f), impulse(d)) for f, d in pairs]
    fine_impulse = mean([f for f, _ in impulses])
    probability = paired_bias(captured)
    contact = bias([d - f for f, d in touching])
    of_impulse = bias([d - f for f, d in impulses], fine_impulse)

    def number(pair):
        return ", ".join(f"{v:.7f}" for v in pair)

    with open(header_path, "w", encoding="utf-8") as file:
        file.write(HEADER.format(captures=len(pairs), probability=number(probability), first_contact=number(contact),
                                 impulse=number(of_impulse)))

    end = 12.0  # s simulated in each run
    cpu = {v: [seconds[str(p), v] for p in points] for v in ("fine", "draft")}
    steps = {v: [float(runs[str(p), v]["time_step_s"]) for p in points] for v in ("fine", "draft")}
    error = {v: [float(runs[str(p), v]["energy_error"]) for p in points] for v in ("fine", "draft")}

    def verdict(value, bound):
        reached = abs(value[0]) < bound
        surely = abs(value[0]) + value[1] < bound
        return "below" if surely else "below, its interval not" if reached else "not reached"

    page = f"""# What a draft is worth

`solver.fidelity = "draft"` against the mesh of case 1, over the scattered captures of `studies/draft_bias.toml`: each was run twice with the
same draws. Written by `./dev draft-bias`, with the table from which the program says it (engine/scenario/draft_bias.h). THEORY.md 7.4 says
what a draft is. Intervals are of 95 %.

{len(pairs)} captures; {len(lost)} more were not judged, because one of the two runs ended early.

| quantity | fine | draft | draft minus fine | bound | |
| --- | --- | --- | --- | --- | --- |
| probability of capture | {100 * mean([f for f, _ in captured]):.1f} % | {100 * mean([d for _, d in captured]):.1f} % | \
{100 * probability[0]:+.2f} +- {100 * probability[1]:.2f} points | 1 point | {verdict(probability, 0.01)} |
| first contact | {mean([f for f, _ in touching]):.3f} s | {mean([d for _, d in touching]):.3f} s | \
{contact[0]:+.3f} +- {contact[1]:.3f} s | 0.05 s | {verdict(contact, 0.05)} |
| impulse on the target | {fine_impulse:.2f} N s | {mean([d for _, d in impulses]):.2f} N s | \
{100 * of_impulse[0]:+.1f} +- {100 * of_impulse[1]:.1f} % | 5 % | {verdict(of_impulse, 0.05)} |

Captured only by the fine mesh: {sum(f and not d for f, d in captured)}, only by the draft: {sum(d and not f for f, d in captured)}. \
Touched in one of the two only: {one_touches}. First contact is that of a frame, of which there are
20 a second. The impulse is the size of the vector; its mean is made by the few captures in which the winches press the target: the median of
the differences is {quantile([d - f for f, d in impulses], 0.5):+.2f} N s, nine tenths lie between \
{quantile([d - f for f, d in impulses], 0.05):+.1f} and {quantile([d - f for f, d in impulses], 0.95):+.1f} N s. A single capture is not
predicted by its draft, a map is.

| | fine | draft | ratio |
| --- | --- | --- | --- |
| processor time of a capture of {end:g} s, mean (s) | {mean(cpu["fine"]):.3f} | {mean(cpu["draft"]):.3f} | \
{mean(cpu["fine"]) / mean(cpu["draft"]):.1f} |
| median, dearest twentieth (s) | {quantile(cpu["fine"], 0.5):.3f}, {quantile(cpu["fine"], 0.95):.3f} | \
{quantile(cpu["draft"], 0.5):.3f}, {quantile(cpu["draft"], 0.95):.3f} | |
| times real time, of all | {end / mean(cpu["fine"]):.1f} | {end / mean(cpu["draft"]):.1f} | |
| energy error, part of the energy put in: median, nine tenths, largest | {quantile(error["fine"], 0.5):.1e}, \
{quantile(error["fine"], 0.9):.1e}, {max(error["fine"]):.1e} | {quantile(error["draft"], 0.5):.1e}, {quantile(error["draft"], 0.9):.1e}, \
{max(error["draft"]):.1e} | |
| smallest step, median (ms) | {1e3 * quantile(steps["fine"], 0.5):.3f} | {1e3 * quantile(steps["draft"], 0.5):.3f} | \
{quantile(steps["draft"], 0.5) / quantile(steps["fine"], 0.5):.1f} |

Times are processor time, of a machine that did other things too.
"""
    with open(page_path, "w", encoding="utf-8") as file:
        file.write(page)
    print(page)


if __name__ == "__main__":
    main()
