#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/json.hpp"
#include "forming/report/checks/check.hpp"
#include "forming/report/summary.hpp"

namespace parison::forming {

/// Every number of a run that is watched, of its parts that the scene has.
Checks checks(const Scene& scene, const State& state, const RunFacts& facts);

/// Those of heat: balance, overshoots, thermal skin, conductance.
void add_heat_checks(const Scene& scene, const State& state, const Diagnostics& seen, Checks& checks);
/// Those of the motion: work, volume, penetration, axis, contacts, steps, inertia, caps.
void add_flow_checks(const Scene& scene, const State& state, const RunFacts& facts, Checks& checks);

/// Those of a container: two ways to one volume from the drawings, and that of the formed glass beside it.
void add_capacity_checks(const Scene& scene, const State& state, const RunFacts& facts, Checks& checks);
/// That of the capacity of the formed glass beside the one drawn, m3.
void add_capacity_check(double capacity, double drawn, Checks& checks);

/// That of a container that has sunk while it cooled, by such a share of its height.
void add_sag_check(double sag, Checks& checks);

/// That of glass hotter than all that can heat it, of a scene with heat and flow.
void add_hot_glass_check(const Scene& scene, const State& state, const HotGlass& hot, Checks& checks);
/// By how much glass was hotter than all that can heat it, when and where; empty where it was so by no more than is
/// told.
std::string hot_glass_text(const Scene& scene, const HotGlass& hottest);

/// That of tables over temperature, where the scene has some.
void add_table_check(const Scene& scene, const std::vector<TablesExcess>& tables, Checks& checks);

/// The list `checks` and the verdict as keys of summary.json.
void add_checks(core::JsonWriter& json, const Checks& checks, bool completed);
/// What the checks say together, of a run that came to its end or did not.
std::string verdict_of_run(const Checks& checks, bool completed);

}  // namespace parison::forming
