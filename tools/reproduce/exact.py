# SPDX-License-Identifier: GPL-3.0-or-later
"""Two insulated slabs of finite height brought together: the exact solution by numerical inversion of its Laplace transform."""
import numpy as np

CONDUCTANCE = 5000.0  # W/m2/K
RADIUS = 0.020  # m
# conductivity W/m/K, density kg/m3, heat capacity J/kg/K, height m, start degC
GLASS = (2.77, 2500.0, 1282.0, 0.020, 1150.0)
STEEL = (37.0, 7800.0, 620.0, 0.030, 485.0)

# Time s, glass side degC, steel side degC, heat J/m2: the published table that the inversion is checked against.
TABLE = ((0.5, 785.5102, 566.1886, 763661), (1, 742.0877, 575.8608, 1236161), (2, 706.4829, 583.7917, 1941847),
         (5, 671.5318, 591.5769, 3393853), (10, 652.8883, 595.7298, 5060352))


def talbot(transform, time, points=32):
    """Inverse Laplace transform at a time: the fixed Talbot rule (Abate and Valko 2004)."""
    r = 2 * points / (5 * time)
    theta = np.arange(1, points) * np.pi / points
    cot = 1 / np.tan(theta)
    s = r * theta * (cot + 1j)
    slope = 1 + 1j * (theta + (theta * cot - 1) * cot)
    inside = np.exp(time * s) * np.array([transform(p) for p in s]) * slope
    return r / points * (0.5 * np.exp(r * time) * transform(r).real + inside.real.sum())


def surface_rise(body, s):
    """Transform of the surface temperature per transform of the flux into an insulated slab, K m2/W."""
    k, density, capacity, height, _ = body
    root = np.sqrt(s + 0j)
    return 1 / (np.sqrt(k * density * capacity) * root * np.tanh(height * root * np.sqrt(density * capacity / k)))


def flux(s):
    difference = GLASS[4] - STEEL[4]
    return CONDUCTANCE * difference / s / (1 + CONDUCTANCE * (surface_rise(GLASS, s) + surface_rise(STEEL, s)))


def solution(time):
    """Glass side and steel side of the contact, degC, and the heat exchanged, J/m2."""
    if time <= 0:
        return GLASS[4], STEEL[4], 0.0
    return (GLASS[4] - talbot(lambda s: surface_rise(GLASS, s) * flux(s), time),
            STEEL[4] + talbot(lambda s: surface_rise(STEEL, s) * flux(s), time), talbot(lambda s: flux(s) / s, time))


def check():
    """Largest distance from the table, K and relative heat."""
    found = [(solution(row[0]), row) for row in TABLE]
    kelvin = max(max(abs(at[0] - row[1]), abs(at[1] - row[2])) for at, row in found)
    return kelvin, max(abs(at[2] / row[3] - 1) for at, row in found)
