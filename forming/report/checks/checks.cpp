// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/checks/checks.hpp"

namespace parison::forming {

Checks checks(const Scene& scene, const State& state, const RunFacts& facts) {
  Checks all;
  if (scene.has_heat()) add_heat_checks(scene, state, facts.diagnostics, all);
  if (scene.has_flow()) add_flow_checks(scene, state, facts, all);
  if (scene.has_heat() && scene.has_flow()) add_hot_glass_check(scene, state, facts.diagnostics.hot_glass, all);
  add_capacity_checks(scene, state, facts, all);
  add_table_check(scene, facts.diagnostics.tables, all);
  return all;
}

std::string verdict_of_run(const Checks& checks, bool completed) {
  return (completed ? "" : "stopped before its end; until then ") + verdict_sentence(checks);
}

void add_checks(core::JsonWriter& json, const Checks& checks, bool completed) {
  json.add("trustworthy", trustworthy(checks));
  json.add("verdict", verdict_of_run(checks, completed));
  json.open_list("checks");
  for (const Check& check : checks) {
    json.open_object("");
    json.add("name", check.name);
    json.add("value", check.value);
    json.add("limit", check.limit);
    json.add("severe_limit", check.severe_limit);
    json.add("unit", check.unit);
    json.add("verdict", name_of(check.verdict()));
    json.add("sentence", check.sentence);
    json.close();
  }
  json.close();
}

}  // namespace parison::forming
