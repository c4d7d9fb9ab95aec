# SPDX-License-Identifier: BSD-3-Clause
"""The particles of one frame, read with the reader that ParaView uses."""
from dataclasses import dataclass

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

from coronet_plot.run import Mistake


@dataclass
class Frame:
    time: float
    positions: numpy.ndarray  # two coordinates per particle, in the plane shown
    pressure: numpy.ndarray
    cell: numpy.ndarray  # the two sizes of what a particle fills


def read_frame(run, time, path):
    """The particles of a frame in the plane that the run is shown in; in 3D those of a slice about it."""
    reader = vtkHDFReader()
    if not reader.CanReadFile(str(path)):
        raise Mistake(f"{path} is not a frame that VTK can read.")
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    pressure = grid.GetPointData().GetArray("pressure")
    if pressure is None:
        raise Mistake(f"{path} has no field 'pressure' to colour the particles by.")
    points, pressure = vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(pressure)

    cell = run.cell(time)
    shown = numpy.isfinite(points).all(axis=1)  # a run that diverged has lost some
    if run.case.get("dimension") == 3:
        across = 3 - sum(run.plane)
        # Within 3/4 of a spacing is one layer where particles lie in the plane, two where they lie beside it.
        shown &= abs(points[:, across]) < 0.75 * cell[across]
    if not shown.any():
        raise Mistake(f"{path} has no particles to show.")
    return Frame(time, points[shown][:, run.plane], pressure[shown], cell[list(run.plane)])
