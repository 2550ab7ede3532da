// Cuts every facet of an OFF file in four, again and again, until there are so many: subdivide.cjs MESH.off FACETS.
const { readFileSync, writeSync } = require("node:fs");

const many = 2 ** 26; // vertices
const [file, wanted] = process.argv.slice(2);
const words = readFileSync(file, "latin1").replace(/#.*/g, "").split(/\s+/).filter(Boolean);
const [magic, vertices, facets] = [words[0], Number(words[1]), Number(words[2])];
if (magic !== "OFF" || !(facets > 0)) throw new Error(`${file} is no OFF file with facets`);
const points = words.slice(4, 4 + 3 * vertices).map(Number);
let corners = [];
for (let i = 0, at = 4 + 3 * vertices; i < facets; ++i, at += 4) {
  if (words[at] !== "3") throw new Error(`${file}: facet ${i} is no triangle`);
  corners.push(...words.slice(at + 1, at + 4).map(Number));
}
while (corners.length < 3 * wanted) {
  const between = new Map();
  const middle = (a, b) => {
    const key = Math.min(a, b) * many + Math.max(a, b);
    if (!between.has(key)) {
      between.set(key, points.length / 3);
      for (let c = 0; c < 3; ++c) points.push((points[3 * a + c] + points[3 * b + c]) / 2);
    }
    return between.get(key);
  };
  const finer = [];
  for (let i = 0; i < corners.length; i += 3) {
    const [x, y, z] = corners.slice(i, i + 3);
    const [xy, yz, zx] = [middle(x, y), middle(y, z), middle(z, x)];
    finer.push(x, xy, zx, y, yz, xy, z, zx, yz, xy, yz, zx);
  }
  corners = finer;
}
const lines = [`OFF\n${points.length / 3} ${corners.length / 3} 0`];
for (let i = 0; i < points.length; i += 3) lines.push(`${points[i]} ${points[i + 1]} ${points[i + 2]}`);
for (let i = 0; i < corners.length; i += 3) lines.push(`3 ${corners[i]} ${corners[i + 1]} ${corners[i + 2]}`);
const text = Buffer.from(lines.join("\n") + "\n");
for (let at = 0; at < text.length;) at += writeSync(1, text, at);
