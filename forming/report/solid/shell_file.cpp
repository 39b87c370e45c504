// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/shell_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/numbers.hpp"
#include "forming/report/solid/shell_loads.hpp"
#include "forming/report/solid/shell_stress.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::forming {
namespace {

std::string elements_of(const Shell& shell, std::size_t nodes, const char* type) {
  std::string text;
  for (std::size_t e = 0; e < shell.elements.size(); ++e)
    if (shell.elements[e].size() == nodes) text += fmt::format("{}, {}\n", e + 1, fmt::join(shell.elements[e], ", "));
  return text.empty() ? text : fmt::format("*ELEMENT, TYPE={}, ELSET=WALL\n", type) + text;
}

std::vector<long> numbers(const Shares& shares) {
  std::vector<long> found;
  for (const auto& [node, share] : shares) found.push_back(node);
  return found;
}

template <typename Nodes>
std::string set_of(const char* name, const Nodes& nodes) {
  return nodes.empty() ? "" : fmt::format("*NSET, NSET={}\n{},\n", name, fmt::join(nodes, ",\n"));
}

}  // namespace

ShellGlass shell_glass(const Scene& scene) {
  const std::string fallback = "flint";
  const bool own = scene.glass.annealing.has_value();
  const auto& library = library_materials();
  const auto bundled =
      std::find_if(library.begin(), library.end(), [&](const NamedMaterial& one) { return one.name == fallback; });
  const cooling::GlassLaw& law = own ? *scene.glass.annealing : bundled->annealing.value();
  const core::Table relative = scene.glass.relative_density();
  const double room = core::zero_celsius + 20;
  return {law.young, law.poisson, scene.glass.density() * (relative.x.empty() ? 1 : relative(room)),
          is_upright(scene, scene.stages.size() - 1) ? 1 : -1,
          fmt::format("** Young's modulus and Poisson's ratio of {}, density of the case.\n",
                      own ? "the case" : fallback + ": the glass of the case has none (annealing)")};
}

std::string shell_text(const Shell& shell, const ShellGlass& glass) {
  constexpr double megapascal = 1e6, tonne_per_cubic_millimetre = 1e12;
  std::string nodes, thickness;
  for (std::size_t i = 0; i < shell.nodes.size(); ++i) {
    const ShellNode& node = shell.nodes[i];
    nodes += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", i + 1, node.at[0], node.at[1], node.at[2]);
    thickness += fmt::format("{}, {:.7g}\n", i + 1, node.thickness);
  }
  const ShellPlaces places = shell_places(shell, glass.up);
  return "** Container by Parison: the middle of the wall. Units: mm, t, s, N, MPa. A positive pressure on WALL acts "
         "from inside.\n*NODE, NSET=CONTAINER\n" +
         nodes + elements_of(shell, 8, glass.residual ? "S8" : "S8R") + elements_of(shell, 6, "S6") +
         set_of("FINISH", numbers(places.finish)) + set_of("BODY", numbers(places.body)) + set_of("BASE", places.base) +
         "*NODAL THICKNESS\n" + thickness + glass.remark +
         fmt::format("*MATERIAL, NAME=GLASS\n*ELASTIC\n{:g}, {:g}\n*DENSITY\n{:.6g}\n", glass.young / megapascal,
                     glass.poisson, glass.density / tonne_per_cubic_millimetre) +
         "*SHELL SECTION, ELSET=WALL, MATERIAL=GLASS, NODAL THICKNESS\n1.\n" +
         (glass.residual ? initial_stress(shell, glass.residual) : "") +
         shell_steps(shell, places, glass.up, bool(glass.residual));
}

}  // namespace parison::forming
