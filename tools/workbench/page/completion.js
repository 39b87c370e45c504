// SPDX-License-Identifier: GPL-3.0-or-later
// Completion in the text of the case: what the reader allows in place of a word, asked of it with a probe there.

import { ask } from "./api.js";
import { autocompletion, completionKeymap, keymap } from "./codemirror/codemirror.min.js";
import { model } from "./model.js";

const probe = "probe_of_the_workbench";

/** What closes the brackets that a line has opened, which is an entry of a list where it begins with one. */
function closing(line) {
  let open = "";
  for (const sign of line.replace(/"[^"]*("|$)/g, "")) open = "{[".includes(sign) ? (sign === "{" ? "}" : "]") + open : "}]".includes(sign) ? open.slice(1) : open;
  return open && /^\s*\{/.test(line) ? `${open},` : open;
}

/** The word at a place of a line, a name in quotes, the name of a table or a key, and the rest of the line with the probe in its place, closed where it is not. Null where there is none of them. */
function probed(before, after) {
  const quoted = before.match(/^(?:[^"#]*"[^"]*")*[^"#]*"([\w-]*)$/);
  if (quoted && after.trim() === "") return [quoted[1], `${probe}"${closing(before)}`];
  if (quoted) return /^[\w-]*"/.test(after) ? [quoted[1], after.replace(/^[\w-]*/, probe)] : null;
  const header = before.match(/^\s*(\[\[?)(\w*)$/);
  if (header) return [header[2], probe + (header[1].length === 2 ? "]]" : "]") + after.replace(/^\w*\]*/, "")];
  const key = before.match(/^(?:(?:[^"#]|"[^"]*")*[{,]\s*|\s*)(?:\w+\.)*(\w*)$/);
  if (!key) return null;
  const rest = after.replace(/^\w*/, "") || closing(before);
  return [key[1], probe + (/^\s*[=.]/.test(rest) ? rest : ` = 0${rest}`)];
}

async function allowed(context) {
  const text = context.state.doc.toString(), line = context.state.doc.lineAt(context.pos);
  const found = probed(line.text.slice(0, context.pos - line.from), line.text.slice(context.pos - line.from));
  if (!found || !(found[0] || context.explicit)) return null;
  const [word, after] = found, from = context.pos - word.length;
  const asked = { case: model.name, probe, text: text.slice(0, from) + after + text.slice(line.to) };
  const answer = await ask("allowed", asked).catch(() => null);
  return answer && answer.allowed.length ? { from, options: answer.allowed.map((label) => ({ label })), validFor: /^[\w-]*$/ } : null;
}

export const completion = [autocompletion({ override: [allowed], icons: false }), keymap.of(completionKeymap)];
