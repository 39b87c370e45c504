// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "forming/report/checks/checks.hpp"
#include "forming/report/summary_parts.hpp"
#include "forming/step/balance/work.hpp"

namespace parison::forming {

namespace {

void add_shape_checks(const Scene& scene, const State& state, const Diagnostics& seen, Checks& checks) {
  const double wall = core::mean_wall(state.glass.mesh);
  checks.push_back({"volume_drift", seen.max_drift, 1e-3, 1e-2, "%",
                    "the glass had so much more or less volume than at its start, and its wall is wrong by about as "
                    "much; a smaller numerics.strain_per_step helps",
                    CheckKind::error});
  if (!scene.tools.empty()) {
    const std::string entered = entered_face_sentence(scene, seen.in_tools);
    const auto check = [&](const char* name, const Penetrated& found, double limit, double severe_limit,
                           const char* what, const char* advice) {
      const std::string where = place_of_penetration(scene, found);
      checks.push_back({name, std::max(found.share, found.depth / wall), limit, severe_limit, "%",
                        !entered.empty() ? entered
                                         : fmt::format("{} by so much of the mean wall, then or at the end{}; {}", what,
                                                       where.empty() ? "" : ", " + where, advice),
                        CheckKind::resolution});
    };
    check("penetration", seen.in_tools.node, 1e-2, 0.1, "a node of the glass was inside a tool",
          "a smaller numerics.strain_per_step or numerics.surface_size helps");
    check("edge_penetration", seen.in_tools.edge, 5e-2, 0.25, "an edge of the glass cut into a tool",
          "a smaller numerics.surface_size, or a finer --accuracy, helps");
  }
  const auto is_symmetry = [](const Boundary& boundary) { return boundary.kind == BoundaryKind::symmetry; };
  if (scene.geometry == core::Geometry::axisymmetric ||
      std::any_of(scene.glass.boundaries.begin(), scene.glass.boundaries.end(), is_symmetry))
    checks.push_back({"axis", seen.off_axis / wall, 1e-2, 0.1, "%",
                      "a node of the glass passed the axis in one step and was put back, or lay beyond a plane of "
                      "symmetry, by so much of the mean wall; a smaller numerics.strain_per_step helps, and where a "
                      "hole closes at such a plane the whole section in place of its half",
                      CheckKind::resolution});
}

/// Whether the glass still has a mapped mesh with a single division from side to side: the recovery has nothing to
/// compare there.
bool has_single_division(const Scene& scene, const State& state) {
  const auto& mapped = scene.glass.mesh.mapped;
  return mapped && std::min(mapped->along_first, mapped->along_second) == 1 && remeshes(state) == 0;
}

void add_mesh_checks(const Scene& scene, const State& state, const FlowWork& flow, Checks& checks) {
  const RemeshStatistics& remeshing = state.totals.remeshing;
  // At tools most of it lies where contact ends, whose stresses no mesh resolves and which change little else; of glass
  // that nothing touches it is the error of the whole wall.
  const double unresolved_limit = scene.tools.empty() ? 0.01 : 0.03;
  // Motion that loses less than counts as motion at all, as of a drop that becomes as round as its mesh can be, is
  // none to resolve: it stays below the limit.
  const double measure = std::max(flow.sampled, least_loss(scene, state) / unresolved_limit);
  const double unresolved = flow.sampled != 0 ? flow.unresolved / measure : 0;
  checks.push_back({"flow_resolution", unresolved, unresolved_limit, 0.5, "%",
                    "about so much of the work is dissipated by motion that the glass mesh does not resolve, and "
                    "shapes, forces and times are wrong by up to as much; a "
                    "smaller numerics.surface_size or mesh.size of the glass, or more numerics.elements_across helps",
                    CheckKind::error});
  if (scene.glass.mesh.mapped)
    checks.push_back(
        {"single_division", has_single_division(scene, state) ? 1.0 : 0.0, 0, no_limit, "",
         "the mapped mesh of the glass has a single division from side to side, and how much of the flow it "
         "does not resolve cannot be told; two divisions or more help"});
  checks.push_back({"failed_meshes", static_cast<double>(remeshing.failed), 1, no_limit, "",
                    "so many new glass meshes could not be made and the old ones stayed in use, as a rule next to thin "
                    "films or folds; a smaller numerics.surface_size may help"});
  checks.push_back({"mesh_coarsening", remeshing.coarsening_factor - 1, 0, 1, "%",
                    fmt::format("a glass mesh was so much coarser than asked for, to have about {:g} cells; a larger "
                                "numerics.max_cells lifts this",
                                scene.accuracy.max_cells)});
}

void add_step_checks(const Scene& scene, const State& state, const Diagnostics& seen, Checks& checks) {
  const Totals& totals = state.totals;
  const double steps = std::max(1.0, static_cast<double>(totals.steps));
  // What unequal contraction gives is no load's: glass that should be stiffer would have it as stress.
  const double capped = std::max(seen.work.capped - std::max(-totals.work.expansion, 0.0), 0.0);
  const double share_of_capped = capped != 0 ? capped / std::max(totals.work.dissipation, least_loss(scene, state)) : 0;
  const double contacts = std::max(1.0, static_cast<double>(seen.steps.contacts));
  const Work& work = totals.work;
  const double lost = std::max(work.dissipation + work.friction + work.impact_loss, least_loss(scene, state));
  if (!scene.tools.empty())
    checks.push_back({"impact", std::abs(work.impact_loss) / lost, 0.03, 0.3, "%",
                      "glass without inertia has no impact, but so much of the work was booked as one, where tools "
                      "acted on glass before they had reached it: forces act too long, and shapes and times are wrong "
                      "by up to as much; a smaller numerics.landing_per_step or numerics.min_step helps",
                      CheckKind::error});
  if (!scene.tools.empty())
    checks.push_back({"locked_contacts", static_cast<double>(seen.steps.locked_contacts) / contacts, 1e-2, 0.1, "%",
                      "so many of all contacts were held closed although they pull, because the set of contacts "
                      "cycled: glass sticks there that should come off; a smaller numerics.surface_size or "
                      "numerics.max_step helps",
                      CheckKind::resolution});
  checks.push_back({"step_collapse", static_cast<double>(seen.steps.short_steps) / steps, 0.3, no_limit, "%",
                    fmt::format("so many of the steps were shorter than ten times numerics.min_step, {:g} s: the "
                                "motion is faster there than any forming, as of a bursting film or of a tool that is "
                                "not balanced; look at the last pictures",
                                scene.accuracy.min_step)});
  if (scene.has_heat())
    checks.push_back(
        {"coupling", seen.work.unforeseen / std::max(totals.work.dissipation, least_loss(scene, state)), 0.01, 0.1, "%",
         "the heat of the steps changed the viscosity otherwise than they had foreseen, and forces are "
         "wrong by about so much, temperatures too where work warms the glass; a smaller numerics.max_step "
         "helps",
         CheckKind::error});
  checks.push_back({"inertia", seen.work.max_reynolds, 1, 20, "",
                    "inertia is neglected, but the Reynolds number reached this: speeds and times are too short; a "
                    "stiffer glass or slower tools are what this program can do"});
  checks.push_back(
      {"viscosity_cap", share_of_capped, 1e-2, 0.1, "%",
       "the flow takes no glass as stiffer than 3e10 Pa.s, and so much of the work was lost in glass that should be "
       "stiffer: forces are too low and the glass gives way too easily; hotter glass or a constant "
       "viscosity, which has no cap, helps"});
}

}  // namespace

void add_flow_checks(const Scene& scene, const State& state, const RunFacts& facts, Checks& checks) {
  checks.push_back({"work_balance", max_work_imbalance(scene, state, facts), 5e-3, 5e-2, "%",
                    "the work done on the glass and the work dissipated or stored differ by this at a stage's end, and "
                    "forces and times are wrong by about as much; a higher accuracy or a smaller "
                    "numerics.strain_per_step helps",
                    CheckKind::error});
  add_shape_checks(scene, state, facts.diagnostics, checks);
  add_mesh_checks(scene, state, facts.diagnostics.work, checks);
  add_step_checks(scene, state, facts.diagnostics, checks);
}

}  // namespace parison::forming
