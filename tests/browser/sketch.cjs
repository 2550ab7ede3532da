// Draws on camel and cow with the mouse, as a person does: sketch.cjs ADDRESS LABELS, where the camel's labels as the
// page has them are written, one a line. Fingers, a pen and the run are left to Chromium.
const assert = require("node:assert");
const { writeFileSync } = require("node:fs");
const { after, before, test } = require("node:test");
const { browser_name } = require("./page.cjs");
const { User, strokes } = require("./user.cjs");

const [address, labels_file] = process.argv.slice(2);
const parts = ["head", "body", "hind"];
const models = Object.keys(strokes);
const in_chromium = { skip: browser_name !== "chromium" && "in Chromium only" };
let user;

before(async () => {
  user = await User.at(address, models);
});
after(() => user.leave());

test("asks for parts first", async () => {
  assert.match(await user.hint(), /Add the parts/);
  for (const part of parts) await user.add_part(part);
  assert.deepEqual(await user.listed(), parts);
});

test("strokes colour the parts on both models", async () => {
  for (const model of models) {
    for (const [i, part] of parts.entries()) {
      await user.press(String(i + 1));
      assert.match(await user.hint(), new RegExp(`${part} on ${model}|is drawn`));
      await user.saved(() => user.drag(model, strokes[model][part]));
    }
    for (const part of parts) assert.ok((await user.share_of(model, part)) > 0.003, `${part} of ${model} is seen`);
    assert.deepEqual((await user.result(model)).parts.map(({ name }) => name), parts);
  }
  const times = await user.page.evaluate(() => performance.getEntriesByName("stroke to parts").map(({ duration }) => duration));
  assert.equal(times.length, 6);
  console.log(`from the end of a stroke to coloured parts: ${times.map((t) => t.toFixed(0)).join(", ")} ms`);
});

test("a stroke beside the model is refused with a word, and saves nothing", async () => {
  const changes = () => user.requests.filter(({ method }) => method !== "GET").length;
  const before_it = changes();
  await user.drag("camel", [[0.03, 0.9], [0.1, 0.95]]);
  assert.match(await user.hint(), /missed the model/);
  assert.equal(changes(), before_it);
});

test("undo and redo go through all strokes", async () => {
  const whole = await user.sketch("cow");
  await user.saved(() => user.press("Control+z"));
  assert.deepEqual(await user.drawn("cow"), ["head", "body"]);
  assert.ok((await user.share_of("cow", "hind")) < 0.002);
  await user.saved(() => user.press("Control+Shift+z"));
  assert.deepEqual((await user.sketch("cow")).parts, whole.parts);
  assert.ok((await user.share_of("cow", "hind")) > 0.003);
});

test("the eraser removes the stroke that it touches", async () => {
  await user.press("e");
  const [x, y] = strokes.cow.hind[0];
  await user.saved(() => user.drag("cow", [[x - 0.04, y + 0.03], [x + 0.04, y + 0.03]]));
  assert.deepEqual(await user.drawn("cow"), ["head", "body"]);
  await user.saved(() => user.press("Control+z"));
});

/** Points on the way along a stroke. */
const along = ([a, b]) => [0, 0.25, 0.5, 0.75, 1].map((t) => a.map((value, i) => (1 - t) * value + t * b[i]));

const body_strokes = async () => (await user.sketch("cow")).parts[parts.indexOf("body")].strokes;

test("one finger and a pen draw, whatever the palm does", in_chromium, async () => {
  await user.press("2");
  await user.saved(() => user.touch("cow", along(strokes.cow.body)));
  await user.saved(() => user.pen("cow", along(strokes.cow.body), [0.4, 0.9]));
  const [mouse, finger, pen_stroke] = await body_strokes();
  for (const stroke of [finger, pen_stroke]) {
    assert.deepEqual(stroke.camera, mouse.camera);
    assert.ok(stroke.screen.length >= 5);
  }
  for (let i = 0; i < 2; ++i) await user.saved(() => user.press("Control+z"));
  assert.deepEqual(await body_strokes(), [mouse]);
});

test("two fingers turn and draw nothing", in_chromium, async () => {
  await user.reset("cow"); // with the focus, whose frame is seen
  const [before_it, strokes_then] = [await user.picture("cow"), await body_strokes()];
  await user.touch("cow", along([[0.3, 0.4], [0.45, 0.4]]), along([[0.5, 0.6], [0.65, 0.6]]));
  assert.ok((await user.picture("cow")) !== before_it);
  assert.deepEqual(await body_strokes(), strokes_then);
  await user.reset("cow");
});

test("a stroke on a turned model keeps the camera that it was drawn with", async () => {
  const camera = (stroke) => JSON.stringify(stroke.camera);
  await user.page.locator("canvas").first().focus();
  for (let i = 0; i < 3; ++i) await user.press("ArrowRight");
  await user.press("2");
  await user.saved(() => user.drag("camel", [[0.4, 0.42], [0.5, 0.42]]));
  const body = (await user.sketch("camel")).parts[parts.indexOf("body")].strokes;
  assert.equal(body.length, 2);
  assert.notEqual(camera(body[0]), camera(body[1]));
  await user.reset("camel");
});

