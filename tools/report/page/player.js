// SPDX-License-Identifier: GPL-3.0-or-later
// What shows outputs one after another: a slider, a button that plays them, and the moment that the page shares.

const playStep = 60; // least time of a frame, ms

/** A subclass has `times` of its outputs, `state.index` and `draw`; `timeChanged` tells the page of another moment. */
class Player {
  constructor(state, timeChanged) {
    Object.assign(this, { state, timeChanged });
  }

  /** The slider with its button. */
  scrub() {
    this.slider = element("input", {
      type: "range",
      min: 0,
      max: this.times.length - 1,
      step: 1,
      "aria-label": "time",
      oninput: () => this.show(Number(this.slider.value)),
    });
    this.button = element("button", { onclick: () => this.play(!this.playing) }, "Play");
    return element("div", { class: "scrub" }, this.button, this.slider);
  }

  get last() {
    return this.times.length - 1;
  }
  get time() {
    return this.times[this.state.index];
  }
  /** Whether somebody plays it or holds it by the pointer. */
  get isHeld() {
    return Boolean(this.playing || this.held);
  }
  get atEnd() {
    return this.state.index >= this.last;
  }

  clampIndex() {
    this.state.index = Math.max(0, Math.min(this.last, this.state.index ?? this.last));
    this.slider.max = this.last;
    this.slider.value = this.state.index;
  }

  show(index, quietly = false) {
    this.state.index = Math.max(0, Math.min(this.last, index));
    this.draw();
    if (!quietly) this.timeChanged(this.time, this);
  }

  showTime(time, quietly = false) {
    this.show(nearestOf(this.times, time), quietly);
  }

  play(on) {
    clearTimeout(this.timer);
    this.playing = on;
    this.button.textContent = on ? "Stop" : "Play";
    if (!on) return;
    if (this.atEnd) this.show(0);
    const next = () => {
      const i = this.state.index;
      if (i >= this.last) return this.play(false);
      this.timer = setTimeout(
        () => {
          this.show(i + 1);
          next();
        },
        Math.min(400, Math.max(playStep, 1000 * (this.times[i + 1] - this.times[i]))),
      );
    };
    next();
  }
}

/** Ticks a member of a part's state. */
function tickOf(part, label, key) {
  const box = element("input", {
    type: "checkbox",
    checked: Boolean(part.state[key]),
    onchange: () => {
      part.state[key] = box.checked;
      part.draw();
    },
  });
  return element("label", {}, box, label);
}

/** Chooses a member of a part's state among [value, text]. */
function selectOf(part, label, key, entries) {
  const select = element(
    "select",
    {
      "data-key": key,
      onchange: () => {
        part.state[key] = entries[select.selectedIndex][0];
        part.draw();
      },
    },
    ...entries.map(([value, text]) => element("option", { value, selected: value === part.state[key] }, text)),
  );
  return element("label", {}, label, select);
}

/** A colour scale with its ends. */
const scaleBar = (title, colours, [low, high], text) =>
  element(
    "div",
    {},
    element("small", {}, title),
    element("div", { class: "scale", style: { background: gradient(colours) } }),
    element("div", { class: "ends" }, element("span", {}, text(low)), element("span", {}, text(high))),
  );
