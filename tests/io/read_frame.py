# SPDX-License-Identifier: BSD-3-Clause
"""Opens a frame as ParaView does and checks that all of it is there: read_frame.py FILE POINTS"""
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_VERTEX
from vtkmodules.vtkIOHDF import vtkHDFReader


def main(file, count):
    reader = vtkHDFReader()
    assert reader.CanReadFile(file), f"{file} is no VTKHDF file"
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetClassName() == "vtkUnstructuredGrid", grid.GetClassName()
    assert grid.GetNumberOfPoints() == count, f"{grid.GetNumberOfPoints()} points, not {count}"
    assert grid.GetNumberOfCells() == count, f"{grid.GetNumberOfCells()} cells, not {count}"
    for k in range(count):
        cell = grid.GetCell(k)
        assert cell.GetCellType() == VTK_VERTEX and cell.GetPointId(0) == k, f"cell {k} is not the vertex {k}"

    fields = grid.GetPointData()
    names = [fields.GetArrayName(k) for k in range(fields.GetNumberOfArrays())]
    arrays = {name: vtk_to_numpy(fields.GetArray(name)) for name in names}
    assert numpy.issubdtype(arrays.pop("id").dtype, numpy.int64), "identities are not 64 bit integers"
    for name, components in {"pressure": 1, "velocity": 3, "stress": 6, "gradient": 9}.items():
        values = arrays[name]
        assert values.size == count * components, f"{name} has shape {values.shape}"
        assert (numpy.diff(values.ravel()) == 1).all(), f"{name} does not count up as written"
    points = vtk_to_numpy(grid.GetPoints().GetData())
    assert (numpy.diff(points.ravel()) == 1).all(), "points are not as written"
    time = grid.GetFieldData().GetArray("Time")
    assert time is not None and time.GetValue(0) == 0.0125, "the time is missing from the field data"


main(sys.argv[1], int(sys.argv[2]))
