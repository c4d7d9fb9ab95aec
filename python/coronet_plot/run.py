# SPDX-License-Identifier: BSD-3-Clause
"""What a run left in its directory: the case, the series, the list of its frames, and how it ended."""
import csv
import json
import re
import tomllib
from pathlib import Path

import numpy


class Mistake(Exception):
    """Something the user can put right: a sentence, shown without a traceback."""


class Run:
    def __init__(self, directory):
        self.directory = Path(directory)
        if not self.directory.is_dir():
            raise Mistake(f"{directory} is not a directory; name one that `coronet run` has written.")
        missing = [name for name in ("case.toml", "series.csv") if not (self.directory / name).is_file()]
        if missing:
            raise Mistake(f"{directory} is not the directory of a run: it has no {' and no '.join(missing)}.")
        self.case = read_case(self.directory / "case.toml")
        self.series = read_table(self.directory / "series.csv", "time")
        curve = self.directory / "flow_curve.csv"
        self.flow_curve = read_table(curve, "shear_rate", "stress", "fit", "as_run") if curve.is_file() else None
        self.frames = read_frame_list(self.directory)
        summary = read_summary(self.directory / "summary.json")
        self.failed, self.measures = failure(summary), summary.get("measures", {})

    def has(self, *columns):
        return all(column in self.series for column in columns)

    @property
    def stretches(self):
        return self.has("exact_semi_axis_x")

    @property
    def rotates(self):
        """Drift is relative, so a run that starts without angular momentum has none to show."""
        named = "rotating" in self.case.get("name", "") or self.has("angular_momentum_drift")
        found = self.has("angular_momentum_z") and self.series["angular_momentum_z"][0] != 0
        return named and found and not self.driven

    @property
    def driven(self):
        """Gravity or a body force changes momentum: what is conserved without them is not here."""
        fluid = self.case.get("fluid", {})
        return any(fluid.get("gravity", [])) or any(force != "0" for force in fluid.get("body_force", []))

    @property
    def value_probes(self):
        """The probes of one value at one point, each with a column of its name."""
        probes = self.case.get("probes", [])
        return [probe for probe in probes if probe.get("kind") == "value" and self.has(probe.get("name"))]

    @property
    def name(self):
        return self.case.get("name", self.directory.resolve().name)

    @property
    def spacing(self):
        return float(self.case["particles"]["spacing"])

    @property
    def method(self):
        method = self.case.get("method", {})
        shifting = method.get("shifting", "none")
        return method.get("gradient", "run").upper() + (f" + {shifting}" if shifting != "none" else "")

    @property
    def plane(self):
        """The two axes that pictures show: x and y, or x and z where a spheroid has its own axis along z."""
        return (0, 2) if self.has("semi_axis_z") else (0, 1)

    def cell(self, time):
        """The sizes along x, y and z of what was a cube of a spacing at the start: the exact flow stretches it."""
        sizes = numpy.full(3, self.spacing)
        for k, column in enumerate("exact_semi_axis_" + axis for axis in "xyz"):
            if self.has(column):
                sizes[k] *= self.at(column, time) / self.series[column][0]
        return sizes

    def at(self, column, time):
        return numpy.interp(time, self.series["time"], self.series[column])


def read_case(path):
    try:
        case = tomllib.loads(path.read_text())
    except ValueError as error:
        raise Mistake(f"{path} is not valid TOML: {error}.") from None
    if "spacing" not in case.get("particles", {}):
        raise Mistake(f"{path} has no particles.spacing: it is not the case of a run.")
    return case


def read_table(path, *needed):
    """Columns by name. The last row of a run that still goes on may be half written: it is left out."""
    with path.open(newline="") as file:
        header, *rows = list(csv.reader(file)) or [[]]
    whole = [row for row in rows if len(row) == len(header)]
    if not whole:
        raise Mistake(f"{path} has no samples yet.")
    try:
        table = numpy.array(whole, dtype=float)
    except ValueError as error:
        raise Mistake(f"{path} holds something that is not a number: {error}.") from None
    for column in needed:
        if column not in header:
            raise Mistake(f"{path} has no column '{column}'.")
    return dict(zip(header, table.T))


def read_summary(path):
    """What the run says of itself at its end. One that goes on has no summary yet."""
    try:
        summary = json.loads(path.read_text())
    except (OSError, ValueError):
        return {}
    return summary if isinstance(summary, dict) else {}


def failure(summary):
    """None, or the time at which the run failed, from its message."""
    if summary.get("status") != "failed":
        return None
    found = re.search(r"failed at t = ([-+.\de]+) s", str(summary.get("message")))
    return float(found[1]) if found else float("nan")


def read_frame_list(directory):
    """Pairs of time and path, in order of time. Frames that were moved away since are left out."""
    listing = directory / "frames.vtkhdf.series"
    if not listing.is_file():
        return []
    try:
        entries = json.loads(listing.read_text())["files"]
        frames = [(entry["time"], directory / entry["name"]) for entry in entries]
    except (ValueError, KeyError, TypeError):
        raise Mistake(f"{listing} is not a list of frames as `coronet run` writes it.") from None
    return sorted(frame for frame in frames if frame[1].is_file())
