// The page of a batch: a line per pair.
import { facts } from "./arrays.js";
import { Surface } from "./surface.js";
import { theme_button } from "./theme.js";
import { Thumbnails } from "./thumbnails.js";

const by_id = (id) => document.getElementById(id);
const order = ["failed", "warnings", "done"];
const width = 96;
const height = 66;

// The main figures, those that any pair has.
const columns = [];
for (const row of facts.rows) {
  for (const { heading, meaning, pointer } of row.figures) {
    if (heading && !columns.some((column) => column.pointer === pointer)) columns.push({ heading, meaning, pointer });
  }
}

const value_of = (row, pointer) => row.figures.find((figure) => figure.pointer === pointer)?.value ?? "-";

/** What a row is sorted by: numbers as numbers, missing ones last. */
function key_of(row, column) {
  if (column === "name") return row.name;
  if (column === "verdict") return order.indexOf(row.verdict);
  const text = value_of(row, column);
  return text === "-" ? Infinity : Number.isNaN(Number(text)) ? text : Number(text);
}

function cell(name, text, className = "") {
  return Object.assign(document.createElement(name), { textContent: text, className });
}

let thumbnails = null;

function pictures(row) {
  const place = cell("td", "", "pictures");
  for (const name of ["source", "compatible", "target"]) {
    if (!row.surfaces?.[name]) continue;
    const picture = new Image(width, height);
    picture.alt = `${row.name}: ${name === "compatible" ? "compatible mesh" : name}`;
    picture.dataset.surface = name;
    place.append(picture);
  }
  return place;
}

// Pictures are drawn after the table is there, a few at a time.
function draw_pictures(waiting) {
  const next = waiting.shift();
  if (!next) return;
  thumbnails ??= new Thumbnails(width, height);
  const { row, picture } = next;
  const surface = new Surface(row.surfaces[picture.dataset.surface], row.parts);
  surface.paint("parts");
  picture.src = thumbnails.draw(surface);
  setTimeout(() => draw_pictures(waiting));
}

function line_of(row) {
  const line = document.createElement("tr");
  line.className = row.verdict;
  const name = cell("th", row.link ? "" : row.name);
  name.scope = "row";
  if (row.link) name.append(Object.assign(cell("a", row.name), { href: row.link }));
  const verdict = cell("td", "", "verdict");
  verdict.append(cell("strong", row.verdict));
  const grave = row.findings.filter(({ weight }) => weight !== "note");
  if (grave.length > 0) {
    const text = `${grave[0].stage ? grave[0].stage + ": " : ""}${grave[0].text}`;
    verdict.append(cell("span", text + (grave.length > 1 ? ` (and ${grave.length - 1} more)` : "")));
  }
  line.append(name, pictures(row), verdict);
  for (const { pointer } of columns) {
    const value = value_of(row, pointer);
    line.append(cell("td", value === "-" ? "–" : value, "number"));
  }
  return line;
}

const lines = new Map(facts.rows.map((row) => [row, line_of(row)]));
const body = document.createElement("tbody");
let sorted_by = "verdict";
let ascending = true;

function refresh() {
  const wanted = by_id("filter").value.trim().toLowerCase();
  const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
  const rows = [...lines.keys()].sort((a, b) => {
    const [x, y] = [key_of(a, sorted_by), key_of(b, sorted_by)];
    // Pairs without the figure come last, whichever way.
    if ((x === Infinity) !== (y === Infinity)) return x === Infinity ? 1 : -1;
    return (ascending ? compare(x, y) : compare(y, x)) || compare(a.name, b.name);
  });
  for (const row of rows) lines.get(row).hidden = wanted !== "" && !lines.get(row).textContent.toLowerCase().includes(wanted);
  body.replaceChildren(...rows.map((row) => lines.get(row)));
  for (const heading of document.querySelectorAll("th[data-column]")) {
    const chosen = heading.dataset.column === sorted_by;
    heading.setAttribute("aria-sort", chosen ? (ascending ? "ascending" : "descending") : "none");
  }
}

function heading_of(text, column, title) {
  const heading = document.createElement("th");
  heading.scope = "col";
  heading.dataset.column = column;
  const button = Object.assign(cell("button", text), { type: "button", title });
  button.addEventListener("click", () => {
    ascending = sorted_by === column ? !ascending : true;
    sorted_by = column;
    refresh();
  });
  heading.append(button);
  return heading;
}

const table = document.createElement("table");
const head = table.createTHead().insertRow();
head.append(heading_of("Pair", "name", "SOURCE-TARGET"));
head.append(Object.assign(cell("th", "Source, compatible mesh, target"), { scope: "col" }));
head.append(heading_of("State", "verdict", "failures first"));
for (const { heading, pointer, meaning } of columns) {
  const place = heading_of(heading, pointer, meaning);
  place.className = "number";
  head.append(place);
}
table.append(body);
by_id("pairs").append(table);
by_id("name").textContent = facts.name;
const count = (verdict) => facts.rows.filter((row) => row.verdict === verdict).length;
by_id("verdict").textContent = `${facts.rows.length} pairs: ${order.map((verdict) => `${count(verdict)} ${verdict}`).join(", ")}`;
by_id("verdict").className = count("failed") > 0 ? "failure" : count("warnings") > 0 ? "warning" : "good";
by_id("units").textContent = columns.map(({ heading, meaning }) => `${heading}: ${meaning}`).join(" · ");
by_id("colophon").textContent = `Made by partwise ${facts.version}.`;
by_id("filter").addEventListener("input", refresh);
theme_button(by_id("theme"), () => {});
refresh();
draw_pictures([...lines].flatMap(([row, line]) =>
  [...line.querySelectorAll("img")].map((picture) => ({ row, picture }))));
