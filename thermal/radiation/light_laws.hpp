#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "thermal/properties.hpp"
#include "thermal/radiation/fresnel.hpp"
#include "thermal/radiation/planck.hpp"

namespace parison::thermal {

/// A cone of directions: those whose angle to the normal of the nearest surface has a cosine, without sign, from
/// `from` to `to`.
struct Cone {
  double from, to;

  double share() const { return to - from; }                                 ///< of all directions
  double first() const { return (to * to - from * from) / 2; }               ///< int mu dmu
  double second() const { return (to * to * to - from * from * from) / 3; }  ///< int mu^2 dmu
};

/// Light of one band in one cone of directions.
struct LightGroup {
  int band;
  double absorption;  ///< kappa, 1/m
  double share;       ///< of all directions
  double diffusion;   ///< mean of mu^2 over the cone, over kappa, m; of all directions 1/(3 kappa); unused by rays
  double open;        ///< c of the flux out of the glass behind Fresnel's reflection; 0 where all is reflected
  double black;       ///< of that to a black wall in optical contact, without reflection (Marshak)
};

/// What the light in a glass does in each group and at its surfaces. The flux out of the surface is c (G - equilibrium
/// irradiation of what is outside), with the irradiation G, the light from all directions of the cone, W/m2.
class LightLaws {
 public:
  explicit LightLaws(const Radiation& radiation);

  int group_count() const { return static_cast<int>(groups_.size()); }
  const LightGroup& group(int g) const { return groups_[g]; }
  /// Irradiation of a group in equilibrium at a temperature, K: its share of 4 n^2 times the emissive power of the
  /// band in vacuum, W/m2.
  Emission irradiation(int g, double temperature) const {
    const Emission e = emission_[groups_[g].band](temperature);
    const double scale = 4 * square_ * groups_[g].share;
    return {scale * e.value, scale * e.derivative};
  }
  /// Emissive power of a black body in vacuum in the band of a group, W/m2.
  Emission emissive_power(int g, double temperature) const { return emission_[groups_[g].band](temperature); }
  /// Emissive power in vacuum beyond the last band; zero where no part of the spectrum is opaque.
  Emission opaque_emission(double temperature) const { return opaque_ ? (*opaque_)(temperature) : Emission{0, 0}; }
  bool has_opaque() const { return opaque_.has_value(); }
  /// Coefficient of the flux to a grey, diffuse tool of this emissivity behind a gap that is wider than a wavelength.
  double to_tool(int g, double emissivity) const;

 private:
  std::vector<LightGroup> groups_;
  std::vector<BandEmission> emission_;  ///< by band
  std::optional<BandEmission> opaque_;
  double square_;
  bool rays_;
};

/// Exchange factor of opaque bands between two parallel grey surfaces: 1/(1/a + 1/b - 1), zero where either is.
double grey_exchange(double a, double b);

}  // namespace parison::thermal
