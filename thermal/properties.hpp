#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "core/case/table.hpp"
#include "core/case/time_function.hpp"
#include "thermal/cells/cell_batch.hpp"
#include "thermal/radiation/planck.hpp"

namespace parison::thermal {

/// Part of the spectrum in which a glass absorbs alike; it begins where the band before it ends.
struct Band {
  double up_to;       ///< wavelength in vacuum, m; infinite for the rest of the spectrum
  double absorption;  ///< absorption coefficient kappa, 1/m; that of the first entry where it depends on temperature
  core::Table relative = {};  ///< kappa over `absorption`, by temperature, K; empty: the same at all temperatures
};

/// The mean absorption that gives Rosseland's conduction of bands, 1/m, over temperature, K: the harmonic mean weighted
/// with the derivative of the emission, where glass beyond the last band conducts nothing (M. F. Modest, Radiative Heat
/// Transfer, 3rd ed. 2013, chapter 15).
core::Table rosseland_absorption(const std::vector<Band>& bands);

/// Internal radiation. Rosseland (1924): it adds to the conductivity k_r = 16/3 n^2 sigma T^3 / kappa, T in K, which
/// holds where the wall is optically thick, kappa w >> 1. P1: an equation for the light of each band (see
/// radiation/README.md); beyond the last band the glass is opaque. P1 in cones: two equations, for the directions that
/// total reflection keeps inside and for those that leave. Transfer: the radiative transfer equation along rays.
struct Radiation {
  enum class Model { rosseland, p1, p1_cones, transfer };
  double refractive_index;
  double absorption;      ///< rosseland: mean absorption coefficient kappa, 1/m
  bool thin_wall = true;  ///< rosseland: multiply k_r by thin_wall_factor of the local wall thickness
  Model model = Model::rosseland;
  std::vector<Band> bands = {};  ///< of all but rosseland: wavelengths rise
  core::Table relative = {};     ///< rosseland: kappa over `absorption`, by temperature, K; empty: the same at all
};

/// Thermal properties of a body; tables over temperature in K.
struct Material {
  double density;             ///< kg/m3
  core::Table heat_capacity;  ///< J/kg/K
  core::Table conductivity;   ///< W/m/K, without internal radiation
  std::optional<Radiation> radiation;
  core::Table relative_density = {};  ///< density over `density`, by temperature, K; empty: the same at all
};

/// Convection and radiation from a boundary to its surroundings, heat flux positive out of the body:
/// q = h (T - T_air) + emissivity sigma (T^4 - T_ambient^4), with the Stefan-Boltzmann constant sigma.
struct SurfaceExchange {
  core::TimeFunction h = 0;                  ///< heat transfer coefficient, W/m2/K
  core::TimeFunction air_temperature = 300;  ///< K
  double emissivity = 0;
  core::TimeFunction ambient_temperature = 300;  ///< K
};

/// Whether internal radiation is computed as conduction.
inline bool is_rosseland(const Material& material) {
  return material.radiation && material.radiation->model == Radiation::Model::rosseland;
}
/// Whether the light inside is computed band by band.
inline bool has_light(const Material& material) {
  return material.radiation && material.radiation->model != Radiation::Model::rosseland;
}

/// Whether a band of that light absorbs otherwise at another temperature.
bool absorption_varies(const Material& material);

/// A SurfaceExchange at one time.
struct ExchangeCoefficients {
  double h;                    ///< W/m2/K
  double air_temperature;      ///< K
  double emissivity;           ///< 0 to 1
  double ambient_temperature;  ///< K
};
inline ExchangeCoefficients coefficients_at(const SurfaceExchange& exchange, double time) {
  return {exchange.h(time), exchange.air_temperature(time), exchange.emissivity, exchange.ambient_temperature(time)};
}

inline constexpr double content_reference = core::zero_celsius;  ///< K, where enthalpy and heat content are zero

/// Factor on the Rosseland conductivity in a wall of thickness w, m: 1/(1 + 4/(3 kappa w)), with kappa of the first
/// entry where it depends on temperature, for which `conductivity` corrects it. It makes the radiative flux between two
/// black walls that of the diffusion approximation with a temperature jump at the walls (Deissler 1964), n^2 sigma
/// (T1^4 - T2^4)/(1 + 3 kappa w/4), close to the exact flux in thick and in thin walls.
template <typename Number>
[[gnu::always_inline]] inline Number thin_wall_factor(const Radiation& radiation, const Number& wall_thickness) {
  return radiation.thin_wall ? 1 / (1 + 4 / (3 * radiation.absorption * wall_thickness)) : Number{} + 1;
}

/// Conductivity with internal radiation, W/m/K, at a temperature, K; `thin_wall` multiplies the radiative part.
double conductivity(const Material& material, double temperature, double thin_wall = 1);

/// The same, prepared for many evaluations.
class Conductivity {
 public:
  explicit Conductivity(const Material& material);
  double operator()(double temperature, double thin_wall = 1) const {
    double k = phonon_(temperature);
    add_radiant(temperature, thin_wall, k);
    return k;
  }
  void set_values(const PointValues& temperature, const PointValues& thin_wall, PointValues& values) const;
  /// Derivatives with respect to temperature, W/m/K2.
  void set_derivatives(const PointValues& temperature, const PointValues& thin_wall, PointValues& derivatives) const;

