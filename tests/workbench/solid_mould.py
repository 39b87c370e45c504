# SPDX-License-Identifier: GPL-3.0-or-later
"""A half of the mould of a square jar as a STEP file, its finish up, as a mould shop's CAD program writes it: by gmsh, None where that is missing."""
try:
    import gmsh
except ImportError:
    gmsh = None

HALF, CORNER, TOP, SHOULDER, BASE, RADIUS, BACK, ZERO = 31.5, 12, 12, 24, 95, 62, 122, 150  # mm; ZERO is where the file has the plane of the finish
BOX = {"left": 0, "right": RADIUS, "low": TOP, "high": BACK}  # of its section


def write(path):
    """Round down to the shoulder, then square with round corners; the parting plane is x = z."""
    if not gmsh:
        return None
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    occ = gmsh.model.occ
    down = lambda z: ZERO - z
    body = occ.addCylinder(0, 0, down(BACK), 0, 0, BACK - TOP, RADIUS)
    neck = occ.addCylinder(0, 0, down(SHOULDER), 0, 0, SHOULDER - TOP, HALF)
    square = occ.addRectangle(-HALF, -HALF, down(BASE), 2 * HALF, 2 * HALF, roundedRadius=CORNER)
    hole = occ.extrude([(2, square)], 0, 0, BASE - SHOULDER)[1]
    mould, _ = occ.cut([(3, body)], [(3, neck), hole])
    half, _ = occ.intersect(mould, [(3, occ.addBox(-2 * RADIUS, 0, 0, 4 * RADIUS, 2 * RADIUS, 2 * ZERO))])
    occ.remove([one for one in occ.getEntities(2) if one == (2, square)])
    occ.synchronize()
    gmsh.write(str(path))
    gmsh.finalize()
    return path
