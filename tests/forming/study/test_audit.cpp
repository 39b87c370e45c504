// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "../scene_text.hpp"
#include "forming/study/audit.hpp"

namespace parison::forming {
namespace {

/// A plate of glass, 4 mm thick, that sags on a ring; the scene names neither tension nor radiation.
const std::string plate_on_ring = R"(case = "sag"
geometry = "axisymmetric"
air = { temperature = "800 degC", h = "20 W/m2/K", ambient = "800 degC" }
interface = [{ tools = ["rim"], law = "constant", h = "500 W/m2/K" }]
stage = [{ name = "sag", duration = "5 s", gravity = "-9.81 m/s2", tools = ["rim"] }]
)" + container_glass("1.3 W/m/K") +
                                  iron + R"([glass]
material = "glass"
temperature = "800 degC"
boundary = [{ name = "bottom", path = "(0, 0) (40, 0) mm", condition = "contact" },
            { name = "surface", path = "(40, 4) (0, 4) mm", condition = "contact" },
            { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "rim"
material = "iron"
temperature = "700 degC"
friction = "stick"
boundary = [{ name = "top", path = "(60, 0) (35, 0) (35, -20) mm", condition = "contact" },
            { name = "rest", path = "(60, -20) (60, 0) mm", condition = "insulated" }]
)";

struct Audited {
  std::vector<AuditRun> runs;
  const AuditRun& named(const std::string& name) const {
    return *std::find_if(runs.begin(), runs.end(), [&](const AuditRun& run) { return run.variant.name == name; });
  }
  AuditChange change(const std::string& name) const { return audit_change(named(name), runs.front()); }
};

Audited audited(const std::string& text) {
  const std::string folder = write_scene(text);
  Audited audited;
  for (const Variant& variant : audit_variants(read_scene(folder, "draft coarser 2")))
    audited.runs.push_back(audit_run(folder, variant, {}));
  return audited;
}

TEST(Audit, gravity_makes_the_sag_of_a_plate_and_nothing_else_matters_as_much) {
  const Audited sag = audited(plate_on_ring);
  for (const AuditRun& run : sag.runs) EXPECT_TRUE(run.completed) << run.variant.name << run.reason;
  const double gravity = sag.change("no_gravity").shape;
  EXPECT_GT(gravity, 0.3 * sag.runs.front().wall);
  for (const char* name : {"with_tension", "with_radiation", "fixed_tools", "no_air_cooling"})
    EXPECT_LT(sag.change(name).shape, 0.1 * gravity) << name;
}

TEST(Audit, a_change_that_means_nothing_shows_the_noise) {
  const Audited sag = audited(plate_on_ring);
  EXPECT_TRUE(is_noise(sag.named("warmer").variant) && is_noise(sag.named("colder").variant));
  EXPECT_FALSE(is_noise(sag.named("no_gravity").variant));
  EXPECT_GT(sag.change("warmer").shape, 0);
  EXPECT_LT(sag.change("warmer").shape, 1e-3 * sag.change("no_gravity").shape);
  EXPECT_LT(audit_change(sag.runs.front(), sag.runs.front()).shape, 1e-15);
}

TEST(Audit, trapped_air_is_a_part_that_is_taken_out_where_the_case_has_it_and_added_where_not) {
  const auto names = [](const Scene& scene) {
    std::vector<std::string> found;
    for (const Variant& variant : audit_variants(scene)) {
      EXPECT_NO_THROW(read_scene(scene.file, "draft", variant.overrides)) << variant.name;
      found.push_back(variant.name);
    }
    return found;
  };
  const auto has = [](const std::vector<std::string>& all, const char* name) {
    return std::count(all.begin(), all.end(), name) == 1;
  };
  EXPECT_TRUE(has(names(scene_of(plate_on_ring)), "with_trapped_air"));
  const std::string air = "trapped_air = { law = \"adiabatic\", temperature = \"500 degC\" }\n";
  EXPECT_TRUE(has(names(scene_of(air + plate_on_ring)), "no_trapped_air"));
}

}  // namespace
}  // namespace parison::forming