test("a marker asks for its partner, and can be moved, renamed and deleted", async () => {
  await user.press("m");
  await user.saved(() => user.click("camel", strokes.camel.head[1]));
  assert.match(await user.hint(), /marker 1 on cow/);
  await user.saved(() => user.click("cow", strokes.cow.head[1]));
  const [first] = (await user.sketch("cow")).markers;
  await user.saved(() => user.drag("cow", [strokes.cow.head[1], strokes.cow.head[0]]));
  const [moved] = (await user.sketch("cow")).markers;
  assert.equal(moved.name, first.name);
  assert.notEqual(moved.face, first.face);
  await user.saved(async () => {
    await user.page.locator("#markers input").fill("nose");
    await user.press("Enter");
  });
  for (const model of models) assert.deepEqual((await user.sketch(model)).markers.map(({ name }) => name), ["nose"]);
  await user.saved(() => user.page.getByLabel("Delete nose").click());
  for (const model of models) assert.deepEqual((await user.sketch(model)).markers, []);
  await user.saved(() => user.press("Control+z"));
});

test("the mirror image of a marker is suggested where a model is symmetric", async () => {
  const names = async (model) => (await user.sketch(model)).markers.map(({ name }) => name);
  await user.press("m");
  await user.page.locator("#mirror").check();
  await user.saved(() => user.click("camel", [0.8, 0.15]));
  await user.until(async () => (await user.hint()).includes("Enter adds the mirror image of marker 2 on camel"));
  await user.saved(() => user.press("Enter"));
  assert.deepEqual(await names("camel"), ["nose", "marker 2", "marker 3"]);
  // The camel's left and right differ by x.
  const [a, b] = await Promise.all(["marker 2", "marker 3"].map((name) => user.marker_place("camel", name)));
  assert.ok(Math.abs(a[0] - b[0]) > 0.02 && Math.abs(a[1] - b[1]) < 0.002 && Math.abs(a[2] - b[2]) < 0.002, `${a} and ${b}`);
  assert.match(await user.hint(), /marker 2 on cow/);
  await user.saved(() => user.click("cow", [0.8, 0.33]));
  await user.saved(() => user.page.getByLabel("Add the mirror image of marker 2").click());
  assert.deepEqual(await names("cow"), ["nose", "marker 2", "marker 3"]); // as on the camel
  for (let i = 0; i < 4; ++i) await user.saved(() => user.press("Control+z"));
  assert.deepEqual(await Promise.all(models.map(names)), [["nose"], ["nose"]]);
  await user.page.locator("#mirror").uncheck();
});

test("an anchor is accepted where it is proposed, and its partner asked for", async () => {
  const { proposed_anchors } = await user.result("camel");
  assert.ok(proposed_anchors.length > 0);
  const places = [];
  for (const anchor of proposed_anchors) places.push({ anchor, ...(await user.seen("camel", anchor.vertex)) });
  const [{ anchor, place }] = places.sort((a, b) => a.distance - b.distance);
  await user.press("a");
  await user.saved(() => user.click("camel", place));
  const name = anchor.name.replace(" (proposed)", "");
  assert.deepEqual((await user.sketch("camel")).anchors, [{ ...anchor, name }]);
  const hint = await user.hint();
  assert.ok(hint.includes(`${name} on cow`), hint);
  await user.press("Escape");
});

test("everything is there again after reloading", async () => {
  await user.add_part("tail"); // without a stroke
  const old = await Promise.all(models.map((model) => user.sketch(model)));
  await user.open();
  assert.deepEqual(await user.listed(), [...parts, "tail"]);
  assert.deepEqual(await Promise.all(models.map((model) => user.sketch(model))), old);
  for (const part of parts) assert.ok((await user.share_of("camel", part)) > 0.003);
  assert.equal(await user.page.locator("#markers input").inputValue(), "nose");
  await user.saved(() => user.page.getByLabel("Delete tail").click());
});

test("a run can be cancelled", in_chromium, async () => {
  await user.saved(() => user.page.locator("#anchors .delete").click()); // the anchor without a partner
  await user.page.click("#run");
  await user.page.click("#cancel");
  await user.page.waitForFunction(() => document.getElementById("run-text").textContent === "Cancelled.");
  assert.ok(await user.page.locator("#run").isEnabled());
});

test("the models agree, and a run ends with the compatible mesh to look at", in_chromium, async () => {
  assert.match(await user.page.locator("#differences").textContent(), /Yes/);
  const source = await user.picture("camel");
  await user.page.click("#run");
  await user.page.waitForSelector("#progress .running");
  await user.page.waitForSelector("#morph-row:not([hidden])", { timeout: 180_000 });
  assert.match(await user.page.locator("#run-text").textContent(), /[^t] ?Certified one-to-one/);
  const compatible = await user.picture("camel");
  await user.page.locator("#morph").fill("0.5");
  const halfway = await user.picture("camel");
  assert.ok(compatible !== source && halfway !== source && halfway !== compatible);
  await user.page.click("#close-result");
  assert.equal(await user.page.locator("#run-text").textContent(), "");
});

test("nothing was complained of, and nothing else was asked for", async () => {
  assert.deepEqual(user.complaints, []);
  assert.ok(user.requests.every(({ url }) => url.startsWith(address) || url.startsWith("data:")));
  const { labels } = await user.result("camel");
  writeFileSync(labels_file, Array.from(Buffer.from(labels, "base64"), (label) => `${label}\n`).join(""));
});
