// The page of sketch with the camel alone: sketch-alone.cjs ADDRESS.
const assert = require("node:assert");
const { after, before, test } = require("node:test");
const { User, strokes } = require("./user.cjs");

const [address] = process.argv.slice(2);
let user;

before(async () => {
  user = await User.at(address, ["camel"]);
});
after(() => user.leave());

test("nothing speaks of a second model", async () => {
  assert.equal(await user.page.locator("canvas").count(), 1);
  for (const part of ["#link-row", "#agreement", "#run-bar"]) assert.ok(await user.page.locator(part).isHidden(), part);
});

test("parts, markers and their mirror images are drawn and saved", async () => {
  for (const part of ["head", "body"]) {
    await user.add_part(part);
    // The view is wider than beside another, and as high: the model is drawn as large, in its middle.
    const place = ([x, y]) => [0.5 + (x - 0.5) / 2, y];
    await user.saved(() => user.drag("camel", strokes.camel[part].map(place)));
    assert.ok((await user.share_of("camel", part)) > 0.003);
  }
  assert.deepEqual(await user.drawn("camel"), ["head", "body"]);
  await user.press("m");
  await user.page.locator("#mirror").check();
  await user.saved(() => user.click("camel", [0.65, 0.15]));
  await user.until(async () => (await user.hint()).includes("Enter adds"));
  await user.saved(() => user.press("Enter"));
  assert.deepEqual((await user.sketch("camel")).markers.map(({ name }) => name), ["marker 1", "marker 2"]);
  assert.doesNotMatch(await user.hint(), /Now click/); // no partner is asked for
});

test("nothing was complained of", () => assert.deepEqual(user.complaints, []));
