// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conductance/interface_conductance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parison::contact {

namespace {

using core::Dual;
using core::Index;

/// The arguments at the points of a run, and where the results go.
struct Batch {
  Eigen::Ref<const Eigen::ArrayXd> pressure, pressure_part, log_viscosity;
  Eigen::Ref<Eigen::ArrayXd> h;
  double* derivative;  ///< null: not wanted

  Eigen::Map<Eigen::ArrayXd> derivatives() const { return {derivative, h.size()}; }
};

Index evaluate(const ConstantConductance& law, Batch batch) {
  batch.h.setConstant(law.h);
  if (batch.derivative) batch.derivatives().setZero();
  return 0;
}

/// Entries [first, first + 8) of an array, filled up with zeros behind its end: Eigen's exponential of a single number
/// may differ in the last bit from that of a packet.
using Values = Eigen::Array<double, 8, 1>;
template <typename Array>
Values load(const Array& from, Index first) {
  if (from.size() - first >= Values::SizeAtCompileTime) return from.template segment<Values::SizeAtCompileTime>(first);
  Values values = Values::Zero();
  values.head(from.size() - first) = from.tail(from.size() - first);
  return values;
}
template <typename Array>
void store(const Values& values, Index first, Array&& to) {
  if (to.size() - first >= Values::SizeAtCompileTime)
    to.template segment<Values::SizeAtCompileTime>(first) = values;
  else
    to.tail(to.size() - first) = values.head(to.size() - first);
}

Index evaluate(const PressureViscosityConductance& law, Batch batch) {
  for (Index first = 0; first < batch.h.size(); first += Values::SizeAtCompileTime) {
    const Values pressure_part = load(batch.pressure_part, first), log_viscosity = load(batch.log_viscosity, first);
    if (batch.derivative) {
      const auto h =
          law.from_logarithms<Dual<Values>>({pressure_part, Values::Zero()}, {log_viscosity, Values::Ones()});
      store(h.value, first, batch.h);
      store(h.derivative, first, batch.derivatives());
    } else {
      store(law.from_logarithms(pressure_part, log_viscosity), first, batch.h);
    }
  }
  return 0;
}

/// Gaps have more arguments: set_gap_conductance.
Index evaluate(const GapConductance&, Batch batch) {
  batch.h.setZero();
  if (batch.derivative) batch.derivatives().setZero();
  return 0;
}

Index evaluate(const TableConductance& law, Batch batch) {
  Index clamped = 0;
  for (Index i = 0; i < batch.h.size(); ++i) {
    const auto viscosity = exp(Dual<double>{batch.log_viscosity[i], 1});
    const auto [h, derivative] = law(Dual<double>{batch.pressure[i], 0}, viscosity);
    batch.h[i] = h;
    if (batch.derivative) batch.derivative[i] = derivative;
    clamped += law.clamps(batch.pressure[i], viscosity.value);
  }
  return clamped;
}

/// The other values of the interface, of which a gap alone depends.
struct Faces {
  double age;  ///< s
  const std::vector<core::InterfacePoint>& points;
  const Eigen::ArrayXd &slave, &master;  ///< K
  Eigen::ArrayXd *h, *dh_dT;
};

/// The points of a run that has the law of a gap.
void evaluate(const GapConductance& law, Index first, Index count, const Faces& faces) {
  for (Index i = first; i < first + count; ++i) {
    const core::InterfacePoint& point = faces.points[static_cast<std::size_t>(i)];
    const double opening = law.opening_after(std::max(point.opening, 0.0), point.closing_rate, faces.age);
    const auto h = law.at_opening(opening, Dual<double>{faces.slave[i], 1}, Dual<double>{faces.master[i], 0});
    (*faces.h)[i] = h.value;
    if (faces.dh_dT) (*faces.dh_dT)[i] = h.derivative;
  }
}

}  // namespace

InterfaceConductance::InterfaceConductance(std::vector<ConductanceLaw> laws,
                                           const std::vector<core::InterfacePoint>& points)
    : laws_(std::move(laws)), pressure_(points.size()), pressure_part_(points.size()) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Index law = points[i].law, at = static_cast<Index>(i);
    if (i == 0 || law != points[i - 1].law) runs_.push_back({law, at, 0});
    ++runs_.back().count;
    pressure_[at] = std::max(points[i].pressure, 0.0);
    const auto* pressure_law = std::get_if<PressureViscosityConductance>(&laws_[law]);
    pressure_part_[at] = pressure_law ? pressure_law->pressure_part(pressure_[at]) : 0;
  }
}

Index InterfaceConductance::operator()(const Eigen::ArrayXd& log_viscosity, Eigen::ArrayXd& h,
                                       Eigen::ArrayXd* dh_dlog) const {
  Index clamped = 0;
  for (const auto& [law, first, count] : runs_) {
    const Batch batch{pressure_.segment(first, count), pressure_part_.segment(first, count),
                      log_viscosity.segment(first, count), h.segment(first, count),
                      dh_dlog ? dh_dlog->data() + first : nullptr};
    clamped += std::visit([&](const auto& l) { return evaluate(l, batch); }, laws_[law]);
  }
  return clamped;
}

void InterfaceConductance::set_gap_conductance(double age, const std::vector<core::InterfacePoint>& points,
                                               const Eigen::ArrayXd& slave_temperature,
                                               const Eigen::ArrayXd& master_temperature, Eigen::ArrayXd& h,
                                               Eigen::ArrayXd* dh_dT) const {
  const Faces faces{age, points, slave_temperature, master_temperature, &h, dh_dT};
  for (const auto& [law, first, count] : runs_)
    if (const auto* gap = std::get_if<GapConductance>(&laws_[law])) evaluate(*gap, first, count, faces);
}

}  // namespace parison::contact
