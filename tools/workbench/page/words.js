// SPDX-License-Identifier: GPL-3.0-or-later
// All words of the page, by language; another language is another column.

const table = {
  //            English, German
  title: ["Parison workbench", "Parison Werkbank"],
  start: ["All cases", "Alle Fälle"],
  undo: ["Undo", "Rückgängig"],
  redo: ["Redo", "Wiederholen"],
  dark: ["Dark", "Dunkel"],
  light: ["Light", "Hell"],
  language: ["Deutsch", "English"],
  newCase: ["New container", "Neuer Behälter"],
  newHint: [
    "Writes gob, blank, plunger and mould of ordinary proportions that run; then change what you like.",
    "Schreibt Tropfen, Vorform, Pegel und Fertigform üblicher Verhältnisse, die laufen; dann ändern, was gefällt.",
  ],
  process: ["Process", "Verfahren"],
  nnpb: ["narrow-neck press and blow", "Enghals-Press-Blas"],
  press_and_blow: ["press and blow", "Press-Blas"],
  weight: ["Weight", "Gewicht"],
  capacityToRim: ["Capacity to the rim", "Randvollvolumen"],
  height: ["Height", "Höhe"],
  finish: ["Finish (outer diameter)", "Mündung (Außendurchmesser)"],
  name: ["Name", "Name"],
  create: ["Create", "Anlegen"],
  copy: ["Copy and open", "Kopieren und öffnen"],
  look: ["Look", "Ansehen"],
  copyName: ["Name of the copy", "Name der Kopie"],
  bundled: ["Bundled cases", "Mitgelieferte Fälle"],
  yourCases: ["Cases in this folder, newest first", "Fälle in diesem Ordner, neueste zuerst"],
  yourResults: ["Results", "Ergebnisse"],
  none: ["none yet", "noch keine"],
  bundledHint: ["A bundled case: copy it to change it.", "Ein mitgelieferter Fall: zum Ändern kopieren."],
  section: ["Section", "Schnitt"],
  values: ["Values", "Werte"],
  text: ["Case file", "Falldatei"],
  run: ["Run", "Rechnung"],
  result: ["Result", "Ergebnis"],
  closer: ["Closer", "Näher"],
  farther: ["Farther", "Weiter"],
  whole: ["Whole", "Ganz"],
  corners: ["Corners", "Ecken"],
  turned: ["As it stands", "Wie es steht"],
  glassWeight: ["Weight", "Gewicht"],
  stop: ["Stop of the plunger", "Anschlag des Pegels"],
  cavity: ["Press cavity", "Pressvolumen"],
  capacity: ["Capacity to the rim", "Randvollvolumen"],
  filled: ["To the fill level", "Bis zur Füllhöhe"],
  ullage: ["Ullage", "Leerraum"],
  clearance: ["Clearance at the base", "Abstand am Boden"],
  overlap: ["Parison stands in the mould by", "Külbel ragt in die Form um"],
  clearanceTitle: ["Clearance of parison and mould, up to", "Abstand Külbel – Fertigform, bis"],
  noFindings: ["Nothing unusual.", "Nichts Ungewöhnliches."],
  findings: ["Unusual, no error: is it meant?", "Ungewöhnlich, kein Fehler: ist das gewollt?"],
  cannotBegin: ["The first stage cannot begin", "Die erste Stufe kann nicht beginnen"],
  line: ["line", "Zeile"],
  checking: ["checking …", "wird geprüft …"],
  sketch: ["Sketch", "Skizze"],
  sketchFollows: ["Sketch after each change", "Skizze nach jeder Änderung"],
  sketchRuns: ["sketch is computed …", "Skizze wird gerechnet …"],
  sketchOld: ["sketch of an earlier version", "Skizze eines früheren Stands"],
  sketchThere: [
    "sketch: thinnest wall about {0} mm, mean {1} mm; not for contact peaks and thinnest places",
    "Skizze: dünnste Wand etwa {0} mm, Mittel {1} mm; nicht für Kontaktspitzen und dünnste Stellen",
  ],
  sketchFailed: ["the sketch has no result: {0}", "die Skizze hat kein Ergebnis: {0}"],
  dimensions: ["Dimensions", "Maße"],
  glass: ["Glass and gob", "Glas und Tropfen"],
  stage: ["Stage", "Stufe"],
  tool: ["Tool", "Werkzeug"],
  interface: ["Contact", "Kontakt"],
  probe: ["Probe", "Messstelle"],
  air: ["Air", "Luft"],
  others: ["More", "Weiteres"],
  brokenText: ["The file cannot be read as it is; mend it in the text.", "Die Datei ist so nicht lesbar; im Text beheben."],
  accuracy: ["Accuracy", "Genauigkeit"],
  sketchAccuracy: ["sketch (draft coarser 2)", "Skizze (draft coarser 2)"],
  draft: ["draft", "Entwurf (draft)"],
  standard: ["standard", "Standard (standard)"],
  fine: ["fine", "fein (fine)"],
  startRun: ["Start", "Start"],
  stopRun: ["Stop", "Anhalten"],
  resumeRun: ["Resume", "Fortsetzen"],
  openResult: ["Look at the result", "Ergebnis ansehen"],
  time: ["{0} s of at most {1} s, stage {2}", "{0} s von höchstens {1} s, Stufe {2}"],
  state_running: ["running", "läuft"],
  state_completed: ["completed", "fertig"],
  state_stopped: ["stopped", "angehalten"],
  state_failed: ["failed", "gescheitert"],
  state_ended: ["ended", "beendet"],
  noRun: ["No run has been started here yet.", "Hier wurde noch nichts gerechnet."],
  noResult: ["No result is chosen.", "Kein Ergebnis gewählt."],
  serverAway: [
    "The server does not answer; start `parison workbench` again and open the address that it prints. What was saved is in the file.",
    "Der Server antwortet nicht; `parison workbench` neu starten und die genannte Adresse öffnen. Gespeichertes steht in der Datei.",
  ],
  conflict: [
    "Another program has changed the file while you typed. Which text is to stay?",
    "Ein anderes Programm hat die Datei während des Tippens geändert. Welcher Text soll bleiben?",
  ],
  theirs: ["The file", "Die Datei"],
  mine: ["Yours", "Ihr Text"],
  keepTheirs: ["Keep the file", "Datei behalten"],
  keepMine: ["Write yours", "Ihren Text schreiben"],
  handleHint: [
    "Drag, or use the arrow keys (Shift: finer)",
    "Ziehen oder Pfeiltasten (Umschalt: feiner)",
  ],
};

const languages = ["en", "de"];
let language = 0;

export function setLanguage(name) {
  language = Math.max(0, languages.indexOf(name));
  document.documentElement.lang = languages[language];
}
export const languageName = () => languages[language];
export const otherLanguage = () => languages[1 - language];

/** The word of the language in use; {0}, {1} ... are what follows. */
export function word(name, ...parts) {
  return (table[name] ? table[name][language] : name).replace(/\{(\d)\}/g, (_, i) => parts[i]);
}
