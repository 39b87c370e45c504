// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to the server. Addresses are relative: the token of the page is in them.

import { say } from "./dom.js";
import { word } from "./words.js";

let away = false;

export async function ask(question, asked = {}) {
  let response;
  try {
    response = await fetch(`api/${question}`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(asked),
    });
  } catch {
    away = true;
    say(word("serverAway"));
    throw Object.assign(new Error(word("serverAway")), { away });
  }
  if (away) say("");
  away = false;
  const answer = await response.json();
  if (!response.ok) throw Object.assign(new Error(answer.error), { status: response.status });
  return answer;
}

/** Sends what the browser is to bring to the server although the page goes; up to 64 kB. */
export function send(question, asked) {
  fetch(`api/${question}`, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(asked), keepalive: true });
}

/** Asks and shows the sentence of a refusal; nothing then. */
export async function tryAsk(question, asked) {
  try {
    const answer = await ask(question, asked);
    say("");
    return answer;
  } catch (error) {
    say(error.message);
    return null;
  }
}
