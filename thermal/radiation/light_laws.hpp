#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "thermal/properties.hpp"
#include "thermal/radiation/fresnel.hpp"
#include "thermal/radiation/planck.hpp"

namespace parison::thermal {

/// What the light in a glass does in each band and at its surfaces. The emissive powers are those in the glass of
/// refractive index n, n^2 times those in vacuum; G is the irradiation, the light from all directions, W/m2.
class LightLaws {
 public:
  explicit LightLaws(const Radiation& radiation);

  int band_count() const { return static_cast<int>(bands_.size()); }
  double absorption(int band) const { return bands_[band].absorption; }  ///< 1/m
  /// 4 times the emissive power of a band, W/m2: the irradiation in equilibrium at a temperature, K.
  Emission irradiation(int band, double temperature) const {
    const Emission e = emission_[band](temperature);
    return {4 * square_ * e.value, 4 * square_ * e.derivative};
  }
  /// Emissive power in vacuum beyond the last band; zero where no part of the spectrum is opaque.
  Emission opaque_emission(double temperature) const { return opaque_ ? (*opaque_)(temperature) : Emission{0, 0}; }
  bool has_opaque() const { return opaque_.has_value(); }

  /// Coefficients c of the flux out of the glass, c (G - equilibrium irradiation of what is outside), of P1 with the
  /// moments of the reflectivity: black surroundings behind Fresnel's reflection.
  double to_surroundings() const { return open_; }
  /// A black wall in optical contact, without reflection (Marshak): 1/2.
  static constexpr double to_black_wall() { return 0.5; }
  /// A grey, diffuse tool of this emissivity behind a gap that is wider than a wavelength.
  double to_tool(double emissivity) const;

 private:
  std::vector<Band> bands_;
  std::vector<BandEmission> emission_;
  std::optional<BandEmission> opaque_;
  double square_, open_;
};

/// Exchange factor of opaque bands between two parallel grey surfaces: 1/(1/a + 1/b - 1), zero where either is.
double grey_exchange(double a, double b);

}  // namespace parison::thermal