 private:
  void add_radiant(double temperature, double thin_wall, double& sum) const {
    if (relative_.x.empty()) return add_radiant<double>(temperature, thin_wall, sum);
    const double T = core::positive_part(temperature);
    sum += radiant_ * T * T * T / (relative_(temperature) + added_depth(thin_wall));
  }
  /// What the walls add to a relative absorption a: 1/(1 + 4/(3 a kappa w)) = a/(a + 4/(3 kappa w)).
  static double added_depth(double thin_wall) { return 1 / thin_wall - 1; }
  void add_varying(const PointValues& temperature, const PointValues& thin_wall, PointValues& values) const;
  void add_varying_derivatives(const PointValues& temperature, const PointValues& thin_wall,
                               PointValues& derivatives) const;
  template <typename Number>
  [[gnu::always_inline]] void add_radiant(const Number& temperature, const Number& thin_wall, Number& sum) const {
    const Number T = core::positive_part(temperature);
    sum += radiant_ * thin_wall * T * T * T;
  }

  core::Table phonon_;
  core::Table relative_;  ///< absorption over that which `radiant_` belongs to; empty: 1
  double radiant_ = 0;    ///< W/m/K4
};

/// Specific enthalpy and its derivative, the heat capacity.
struct EnthalpyValue {
  double h;  ///< J/kg
  double c;  ///< J/kg/K
};

/// The integral of a heat capacity table from `content_reference`, prepared for many evaluations; temperatures in K.
class Enthalpy {
 public:
  explicit Enthalpy(const core::Table& heat_capacity);
  EnthalpyValue operator()(double temperature) const;
  void set_enthalpies(const PointValues& temperature, PointValues& values) const;  ///< J/kg
  void set_capacities(const PointValues& temperature, PointValues& values) const;  ///< J/kg/K

 private:
  core::Table capacity_;
  std::vector<double> at_knot_;  ///< J/kg
};

namespace detail {
template <typename Law>
[[gnu::always_inline]] inline void set_each(const PointValues& temperature, const Law& law, PointValues& values) {
  for (int q = 0; q < 6; ++q)
    values[q] =
        VectorizedArray{law(temperature[q][0]), law(temperature[q][1]), law(temperature[q][2]), law(temperature[q][3])};
}
}  // namespace detail

[[gnu::always_inline]] inline void Conductivity::set_values(const PointValues& temperature,
                                                            const PointValues& thin_wall, PointValues& values) const {
  if (phonon_.x.size() == 1)
    for (VectorizedArray& value : values) value = VectorizedArray{} + phonon_.y[0];
  else
    detail::set_each(
        temperature, [this](double T) { return phonon_(T); }, values);
  if (radiant_ == 0) return;
  if (!relative_.x.empty()) return add_varying(temperature, thin_wall, values);
  for (int q = 0; q < 6; ++q) add_radiant(temperature[q], thin_wall[q], values[q]);
}

[[gnu::always_inline]] inline void Conductivity::set_derivatives(const PointValues& temperature,
                                                                 const PointValues& thin_wall,
                                                                 PointValues& derivatives) const {
  if (phonon_.x.size() == 1)
    derivatives = {};
  else
    detail::set_each(
        temperature, [this](double T) { return phonon_.derivative(T); }, derivatives);
  if (radiant_ == 0) return;
  if (!relative_.x.empty()) return add_varying_derivatives(temperature, thin_wall, derivatives);
  for (int q = 0; q < 6; ++q) {
    const VectorizedArray T = core::positive_part(temperature[q]);
    derivatives[q] += 3 * radiant_ * thin_wall[q] * T * T;
  }
}

[[gnu::always_inline]] inline void Enthalpy::set_enthalpies(const PointValues& temperature, PointValues& values) const {
  if (capacity_.x.size() > 1)
    return detail::set_each(
        temperature, [this](double T) { return (*this)(T).h; }, values);
  for (int q = 0; q < 6; ++q) values[q] = at_knot_[0] + capacity_.y[0] * (temperature[q] - capacity_.x[0]);
}

[[gnu::always_inline]] inline void Enthalpy::set_capacities(const PointValues& temperature, PointValues& values) const {
  if (capacity_.x.size() > 1)
    return detail::set_each(
        temperature, [this](double T) { return (*this)(T).c; }, values);
  for (VectorizedArray& value : values) value = VectorizedArray{} + capacity_.y[0];
}

/// Heat flux out of a surface and its derivative.
struct SurfaceFlux {
  double q;      ///< W/m2
  double dq_dT;  ///< W/m2/K
};
/// The flux of SurfaceExchange at a surface temperature, K.
SurfaceFlux surface_flux(const ExchangeCoefficients& exchange, double temperature);

}  // namespace parison::thermal
