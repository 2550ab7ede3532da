// Draws on camel and cow with the mouse, as a person does: sketch.cjs ADDRESS LABELS, where the camel's labels as the
// page has them are written, one a line.
const assert = require("node:assert");
const { writeFileSync } = require("node:fs");
const { after, before, test } = require("node:test");
const { chromium, options } = require("./page.cjs");

const [address, labels_file] = process.argv.slice(2);
const parts = ["head", "body", "hind"];
let browser, page;
const complaints = [];
const requests = [];

// As shares of a view's width and height; both models look to the right.
const strokes = {
  camel: { head: [[0.83, 0.14], [0.88, 0.16]], body: [[0.25, 0.38], [0.57, 0.36]], hind: [[0.145, 0.61], [0.1, 0.725]] },
  cow: { head: [[0.84, 0.325], [0.89, 0.363]], body: [[0.2, 0.44], [0.54, 0.42]], hind: [[0.16, 0.6], [0.17, 0.725]] },
};
const models = Object.keys(strokes);

before(async () => {
  browser = await chromium.launch(options);
  page = await browser.newPage({ viewport: { width: 1280, height: 720 }, colorScheme: "light" });
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => requests.push({ method: request.method(), url: request.url() }));
  await open();
});
after(() => browser.close());

async function open() {
  await page.goto(address);
  await page.waitForFunction(() => document.querySelectorAll(".view .status:not(:empty)").length === 2);
}

async function at(model, [x, y]) {
  const box = await page.locator("canvas").nth(models.indexOf(model)).boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}

/** Does something, and waits until the server has answered all that came of it. */
async function saved(action) {
  const answer = page.waitForResponse((response) => response.request().method() === "PUT");
  const compared = page.waitForResponse((response) => response.url().endsWith("/check"));
  await action();
  assert.equal((await answer).status(), 200);
  await compared;
  await page.waitForFunction(() => document.getElementById("saved").textContent === "Saved");
}

async function drag(model, points) {
  await page.mouse.move(...(await at(model, points[0])));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...(await at(model, point)), { steps: 12 });
  await page.mouse.up();
}

const click = (model, point) => drag(model, [point]);

const result = (model) => page.evaluate((i) => fetch(`models/${i}/result`).then((r) => r.json()), models.indexOf(model));
const sketch = (model) => page.evaluate((i) => fetch(`models/${i}/sketch`).then((r) => r.json()), models.indexOf(model));

/** Share of a view's pixels that have the hue of a part, as its entry in the list shows it. */
async function share_of(model, part) {
  const color = await page.locator("#parts .swatch").nth(parts.indexOf(part)).evaluate((swatch) => getComputedStyle(swatch).backgroundColor);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 30))));
  const png = (await page.locator("canvas").nth(models.indexOf(model)).screenshot()).toString("base64");
  return page.evaluate(async ([data, [r, g, b]]) => {
    const image = new Image();
    image.src = "data:image/png;base64," + data;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, image.width, image.height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      // Shaded, but by one factor for all channels, which the background, bright and grey, has not.
      const light = (pixels[i] + pixels[i + 1] + pixels[i + 2]) / (r + g + b);
      const off = Math.abs(pixels[i] - light * r) + Math.abs(pixels[i + 1] - light * g) + Math.abs(pixels[i + 2] - light * b);
      if (light > 0.55 && off < 25) ++count;
    }
    return count / (image.width * image.height);
  }, [png, color.match(/[0-9]+/g).map(Number)]);
}

/** Names of the parts that have strokes on a model. */
async function drawn(model) {
  return (await sketch(model)).parts.filter(({ strokes: lines }) => lines.length > 0).map(({ name }) => name);
}

async function add_part(name) {
  await page.keyboard.press("n");
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
  await page.waitForFunction(async (wanted) => {
    if (document.getElementById("saved").textContent !== "Saved") return false;
    const last = await Promise.all([0, 1].map(async (i) => (await (await fetch(`models/${i}/sketch`)).json()).parts.at(-1)));
    return last.every((part) => part?.name === wanted);
  }, name);
  await page.waitForTimeout(100); // the comparison of the models
}

const listed = () => page.locator("#parts input").evaluateAll((fields) => fields.map((field) => field.value));

test("asks for parts first", async () => {
  assert.match(await page.locator("#hint").textContent(), /Add the parts/);
  for (const part of parts) await add_part(part);
  assert.deepEqual(await listed(), parts);
});

test("strokes colour the parts on both models", async () => {
  for (const model of models) {
    for (const [i, part] of parts.entries()) {
      await page.keyboard.press(String(i + 1));
      assert.match(await page.locator("#hint").textContent(), new RegExp(`${part} on ${model}|is drawn`));
      await saved(() => drag(model, strokes[model][part]));
    }
    for (const part of parts) assert.ok((await share_of(model, part)) > 0.003, `${part} of ${model} is seen`);
    assert.deepEqual((await result(model)).parts.map(({ name }) => name), parts);
  }
  const times = await page.evaluate(() => performance.getEntriesByName("stroke to parts").map(({ duration }) => duration));
  assert.equal(times.length, 6);
  console.log(`from the end of a stroke to coloured parts: ${times.map((t) => t.toFixed(0)).join(", ")} ms`);
});

