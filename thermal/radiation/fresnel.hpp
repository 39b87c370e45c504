#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::thermal {

/// Reflectivity of a smooth surface for unpolarised light that meets it from inside, from the side of refractive index
/// n against 1, at the cosine mu of the angle to the normal (Fresnel's equations with Snell's law; M. F. Modest,
/// *Radiative Heat Transfer*, 3rd ed. 2013, chapter 2): 1 beyond the critical angle.
double fresnel_reflectivity(double n, double mu);

/// Cosine of the critical angle, below which all light is reflected: sqrt(1 - 1/n^2).
double critical_cosine(double n);

/// Moments of that reflectivity over the cosines from one to another, by default over the whole hemisphere inside.
struct ReflectivityMoments {
  double first;   ///< int mu R dmu; of the hemisphere twice that is the share of diffuse light that is reflected
  double second;  ///< int mu^2 R dmu
};
ReflectivityMoments reflectivity_moments(double n, double from = 0, double to = 1);

/// Hemispherical emissivity of an opaque body of index n in air: 1 less what the surface reflects of diffuse light from
/// outside, n^2 (1 - 2 first) by reciprocity.
double surface_emissivity(double n);

}  // namespace parison::thermal
