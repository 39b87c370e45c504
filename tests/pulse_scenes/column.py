# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat of layers whose exchange changes over time: finite volumes in one dimension, of the tests' own."""
import math
from dataclasses import dataclass


@dataclass
class Layer:
    """A layer with an insulated back: W/m/K, J/m3/K, m, K at the start."""
    conductivity: float
    capacity: float
    thickness: float
    temperature: float

    def heights(self, shortest):
        """Heights of the cells from the surface on: thin for the shortest event, s, and growing."""
        first = min(0.02 * math.sqrt(self.conductivity / self.capacity * shortest), self.thickness / 20)
        heights, depth = [], 0.0
        while depth < self.thickness:
            heights.append(min(first + 0.04 * depth, self.thickness / 60))
            depth += heights[-1]
        return [height * self.thickness / depth for height in heights]


@dataclass
class Interval:
    """A time, s, in which h, W/m2/K (infinite: the surface has that temperature), and the temperature around, K, run straight;
    with a `law` it gives h, of a value that runs straight in its place."""
    duration: float
    h: tuple
    temperature: tuple = (0.0, 0.0)
    law: object = None

    def at(self, share):
        def between(pair):
            return pair[0] if pair[0] == pair[1] else (1 - share) * pair[0] + share * pair[1]
        return self.law(between(self.h)) if self.law else between(self.h), between(self.temperature)


class Column:
    """One layer in surroundings, or two that exchange heat; cells are numbered from the back of the second over the contact."""

    def __init__(self, layers, shortest):
        self.capacity, self.between, self.temperature = [], [], []
        for number, layer in enumerate(layers):
            heights = layer.heights(shortest)
            if number == 1:
                self.contact = len(self.capacity)
                self.between.append(0.0)  # by the exchange
            else:
                heights.reverse()
            self.between += [2 * layer.conductivity / (a + b) for a, b in zip(heights, heights[1:])]
            self.capacity += [layer.capacity * height for height in heights]
            self.temperature += [layer.temperature] * len(heights)
        first = layers[0].heights(shortest)[0]
        self.inner = 0.5 * first / layers[0].conductivity
        if len(layers) == 2:
            self.inner += 0.5 * layers[1].heights(shortest)[0] / layers[1].conductivity
        self.surface_resistance = 0.5 * first / layers[0].conductivity
        self.two = len(layers) == 2
        self.surface = len(layers[0].heights(shortest)) - 1

    def through(self, h):
        return 0.0 if h == 0 else 1 / (self.inner + (0.0 if math.isinf(h) else 1 / h))

    def flow(self, temperature, h, around):
        other = temperature[self.surface + 1] if self.two else around
        return self.through(h) * (temperature[self.surface] - other)

    def backward(self, temperature, h, around, dt):
        """A step of Euler's backward method: a tridiagonal system."""
        n, s = len(temperature), self.surface
        between = list(self.between)
        diagonal = [c / dt for c in self.capacity]
        right = [c / dt * t for c, t in zip(self.capacity, temperature)]
        if self.two:
            between[s] = self.through(h)
        else:
            diagonal[s] += self.through(h)
            right[s] += self.through(h) * around
        for i in range(n - 1):
            diagonal[i] += between[i]
            diagonal[i + 1] += between[i]
        for i in range(1, n):
            share = between[i - 1] / diagonal[i - 1]
            diagonal[i] -= share * between[i - 1]
            right[i] += share * right[i - 1]
        right[-1] /= diagonal[-1]
        for i in range(n - 2, -1, -1):
            right[i] = (right[i] + between[i] * right[i + 1]) / diagonal[i]
        return right

    def step(self, interval, start, end):
        """One step and two of half its length, extrapolated; gives the heat out of the first layer, J/m2."""
        dt, middle = (end - start) * interval.duration, 0.5 * (start + end)
        whole = self.backward(self.temperature, *interval.at(end), dt)
        half = self.backward(self.temperature, *interval.at(middle), 0.5 * dt)
        full = self.backward(half, *interval.at(end), 0.5 * dt)
        early = 0.5 * dt * (self.flow(half, *interval.at(middle)) + self.flow(full, *interval.at(end)))
        heat = 2 * early - dt * self.flow(whole, *interval.at(end))
        self.temperature = [2 * b - a for a, b in zip(whole, full)]
        return heat


def integrate(layers, intervals, steps=40):
    """Heat given by the first layer, J/m2, at the end of each interval, and the temperature of its surface at the end, K."""
    whole = sum(interval.duration for interval in intervals)
    shortest = max(min(interval.duration for interval in intervals), 1e-6 * whole)
    column, heat, given = Column(layers, shortest), 0.0, []
    for interval in intervals:
        for i in range(steps):
            heat += column.step(interval, (i / steps) ** 3, ((i + 1) / steps) ** 3)
        given.append(heat)
    flow = column.flow(column.temperature, *intervals[-1].at(1.0))
    return given, column.temperature[column.surface] - flow * column.surface_resistance