test("a stroke beside the model is refused with a word, and saves nothing", async () => {
  const changes = () => requests.filter(({ method }) => method !== "GET").length;
  const before_it = changes();
  await drag("camel", [[0.03, 0.9], [0.1, 0.95]]);
  assert.match(await page.locator("#hint").textContent(), /missed the model/);
  assert.equal(changes(), before_it);
});

test("undo and redo go through all strokes", async () => {
  const whole = await sketch("cow");
  await saved(() => page.keyboard.press("Control+z"));
  assert.deepEqual(await drawn("cow"), ["head", "body"]);
  assert.ok((await share_of("cow", "hind")) < 0.002);
  await saved(() => page.keyboard.press("Control+Shift+z"));
  assert.deepEqual((await sketch("cow")).parts, whole.parts);
  assert.ok((await share_of("cow", "hind")) > 0.003);
});

test("the eraser removes the stroke that it touches", async () => {
  await page.keyboard.press("e");
  const [x, y] = strokes.cow.hind[0];
  await saved(() => drag("cow", [[x - 0.04, y + 0.03], [x + 0.04, y + 0.03]]));
  assert.deepEqual(await drawn("cow"), ["head", "body"]);
  await saved(() => page.keyboard.press("Control+z"));
});

/** Fingers on the screen, each a path of as many points, all at once: they come down one after the other. */
async function touch(model, ...paths) {
  const session = await page.context().newCDPSession(page);
  const send = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  const point = async (finger, step) => {
    const [x, y] = await at(model, paths[finger][step]);
    return { x, y, id: finger };
  };
  const down = [];
  for (const finger of paths.keys()) {
    down.push(await point(finger, 0));
    await send("touchStart", down);
  }
  for (const step of paths[0].keys()) await send("touchMove", await Promise.all([...paths.keys()].map((finger) => point(finger, step))));
  await send("touchEnd", []);
  await session.detach();
}

/** A pen, which draws through the points while a hand lies on the screen at `palm`. */
async function pen(model, points, palm) {
  const session = await page.context().newCDPSession(page);
  const send = async (type, place, more) => {
    const [x, y] = await at(model, place);
    await session.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, clickCount: 1, pointerType: "pen", ...more });
  };
  const [x, y] = await at(model, palm);
  const hand = (type, ...touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("mousePressed", points[0]);
  await hand("touchStart", { x, y });
  for (const place of points) {
    await send("mouseMoved", place);
    await hand("touchMove", { x: x + 40 * place[0], y });
  }
  await send("mouseReleased", points.at(-1), { buttons: 0 });
  await hand("touchEnd");
  await session.detach();
}

/** Points on the way along a stroke. */
const along = ([a, b]) => [0, 0.25, 0.5, 0.75, 1].map((t) => a.map((value, i) => (1 - t) * value + t * b[i]));

const body_strokes = async () => (await sketch("cow")).parts[parts.indexOf("body")].strokes;

const picture = async (model) => {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 30))));
  return (await page.locator("canvas").nth(models.indexOf(model)).screenshot()).toString("base64");
};

async function reset(model) {
  await page.locator("canvas").nth(models.indexOf(model)).focus();
  await page.keyboard.press("0");
}

test("one finger and a pen draw, whatever the palm does", async () => {
  await page.keyboard.press("2");
  await saved(() => touch("cow", along(strokes.cow.body)));
  await saved(() => pen("cow", along(strokes.cow.body), [0.4, 0.9]));
  const [mouse, finger, pen_stroke] = await body_strokes();
  for (const stroke of [finger, pen_stroke]) {
    assert.deepEqual(stroke.camera, mouse.camera);
    assert.ok(stroke.screen.length >= 5);
  }
  for (let i = 0; i < 2; ++i) await saved(() => page.keyboard.press("Control+z"));
  assert.deepEqual(await body_strokes(), [mouse]);
});

test("two fingers turn and draw nothing", async () => {
  await reset("cow"); // with the focus, whose frame is seen
  const [before_it, strokes_then] = [await picture("cow"), await body_strokes()];
  await touch("cow", along([[0.3, 0.4], [0.45, 0.4]]), along([[0.5, 0.6], [0.65, 0.6]]));
  assert.ok((await picture("cow")) !== before_it);
  assert.deepEqual(await body_strokes(), strokes_then);
  await reset("cow");
});

test("a stroke on a turned model keeps the camera that it was drawn with", async () => {
  const camera = (stroke) => JSON.stringify(stroke.camera);
  await page.locator("canvas").first().focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("2");
  await saved(() => drag("camel", [[0.4, 0.42], [0.5, 0.42]]));
  const body = (await sketch("camel")).parts[parts.indexOf("body")].strokes;
  assert.equal(body.length, 2);
  assert.notEqual(camera(body[0]), camera(body[1]));
  await reset("camel");
});

