// The page of a batch with pairs a-b (done, with a page), a-c and a-d (failed): batch.cjs PAGE
const assert = require("node:assert");
const { after, before, test } = require("node:test");
const { launch, open_page } = require("./page.cjs");

const [file] = process.argv.slice(2);
let browser, page, complaints, requests;

before(async () => {
  browser = await launch();
  ({ page, complaints, requests } = await open_page(browser, file));
});
after(() => browser.close());

const names = () => page.locator("tbody tr:not([hidden]) th").allTextContents();

test("failures come first, and say what is missing", async () => {
  assert.deepEqual(await names(), ["a-c", "a-d", "a-b"]);
  assert.match(await page.locator("tbody tr").first().textContent(), /failed.*compatible\.ply/);
  assert.match(await page.locator("#verdict").textContent(), /3 pairs: 2 failed/);
});

test("columns sort, both ways", async () => {
  await page.getByRole("button", { name: "Pair" }).click();
  assert.deepEqual(await names(), ["a-b", "a-c", "a-d"]);
  await page.getByRole("button", { name: "Pair" }).click();
  assert.deepEqual(await names(), ["a-d", "a-c", "a-b"]);
  assert.equal(await page.locator('th[data-column="name"]').getAttribute("aria-sort"), "descending");
  // Pairs without the figure are last, whichever way.
  for (const last of ["a-d", "a-d"]) {
    await page.getByRole("button", { name: "rms %" }).click();
    assert.equal((await names()).at(-1), last);
  }
});

test("a filter leaves the lines that have the words", async () => {
  await page.fill("#filter", "a-B");
  assert.deepEqual(await names(), ["a-b"]);
  await page.fill("#filter", "");
  assert.equal((await names()).length, 3);
});

test("thumbnails show something", async () => {
  await page.waitForFunction(() => [...document.querySelectorAll(".pictures img")].every((picture) => picture.src && picture.complete));
  const filled = await page.locator(".pictures img").evaluateAll((pictures) => pictures.map((picture) => {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [picture.naturalWidth, picture.naturalHeight];
    const context = canvas.getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 128) ++count;
    return count / (data.length / 4);
  }));
  assert.ok(filled.length >= 5);
  for (const share of filled) assert.ok(share > 0.05 && share < 0.95, String(filled));
});

test("a pair with a page is a link to it", async () => {
  assert.equal(await page.getByRole("link", { name: "a-b" }).getAttribute("href"), "a-b/report.html");
  await page.getByRole("link", { name: "a-b" }).click();
  assert.equal(await page.locator("#name").textContent(), "a-b");
});

test("nothing was complained of, and nothing else was asked for", () => {
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests.filter((url) => !url.startsWith("file:")), []);
});
