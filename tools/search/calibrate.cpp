// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/search/calibrate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/io/written_files.hpp"
#include "forming/study/search/calibration/calibration.hpp"
#include "forming/study/search/minimum/least_squares.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/folder_lock.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/search/search_runs.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using forming::CalibrationCase;
using forming::FitIntervals;
using forming::SearchVariable;

/// A fit while it goes on.
struct Fit {
  const CalibrationCase& calibration;
  std::string output;
  SearchRuns runs;
  std::size_t limit = 0, asked = 0, failed = 0;
  std::string first_failure = {};
};

std::vector<std::optional<VectorXd>> ask(Fit& fit, const std::vector<VectorXd>& places) {
  const std::vector<MadeRun> made = fit.runs.make(places);
  std::vector<std::optional<VectorXd>> found;
  for (std::size_t i = 0; i < made.size(); ++i) {
    found.push_back(made[i].reason.empty() ? forming::misfit(fit.calibration.curves, fit.output + '/' + made[i].folder)
                                           : std::nullopt);
    const std::string reason = made[i].reason.empty() ? "it lacks what was measured" : made[i].reason;
    if (!found.back() && fit.failed++ == 0) fit.first_failure = reason;
    std::string line = found.back()
                           ? fmt::format("{:>9.4g}", found.back()->norm() / std::sqrt(double(found.back()->size())))
                           : "   failed";
    for (std::size_t k = 0; k < fit.calibration.variables.size(); ++k)
      line += "  " + fit.calibration.variables[k].text(places[i][Eigen::Index(k)]);
    fmt::print("[{:>3}] {}{}\n", ++fit.asked, line, found.back() ? "" : "  " + reason);
    std::fflush(stdout);
  }
  return found;
}

/// Difference quotients beside the optimum; empty where stopped or a run failed.
MatrixXd jacobian_at(Fit& fit, const VectorXd& at, const VectorXd& residual) {
  std::vector<VectorXd> places;
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const SearchVariable& variable = fit.calibration.variables[std::size_t(i)];
    places.push_back(at);
    places.back()[i] += at[i] + variable.step <= variable.high() ? variable.step : -variable.step;
  }
  const auto found = ask(fit, places);
  MatrixXd jacobian(residual.size(), at.size());
  if (found.size() < places.size()) return {};
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!found[k]) return {};
    jacobian.col(i) = (*found[k] - residual) / (places[k][i] - at[i]);
  }
  return jacobian;
}

void print_fit(const CalibrationCase& calibration, const FitIntervals& intervals) {
  fmt::print("\n  {:<36}{:>12} {:<10} 95 % interval\n", "constant", "value", "");
  for (std::size_t i = 0; i < calibration.variables.size(); ++i) {
    const SearchVariable& variable = calibration.variables[i];
    const forming::FittedConstant& found = intervals.constants[i];
    const std::string& unit = variable.bounds.unit;
    const std::string interval = std::isfinite(found.low) ? fmt::format("{:.5g} to {:.5g}", found.low, found.high)
                                                          : std::string("not to be told from these data");
    fmt::print("  {:<36}{:>12} {:<10} {}{}\n", variable.key, fmt::format("{:.5g}", found.value), unit, interval,
               found.at_bound ? ", at its bound" : "");
  }
  for (const std::string& sentence : intervals.cannot) fmt::print("  {}\n", sentence);
  fmt::print("  scatter of the data about the model: {:.3g} times the stated noise, {} degrees of freedom\n",
             intervals.scatter, intervals.freedom);
}

void write_fit(const CalibrationCase& calibration, const FitIntervals& intervals, const VectorXd& residual,
               const std::string& output) {
  core::JsonWriter json;
  json.add("case", calibration.case_path);
  json.add("accuracy", calibration.accuracy);
  json.add("scatter", intervals.scatter);
  json.add("degrees_of_freedom", intervals.freedom);
  json.open_object("constants");
  for (std::size_t i = 0; i < calibration.variables.size(); ++i) {
    const forming::FittedConstant& found = intervals.constants[i];
    json.open_object(calibration.variables[i].key);
    json.add("unit", calibration.variables[i].bounds.unit);
    json.add("value", found.value);
    json.add("low", found.low);
    json.add("high", found.high);
    json.add("at_bound", found.at_bound);
    json.close();
  }
  json.close();
  json.open_list("cannot_tell");
  for (const std::string& sentence : intervals.cannot) json.add("", sentence);
  json.close();
  core::replace_file(output + "/calibration.json", json.finish());
  std::string text = "curve,at,measured,model\n";
  Eigen::Index row = 0;
  for (const forming::MeasuredCurve& curve : calibration.curves)
    for (std::size_t i = 0; i < curve.at.size(); ++i, ++row)
      text += fmt::format("{},{:.9g},{:.9g},{:.9g}\n", core::csv_text(curve.name()), curve.at[i], curve.value[i],
                          curve.value[i] + residual[row] * curve.noise);
  core::replace_file(output + "/fit.csv", text);
}

