# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of each marked block: a function for each name, of the stored figures alone."""
import math
import sys
import tomllib

from documents import store, verified
from documents.store import ROOT, benchmark

def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|" + "---|" * len(heading)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])

def listed(rows):
    """A line for each row, whose second part may have several lines."""
    return "\n".join(f"* {name}: {text}" for name, text in rows)

def digits(value, count=2):
    """A number with so many significant digits, as people write it."""
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{count - 1}e}"))))
    if -4 <= exponent < 6:
        return f"{value:.{max(0, count - 1 - exponent)}f}"
    mantissa, power = f"{value:.{count - 1}e}".split("e")
    return f"{mantissa}e{int(power)}"

def percent(key, count=2):
    return f"{digits(benchmark(key), count)} %"

# --- README.md, READMEs of tools -----------------------------------------------------------------------------------------

def speed():
    """The jar's CPU time and what it is off by at each preset, from the stored runs of its README."""
    fine, rows = store.run("jar", "fine"), []
    for name in ("draft", "standard"):
        run = store.run("jar", name)
        rows.append([name, digits(run["cpu_seconds"] / run["time_s"]), against_fine("jar", name, bars_module().profile_errors),
                     against_fine("jar", name, bars_module().heat_error)])
    rows.append(["fine (the reference)", digits(fine["cpu_seconds"] / fine["time_s"]), "", ""])
    return table(["accuracy", f"CPU time over the {fine['time_s']:.1f} s of the process", "wall thickness off: mean, largest",
                  "heat into the tools off"], rows)

def bars():
    kinds = ("glass", "heat", "heat, all tools", "thickness", "time", "profile, mean", "profile, largest")
    rows = [["true errors inside their bars", percent("bars.inside")],
            ["bars at most five times the larger of the true error and 0.01 %", percent("bars.narrow_resolved")]]
    rows += [["bars over true errors, root mean square", "; ".join(f"{kind} {digits(benchmark(f'bars.{kind}'))}" for kind in kinds)]]
    return table(["what", "measured"], rows)

def scene_bars():
    found = store.read(store.BARS, "tests/error_bars --store")["kinds"]
    rows = [[line["kind"], str(line["scenes"]), str(line["count"]), f"{100 * line['inside']:.0f}",
             f"{100 * line['left_out']:.0f}", digits(line["width"])] for line in found]
    return table(["kind", "scenes", "counted", "inside, %", "inside by the factor of other scenes, %", "bar over true error, median"], rows)

def noise():
    stored = store.read(store.BENCHMARKS, "tools/bench noise container_noise --save")
    walls = sorted(key.removesuffix(".worst") for key in stored if key.startswith("noise.") and key.endswith(".worst"))
    kinds = list(dict.fromkeys(key.split("/")[1] for key in stored if key.startswith("noise.") and "/" in key))
    rows = [[", ".join(reversed(wall.split(".")[1:])), *(digits(benchmark(wall + of)) for of in ("", ".worst", ".within_bars", *(f"/{kind}" for kind in kinds)))]
            for wall in walls]
    return table(["wall of: scatter in %", "all places", "worst place", "quantities within bars", *kinds], rows)

def asked_accuracies():
    found = store.read(store.ASKED, "tests/asked_accuracies --store")
    rows = [[f"scenes {group}", str(one["scenes"]), ", ".join(f"{target:g}" for target in one["targets"]),
             f"{one['reached']} of {one['count']}", *(f"{ratio:.1f}" for ratio in one["cost"])]
            for group, one in found.items()]
    return table(["which", "scenes", "asked for, %", "reached", "cost, median", "largest"], rows)

def difference_bars():
    found = store.read(store.DIFFERENCE_BARS, "tests/difference_bars --store")
    rows = [[line["kind"], str(line["changes"]), str(line["count"]), f"{100 * line['inside']:.0f}", digits(line["width"]),
             f"{100 * line['real']:.0f}", f"{100 * line['wrong']:.1f}"] for line in found]
    return table(["kind", "changes", "counted", "inside, %", "over the sum of both bars, median", "real, %", "real with the wrong sign, %"], rows)

def costs(path, command, columns=("measured",)):
    """What a test has measured; a block may name its rows by their numbers."""
    def rows(*numbers):
        found = store.read(path, f"tests/{command} --store")
        rows = [[line["what"], *(line[column] for column in columns)] for line in ([found[int(i)] for i in numbers] or found)]
        return listed(rows) if len(columns) == 1 else table(["what", *columns], rows)
    return rows

