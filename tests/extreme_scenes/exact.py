# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact solutions: heat of slabs and spheres by Laplace transforms, viscous flows in closed form."""
import cmath
import math

SIGMA = 5.670374419e-8


def invert(transform, time, terms=24):
    """The function of a Laplace transform at a time, by the fixed Talbot rule (J. Abate, P. Valko 2004)."""
    r = 2 * terms / (5 * time)
    total = 0.5 * transform(r).real * math.exp(r * time)
    for k in range(1, terms):
        angle = k * math.pi / terms
        cotangent = math.cos(angle) / math.sin(angle)
        s = r * angle * complex(cotangent, 1)
        weight = complex(1, angle + (angle * cotangent - 1) * cotangent)
        total += (cmath.exp(s * time) * transform(s) * weight).real
    return total * r / terms


def slab_admittance(k, capacity, thickness):
    """Surface flux over surface temperature of a slab with an insulated back, of the Laplace variable."""
    def admittance(s):
        root = cmath.sqrt(s * capacity / k)
        return k * root * cmath.tanh(root * thickness) if abs(root * thickness) < 300 else k * root
    return admittance


def sphere_admittance(k, capacity, radius):
    def admittance(s):
        z = cmath.sqrt(s * capacity / k) * radius
        if abs(z) < 0.05:  # z coth z - 1 without the loss of digits
            return k / radius * (z * z / 3 - z ** 4 / 45)
        return k / radius * ((z / cmath.tanh(z) if abs(z) < 300 else z) - 1)
    return admittance


def heat_through(admittances, h, jump, time):
    """Heat for a jump through h between the surfaces of bodies (one: its surroundings are constant), J/m2."""
    resistance = 0 if h == math.inf else 1 / h

    def transform(s):
        return jump / (s * s * (resistance + sum(1 / a(s) for a in admittances)))
    return invert(transform, time)


def shell_time(viscosity, pressure, inner, outer, new_inner, tension=0.0, steps=4000):
    """Time in which a spherical shell is blown from one inner radius to another, s; trapezoidal rule in the logarithm of the radius."""
    volume = outer ** 3 - inner ** 3

    def slowness(a):  # dt / d ln a: radial balance dp - 2 gamma (1/a + 1/b) = 4 eta (da/dt) a^2 (1/a^3 - 1/b^3)
        b = (a ** 3 + volume) ** (1 / 3)
        return 4 * viscosity * (volume / b ** 3) / (pressure - 2 * tension * (1 / a + 1 / b))
    width = math.log(new_inner / inner) / steps
    values = [slowness(inner * math.exp(i * width)) for i in range(steps + 1)]
    return width * (sum(values) - 0.5 * (values[0] + values[-1]))


def radiated_temperature(start, surroundings, area, emissivity, heat_capacity, time, steps=20000):
    """Temperature of a body of one temperature that radiates, K (Runge-Kutta)."""
    def rate(T):
        return -emissivity * SIGMA * area * (T ** 4 - surroundings ** 4) / heat_capacity
    dt, T = time / steps, start
    for _ in range(steps):
        a = rate(T)
        b = rate(T + 0.5 * dt * a)
        c = rate(T + 0.5 * dt * b)
        T += dt / 6 * (a + 2 * b + 2 * c + rate(T + dt * c))
    return T