double noise_in(const std::string& text, const char* unit, const char* option) {
  core::CaseNode node;
  node.kind = core::CaseNode::Kind::text;
  node.file = option;
  node.text = text;
  const double noise = forming::in_unit(forming::read_measured(node), unit, node);
  if (!(noise > 0)) core::refuse(node, fmt::format("\"{}\" was found, allowed is a noise above zero", text));
  return noise;
}

CalibrationCase read_calibration(const CalibrateRequest& request) {
  const forming::Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  CalibrationCase calibration;
  calibration.file = "--vary";
  calibration.case_path = request.case_path;
  calibration.accuracy = request.accuracy;
  calibration.overrides = request.overrides;
  calibration.variables =
      forming::varied_constants(request.varied, request.case_path, request.overrides, scene.has_flow());
  calibration.keep = forming::Keep::history;
  const forming::CalibrationNoise noise{noise_in(request.temperature_noise, "K", "--temperature-noise"),
                                        noise_in(request.thickness_noise, "mm", "--thickness-noise"),
                                        noise_in(request.position_noise, "mm", "--position-noise"),
                                        noise_in(request.force_noise, "N", "--force-noise")};
  std::size_t rows = 0;
  for (const std::string& path : request.data)
    for (forming::MeasuredCurve& curve : forming::read_measurements(path, scene, noise)) {
      rows += curve.at.size();
      calibration.curves.push_back(std::move(curve));
    }
  if (rows <= calibration.variables.size())
    throw core::CaseError(fmt::format("{}: {} measurements were found, allowed are more than constants, {}",
                                      request.data.front(), rows, calibration.variables.size()));
  forming::check_corners(calibration);
  return calibration;
}

int stopped_text() {
  fmt::print(stderr, "parison: stopped on request; the same command goes on with it\n");
  return run_failed;
}

int fit_constants(Fit& fit, const CalibrationCase& calibration, bool with_flow) {
  const auto count = static_cast<Eigen::Index>(calibration.variables.size());
  VectorXd start(count), low(count), high(count), step(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SearchVariable& variable = calibration.variables[std::size_t(i)];
    start[i] = variable.start, low[i] = variable.low(), high[i] = variable.high(), step[i] = variable.step;
  }
  const double least_gain = with_flow ? 1e-3 : 1e-6;
  const auto found = forming::least_squares(start, {low, high, step, fit.limit, 0, 0, least_gain},
                                            [&](const std::vector<VectorXd>& places) { return ask(fit, places); });
  using Ending = forming::LeastSquaresResult::Ending;
  if (found.ending == Ending::stopped) return stopped_text();
  if (found.ending == Ending::start_failed) {
    fmt::print(stderr, "parison: the run at the start has no results: {}\n", fit.first_failure);
    return run_failed;
  }
  const MatrixXd jacobian = jacobian_at(fit, found.at, found.residual);
  if (jacobian.size() == 0) {
    if (stop_requested()) return stopped_text();
    fmt::print(stderr, "parison: no interval, as a run beside the answer has no results: {}\n", fit.first_failure);
    return run_failed;
  }
  const FitIntervals intervals = forming::fit_intervals(calibration.variables, found.at, found.residual, jacobian);
  print_fit(calibration, intervals);
  write_fit(calibration, intervals, found.residual, fit.output);
  fmt::print("\n  {} runs, {} failed{}; {}/calibration.json, fit.csv\n", fit.asked, fit.failed,
             found.ending == Ending::no_more_runs ? ", all that were allowed: the fit may not have ended" : "",
             fit.output);
  return found.ending == Ending::no_more_runs ? run_failed : 0;
}

}  // namespace

int calibrate(const CalibrateRequest& request) {
  const CalibrationCase calibration = read_calibration(request);
  const forming::Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  const std::string output =
      request.output.empty() ? "results/calibrate_" + fs::path(request.data.front()).stem().string() : request.output;
  const int jobs = usual_jobs(request.jobs);
  fmt::print("{} at {} accuracy: {} constants, {} curves, {} runs at once, in {}\n", request.case_path,
             request.accuracy, calibration.variables.size(), calibration.curves.size(), jobs, output);
  for (const forming::MeasuredCurve& curve : calibration.curves)
    fmt::print("  {}: {} values of {}\n", curve.name(), curve.at.size(), curve.file);
  fmt::print("  rms of the misfit in units of the noise, then the constants\n");
  std::fflush(stdout);
  catch_signals();
  core::claim_folder(output, "calibrate", {"step_*", "calibration.json", "fit.csv"});
  const FolderLock lock(output);
  Fit fit{calibration, output, SearchRuns(calibration, output, jobs), request.runs};
  return fit_constants(fit, calibration, scene.has_flow());
}

}  // namespace parison::tools