def preset_orders():
    found = store.read(store.BARS, "tests/error_bars --store")["presets"]
    rows = [[line["scene"]] + [digits(100 * error) for error in line["errors"]] + [digits(line["order"])] for line in found]
    return table(["lengths off, root mean square, %", "draft", "standard", "fine", "order in the edge"], rows)

def parts():
    return f"estimates are off by a factor of {digits(benchmark('parts.usual'))} as a rule, of {digits(benchmark('parts.worst'))} at the most where the change is above 0.5 %."

def model():
    calibration = store.read(store.CALIBRATION, "tools/bench --save")["model_parts"]
    rows = [[part, digits(of["number"]), digits(100 * of["thickness"]), digits(100 * of["heat"])]
            for part, of in calibration["parts"].items()]
    return table([f"part, measured on {calibration['case']}", "its number there", "wall thickness, mean, %", "heat into the tools, %"], rows)

def radiation_models():
    """Cheaper models of radiation against transfer in each scene, how far a case goes beyond all others, and what they cost."""
    scenes = store.read(store.CALIBRATION, "tools/bench models --save")["radiation_models"]["scenes"]
    models = list(scenes[0]["models"])
    worst = lambda found, model: max(max(scene["models"][model][key] for key in ("thickness", "heat")) for scene in found)
    rows = []
    for scene in scenes:
        off = [" / ".join(digits(100 * scene["models"][model][key]) for key in ("thickness", "heat")) for model in models]
        rows.append([f"{scene['case']} of {scene['glass']}", *off, digits(100 * scene["noise"])])
    left_out = [max(worst([scene for scene in scenes if scene["case"] == case], model) / worst([scene for scene in scenes if scene["case"] != case], model)
                    for case in dict.fromkeys(scene["case"] for scene in scenes)) for model in models]
    rows.append(["any case over the worst of the others, at the most", *(digits(ratio) for ratio in left_out), ""])
    rows.append(["the worst of all: the error that counts"] + [digits(100 * worst(scenes, model)) for model in models] + [""])
    mean = [math.exp(sum(math.log(scene["models"][model]["cost"]) for scene in scenes) / len(scenes)) for model in models]
    rows.append(["CPU time over that by `transfer`", *(digits(cost) for cost in mean), ""])
    skin = [max(scene["models"][model]["skin_K"] for scene in scenes) for model in models]
    rows.append(["mean skin at the end of any stage off by up to, K", *(digits(kelvin) for kelvin in skin), ""])
    return table(["wall in the mean / heat into tools, off from `transfer`, %", *(f"`{model}`" for model in models), "noise"], rows)

def bench():
    both = [("CPU time of the jar over its process time", "jar.{}.cpu", "", "1; 8"),
            ("share of flow in it", "jar.{}.flow", " %", ""), ("share of heat", "jar.{}.heat", " %", ""),
            ("share of remeshing and transfer", "remesh.{}.share", " %", "10 %"),
            ("share of the interface in the steps, built and assembled", "interface.{}.share", " %", "3 %"),
            ("flow of a step over one factorisation and solve of its matrix", "flow.{}.step", "", "1.6")]
    rows = [[what] + [digits(benchmark(key.format(accuracy))) + unit for accuracy in ("draft", "standard")] + [wanted]
            for what, key, unit, wanted in both]
    rows.append(["time outside factorisation and back-substitution", "", percent("solver.outside"), "35 %"])
    rows.append(["heat from the glass changed by a new mesh in mid-stage, six containers, at the most",
                 digits(benchmark("remesh_heat.draft.worst")) + " %", digits(benchmark("remesh_heat.standard.worst")) + " %", "0.3 %"])
    rows.append(["start of the program, s", f"{benchmark('start.version'):.3f}", "", "0.05"])
    rows.append(["growth of the flow's CPU time with the mesh, exponent, 2.5 k to 40 k triangles", digits(benchmark("growth.flow")),
                 "", "1.3"])
    rows.append(["peak memory with 10 k triangles, MB; of which the program and its libraries",
                 f"{benchmark('memory.peak'):.0f}; {benchmark('memory.program'):.0f}", "", "300"])
    return table(["what", "draft", "standard", "wanted"], rows)

# --- tests/README.md ----------------------------------------------------------------------------------------------------

def calculix():
    return f"CalculiX 2.20 takes {benchmark('calculix.ratio'):.0f} times the CPU time in steps of 0.002 s, {benchmark('calculix.own_control'):.0f} times by its own step control."

