// SPDX-License-Identifier: GPL-3.0-or-later
// A tube blown into a square mould is the same glass wherever it stands, and whatever sector of it is computed.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "figure.hpp"
#include "solid/hex_block.hpp"
#include "solid/square_cavity.hpp"

namespace parison::tests {
namespace {

/// How glass and mould together are turned, mirrored or shifted in space.
struct Placing {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vector3 shift = Vector3::Zero();  ///< m
  Vector3 there(const Vector3& x) const { return turn * x + shift; }
  Vector3 back(const Vector3& x) const { return turn.transpose() * (x - shift); }
};

Placing turned(double angle) {
  return {Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix(), Vector3::Zero()};
}

/// A tool with its place.
class Placed : public contact::ToolSurface {
 public:
  Placed(const contact::ToolSurface& tool, const Placing& placing) : tool_(tool), placing_(placing) {}
  contact::SurfaceGap gap(const Vector3& at) const override {
    const contact::SurfaceGap own = tool_.gap(placing_.back(at));
    return {own.distance, placing_.turn * own.normal};
  }

 private:
  const contact::ToolSurface& tool_;
  const Placing& placing_;
};

constexpr double inside = 14e-3, outside = 17e-3, bottom = 20e-3, top = 50e-3;  ///< of the tube, m
constexpr Index cells_of_quarter = 8;

/// A sector of a tube whose wall is thickest above, between angles; it stands where it is placed.
core::HexMesh tube_sector(double from, double to, const Placing& placing) {
  const auto around = static_cast<Index>(std::lround(cells_of_quarter * (to - from) / (M_PI / 2)));
  core::HexMesh mesh = hex_block(around, 2, 2, [&](const Vector3& x) {
    const double radius = outside - (outside - inside) * (1 - x[2]) * (0.7 + 0.3 * x[1]),
                 at = from + (to - from) * x[0];
    return placing.there({radius * std::cos(at), radius * std::sin(at), bottom + (top - bottom) * x[1]});
  });
  if (placing.turn.determinant() < 0)
    for (auto& cell : mesh.cells)
      for (int n = 0; n < 27; n += 3) std::swap(cell[n], cell[n + 2]);
  return mesh;
}

/// Where glass of a sector went, put back to where it was not placed.
struct Blown {
  std::vector<Vector3> from, to;
  std::vector<double> steps;
  Index touching = 0;  ///< points
};

Blown blow(double from, double to, const Placing& placing = {}) {
  const auto material = uniform_glass(1);
  const SquareCavity cavity(20e-3, 6e-3);
  const Placed mould(cavity, placing);
  flow::SolidGlass glass = glass_of(tube_sector(from, to, placing), material);
  const auto nodes = [&](const std::function<bool(const Vector3&)>& is_so) {
    return nodes_where(glass.mesh, [&](const Vector3& x) { return is_so(placing.back(x)); });
  };
  const auto faces = [&](const std::function<bool(const Vector3&)>& is_so) {
    return faces_where(glass.mesh, [&](const Vector3& x) { return is_so(placing.back(x)); });
  };
  flow::SolidProblem problem;
  problem.material = &material;
  problem.gravity = -1e-3;  // a tenth of what the gas does
  for (const double at : {from, to}) {
    const Vector3 normal(-std::sin(at), std::cos(at), 0);
    problem.planes.push_back(
        {placing.turn * normal, nodes([=](const Vector3& x) { return std::abs(x.dot(normal)) < 1e-9; })});
  }
  problem.planes.push_back({Vector3::UnitZ(), nodes([](const Vector3& x) { return x[2] > top - 1e-9; })});
  problem.contact_faces = faces([](const Vector3& x) { return x.head<2>().norm() > outside - 1e-6; });
  problem.pressures = {{faces([](const Vector3& x) {
                          const double share = (x[2] - bottom) / (top - bottom);
                          const double radius = outside - (outside - inside) * (0.7 + 0.3 * share);
                          return x.head<2>().norm() < radius + 1e-6;
                        }),
                        1.0}};
  problem.tools = {{&mould, Vector3::Zero(), Vector3::Zero(), {}}};
  flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
  Blown blown;
  for (const Vector3& x : glass.mesh.nodes) blown.from.push_back(placing.back(x));
  for (int step = 0; step < 20; ++step) {
    flow::SolidStepLimits limits;
    limits.longest = step ? 1 : 0.01;
    const auto done = flow::step_flow(problem, matrix, glass, flow::propose_step(problem, glass, limits));
    EXPECT_TRUE(done.accepted);
    blown.steps.push_back(done.dt);
  }
  for (const Vector3& x : glass.mesh.nodes) blown.to.push_back(placing.back(x));
  for (const auto& point : glass.contact) blown.touching += point.touches;
  return blown;
}

/// Largest distance of two results where both have glass, m; `whole` has all of `part`.
double apart(const Blown& part, const Blown& whole) {
  double worst = 0;
  std::size_t found = 0;
  for (std::size_t a = 0; a < part.from.size(); ++a)
    for (std::size_t b = 0; b < whole.from.size(); ++b)
      if ((part.from[a] - whole.from[b]).norm() < 1e-9) {
        ++found;
        worst = std::max(worst, (part.to[a] - whole.to[b]).norm());
      }
  EXPECT_EQ(found, part.from.size());
  return worst;
}

TEST(SolidSymmetry, GlassAndMouldTurnedMirroredOrShiftedGiveTheSame) {
  const Blown whole = blow(0, M_PI / 2);
  double way = 0;
  for (std::size_t n = 0; n < whole.from.size(); ++n) way = std::max(way, (whole.to[n] - whole.from[n]).norm());
  fmt::print("steps to {:.4f} s, touching {} way {:.2f} mm\n", whole.steps.back(), whole.touching, 1e3 * way);
  EXPECT_GT(whole.touching, 100);
  Placing mirror, shift;
  mirror.turn(0, 0) = -1;
  shift.shift = {0.13, -0.07, 0.41};
  Placing all = turned(2.1);
  all.turn = all.turn * mirror.turn;
  all.shift = shift.shift;
  Figure figure("nodes of a blown tube turned, mirrored, shifted: apart", "m");
  for (const auto& [name, placing] :
       {std::pair{"turned", turned(0.7)}, {"mirrored", mirror}, {"shifted", shift}, {"all", all}}) {
    const double distance = apart(blow(0, M_PI / 2, placing), whole);
    fmt::print("{}: apart {:.2e} m\n", name, distance);
    figure.add(distance);
  }
  figure.at_most(1e-9);
}

TEST(SolidSymmetry, AQuarterIsTwoEighths) {
  const Blown quarter = blow(0, M_PI / 2);
  Figure figure("nodes of a quarter of a blown tube against those of two eighths: apart", "m");
  for (const auto& [from, to] : {std::pair{0.0, M_PI / 4}, {M_PI / 4, M_PI / 2}}) {
    const Blown eighth = blow(from, to);
    const double distance = apart(eighth, quarter);
    fmt::print("eighth touching {} of {}: apart {:.2e} m\n", eighth.touching, quarter.touching, distance);
    EXPECT_EQ(2 * eighth.touching, quarter.touching);
    figure.add(distance);
  }
  figure.at_most(1e-9);
}

}  // namespace
}  // namespace parison::tests
