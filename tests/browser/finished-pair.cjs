// The page of a finished pair: finished-pair.cjs PAGE MEASURE_JSON
const assert = require("node:assert");
const { readFileSync, statSync } = require("node:fs");
const { after, before, test } = require("node:test");
const { launch, open_page, shoot, share, difference, covered, settled } = require("./page.cjs");

const [file, measure_file] = process.argv.slice(2);
const measure = JSON.parse(readFileSync(measure_file));
const red = "r > 110 && g < 40 && b < 40";
const spot = "r > 190 && g < 40 && b > 90 && b < 160";
let browser, page, complaints, requests;

before(async () => {
  browser = await launch();
  ({ page, complaints, requests } = await open_page(browser, file));
});
after(() => browser.close());

const choose = (stage) => page.click(`[data-stage="${stage}"]`);
const slide = (value) => page.locator("#morph").fill(String(value));
async function color(mode) {
  await page.selectOption("#color", mode);
}

test("is below 15 MB", () => assert.ok(statSync(file).size < 15e6));

test("every stage draws both views, and each looks different", async () => {
  const stages = await page.locator("[data-stage]").evaluateAll((tabs) => tabs.map((tab) => tab.dataset.stage));
  assert.ok(stages.length >= 12);
  let last = null;
  for (const stage of stages) {
    await choose(stage);
    await shoot(page, stage);
    for (const half of [0, 1]) assert.ok((await covered(page, stage, half)) > 0.03, `${stage}, view ${half}`);
    if (last) {
      const [left, right] = [await difference(page, last, stage, 0), await difference(page, last, stage, 1)];
      assert.ok(left + right > 0.002, `${stage} looks like ${last}`);
    }
    last = stage;
  }
});

test("without folds nothing is red", async () => {
  assert.equal(measure.hull_folds.total, 0);
  for (const stage of ["hullmaps", "crossmap"]) assert.equal(await share(page, stage, 0, red), 0);
});

test("the slider moves vertices from the source to the compatible mesh", async () => {
  await choose("morph");
  for (const value of [0, 0.5, 1]) {
    await slide(value);
    await shoot(page, `morph ${value}`);
  }
  assert.equal(await page.locator("#morph-value").textContent(), "100 %");
  for (const stage of ["models", "compatible"]) {
    await choose(stage);
    await color("parts");
    await shoot(page, `${stage} in parts`);
  }
  assert.ok((await difference(page, "morph 0", "models in parts", 0)) < 1e-4);
  assert.ok((await difference(page, "morph 1", "compatible in parts", 0)) < 1e-4);
  assert.ok((await difference(page, "morph 0", "morph 0.5", 0)) > 0.003);
  assert.ok((await difference(page, "morph 0.5", "morph 1", 0)) > 0.003);
  assert.ok((await difference(page, "morph 0", "morph 1", 1)) < 1e-4, "the other view stays");
});

test("pointing at one model marks the same place on the other", async () => {
  await choose("models");
  const box = await page.locator("#canvas").boundingBox();
  for (const [x, y] of [[0.25, 0.45], [0.75, 0.45]]) {
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    await page.mouse.move(box.x + x * box.width + 1, box.y + y * box.height);
    await shoot(page, "marked");
    for (const half of [0, 1]) assert.ok((await share(page, "marked", half, spot)) > 1e-5, `pointing at ${x}, view ${half}`);
    assert.notEqual(await page.locator("#place").textContent(), "");
  }
  await page.mouse.move(box.x + 3, box.y + 3);
  await shoot(page, "unmarked");
  for (const half of [0, 1]) assert.equal(await share(page, "unmarked", half, spot), 0);
});

test("both views turn together, by mouse and by keys, and come back", async () => {
  await page.mouse.move(5, 5);
  await choose("models");
  await shoot(page, "at first");
  const box = await page.locator("#canvas").boundingBox();
  await page.mouse.move(box.x + 100, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 180, box.y + 130, { steps: 3 });
  await page.mouse.up();
  await page.mouse.move(5, 5);
  await shoot(page, "dragged");
  await page.locator("#canvas").focus();
  await page.keyboard.press("0");
  await shoot(page, "reset");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("+");
  await shoot(page, "by keys");
  await page.click("#reset");
  await shoot(page, "reset again");
  for (const half of [0, 1]) {
    assert.ok((await difference(page, "at first", "dragged", half)) > 0.01);
    assert.ok((await difference(page, "at first", "by keys", half)) > 0.01);
    assert.ok((await difference(page, "at first", "reset", half)) < 1e-3);
    assert.ok((await difference(page, "at first", "reset again", half)) < 1e-3);
  }
});

test("arrow keys go from stage to stage", async () => {
  await choose("models");
  await page.locator('[data-stage="models"]').focus();
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.locator("#stage-title").textContent(), "Parts");
  assert.equal(await page.locator('[aria-selected="true"]').getAttribute("data-stage"), "parts");
  await page.keyboard.press("End");
  assert.equal(await page.locator("#stage-title").textContent(), "Distortion");
});

test("colour maps have legends with units and ascending values", async () => {
  const numbers = async () => (await page.locator("#legend .ticks span").allTextContents()).map((text) => Number(text.replace("×", "")));
  for (const [stage, unit] of [["distance", "% of the target's diagonal"], ["distortion", "4: isometry"]]) {
    await choose(stage);
    assert.ok((await page.locator("#legend").textContent()).includes(unit));
    const ticks = await numbers();
    assert.ok(ticks.length >= 3 && ticks.every((tick, i) => i === 0 || tick > ticks[i - 1]), String(ticks));
  }
  await color("area");
  assert.equal((await numbers())[1], 1);
});

test("edges and markers can be shown", async () => {
  await choose("compatible");
  await shoot(page, "bare");
  await page.check("#edges");
  await shoot(page, "edges");
  await page.check("#markers");
  await shoot(page, "markers");
  assert.ok((await difference(page, "bare", "edges", 0)) > 0.01);
  if (measure.markers > 0) assert.ok((await difference(page, "edges", "markers", 1)) > 1e-5);
  await page.uncheck("#edges");
  await page.uncheck("#markers");
});

test("figures and history are those of the documents", async () => {
  const value = async (meaning) => page.locator("#figures tr", { hasText: meaning }).first().locator("td").nth(1).textContent();
  assert.equal(await value("facets of the source"), String(measure.source_faces));
  assert.equal(await value("two-sided RMS distance"), (100 * measure.rms_distance).toFixed(3));
  assert.equal(await page.locator("#history tbody tr").count(), measure.history.length);
  assert.match(await page.locator("#verdict").textContent(), measure.one_to_one ? /^certified/ : /not certified/);
});

test("light and dark", async () => {
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await paper();
  await page.click("#theme");
  assert.notEqual(await paper(), light);
  await page.click("#theme");
  assert.equal(await paper(), light);
});

test("on a narrow screen the views are one above the other, and nothing is wider than the screen", async () => {
  const narrow = await open_page(browser, file, { width: 400, height: 800, colorScheme: "dark" });
  await settled(narrow.page);
  assert.ok(await narrow.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  const canvas = await narrow.page.locator("#canvas").boundingBox();
  assert.ok(canvas.height > canvas.width);
  assert.deepEqual(narrow.complaints, []);
});

test("nothing was complained of, and nothing else was asked for", () => {
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, [`file://${file}`]);
});