def verification():
    return listed(verified.rows(digits)) + "\n\n" + verified.left_out()

def expected():
    """Case, label, stored value and bounds of each expectation of the bundled cases."""
    sys.path.insert(0, str(ROOT / "tools"))
    import expect

    for case in store.RUNS:
        found = store.run(case, "draft" if "draft" in store.RUNS[case] else next(iter(store.RUNS[case])))["expectations"]
        for entry in tomllib.loads((ROOT / "cases" / case / "expect.toml").read_text())["expect"]:
            for label, _, bounds in expect.expectations(entry):
                if label not in found:
                    raise store.Missing(f"cases/{case}/figures.json has no \"{label}\": tools/readme_figures --run {case}.draft")
                yield case, label, found[label], bounds, expect.allowed(*bounds)

def allowed_of(values):
    """Of one value its bounds; of several times of a column their middles and what they may be off by."""
    if len(values) > 1 and all(map(math.isfinite, (bound for _, bounds, _ in values for bound in bounds))):
        return ", ".join(f"{(low + high) / 2:.6g}" for _, (low, high), _ in values) + f" ± {(values[0][1][1] - values[0][1][0]) / 2:.3g}"
    allowed = "; ".join(dict.fromkeys(text for _, _, text in values))
    for text, sign in verified.SIGNS.items():
        allowed = allowed.replace(f"{text} ", sign)
    return allowed

BALANCES = ("volume_drift", "max_volume_drift", "energy_imbalance", "max_work_imbalance", "max_penetration_mm", "solid.largest_volume_error",
            "solid.heat_imbalance")

def expectations():
    """A row for each case, a line for each expectation; a column at several times is one line. Of balances that nearest to its limit."""
    grouped, balances = {}, []
    for case, label, found, bounds, allowed in expected():
        if label in BALANCES:
            balances.append((found / bounds[1], f"`{label}` of {case}: {digits(found)} ({allowed})"))
            continue
        column, _, time = label.partition(" at ")
        grouped.setdefault(case, {}).setdefault(column, []).append((time.removesuffix(" s"), (found, bounds, allowed)))
    rows = []
    for case, columns in grouped.items():
        lines = []
        for column, values in columns.items():
            times = ", ".join(time for time, _ in values if time)
            measured = ", ".join(digits(found, 4) for _, (found, _, _) in values)
            lines.append(f"`{column}`" + (f" at {times} s" if times else "") + f": **{measured}** ({allowed_of([of for _, of in values])})")
        rows.append([case, "<br>".join(lines)])
    return listed(rows) + f"\n\nOf {len(balances)} balances, drifts and penetrations the nearest to its limit is {max(balances)[1]}."

def outside():
    """A sentence for each stored figure of the bundled cases and of the verification that stands outside its own limit."""
    for case, label, found, (low, high), allowed in expected():
        if not low <= found <= high:
            yield f"cases/{case}/figures.json: {label} is {found:g}, allowed is {allowed}; tools/readme_figures --run {case} stores it anew"
    for figure in store.verification():
        bound, value = figure["bound"], figure["measured"]
        if bound is not None and (value > bound if figure["sense"] == "at most" else value < bound):
            yield f"tests/figures.json: {figure['what']} is {value:g}, required is {figure['sense']} {bound:g}; tools/verification_table stores it anew"

# --- cases/*/README.md --------------------------------------------------------------------------------------------------

def stages(case, name):
    rows = [[end["name"], f"{end['end_s']:.3f}", f"{end['glass_mean_degC']:.0f}", f"{1e-3 * end['heat_to_tools_J']:.1f}"]
            for end in store.run(case, name)["stages"]]
    return table(["end of", "time, s", "mean of the glass, degC", "heat to tools, kJ"], rows)

def tools(case, name):
    rows = [[tool.replace("_", " "), f"{1e-3 * of['heat_received_J']:.1f}", f"{of['surface_temperature_max_degC']:.0f}"]
            for tool, of in store.run(case, name)["tools"].items()]
    return table(["tool", "heat received, kJ", "hottest contact surface, degC"], rows)

