# SPDX-License-Identifier: BSD-3-Clause
"""What a run left in its directory: the case, the series, and the list of its frames."""
import csv
import json
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
        self.series = read_series(self.directory / "series.csv")
        self.frames = read_frame_list(self.directory)

    def has(self, *columns):
        return all(column in self.series for column in columns)

    @property
    def stretches(self):
        return self.has("exact_semi_axis_x")

    @property
    def rotates(self):
        """Drift is relative, so a run that starts without angular momentum has none to show."""
        named = "rotating" in self.case.get("name", "") or self.has("angular_momentum_drift")
        return named and self.has("angular_momentum_z") and self.series["angular_momentum_z"][0] != 0

    @property
    def spacing(self):
        return float(self.case["particles"]["spacing"])

    @property
    def method(self):
        return self.case.get("method", {}).get("gradient", "run").upper()

    @property
    def plane(self):
        """The two axes that pictures show: x and y, or x and z where a spheroid has its own axis along z."""
        return (0, 2) if self.has("semi_axis_z") else (0, 1)

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


def read_series(path):
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
    if "time" not in header:
        raise Mistake(f"{path} has no column 'time'.")
    return dict(zip(header, table.T))


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
