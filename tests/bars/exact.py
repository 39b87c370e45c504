# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact solutions of the scenes that have one: quantities of interest by name, in the units of summary.json.

Shell and squeezed disc as in tests/README.md; ring from u = a a'/r; ball and half-spaces H. S. Carslaw, J. C. Jaeger,
Conduction of Heat in Solids, 2nd ed. 1959, 9.4 and 12.8.
"""
import math


def wall(inner, outer):
    """Quantities of a shell or a ring with these radii, mm; a quarter of it is drawn."""
    return {"thickness_mean": outer - inner, "thickness_min": outer - inner, "extent_r_max": outer, "extent_z_min": 0.0,
            "extent_z_max": outer}


def sphere():
    """Radii from dp = 4 eta a^2 a' (1/a^3 - 1/b^3) + 2 gamma (1/a + 1/b), by the classical Runge-Kutta method."""
    eta, dp, gamma, a, b, end, steps = 1e4, 1e5, 0.3, 8e-3, 14e-3, 0.165, 20000
    volume = b**3 - a**3

    def speed(r):
        out = (r**3 + volume)**(1 / 3)
        return (dp - 2 * gamma * (1 / r + 1 / out)) / (4 * eta * r * r * (1 / r**3 - 1 / out**3))

    h = end / steps
    for _ in range(steps):
        k1 = speed(a)
        k2 = speed(a + 0.5 * h * k1)
        k3 = speed(a + 0.5 * h * k2)
        a += h / 6 * (k1 + 2 * k2 + 2 * k3 + speed(a + h * k3))
    return wall(1e3 * a, 1e3 * (a**3 + volume)**(1 / 3))


def ring():
    """dp = 2 eta a a' (1/a^2 - 1/b^2), so that ln(a^2/b^2) grows with dp/eta."""
    eta, dp, a, b, end = 1e4, 1e4, 20.0, 26.0, 0.4
    area, ratio = b * b - a * a, (a / b)**2 * math.exp(dp * end / eta)
    b = math.sqrt(area / (1 - ratio))
    return wall(math.sqrt(b * b - area), b)


def squeeze_slip():
    """F = -3 eta W h'/h^2, so that 1/h grows with F/(3 eta W)."""
    eta, force, radius, h0, slow = 1e4, 200.0, 10e-3, 10e-3, 8e-3
    volume = math.pi * radius**2 * h0
    rate = force / (3 * eta * volume)
    h = math.sqrt(slow / rate)
    return {"thickness_mean": 1e3 * h, "thickness_min": 1e3 * h, "time_press": (1 / h - 1 / h0) / rate, "extent_z_min": 0.0,
            "extent_z_max": 1e3 * h, "extent_r_max": 1e3 * math.sqrt(volume / (math.pi * h)), "peak_force_plate": force}


def ball():
    """Series over the roots of tan x = x/(1 - Bi)."""
    k, rho, c, radius, h, hot, cold, end = 2.5, 2400, 1300, 15e-3, 200, 1050, 50, 20
    biot, fourier = h * radius / k, k / (rho * c) * end / radius**2
    mean = skin = 0
    for n in range(60):
        low, high = n * math.pi + 1e-9, (n + 1) * math.pi - 1e-9
        for _ in range(200):
            x = 0.5 * (low + high)
            above = x * math.cos(x) + (biot - 1) * math.sin(x)
            low, high = (x, high) if (above > 0) == (n % 2 == 0) else (low, x)
        share = 4 * (math.sin(x) - x * math.cos(x)) / (2 * x - math.sin(2 * x)) * math.exp(-x * x * fourier)
        mean += share * 3 * (math.sin(x) - x * math.cos(x)) / x**3
        skin += share * math.sin(x) / x
    return {"glass_mean": cold + (hot - cold) * mean, "glass_skin": cold + (hot - cold) * skin}


def half_spaces():
    """The skin is the whole outline of the glass, 20 mm wide and 15 mm high."""
    (k1, rho1, c1), (k2, rho2, c2), h = (2.5, 2400, 1300), (46, 7200, 490), 3000
    hot, span, end, width, height = 1100, 650, 3, 20e-3, 15e-3
    e1, e2 = math.sqrt(k1 * rho1 * c1), math.sqrt(k2 * rho2 * c2)
    rate = h * (1 / e1 + 1 / e2)
    root, diffusivity = rate * math.sqrt(end), k1 / (rho1 * c1)

    def scaled_erfc(x):
        """exp(x^2) erfc(x), by its asymptotic series where erfc is nothing."""
        return math.exp(x * x) * math.erfc(x) if x < 20 else (1 - 0.5 / x**2 + 0.75 / x**4) / (x * math.sqrt(math.pi))

    def glass(x):
        s = x / (2 * math.sqrt(diffusivity * end))
        return hot - span * e2 / (e1 + e2) * (math.erfc(s) - math.exp(-s * s) * scaled_erfc(s + root))

    heat = h * span / rate**2 * (scaled_erfc(root) - 1 + 2 * rate * math.sqrt(end / math.pi))
    count = 3000  # Simpson's rule along a side
    weights = [1 if i in (0, count) else 4 if i % 2 else 2 for i in range(count + 1)]
    side = sum(w * glass(height * i / count) for i, w in enumerate(weights)) / (3 * count) * height
    return {"heat_iron": heat * width, "glass_mean": hot - heat / (rho1 * c1 * height),
            "glass_skin": (width * (glass(0) + glass(height)) + 2 * side) / (2 * (width + height))}


SOLUTIONS = {f.__name__: f for f in (sphere, ring, squeeze_slip, ball, half_spaces)}