def in_space(case, *names):
    """The container of runs in space, a line each."""
    lines = []
    for name in names:
        run = store.run(case, name)
        solid = run["solid"]
        thinnest = solid["thinnest"]
        lines.append(f"{name.capitalize()}: wall {solid['mean_thickness_mm']:.2f} mm in the mean, thinnest {thinnest['thickness_mm']:.2f} mm at (x, y, z) = "
                     f"({thinnest['x_mm']:.0f}, {thinnest['y_mm']:.0f}, {thinnest['z_mm']:.0f}) mm; capacity {solid['capacity_ml']:.1f} ml; "
                     f"{100 * solid['outer_within_0.2mm_of_tools']:.0f} % of the outer side within 0.2 mm of the mould; "
                     f"{solid['cells']} cells, {solid['steps']} steps in space, {digits(run['cpu_seconds'])} s of CPU on one thread.")
    return "\n".join(lines)

def wall(case, *names):
    """Wall, glass, balances and cost of several runs side by side; shared machines scatter."""
    runs = [store.run(case, name) for name in names]
    rows = [["wall: thinnest, mean, thickest, mm"] + [", ".join(f"{r['thickness'][k]:.2f}" for k in ("min_mm", "mean_mm", "max_mm"))
                                                      for r in runs],
            ["glass at the end: mean, coldest, hottest, degC"] +
            [", ".join(f"{r['glass'][f'temperature_{k}_degC']:.0f}" for k in ("mean", "min", "max")) for r in runs],
            *(against_fine_rows(case, names) if "fine" in store.RUNS[case] else []),
            ["work balance, largest imbalance"] + [f"{digits(100 * r['max_work_imbalance'])} %" for r in runs],
            ["steps; remeshes; CPU, s, one thread"] + [f"{r['steps']}; {r['remeshes']}; {digits(r['cpu_seconds'])}" for r in runs]]
    return table([""] + list(names), rows)

def against_fine_rows(case, names):
    return [["wall against fine: mean, largest difference"] + [against_fine(case, name, bars_module().profile_errors) for name in names],
            ["heat into tools against fine"] + [against_fine(case, name, bars_module().heat_error) for name in names]]

