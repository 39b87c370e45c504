// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/shell_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace parison::forming {
namespace {

/// A side of one or two elements.
struct Side {
  std::array<long, 3> nodes;  ///< two corners and the middle
  std::vector<std::size_t> elements;
};

const ShellNode& node_of(const Shell& shell, long number) {
  return shell.nodes[static_cast<std::size_t>(number) - 1];
}

double radius(const Shell& shell, long number) {
  return node_of(shell, number).at.head<2>().norm();
}

std::vector<Side> sides_of(const Shell& shell) {
  std::map<std::pair<long, long>, Side> found;
  for (std::size_t e = 0; e < shell.elements.size(); ++e) {
    const auto& nodes = shell.elements[e];
    const std::size_t corners = nodes.size() / 2;
    for (std::size_t k = 0; k < corners; ++k) {
      const auto ends = std::minmax(nodes[k], nodes[(k + 1) % corners]);
      Side& side = found[ends];
      side.nodes = {ends.first, ends.second, nodes[corners + k]};
      side.elements.push_back(e);
    }
  }
  std::vector<Side> sides;
  for (auto& [ends, side] : found) sides.push_back(std::move(side));
  return sides;
}

/// Shares of the nodes in a force of `total` that is even along sides: a sixth and two thirds of that on a side.
Shares even_force(const Shell& shell, const std::vector<Side>& sides, double total) {
  Shares force;
  double length = 0;
  for (const Side& side : sides) {
    const auto& [from, to, middle] = side.nodes;
    const double on_side = (node_of(shell, from).at - node_of(shell, middle).at).norm() +
                           (node_of(shell, middle).at - node_of(shell, to).at).norm();
    length += on_side;
    force[from] += on_side / 6;
    force[to] += on_side / 6;
    force[middle] += on_side * 2 / 3;
  }
  for (auto& [node, share] : force) share *= total / length;
  return force;
}

/// Sides that satisfy a condition.
template <typename Condition>
std::vector<Side> those(const std::vector<Side>& sides, const Condition& condition) {
  std::vector<Side> found;
  std::copy_if(sides.begin(), sides.end(), std::back_inserter(found), condition);
  return found;
}

double mean_radius(const Shell& shell, std::size_t element) {
  const auto& nodes = shell.elements[element];
  double sum = 0;
  for (const long node : nodes) sum += radius(shell, node);
  return sum / static_cast<double>(nodes.size());
}

/// Sides on a plate; inside of a part that is flat only those at its outer edge. Where none is as near as that, those
/// within twice the distance; none of a closed shell of which all stands.
std::set<long> base_nodes(const Shell& shell, const std::vector<Side>& sides, int up) {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const ShellNode& node : shell.nodes) {
    lowest = std::min(lowest, up * node.outer);
    highest = std::max(highest, up * node.outer);
  }
  for (double near = 0.02; near < 0.04 + 2 * (highest - lowest); near *= 2) {  // mm
    const auto stands = [&](long node) { return up * node_of(shell, node).outer <= lowest + near; };
    const auto all_stand = [&](const auto& nodes) { return std::all_of(nodes.begin(), nodes.end(), stands); };
    const auto is_outermost = [&](const Side& side) {
      if (!all_stand(side.nodes)) return false;
      double flat = -1, other = std::numeric_limits<double>::infinity();
      for (const std::size_t element : side.elements)
        (all_stand(shell.elements[element]) ? flat : other) = mean_radius(shell, element);
      return flat < other && !(side.elements.size() == 2 && std::isinf(other));
    };
    const auto found = those(sides, is_outermost);
    std::set<long> nodes;
    for (const Side& side : found) nodes.insert(side.nodes.begin(), side.nodes.end());
    if (!nodes.empty()) return nodes;
  }
  return {};
}

}  // namespace

