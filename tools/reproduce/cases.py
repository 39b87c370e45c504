# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files of the cylinder test and of its variant with self-weight, as text for `parison run`."""

PAIRS = ((20, 20), (20, 7), (7, 20), (20, 13), (13, 20))  # divisions of glass and steel along the contact
TRIANGLES = "triangles"  # unstructured
# Sizes that standard accuracy gives glass and tool, so that a body keeps its mesh in both roles.
TRIANGLE_MESH = {"glass": 'size = "2 mm", contact_size = "0.2 mm", growth = 0.5',
                 "steel": 'size = "8 mm", contact_size = "0.75 mm", growth = 0.5'}
ROLES = ("glass", "steel")  # who is the slave; the program calls the slave "glass"
TOOL_NAME = {"glass": "crystal", "steel": "steel"}

MATERIALS = {
    "glass": 'density = "2500 kg/m3"\nheat_capacity = "1282 J/kg/K"\nconductivity = "2.77 W/m/K"',
    "steel": 'density = "7800 kg/m3"\nheat_capacity = "620 J/kg/K"\nconductivity = "37 W/m/K"',
}
START = {"glass": "1150 degC", "steel": "485 degC"}
# Viscosity of container glass: the paper's crystal glass is not known.
VISCOSITY = 'viscosity = { law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }'
BOUNDARIES = {
    "glass": (("contact", "(0, 0) (20, 0) mm", "contact"), ("side", "(20, 20) mm", "insulated"),
              ("top", "(0, 20) mm", "insulated"), ("axis", "(0, 0) mm", "symmetry")),
    "steel": (("contact", "({r}, 0) (0, 0) mm", "contact"), ("axis", "(0, -30) mm", "symmetry"),
              ("bottom", "({r}, -30) mm", "insulated"), ("side", "({r}, 0) mm", "insulated")),
}
WIDE_STEEL = 2  # with self-weight, in radii of the glass: the glass spreads


def body(name, mesh, header, rows, radius="20", side="insulated"):
    lines = [header, f'material = "{name}"', f'temperature = "{START[name]}"', "boundary = ["]
    for boundary, path, condition in BOUNDARIES[name]:
        condition = side if name == "glass" and boundary == "side" else condition
        lines.append(f'  {{ name = "{boundary}", path = "{path.format(r=radius)}", condition = "{condition}" }},')
    sizes = TRIANGLE_MESH[name] if mesh == TRIANGLES else f"mapped = [{mesh}, {rows}], ratio = [1, 40]"
    return [*lines, "]", f"mesh = {{ {sizes} }}"]


def heading(name, stage, tool):
    return [f'case = "{name}"', 'geometry = "axisymmetric"',
            f'stage = [{{ name = "contact", tools = ["{tool}"], {stage} }}]']


def heat_case(pair, slave):
    """Heat alone, h = 5000 W/m2/K: the bundled case with other meshes, and the bodies changing places."""
    master = ROLES[1 - ROLES.index(slave)]
    meshes = dict(zip(ROLES, pair if pair != TRIANGLES else (TRIANGLES, TRIANGLES)))
    tool = TOOL_NAME[master]
    lines = heading("cylinders", 'duration = "10 s"', tool)
    lines.append("probe = [")
    for name, owner in ((slave, "glass"), (master, tool)):
        for place, r in (("axis", 0), ("rim", 20)):
            lines.append(f'  {{ name = "{name}_{place}", body = "{owner}", point = "({r}, 0) mm" }},')
    lines.append("]")
    for name in ROLES:
        lines += [f"[material.{name}]", MATERIALS[name]]
    lines += body(slave, meshes[slave], "[glass]", 36)
    lines += body(master, meshes[master], f'[[tool]]\nname = "{tool}"', 36)
    lines += ["[[interface]]", f'tools = ["{tool}"]', 'law = "constant"', 'h = "5000 W/m2/K"', "[output]",
              'interval = "1 s"', 'times = ["0.5 s"]', "[numerics]", 'temperature_tolerance = "0.02 K"']
    return "\n".join(lines) + "\n"


def weight_case(pair):
    """The glass flows under its own weight and slides on the steel; h follows contact pressure and viscosity."""
    glass, steel = pair if pair != TRIANGLES else (TRIANGLES, TRIANGLES)
    lines = heading("self_weight", 'duration = "1 s", gravity = "-9.81 m/s2"', "steel")
    lines += ["[material.glass]", MATERIALS["glass"], VISCOSITY, "[material.steel]", MATERIALS["steel"]]
    lines += body("glass", glass, "[glass]", 24, side="contact")
    lines += body("steel", steel if steel == TRIANGLES else WIDE_STEEL * steel, '[[tool]]\nname = "steel"\nfriction = "slip"',
                  24, radius=str(20 * WIDE_STEEL))
    lines += ["[[interface]]", 'tools = ["steel"]', 'law = "pressure-viscosity"', 'h0 = "500 W/m2/K"', 'h1 = "20000 W/m2/K"',
              'p_ref = "0.2 MPa"', 'eta_ref = "1e3 Pa.s"', "a = 1", "b = 0.25", "[output]", 'interval = "0.1 s"',
              "[numerics]", 'temperature_tolerance = "0.02 K"']
    if pair != TRIANGLES:
        lines.append("quality_floor = 0.001  # keeps the mapped mesh with its flat cells at the contact")
    return "\n".join(lines) + "\n"
