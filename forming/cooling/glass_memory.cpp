// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/cooling/glass_memory.hpp"

#include <cmath>

namespace parison::cooling {

using flow::cell_points;
using flow::SectionTensor;

namespace {

constexpr Index tensor_size = 4;  // of SectionTensor
constexpr Index stress_size = tensor_size * branches;

/// The stresses of the branches of a point, a column for each.
using PointStress = Eigen::Matrix<double, tensor_size, branches>;

Eigen::Map<const PointStress> stress_of(const Eigen::VectorXd& stress, Index point) {
  return Eigen::Map<const PointStress>(stress.data() + stress_size * point);
}

Eigen::VectorXd at_points(const core::Mesh& mesh, const Eigen::VectorXd& nodal) {
  const auto& shape = core::cell_shapes<6>().value;
  Eigen::VectorXd result(mesh.cell_count() * cell_points);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    Eigen::Matrix<double, 6, 1> at_nodes;
    for (int i = 0; i < 6; ++i) at_nodes[i] = nodal[mesh.cells()[c][i]];
    result.segment<cell_points>(c * cell_points) = shape * at_nodes;
  }
  return result;
}

/// A tensor turned from r to z.
void turn(double angle, PointStress& stress) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix4d turned = Eigen::Matrix4d::Zero();
  turned.row(0) << c * c, s * s, 0, -2 * c * s;
  turned.row(1) << s * s, c * c, 0, 2 * c * s;
  turned(2, 2) = 1;
  turned.row(3) << c * s, -c * s, 0, c * c - s * s;
  stress = turned * stress;
}

}  // namespace

GlassMemory at_rest(const core::Mesh& mesh, const Eigen::VectorXd& temperature) {
  const Eigen::VectorXd here = at_points(mesh, temperature);
  GlassMemory memory;
  memory.stress.setZero(stress_size * here.size());
  memory.fictive.resize(branches * here.size());
  for (Index k = 0; k < here.size(); ++k) memory.fictive.segment<branches>(branches * k).setConstant(here[k]);
  memory.pressure.setZero(mesh.node_count());
  return memory;
}

MemoryStep start_step(const GlassLaw& law, const core::Mesh& mesh, const GlassMemory& memory,
                      const Eigen::VectorXd& before, const Eigen::VectorXd& after, double dt) {
  const Eigen::VectorXd from = at_points(mesh, before), to = at_points(mesh, after);
  MemoryStep step;
  const auto points = static_cast<std::size_t>(from.size());
  step.relaxation.reserve(points);
  step.flow.stress.reserve(points);
  step.flow.viscosity.reserve(points);
  step.flow.expansion_rate.reserve(points);
  step.flow.bulk = law.bulk_modulus() * dt;
  step.flow.pressure = memory.pressure.head(mesh.vertex_count());
  for (Index k = 0; k < from.size(); ++k) {
    const Relaxation at = relax(law, memory.fictive.segment<branches>(branches * k).array(), from[k], to[k], dt);
    const Eigen::Vector4d left = stress_of(memory.stress, k) * at.kept.matrix();
    step.flow.stress.push_back({left[0], left[1], left[2], left[3]});
    step.flow.viscosity.push_back(at.modulus.sum() * dt);
    step.flow.expansion_rate.push_back(3 * at.strain / dt);
    step.relaxation.push_back(at);
  }
  return step;
}

GlassMemory end_step(const MemoryStep& step, const GlassMemory& before, const core::Mesh& mesh,
                     const std::vector<flow::PointStrain>& strains, const Eigen::VectorXd& pressure) {
  GlassMemory memory{Eigen::VectorXd(before.stress.size()), Eigen::VectorXd(before.fictive.size()), {}};
  for (Index k = 0; k < static_cast<Index>(strains.size()); ++k) {
    const Relaxation& at = step.relaxation[k];
    const Eigen::Map<const Eigen::Vector4d> deviator(strains[k].deviator.data());
    PointStress stress = stress_of(before.stress, k) * at.kept.matrix().asDiagonal();
    stress += 2 * deviator * at.modulus.matrix().transpose();
    turn(strains[k].rotation, stress);
    Eigen::Map<PointStress>(memory.stress.data() + stress_size * k) = stress;
    memory.fictive.segment<branches>(branches * k) = at.fictive;
  }
  memory.pressure = core::from_vertices(mesh, pressure);
  return memory;
}

std::vector<SectionTensor> stress_at_points(const core::Mesh& mesh, const Eigen::VectorXd& stress,
                                            const Eigen::VectorXd& nodal_pressure) {
  const Eigen::VectorXd pressure = at_points(mesh, nodal_pressure);
  std::vector<SectionTensor> result;
  result.reserve(pressure.size());
  for (Index k = 0; k < pressure.size(); ++k) {
    const Eigen::Vector4d deviator = stress_of(stress, k).rowwise().sum();
    result.push_back({deviator[0] - pressure[k], deviator[1] - pressure[k], deviator[2] - pressure[k], deviator[3]});
  }
  return result;
}

Eigen::VectorXd fictive_at_points(const GlassLaw& law, const Eigen::VectorXd& fictive) {
  const Eigen::Index points = fictive.size() / branches;
  return fictive.reshaped(branches, points).transpose() * law.structure.weight.matrix();
}

}  // namespace parison::cooling
