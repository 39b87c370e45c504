# SPDX-License-Identifier: GPL-3.0-or-later
"""Glass in space as it is seen from the side and above: what render.py draws of it."""
import numpy as np
from matplotlib.collections import PolyCollection
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

# Nodes of the six faces of VTK's hexahedron with 27 nodes in rows; the last two are the inner and the outer side of the wall.
FACES = ((0, 11, 3, 16, 20, 19, 4, 15, 7), (1, 9, 2, 17, 21, 18, 5, 13, 6), (0, 8, 1, 16, 22, 17, 4, 12, 5),
         (3, 10, 2, 19, 23, 18, 7, 14, 6), (0, 8, 1, 11, 24, 9, 3, 10, 2), (4, 12, 5, 15, 25, 13, 7, 14, 6))
INNER, OUTER = 4, 5
AZIMUTH, TILT = 0.45, 0.3


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    return (vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 27),
            vtk_to_numpy(grid.GetPointData().GetArray("temperature_degC")))


class SolidGlass:
    """The surface of the whole container at an output, its mouth up: quadrangles in mm and their temperatures."""

    def __init__(self, path):
        points, cells, self.temperature = read(path)
        faces = np.concatenate([cells[:, face] for face in FACES])
        kinds = np.repeat(range(len(FACES)), len(cells))
        _, back, count = np.unique(faces[:, 4], return_inverse=True, return_counts=True)
        alone = count[back] == 1
        angle = np.arctan2(points[:, 1], points[:, 0])
        far = np.hypot(points[:, 0], points[:, 1]) > 0.1 * np.abs(points[:, :2]).max()
        copies = max(1, round(2 * np.pi / np.where(angle < -1e-4, angle + 2 * np.pi, angle)[far].max()))
        self.sector = 2 * np.pi / copies
        rim = alone & (kinds < INNER) & ~self.in_plane(points[faces]) if copies > 1 else alone & (kinds < INNER)
        low, high = points[:, 2].min(), points[:, 2].max()
        self.up = 1 if not rim.any() or points[faces[rim]][..., 2].mean() > (low + high) / 2 else -1
        self.range = low, high
        self.radius = np.hypot(points[:, 0], points[:, 1]).max()
        shown = faces[alone & ((kinds >= INNER) | rim)]
        quads = np.concatenate([shown[:, [i, i + 1, i + 4, i + 3]] for i in (0, 1, 3, 4)])
        self.values = np.tile(self.temperature[quads].mean(1), copies)
        self.corners = np.concatenate([self.copy(points, number)[quads] for number in range(copies)])

    def in_plane(self, faces):
        """Whether all nodes of a face lie in a plane of symmetry: at the angle 0 or at the end of the sector."""
        planes = [np.abs(faces[..., 1] * np.cos(end) - faces[..., 0] * np.sin(end)).max(1) < 1e-3 for end in (0, self.sector)]
        return planes[0] | planes[1]

    def copy(self, points, number):
        turn = (number + number % 2) * self.sector
        turned = points.copy()
        sign = -1 if number % 2 else 1
        turned[:, 0] = np.cos(turn) * points[:, 0] - sign * np.sin(turn) * points[:, 1]
        turned[:, 1] = np.sin(turn) * points[:, 0] + sign * np.cos(turn) * points[:, 1]
        return turned

    def draw(self, axes, colours, span):
        """What is nearer covers what is behind; heights are those of the axis where the glass is on it. Returns the collection."""
        x, y, z = np.moveaxis(self.corners * [1, self.up, self.up], -1, 0)
        middle = self.up * sum(self.range) / 2
        right = np.cos(AZIMUTH) * x - np.sin(AZIMUTH) * y
        away = np.sin(AZIMUTH) * x + np.cos(AZIMUTH) * y
        seen = np.stack([right, (z - middle) * np.cos(TILT) + away * np.sin(TILT) + middle,
                         (z - middle) * np.sin(TILT) - away * np.cos(TILT)], -1)  # the last one towards the viewer, mm
        order = np.argsort(seen[..., 2].mean(1))
        normal = np.cross(seen[:, 2] - seen[:, 0], seen[:, 3] - seen[:, 1])
        light = 0.6 + 0.4 * np.abs(normal[:, 2]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-12)
        image = axes.scatter([], [], c=[], cmap=colours, vmin=span[0], vmax=span[1])
        paint = image.to_rgba(self.values)
        paint[:, :3] *= light[:, None]
        axes.add_collection(PolyCollection(seen[order, :, :2], facecolors=paint[order], edgecolors=paint[order], linewidths=0.3))
        return image