ShellPlaces shell_places(const Shell& shell, int up) {
  const std::vector<Side> sides = sides_of(shell);
  double low = std::numeric_limits<double>::infinity(), high = -low, widest = 0;
  const auto height = [&](long node) { return up * node_of(shell, node).at[2]; };
  const auto is_in_section = [&](const ShellNode& node) { return std::abs(node.at[1]) < 1e-5; };  // mm
  for (const ShellNode& node : shell.nodes) {
    low = std::min(low, up * node.at[2]);
    high = std::max(high, up * node.at[2]);
    if (is_in_section(node)) widest = std::max(widest, std::abs(node.at[0]));
  }
  ShellPlaces places;
  const auto is_edge = [&](const Side& side) {
    return side.elements.size() == 1 && height(side.nodes[2]) > 0.5 * (low + high);
  };
  places.finish = even_force(shell, those(sides, is_edge), 1);
  places.base = base_nodes(shell, sides, up);
  for (const double direction : {1.0, -1.0}) {
    const auto line = those(sides, [&](const Side& side) {
      return std::all_of(side.nodes.begin(), side.nodes.end(), [&](long number) {
        const ShellNode& node = node_of(shell, number);
        return is_in_section(node) && direction * node.at[0] >= 0.9 * widest;
      });
    });
    places.body.merge(even_force(shell, line, -direction));
  }
  return places;
}

namespace {

/// The node that is farthest along a direction, the first of equal ones.
long farthest(const Shell& shell, const Shares& nodes, double x, double y) {
  constexpr double equal = 1e-6;  // mm
  long found = nodes.begin()->first;
  const auto along = [&](long node) { return x * node_of(shell, node).at[0] + y * node_of(shell, node).at[1]; };
  for (const auto& [node, share] : nodes)
    if (along(node) > along(found) + equal) found = node;
  return found;
}

std::string forces(const Shares& shares, int axis, double total) {
  std::string text;
  for (const auto& [node, share] : shares) text += fmt::format("{}, {}, {:.9g}\n", node, axis, total * share);
  return text;
}

std::string step(const char* remark, const std::string& held, const std::string& nodal, const std::string& pressure) {
  return fmt::format(
      "*STEP\n** {}\n*STATIC\n*BOUNDARY, OP=NEW\n{}*CLOAD, OP=NEW\n{}*DLOAD, OP=NEW\n{}*NODE FILE\nU, RF\n*EL FILE\nS\n"
      "*END STEP\n",
      remark, held, nodal, pressure);
}

}  // namespace

std::string shell_steps(const Shell& shell, const ShellPlaces& places, int up, bool has_stress) {
  constexpr double kilonewton = 1000, bar = 0.1;  // N, MPa
  const auto& [finish, body, base] = places;
  if (finish.empty() || body.empty()) return "** No loads: it is closed or open below.\n";
  const long right = farthest(shell, finish, 1, 0), left = farthest(shell, finish, -1, 0);
  // No load moves the container along or about the axes, so these bear nothing.
  const std::string across = fmt::format("{}, 2, 2\n{}, 2, 2\n{}, 1, 1\n", right, left, farthest(shell, finish, 0, 1));
  const auto height = [&](const auto& one) { return up * node_of(shell, one.first).at[2]; };
  const auto lowest =
      std::min_element(body.begin(), body.end(), [&](const auto& a, const auto& b) { return height(a) < height(b); });
  const std::string loose = fmt::format("{}, 3, 3\n{}, 3, 3\n{}, 2, 2\n", right, left, lowest->first);
  return (has_stress ? step("Residual stress alone, no load", loose + across, "", "") : "") +
         step("Top load: 1 kN on FINISH, BASE on a plate", "BASE, 3, 3\n" + across, forces(finish, 3, -up * kilonewton),
              "") +
         step("Inner pressure: 1 bar, held at FINISH", "FINISH, 3, 3\n" + across, "",
              fmt::format("WALL, P, {:g}\n", bar)) +
         step("Squeeze: 1 kN along both sides of BODY, in y = 0", loose + across, forces(body, 1, kilonewton), "");
}

}  // namespace parison::forming