def bands(case, *names):
    """Mean wall in six parts of the outer side, from the rim to the middle of the bottom."""
    parts, rows = 6, []
    for name in names:
        profile = store.run(case, name)["thickness_profile_mm"]
        row = []
        for i in range(parts):
            values = [t for t in profile[i * len(profile) // parts:(i + 1) * len(profile) // parts] if t is not None]
            row.append(f"{sum(values) / len(values):.2f}" if values else "")
        rows.append([MODELS.get(name.removeprefix("light_"), name), *row])
    return table(["wall, mm, in sixths of the outer side from the rim on"] + [str(i + 1) for i in range(parts)], rows)

def bars_module():
    """The comparison of two results that tools/bench makes."""
    sys.path.insert(0, str(ROOT / "tools"))
    from benchmarks import bars as module

    return module

def against_fine(case, name, error):
    if name == "fine":
        return ""
    found = error(store.run(case, name), store.run(case, "fine"))
    return ", ".join(f"{digits(100 * each)} %" for each in (found if isinstance(found, tuple) else (found,)))

def dwell(case):
    """Heat out of the glass in the blank of the jar by the load that the plunger keeps in the dwell."""
    rows = []
    for load, name in (("8 kN", "dwell_8kN"), ("500 N", "dwell_500N"), ("150 N (the case)", "draft")):
        (end,) = [s for s in store.run(case, name)["stages"] if s["name"] == "dwell"]
        rows.append([load, f"{1e-3 * (end['heat_to_tools_J'] + end['heat_to_air_J']):.1f} kJ"])
    return table(["load in the dwell", "heat out of the glass by its end"], rows)

MODELS = {"enclosure": "the case", "transfer": "transfer", "p1": "P1 in bands", "none": "none: opaque",
          "rosseland": "Rosseland"}

def heat_of(run, kind):
    return 1e-3 * sum(tool.get(kind, 0) for tool in run["tools"].values())

def radiation(case):
    """What the model of radiation changes at draft: wall, heat of the tools, mean skin at the ends of stages, CPU time."""
    rows = []
    for model, label in MODELS.items():
        run = store.run(case, f"light_{model}")
        off = "" if model == "enclosure" else against(run, store.run(case, "light_enclosure"))
        received, radiated, seen = (heat_of(run, kind) for kind in ("heat_received_J", "heat_radiated_J", "heat_from_enclosure_J"))
        skins = ", ".join(f"{stage['name']} {stage['skin_mean_degC']:.0f}" for stage in run["stages"]
                          if "skin_mean_degC" in stage and stage["name"] in ("press", "dwell", "reheat"))
        rows.append([label, f"{run['thickness']['min_mm']:.2f}, {run['thickness']['mean_mm']:.2f}", off, f"{received - radiated:.1f}",
                     f"{radiated:.1f}" if radiated else "", f"{seen:.1f}" if seen else "", skins, digits(run["cpu_seconds"])])
    return table(["radiation", "wall: least, mean, mm", "wall off: mean, largest", "conducted into tools, kJ", "light into them, kJ",
                  "light to their open surfaces, kJ", "mean skin at the end of, degC", "CPU, s"], rows)

def against(run, reference):
    """Wall against that of another run, over the mean wall: mean and largest difference along the outer side."""
    pairs = [(a, b) for a, b in zip(run["thickness_profile_mm"], reference["thickness_profile_mm"]) if a is not None and b is not None]
    mean = sum(b for _, b in pairs) / len(pairs)
    off = [abs(a - b) / mean for a, b in pairs]
    return f"{digits(100 * sum(off) / len(off))} %, {digits(100 * max(off))} %"

def blank_end(case, name):
    (end,) = [stage for stage in store.run(case, name)["stages"] if stage["name"] == "dwell"]
    return end

def blank_slopes(case):
    """Heat out of the glass in the blank, and its mean at the end of the dwell over gob and tool temperature, by differences of 5 K."""
    rows = []
    for model in store.SLOPE_MODELS:
        end = blank_end(case, f"light_{model}")
        slopes = [f"{(blank_end(case, f'slope_{model}{warmer}')['glass_mean_degC'] - end['glass_mean_degC']) / 5:.2f}"
                  for warmer in ("_gob", "_tools")]
        rows.append([MODELS[model], f"{1e-3 * (end['heat_to_tools_J'] + end['heat_to_air_J']):.1f}",
                     f"{end['glass_mean_degC']:.0f}", *slopes])
    return table(["radiation", "heat out of the glass by the end of the dwell, kJ", "mean of the glass then, degC",
                  "K of it per K of the gob", "per K of the blank side's tools"], rows)

def press(case, *names):
    """Where and when the plunger of the tumbler comes to rest, and the heat of each tool."""
    runs = [store.run(case, name) for name in names]
    ends = [[stage for stage in run["stages"] if stage["name"] == "press"][0] for run in runs]
    rows = [["plunger rests at, s; tip at, mm"] + [f"{end['end_s']:.4f}; {end['positions_mm']['plunger']:.3f}" for end in ends]]
    rows += [[f"heat into {tool}, kJ"] + [f"{1e-3 * r['tools'][tool]['heat_received_J']:.2f}" for r in runs] for tool in runs[0]["tools"]]
    return table([""] + list(names), rows)

def by_run(names, what, unit, value):
    return f"{what}: " + ", ".join(f"{value(name)} at {name}" for name in names) + f" ({unit})."

def laps(case, *names):
    return by_run(names, "Air closed in laps", "mm3", lambda name: digits(1e9 * store.run(case, name)["remeshing"]["lap_volume_m3"]))

def sagging(case, *names):
    return by_run(names, "Lowest point after a minute", "z in mm", lambda name: f"{store.run(case, name)['quantities']['extent_z_min']['value']:.2f}")

def shell(case, *names):
    runs = [store.run(case, name) for name in names]
    rows = [["wall: thinnest, thickest, mm"] + [f"{r['thickness']['min_mm']:.4f}, {r['thickness']['max_mm']:.4f}" for r in runs],
            ["volume drift, at the end and at the most"] +
            [f"{digits(abs(r['volume_drift']), 1)}, {digits(r['max_volume_drift'], 1)}" for r in runs]]
    return table([""] + list(names), rows)

BLOCKS = {function.__name__: function for function in (speed, bars, scene_bars, noise, asked_accuracies, difference_bars, preset_orders, parts, model, radiation_models, bench, calculix, verification, expectations)}
BLOCKS |= {"difference_costs": costs(store.DIFFERENCE_COSTS, "difference_costs"), "production_costs": costs(store.PRODUCTION_COSTS, "production_costs"),
           "sweep_costs": costs(store.SWEEP_COSTS, "sweep_costs", ("wanted", "measured")), "slurm_costs": costs(store.SLURM_COSTS, "slurm_costs")}
CASE_BLOCKS = {function.__name__: function for function in (stages, tools, in_space, wall, dwell, radiation, blank_slopes, press, laps, sagging, shell, bands)}
