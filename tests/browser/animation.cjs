// An animation of `morph` in three.js: animation.cjs PAGE_MODULES GLB SECONDS FRAME.off...
// PAGE_MODULES: the npm packages that the report's pages are made from. The frames are those of the animation.
const assert = require("node:assert");
const { readFileSync, writeFileSync } = require("node:fs");
const { after, before, test } = require("node:test");
const path = require("node:path");
const { launch, open_page, shoot, difference, covered } = require("./page.cjs");

const [modules, file, seconds, ...frame_files] = process.argv.slice(2);
const frames = frame_files.map((name) => {
  const [, counts, ...lines] = readFileSync(name, "utf8").trim().split("\n");
  const [vertices, facets] = counts.split(" ").map(Number);
  return { facets, positions: lines.slice(0, vertices).map((line) => line.split(" ").map(Number)) };
});
let browser, page, complaints, requests, loaded;

before(async () => {
  const { outputFiles } = require(path.join(modules, "esbuild")).buildSync({
    entryPoints: [path.join(__dirname, "animation-viewer.js")],
    bundle: true, format: "iife", globalName: "viewer", charset: "utf8", nodePaths: [modules], write: false,
  });
  const html = path.join(path.dirname(file), "animation.html");
  writeFileSync(html, `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">
<canvas id="canvas" width="480" height="360"></canvas><script>${outputFiles[0].text}</script>`);
  browser = await launch();
  ({ page, complaints, requests } = await open_page(browser, html));
  loaded = await page.evaluate((base64) => viewer.load(base64), readFileSync(file).toString("base64"));
});
after(() => browser.close());

/** The largest distance between vertices as three.js has them now and `expected`. */
async function difference_to(expected) {
  const found = await page.evaluate(() => viewer.positions());
  assert.equal(found.length, expected.length);
  return Math.max(...found.map((place, v) => Math.hypot(...place.map((x, i) => x - expected[v][i]))));
}

test("the loader finds one mesh, a morph target for each further frame, and the animation", () => {
  assert.equal(loaded.meshes, 1);
  assert.equal(loaded.vertices, frames[0].positions.length);
  assert.equal(loaded.corners, 3 * frames[0].facets);
  assert.deepEqual(loaded.attributes, ["normal", "position"]);
  assert.equal(loaded.targets, frames.length - 1);
  assert.deepEqual(loaded.targetNames, frames.slice(1).map((_, i) => String(i + 1).padStart(4, "0")));
  assert.deepEqual(loaded.animations, [{ duration: Number(seconds), tracks: 1 }]);
});

test("at each frame's time the vertices are those of the frame, between two they are between", async () => {
  const last = frames.length - 1;
  for (const [i, { positions }] of frames.entries()) {
    await page.evaluate((time) => viewer.show(time), (i / last) * seconds * (1 - 1e-9));
    assert.ok((await difference_to(positions)) < 1e-5, `frame ${i}`);
  }
  await page.evaluate((time) => viewer.show(time), (1.5 / last) * seconds);
  const [a, b] = [frames[1].positions, frames[2].positions];
  assert.ok((await difference_to(a.map((place, v) => place.map((x, i) => (x + b[v][i]) / 2)))) < 1e-5);
  assert.ok((await difference_to(frames[0].positions)) > 0.01, "the models differ");
});

test("the shape is drawn, and moves", async () => {
  for (const [name, time] of [["begin", 0], ["middle", seconds / 2]]) {
    await page.evaluate((t) => viewer.show(t), time);
    await shoot(page, name);
    for (const half of [0, 1]) assert.ok((await covered(page, name, half)) > 0.05, `${name}, half ${half}`);
  }
  assert.ok((await difference(page, "begin", "middle", 0)) > 0.01);
});

test("nothing was complained of, and nothing else was asked for", () => {
  assert.deepEqual(complaints, []);
  assert.equal(requests.filter((url) => !url.startsWith("file:") && !url.startsWith("blob:")).length, 0);
});
