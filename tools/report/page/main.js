// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the page from its data; a live one asks the server for more.

const state = { theme: null, film: {}, space: {} };
let shown = null; // charts and players of what is in the page

function applyTheme(theme) {
  document.documentElement.dataset.theme =
    theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
}

function repaint() {
  if (!shown) return;
  shown.charts.redraw();
  shown.players.forEach((player) => player.draw());
}

function headOf(runs, program) {
  const button = element(
    "button",
    {
      class: "theme",
      onclick: () => {
        state.theme = isDark() ? "light" : "dark";
        applyTheme(state.theme);
        show(shown.runs, program);
      },
    },
    isDark() ? "Light" : "Dark",
  );
  return [
    element("div", { class: "top" }, element("h1", {}, runs.map((run) => run.name).join(", ")), button),
    element("p", { class: "soft" }, `${program}, report of ${runs.length === 1 ? "a run" : `${runs.length} runs`}`),
  ];
}

/** Shows a moment in all plots and players but the one in which it was chosen. */
function showMoment(time, from) {
  shown.charts.setTime(time);
  for (const player of shown.players)
    if (player !== from && nearestOf(player.times, time) !== player.state.index) player.showTime(time, true);
}

function stripPart(runs, film) {
  const strips = runs
    .filter((run) => run.film && run.stages.length)
    .flatMap((run) => [runs.length > 1 ? element("h3", {}, run.name) : null, stripOf(run, film, showMoment)]);
  return film && strips.length ? part("stages", "Ends of the stages", ...strips) : null;
}

/** Puts the whole report into the page, with the film where it was. */
function show(runs, program) {
  if (shown) {
    shown.charts.destroy();
    shown.players.forEach((player) => player.play(false));
  }
  const charts = new Charts(runs[0] ? runs[0].stages : [], showMoment);
  const film = runs.some((run) => run.film) ? new FilmPart(runs, state.film, showMoment) : null,
    space = runs.some((run) => run.space) ? new SpacePart(runs, state.space, showMoment, charts) : null;
  shown = { runs, charts, players: [film, space].filter((player) => player) };
  const parts = [
    overviewPart(runs),
    searchPart(state.search, charts),
    stripPart(runs, film),
    ...(space ? space.parts() : []),
    film
      ? part("film", space ? "Film until the parison" : "Film", film.element)
      : part("film", "Film", element("p", { class: "soft" }, "No output has been written yet.")),
    wallPart(runs, charts),
    coldPart(runs, charts),
    machinePart(runs, charts),
    toolsPart(runs, charts),
    productionPart(state.productions, charts),
    balancePart(runs, charts),
    quantityPart(runs),
    differencePart(state.differences),
    checkPart(runs),
    scenePart(runs),
  ].filter((one) => one);
  document.getElementById("head").replaceChildren(...headOf(runs, program));
  document
    .getElementById("places")
    .replaceChildren(
      element("div", {}, ...parts.map((one) => element("a", { href: `#${one.id}` }, one.firstChild.textContent))),
    );
  document.getElementById("main").replaceChildren(...parts);
  charts.start();
  shown.players.forEach((player) => player.show(player.state.index ?? player.last, true));
}

async function take(page) {
  const buffer = await unpacked(page.bytes);
  state.search = page.search || null;
  state.differences = page.differences || null;
  state.productions = (page.productions || []).map((one, i) => new Production(one, buffer, i));
  const runs = page.runs.map((run, i) => new Run(run, buffer, i));
  // Players at their end follow the run; others stay where they are.
  const stays = shown
    ? shown.players.filter((player) => !player.atEnd).map((player) => [player.state, player.time])
    : [];
  for (const one of [state.film, state.space]) if (!stays.some(([of]) => of === one)) one.index = undefined;
  const isFirst = !shown;
  show(runs, page.program);
  if (isFirst) document.getElementById(location.hash.slice(1))?.scrollIntoView(); // the part was not there when the page came
  if (page.mixed_cases) say("warn", page.mixed_cases);
  for (const [of, time] of stays)
    shown.players.filter((one) => one.state === of).forEach((one) => one.showTime(time, true));
}

function say(kind, ...content) {
  let line = document.getElementById("said");
  if (!line) document.getElementById("head").after((line = element("header", { id: "said" })));
  line.replaceChildren(...content.map((text) => element("p", { class: kind }, text)));
}

/** Asks whether something is new, and for the data when it is, until the page is closed. */
async function follow() {
  let stamp = null;
  for (;;) {
    try {
      const now = await (await fetch("stamp", { cache: "no-store" })).json();
      if (now !== stamp && !(shown && shown.players.some((player) => player.isHeld))) {
        const page = await (await fetch("data", { cache: "no-store" })).json();
        if (page) await take(page);
        stamp = now;
        const going = shown && shown.runs.some((run) => run.state === "running");
        if (page && going) say("soft", "live: the page follows the run");
        else if (page) say("soft", "The run has ended; the page follows it where it is resumed or begins anew.");
        else say("warn", "There is no run in this folder yet; the page waits for it.");
      }
    } catch (error) {
      stamp = null;
      say(
        "warn",
        `The page cannot be brought up to date: ${error.message}. It tries again; is \`parison report --live\` still going?`,
      );
    }
    await new Promise((resolve) => setTimeout(resolve, document.hidden ? 5000 : 2000));
  }
}

function printing(on) {
  applyTheme(on ? "light" : state.theme);
  if (!shown) return;
  shown.players.forEach((player) => (player.printing = on));
  for (const one of document.querySelectorAll("details")) {
    if (on) one.dataset.was = one.open ? "open" : "";
    one.open = on || one.dataset.was === "open";
  }
  shown.charts.plots.forEach((plot) =>
    plot.setSize({
      width: on ? 640 : Math.floor(plot.root.parentNode.clientWidth),
      height: on ? Math.min(plot.tall, 330) : plot.tall,
    }),
  );
  repaint();
}

applyTheme(null);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  if (!state.theme) (applyTheme(null), shown && repaint());
});
addEventListener("beforeprint", () => printing(true));
addEventListener("afterprint", () => printing(false));
addEventListener("resize", () => shown && shown.players.forEach((player) => player.draw()));
const given = JSON.parse(document.getElementById("data").textContent);
if (given) take(given).catch((error) => say("bad", `The report cannot be shown: ${error.message}`));
else follow();