test("a marker asks for its partner, and can be moved, renamed and deleted", async () => {
  await page.keyboard.press("m");
  await saved(() => click("camel", strokes.camel.head[1]));
  assert.match(await page.locator("#hint").textContent(), /marker 1 on cow/);
  await saved(() => click("cow", strokes.cow.head[1]));
  const [first] = (await sketch("cow")).markers;
  await saved(() => drag("cow", [strokes.cow.head[1], strokes.cow.head[0]]));
  const [moved] = (await sketch("cow")).markers;
  assert.equal(moved.name, first.name);
  assert.notEqual(moved.face, first.face);
  await saved(async () => {
    await page.locator("#markers input").fill("nose");
    await page.keyboard.press("Enter");
  });
  for (const model of models) assert.deepEqual((await sketch(model)).markers.map(({ name }) => name), ["nose"]);
  await saved(() => page.getByLabel("Delete nose").click());
  for (const model of models) assert.deepEqual((await sketch(model)).markers, []);
  await saved(() => page.keyboard.press("Control+z"));
});

/** Where the page shows a vertex of a model that was not turned since its first stroke, as shares of the view. */
async function seen(model, vertex) {
  const i = models.indexOf(model);
  const [facts, position] = await page.evaluate(async ([index, v]) => {
    const mesh = await fetch(`models/${index}/mesh`).then((r) => r.arrayBuffer());
    const { models: all } = await fetch("models").then((r) => r.json());
    return [all[index], Array.from(new Float32Array(mesh, 12 * v, 3))];
  }, [i, vertex]);
  const { view, projection } = (await sketch(model)).parts[0].strokes[0].camera;
  const times = (matrix, p) => [0, 4, 8, 12].map((row) => p.reduce((sum, value, j) => sum + matrix[row + j] * value, 0));
  const [x, y, , w] = times(projection, times(view, [...position.map((c, j) => c * facts.diagonal + facts.center[j]), 1]));
  return { place: [(1 + x / w) / 2, (1 - y / w) / 2], distance: w };
}

test("an anchor is accepted where it is proposed, and its partner asked for", async () => {
  const { proposed_anchors } = await result("camel");
  assert.ok(proposed_anchors.length > 0);
  const places = [];
  for (const anchor of proposed_anchors) places.push({ anchor, ...(await seen("camel", anchor.vertex)) });
  const [{ anchor, place }] = places.sort((a, b) => a.distance - b.distance);
  await page.keyboard.press("a");
  await saved(() => click("camel", place));
  const name = anchor.name.replace(" (proposed)", "");
  assert.deepEqual((await sketch("camel")).anchors, [{ ...anchor, name }]);
  const hint = await page.locator("#hint").textContent();
  assert.ok(hint.includes(`${name} on cow`), hint);
  await page.keyboard.press("Escape");
});

test("everything is there again after reloading", async () => {
  await add_part("tail"); // without a stroke
  const old = await Promise.all(models.map(sketch));
  await open();
  assert.deepEqual(await listed(), [...parts, "tail"]);
  assert.deepEqual(await Promise.all(models.map(sketch)), old);
  for (const part of parts) assert.ok((await share_of("camel", part)) > 0.003);
  assert.equal(await page.locator("#markers input").inputValue(), "nose");
  await saved(() => page.getByLabel("Delete tail").click());
});

test("a run can be cancelled", async () => {
  await saved(() => page.locator("#anchors button").last().click()); // the anchor without a partner
  await page.click("#run");
  await page.click("#cancel");
  await page.waitForFunction(() => document.getElementById("run-text").textContent === "Cancelled.");
  assert.ok(await page.locator("#run").isEnabled());
});

test("the models agree, and a run ends with the compatible mesh to look at", async () => {
  assert.match(await page.locator("#differences").textContent(), /Yes/);
  const source = await picture("camel");
  await page.click("#run");
  await page.waitForSelector("#progress .running");
  await page.waitForSelector("#morph-row:not([hidden])", { timeout: 180_000 });
  assert.match(await page.locator("#run-text").textContent(), /[^t] ?Certified one-to-one/);
  const compatible = await picture("camel");
  await page.locator("#morph").fill("0.5");
  const halfway = await picture("camel");
  assert.ok(compatible !== source && halfway !== source && halfway !== compatible);
  await page.click("#close-result");
  assert.equal(await page.locator("#run-text").textContent(), "");
});

test("nothing was complained of, and nothing else was asked for", async () => {
  assert.deepEqual(complaints, []);
  assert.ok(requests.every(({ url }) => url.startsWith(address) || url.startsWith("data:")));
  const { labels } = await result("camel");
  writeFileSync(labels_file, Array.from(Buffer.from(labels, "base64"), (label) => `${label}\n`).join(""));
});
