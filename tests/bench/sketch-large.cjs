// Draws on a large model that stands like the camel: sketch-large.cjs ADDRESS. See sketch-large.
const { User } = require("../browser/user.cjs");

const rest = 1500; // milliseconds: the hints are looked for when the next stroke comes
const strokes = { head: [[0.663, 0.093], [0.712, 0.12]], body: [[0.325, 0.3], [0.55, 0.29]], hind: [[0.263, 0.69], [0.273, 0.83]] };

(async () => {
  const started = Date.now();
  const user = await User.at(process.argv[2], ["large"]);
  console.log(`page: ${Date.now() - started} ms`);
  const timed = async (what, action) => {
    const start = Date.now();
    await user.saved(action);
    const { seconds } = await user.result("large");
    const times = await user.page.evaluate(() => performance.getEntriesByName("stroke to parts").map(({ duration }) => duration));
    console.log(`${what}: ${Date.now() - start} ms in all, server ${(1000 * seconds).toFixed(0)} ms${what.startsWith("stroke") ? `, from mouse-up to coloured parts ${times.at(-1).toFixed(0)} ms` : ""}`);
    await user.page.waitForTimeout(rest);
  };
  const parts = Object.entries(strokes);
  for (const [part] of parts) await user.add_part(part);
  for (const [i, [part, stroke]] of parts.entries()) {
    await user.press(String(i + 1));
    await timed(`stroke of ${part}`, () => user.drag("large", stroke));
  }
  await user.press("2");
  await timed("stroke of body", () => user.drag("large", [[0.36, 0.38], [0.52, 0.36]]));
  await user.press("m");
  await timed("marker", () => user.click("large", [0.444, 0.216]));
  await user.press("e");
  await timed("eraser", () => user.drag("large", [[0.425, 0.25], [0.425, 0.34]]));
  await user.leave();
})();
