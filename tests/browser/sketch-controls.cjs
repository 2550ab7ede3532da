// What surrounds the strokes on the page of sketch, on camel and cow: sketch-controls.cjs ADDRESS.
const assert = require("node:assert");
const { after, before, test } = require("node:test");
const { User, strokes } = require("./user.cjs");

const [address] = process.argv.slice(2);
const models = Object.keys(strokes);
const parts = ["head", "body", "hind"];
const states = []; // the sketches after every action so far
let user;

before(async () => {
  user = await User.at(address, models);
  states.push(await sketches());
});
after(() => user.leave());

async function sketches() {
  const said = await Promise.all(models.map((model) => user.sketch(model)));
  return JSON.stringify(said.map(({ parts: drawn, markers, anchors }) => ({ parts: drawn, markers, anchors })));
}

/** One action, which undo takes back at once. */
async function act(action) {
  await user.saved(action);
  states.push(await sketches());
  assert.notEqual(states.at(-1), states.at(-2));
}

async function draw(model, part) {
  await user.press(String(parts.indexOf(part) + 1));
  await act(() => user.drag(model, strokes[model][part]));
}

const obstacle = () => user.page.locator("#obstacle").textContent();
const run = () => user.page.locator("#run");

test("what a run lacks is said before it, and where", async () => {
  assert.match(await obstacle(), /parts, or markers/);
  for (const part of parts) {
    await act(() => user.press("n"));
    await act(async () => {
      await user.page.keyboard.type(part);
      await user.press("Enter");
    });
  }
  assert.equal(await obstacle(), "To be drawn before a run: head, body, hind on camel; head, body, hind on cow.");
  for (const part of parts) await draw("camel", part);
  for (const part of ["head", "body"]) await draw("cow", part);
  assert.equal(await obstacle(), "To be drawn before a run: hind on cow.");
  assert.ok(await run().isDisabled());
  await draw("cow", "hind");
  assert.equal(await obstacle(), "");
  assert.ok(await run().isEnabled());
  await user.press("m");
  await act(() => user.click("camel", strokes.camel.head[1]));
  assert.equal(await obstacle(), "To be put right before a run: marker 'marker 1' exists only in camel.");
  assert.ok(await run().isDisabled());
  await act(() => user.click("cow", strokes.cow.head[1]));
  assert.ok(await run().isEnabled());
});

test("every action can be undone, back to the start, and redone", async () => {
  await act(async () => {
    await user.page.locator("#markers input").fill("nose");
    await user.press("Enter");
  });
  await act(() => user.drag("cow", [strokes.cow.head[1], strokes.cow.head[0]])); // moves it
  const { proposed_anchors } = await user.result("camel");
  const places = await Promise.all(proposed_anchors.map(({ vertex }) => user.seen("camel", vertex)));
  await user.press("a");
  await act(() => user.click("camel", places.sort((a, b) => a.distance - b.distance)[0].place));
  await user.press("Escape");
  await act(async () => {
    await user.page.locator("#parts input").nth(2).fill("rear");
    await user.press("Enter");
  });
  await user.press("e");
  const [x, y] = strokes.cow.body[0];
  await act(() => user.drag("cow", [[x, y - 0.03], [x, y + 0.03]]));
  await act(() => user.page.getByLabel("Delete rear").click());
  await act(() => user.page.getByLabel("Delete nose").click());
  const [undo, redo] = ["#undo", "#redo"].map((button) => user.page.locator(button));
  assert.ok(await redo.isDisabled());
  for (let at = states.length - 2; at >= 0; --at) {
    await user.press("Control+z");
    await user.until(async () => (await sketches()) === states[at]);
  }
  assert.ok(await undo.isDisabled());
  assert.deepEqual(await user.listed(), []);
  for (let at = 1; at < states.length; ++at) {
    await user.press(at % 2 === 0 ? "Control+y" : "Control+Shift+z");
    await user.until(async () => (await sketches()) === states[at]);
  }
  assert.ok(await redo.isDisabled());
  assert.deepEqual(await user.listed(), ["head", "body"]);
});

test("models turn together when they are linked, and else alone", async () => {
  const turned = async () => {
    await user.canvas("camel").focus(); // whose frame is seen
    const old = [await user.picture("camel"), await user.picture("cow")];
    await user.press("ArrowRight");
    return [(await user.picture("camel")) !== old[0], (await user.picture("cow")) !== old[1]];
  };
  assert.deepEqual(await turned(), [true, false]);
  await user.press("l");
  assert.ok(await user.page.locator("#link").isChecked());
  assert.deepEqual(await turned(), [true, true]);
  await user.page.locator("#link").focus();
  await user.press("Space"); // which works the box, and does not turn
  assert.ok(!(await user.page.locator("#link").isChecked()));
  assert.deepEqual(await turned(), [true, false]);
});

test("nothing was complained of", () => assert.deepEqual(user.complaints, []));
