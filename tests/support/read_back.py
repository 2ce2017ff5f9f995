"""Reads the series that export_dump wrote with VTK's Python and compares every array, bit for bit, and every time.

usage: read_back.py FOLDER
"""
import json
import math
import sys
import xml.etree.ElementTree
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLImageDataReader


def read(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def check_frame(image, expected, folder):
    assert [n - 1 for n in image.GetDimensions()] == expected["cells"], image.GetDimensions()
    assert list(image.GetOrigin()) == expected["origin"], image.GetOrigin()
    assert list(image.GetSpacing()) == expected["pitch"], image.GetSpacing()
    direction = image.GetDirectionMatrix()
    angle = math.degrees(math.atan2(direction.GetElement(1, 0), direction.GetElement(0, 0)))
    assert abs(angle - expected["angle_deg"]) < 1e-12, angle
    assert image.GetFieldData().GetArray("TimeValue").GetValue(0) == expected["time"]
    cells = image.GetCellData()
    assert cells.GetNumberOfArrays() == len(expected["arrays"])
    for wanted in expected["arrays"]:
        array = cells.GetArray(wanted["name"])
        assert array.GetDataTypeAsString() == "float", wanted["name"]
        assert array.GetNumberOfComponents() == wanted["components"], wanted["name"]
        assert bytes(memoryview(array)) == (folder / wanted["dump"]).read_bytes(), wanted["name"]


def check_series(folder, name, expected):
    sets = xml.etree.ElementTree.parse(folder / f"{name}.pvd").getroot().findall("./Collection/DataSet")
    assert [float(s.get("timestep")) for s in sets] == [e["time"] for e in expected]
    for data_set, wanted in zip(sets, expected):
        check_frame(read(folder / data_set.get("file")), wanted, folder)
    return len(sets)


def main():
    frames = 0
    for manifest in sorted(Path(sys.argv[1]).glob("*/expected.json")):
        for name, expected in json.loads(manifest.read_text()).items():
            frames += check_series(manifest.parent, name, expected)
    assert frames == 24, frames
    print(f"{frames} frames read back bit for bit")


main()
