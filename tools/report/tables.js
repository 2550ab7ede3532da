// The page below the views: figures, warnings, history.

function cell(name, text, className = "") {
  const result = document.createElement(name);
  result.textContent = text;
  if (className) result.className = className;
  return result;
}

function table(headings, rows, classes) {
  const result = document.createElement("table");
  const head = result.createTHead().insertRow();
  headings.forEach((text, i) => {
    const heading = cell("th", text, classes[i]);
    heading.scope = "col";
    head.append(heading);
  });
  const body = result.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    row.forEach((value, i) => line.append(value instanceof Node ? value : cell("td", value, classes[i])));
  }
  return result;
}

function note(text) {
  return cell("p", text, "note");
}

export function show_figures(place, facts) {
  if (facts.figures.length === 0) {
    place.append(note("There are no figures: measure.json is missing or cannot be read."));
    return;
  }
  const rows = facts.figures.map(({ meaning, value }) => [meaning, value === "-" ? "–" : value]);
  place.append(table(["Figure", "Value"], rows, ["", "number"]));
}

export function show_findings(place, findings) {
  if (findings.length === 0) {
    place.append(note("None."));
    return;
  }
  const list = document.createElement("ul");
  for (const finding of findings) {
    const item = document.createElement("li");
    item.className = finding.weight;
    item.append(cell("strong", finding.weight), cell("span", finding.stage, "tool"), cell("span", finding.text));
    list.append(item);
  }
  place.append(list);
}

function arguments_text(given) {
  const words = Object.entries(given).map(([option, value]) => {
    const name = (option.length === 1 ? "-" : "--") + option;
    return value === true ? name : `${name} ${Array.isArray(value) ? value.join(" ") : value}`;
  });
  return words.join(" ") || "–";
}

export function show_history(place, history) {
  if (history.length === 0) {
    place.append(note("There is no history."));
    return;
  }
  const number = (value, digits) => (value === null ? "–" : value.toFixed(digits));
  const rows = history.map((entry) => {
    const inputs = cell("td", "");
    const words = entry.inputs.map(({ schema, sha256 }) => {
      const word = cell("code", `${(schema ?? "").replace("partwise/", "")} ${(sha256 ?? "").slice(0, 8)}`);
      word.title = `SHA-256 ${sha256}`;
      return word;
    });
    words.forEach((word, i) => inputs.append(...(i > 0 ? [" "] : []), word));
    return [
      entry.tool, entry.side || "pair", entry.version, arguments_text(entry.arguments), inputs,
      number(entry.seconds, 2), number(entry.peak_memory_mb, 0),
    ];
  });
  const headings = ["Tool", "Of", "Version", "Options given", "Made from", "Time in s", "Memory in MB"];
  place.append(table(headings, rows, ["tool", "", "number", "", "", "number", "number"]));
  if (history.every(({ seconds }) => seconds === null)) {
    place.append(note("No timings: tools write them when they run with --profile, such as " +
      "RELOCATE_FLAGS=--profile for make. Without, equal inputs give equal bytes."));
  }
}
