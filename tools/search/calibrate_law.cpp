// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/case/case_file.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/law/law_fit.hpp"
#include "tools/search/calibrate.hpp"

namespace parison::tools {
namespace {

using namespace contact::law_constant;
namespace dimension = core::dimension;

struct ConstantUnit {
  core::Dimension dimension;
  const char* unit;  ///< in SI, as a case file writes it
};
const std::array<ConstantUnit, contact::law_constants> units{{{dimension::conductance, "W/m2/K"},
                                                              {dimension::conductance, "W/m2/K"},
                                                              {dimension::pressure, "Pa"},
                                                              {dimension::viscosity, "Pa.s"},
                                                              {dimension::none, ""},
                                                              {dimension::none, ""}}};

constexpr double default_p_ref = 0.2e6;  // Pa; any other value gives the same law with another eta_ref

contact::LawFitOptions read_options(const CalibrateRequest& request) {
  contact::LawFitOptions options;
  options.relative = request.relative;
  const auto& names = contact::law_constant_names;
  for (const auto& text : request.fixed) {
    const auto equals = text.find('=');
    core::CaseNode node;
    node.file = "--fix";
    node.key = text.substr(0, equals);
    const auto at = std::find(names.begin(), names.end(), node.key) - names.begin();
    if (equals == text.npos || at == contact::law_constants)
      core::refuse(node, fmt::format("allowed is NAME=VALUE with one of {}", fmt::join(names, ", ")));
    const auto value = core::parse_value(text.substr(equals + 1), node);
    const int constant = static_cast<int>(at);
    const bool exponent = constant == a || constant == b;
    contact::constant_of(options.fixed, constant) = exponent ? core::not_negative(value, units[constant].dimension)
                                                             : core::positive(value, units[constant].dimension);
    options.is_fixed[constant] = true;
  }
  if (!options.is_fixed[p_ref] && !options.is_fixed[eta_ref]) {
    options.is_fixed[p_ref] = true;
    options.fixed.p_ref = default_p_ref;
  }
  return options;
}

std::function<double(double)> viscosity_of(const std::string& case_path) {
  if (case_path.empty()) return {};
  const auto scene = forming::read_scene(case_path, "draft");
  if (!scene.has_flow())
    throw core::CaseError(
        fmt::format("--law: the glass of \"{}\" has no viscosity, allowed is a case whose glass flows", case_path));
  return [viscosity = scene.glass.flow->viscosity](double temperature) { return viscosity(temperature); };
}

std::string shown(double value, const char* unit) {
  return fmt::format("{:.6g}{}{}", value, *unit ? " " : "", unit);
}

std::string constant_lines(const contact::LawFit& fit) {
  std::string text = fmt::format("  {:<10}{:<22}{}\n", "constant", "value", "95 % interval");
  for (int i = 0; i < contact::law_constants; ++i) {
    const auto& constant = fit.constants[i];
    const std::string interval = constant.fixed    ? "fixed"
                                 : !constant.known ? "not identifiable"
                                                   : fmt::format("{:.4g} to {:.4g}", constant.low, constant.high);
    text += fmt::format("  {:<10}{:<22}{}\n", contact::law_constant_names[i], shown(constant.value, units[i].unit),
                        interval);
  }
  return text;
}

std::string residual_line(const contact::LawFit& fit, bool is_flux, bool relative) {
  const auto larger = [](double x, double y) { return std::abs(x) < std::abs(y); };
  const auto max_residual = std::max_element(fit.residual.begin(), fit.residual.end(), larger);
  const double unit = relative ? 100 : 1;
  return fmt::format(
      "  residual: standard deviation {:.4g} {}, {} degrees of freedom; largest {:.4g} in measurement {} of {}\n",
      unit * fit.scatter,
      relative  ? "%"
      : is_flux ? "W/m2"
                : "W/m2/K",
      fit.freedom, unit * *max_residual, max_residual - fit.residual.begin() + 1, fit.residual.size());
}

std::string interface_lines(const contact::LawFit& fit) {
  std::string text = "[[interface]]\ntools = [\"NAME\"]\nlaw = \"pressure-viscosity\"\n";
  for (int i = 0; i < contact::law_constants; ++i) {
    const std::string value = shown(fit.constants[i].value, units[i].unit);
    text += fmt::format("{} = {}{}\n", contact::law_constant_names[i], *units[i].unit ? '"' + value + '"' : value,
                        fit.constants[i].known ? "" : "  # not identifiable");
  }
  return text;
}

}  // namespace

int calibrate_law(const CalibrateRequest& request) {
  const auto options = read_options(request);
  const auto data = contact::read_law_data(request.law, viscosity_of(request.case_path));
  const auto fit = contact::fit_law(data, options);
  const bool is_flux = std::any_of(data.begin(), data.end(), [](const auto& row) { return row.drive != 1; });
  fmt::print("h = h0 + (h1 - h0) x/(1 + x), x = (p/p_ref)^a (eta_ref/eta)^b, fitted to {} measurements of {}\n\n{}\n{}",
             data.size(), is_flux ? "q" : "h", constant_lines(fit), residual_line(fit, is_flux, options.relative));
  for (const auto& warning : fit.warnings) fmt::print("  warning: {}\n", warning);
  fmt::print("\n{}", interface_lines(fit));
  return 0;
}

}  // namespace parison::tools
