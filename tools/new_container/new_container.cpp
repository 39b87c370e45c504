// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/new_container/new_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <regex>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/case/text/case_edit.hpp"
#include "core/io/files.hpp"
#include "core/math/numbers.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/scene.hpp"
#include "tools/new_container/container_fit.hpp"
#include "tools/new_container/tubing.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {

using core::millimetre;
namespace {

constexpr core::Dimension mass_dimension{0, 1};
constexpr double within = 5e-3;

double positive(const char* option, const std::string& text, const core::Dimension& dimension) {
  const auto found = core::parse_quantity(text, dimension);
  if (!found.problem.empty()) throw core::CaseError(fmt::format("{}: {}", option, found.problem));
  if (!(found.value > 0))
    throw core::CaseError(fmt::format("{}: \"{}\" was found, allowed is more than zero", option, text));
  return found.value;
}

std::string template_of(const std::string& process) {
  const auto file = shared_file("tools/new_container/templates") / (process + ".toml");
  if (process.find_first_of("/.") == process.npos && std::filesystem::exists(file)) return file.string();
  throw core::CaseError(fmt::format(
      "--process: \"{}\" was found, allowed are {}; for others `parison new NAME --like CASE`", process, processes));
}

/// A design, and what `parison check` would find unusual about it.
struct Design {
  ContainerFit fit;
  std::size_t findings;
};

/// Refuses tools that do not go into each other, and pressed walls beyond those of the trade.
void check_design(const forming::Scene& scene, const ContainerFit& fit, double capacity) {
  const double off = scene.container->capacity.value_or(0) / capacity - 1;
  constexpr double thinnest = 2 * millimetre, thickest = 12 * millimetre;  // assumed
  if (is_pressed(scene) && (fit.second < thinnest || fit.second > thickest))
    throw core::CaseError(fmt::format("its wall is {:.2g} mm, usual of pressed ware are {:g} to {:g} mm",
                                      fit.second / millimetre, thinnest / millimetre, thickest / millimetre));
  if (std::abs(off) > within || !scene.container->parison || fit.second >= fit.body)
    throw core::CaseError(
        fmt::format("a blank with a radius of {:.4g} mm does not go into a mould with one of {:.4g} mm",
                    fit.second / millimetre, fit.body / millimetre));
}

/// Blanks of several lengths, shares of the height, the usual one first: a short one holds much glass, a long one
/// little. The first of which nothing is unusual, else that with the fewest findings. Pressed ware has one design.
Design best_design(const std::string& file, const std::vector<std::string>& given, double capacity, double mass) {
  std::optional<Design> best;
  std::string refused;
  const bool pressed = is_pressed(forming::read_scene(file, "draft"));
  for (const double share : {0.0, 0.6, 0.7, 0.55, 0.76, 0.5, 0.82, 0.45}) {
    if (share > 0 && pressed) break;
    std::vector<std::string> overrides = given;
    if (share > 0) overrides.push_back(fmt::format("dimension.blank_length={} * height", share));
    try {
      const ContainerFit fit = fit_container(file, overrides, capacity, mass);
      const forming::Scene scene = forming::read_scene(file, "draft", fit.overrides);
      check_design(scene, fit, capacity);
      const std::size_t findings = forming::unusual_values(scene).size();
      if (!best || findings < best->findings) best = Design{fit, findings};
      if (findings == 0) return *best;
    } catch (const core::CaseError& error) {
      if (refused.empty()) refused = std::regex_replace(error.what(), std::regex("^/[^:]*:[0-9]+: "), "");
    }
  }
  if (best) return *best;
  throw core::CaseError(
      fmt::format("no container of ordinary proportions has this weight, capacity and height: {}", refused));
}

/// No ball of the glass is wider than its gob may be.
void limit_gob(const std::string& file, double mass, std::vector<std::string>& given) {
  const forming::Scene scene = forming::read_scene(file, "draft");
  const double ball = std::cbrt(6 * mass / scene.glass.density() / M_PI);
  for (const auto& dimension : scene.dimensions)
    if (dimension.name == "gob_diameter")
      given.push_back(
          fmt::format("dimension.gob_diameter=min({}, {:.4g} mm)", dimension.given, 0.97 * ball / millimetre));
}

/// The template with plain numbers in place of its formulas, to so many parts of a millimetre.
std::string resolved(const std::string& file, const std::vector<std::string>& overrides, const forming::Scene& scene,
                     double parts) {
  std::string text = core::read_text(file);
  for (const std::string& one : overrides) text = core::edited_case_text(text, file, one);
  for (const auto& dimension : scene.dimensions)
    text = core::edited_case_text(text, file,
                                  fmt::format("dimension.{}={:g} mm", dimension.name,
                                              std::round(parts * dimension.measure.value / millimetre) / parts));
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    text = core::edited_case_text(
        text, file, fmt::format("stage.{}.duration={:g} s", i, std::round(100 * scene.stages[i].duration) / 100));
  return std::regex_replace(text, std::regex("parison_[a-z]+ = [^\n]*\n"), "");
}

}  // namespace

std::string container_text(const ContainerWish& wish, const std::string& name) {
  const std::string file = template_of(wish.process);
  const double mass = positive("--weight", wish.weight, mass_dimension);
  const double capacity = positive("--capacity", wish.capacity, core::dimension::volume);
  const double height = positive("--height", wish.height, core::dimension::length);
  std::optional<double> finish;
  if (!wish.finish.empty()) finish = positive("--finish", wish.finish, core::dimension::length);
  const bool tubing = wish.process == tubing_process;
  std::vector<std::string> overrides;
  if (tubing) {
    overrides = fit_tubing({mass, capacity, height, finish}, forming::read_scene(file, "draft").glass.density());
  } else {
    overrides.push_back(fmt::format("dimension.height={:.6g} mm", height / millimetre));
    if (finish) overrides.push_back(fmt::format("dimension.finish_radius={:.6g} mm", *finish / 2 / millimetre));
    overrides.push_back(fmt::format("glass.gob.mass={:.6g} g", 1e3 * mass));
    limit_gob(file, mass, overrides);
    overrides = best_design(file, overrides, capacity, mass).fit.overrides;
  }
  overrides.push_back(fmt::format("case={}", name));
  constexpr double of_tubing = 1000, of_moulds = 100;  // a tube has walls of half a millimetre
  return resolved(file, overrides, forming::read_scene(file, "draft", overrides), tubing ? of_tubing : of_moulds);
}

}  // namespace parison::tools
