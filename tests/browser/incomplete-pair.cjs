// The page of a source on its hulls with folds, and nothing else: incomplete-pair.cjs PAGE
const assert = require("node:assert");
const { after, before, test } = require("node:test");
const { launch, open_page, shoot, share, covered } = require("./page.cjs");

const [file] = process.argv.slice(2);
const red = "r > 190 && g < 60 && b < 60";
let browser, page, complaints, requests;

before(async () => {
  browser = await launch();
  ({ page, complaints, requests } = await open_page(browser, file));
});
after(() => browser.close());

test("says that it is incomplete, and lists the stages that are missing", async () => {
  assert.equal(await page.locator("#verdict").textContent(), "incomplete");
  const failures = await page.locator("#findings li.failure").allTextContents();
  assert.ok(failures.some((text) => text.includes("hull-to-hull") && text.includes("crossmap.ply")));
});

test("folded facets are red", async () => {
  await page.click('[data-stage="hullmaps"]');
  await shoot(page, "folds");
  assert.ok((await share(page, "folds", 0, red)) > 1e-4);
  assert.match(await page.locator("#stage-text").textContent(), /[0-9]+ folded facets are red/);
  assert.match(await page.locator("#legend").textContent(), /folded facets/);
});

test("a stage without a document names it where it would be", async () => {
  await page.click('[data-stage="compatible"]');
  await shoot(page, "empty");
  for (const half of [0, 1]) assert.ok((await covered(page, "empty", half)) < 0.02, "nothing but words");
  assert.match(await page.locator("#left-empty").textContent(), /relocate: there is no such file/);
});

test("nothing was complained of, and nothing else was asked for", () => {
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, [`file://${file}`]);
});
