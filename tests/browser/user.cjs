// A person at the page of sketch: opens it in a browser, draws with the mouse, and sees what comes of it.
const assert = require("node:assert");
const { launch } = require("./page.cjs");

const patience = 30_000; // milliseconds

class User {
  /** @param models names of the models that the page shows, in their order */
  static async at(address, models) {
    const browser = await launch();
    const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, colorScheme: "light" });
    const user = new User(address, models, browser, page);
    await user.open();
    return user;
  }

  constructor(address, models, browser, page) {
    Object.assign(this, { address, models, browser, page, complaints: [], requests: [] });
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type())) this.complaints.push(message.text());
    });
    page.on("pageerror", (error) => this.complaints.push(error.message));
    page.on("request", (request) => this.requests.push({ method: request.method(), url: request.url() }));
  }

  async open() {
    await this.page.goto(this.address);
    await this.answered();
  }

  leave() {
    return this.browser.close();
  }

  hint() {
    return this.page.locator("#hint").textContent();
  }

  canvas(model) {
    return this.page.locator("canvas").nth(this.models.indexOf(model));
  }

  /** The pixel at shares of a view's width and height. */
  async at(model, [x, y]) {
    const box = await this.canvas(model).boundingBox();
    return [box.x + x * box.width, box.y + y * box.height];
  }

  async until(holds) {
    for (const end = Date.now() + patience; !(await holds());) {
      assert.ok(Date.now() < end, `in vain for ${patience / 1000} s`);
      await this.page.waitForTimeout(30);
    }
  }

  /** Waits until nothing is asked of the server that the page's lists and colours wait for. */
  async answered() {
    await this.page.locator("#views[aria-busy=false]").waitFor();
  }

  /** Does something, and waits until the server has answered all that came of it. */
  async saved(action) {
    const answer = this.page.waitForResponse((response) => response.request().method() === "PUT");
    await action();
    assert.equal((await answer).status(), 200);
    await this.answered();
    assert.equal(await this.page.locator("#saved").textContent(), "Saved");
  }

  async drag(model, points) {
    const { mouse } = this.page;
    await mouse.move(...(await this.at(model, points[0])));
    await mouse.down();
    for (const point of points.slice(1)) await mouse.move(...(await this.at(model, point)), { steps: 12 });
    await mouse.up();
  }

  click(model, point) {
    return this.drag(model, [point]);
  }

  press(key) {
    return this.page.keyboard.press(key);
  }

  async add_part(name) {
    await this.saved(() => this.press("n"));
    await this.saved(async () => {
      await this.page.keyboard.type(name);
      await this.press("Enter");
    });
  }

  /** Names in the list of parts. */
  listed() {
    return this.page.locator("#parts input").evaluateAll((fields) => fields.map((field) => field.value));
  }

  /** What the server has of a model: "sketch", "result". */
  asked(what, model) {
    return this.page.evaluate((path) => fetch(path).then((r) => r.json()), `models/${this.models.indexOf(model)}/${what}`);
  }

  result(model) {
    return this.asked("result", model);
  }

  sketch(model) {
    return this.asked("sketch", model);
  }

  /** Names of the parts that have strokes on a model. */
  async drawn(model) {
    return (await this.sketch(model)).parts.filter(({ strokes }) => strokes.length > 0).map(({ name }) => name);
  }

  /** Where a marker of a model lies, in the frame of the page: diagonals of the model. */
  async marker_place(model, name) {
    const { face, barycentric } = (await this.sketch(model)).markers.find((marker) => marker.name === name);
    return this.page.evaluate(async ([i, facet, weights]) => {
      const { models: all } = await fetch("models").then((r) => r.json());
      const mesh = await fetch(`models/${i}/mesh`).then((r) => r.arrayBuffer());
      const corners = new Uint32Array(mesh, 12 * (all[i].vertices + facet), 3);
      return [0, 1, 2].map((axis) => corners.reduce((sum, v, j) => sum + weights[j] * new Float32Array(mesh, 12 * v, 3)[axis], 0));
    }, [this.models.indexOf(model), face, barycentric]);
  }

  async screenshot(model) {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 30))));
    return (await this.canvas(model).screenshot()).toString("base64");
  }

  /** What a view shows once all has come that comes by itself: hints, names of markers, the next frame. */
  async picture(model) {
    await this.until(async () => (await this.page.locator("[aria-busy=true]").count()) === 0);
    let [last, now] = [null, await this.screenshot(model)];
    await this.until(async () => {
      await this.page.waitForTimeout(200);
      [last, now] = [now, await this.screenshot(model)];
      return last === now;
    });
    return now;
  }

  /** Share of a view's pixels that have the hue of a part, as its entry in the list shows it. */
  async share_of(model, part) {
    const swatch = this.page.locator("#parts .swatch").nth((await this.listed()).indexOf(part));
    const color = await swatch.evaluate((entry) => getComputedStyle(entry).backgroundColor);
    return this.page.evaluate(async ([data, [r, g, b]]) => {
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
    }, [await this.screenshot(model), color.match(/[0-9]+/g).map(Number)]);
  }

  /** Looks at a model as at first, which then has the focus. */
  async reset(model) {
    await this.canvas(model).focus();
    await this.press("0");
  }

  /** Where the page shows a vertex of a model that was not turned since its first stroke: shares of the view. */
  async seen(model, vertex) {
    const i = this.models.indexOf(model);
    const [facts, position] = await this.page.evaluate(async ([index, v]) => {
      const mesh = await fetch(`models/${index}/mesh`).then((r) => r.arrayBuffer());
      const { models: all } = await fetch("models").then((r) => r.json());
      return [all[index], Array.from(new Float32Array(mesh, 12 * v, 3))];
    }, [i, vertex]);
    const { view, projection } = (await this.sketch(model)).parts[0].strokes[0].camera;
    const times = (matrix, p) => [0, 4, 8, 12].map((row) => p.reduce((sum, value, j) => sum + matrix[row + j] * value, 0));
    const [x, y, , w] = times(projection, times(view, [...position.map((c, j) => c * facts.diagonal + facts.center[j]), 1]));
    return { place: [(1 + x / w) / 2, (1 - y / w) / 2], distance: w };
  }

  /** Fingers on the screen, each a path of as many points, all at once: they come down one after the other. Chromium only. */
  async touch(model, ...paths) {
    const session = await this.page.context().newCDPSession(this.page);
    const send = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
    const point = async (finger, step) => {
      const [x, y] = await this.at(model, paths[finger][step]);
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

  /** A pen, which draws through the points while a hand lies on the screen at `palm`. Chromium only. */
  async pen(model, points, palm) {
    const session = await this.page.context().newCDPSession(this.page);
    const send = async (type, place, more) => {
      const [x, y] = await this.at(model, place);
      await session.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: 1, clickCount: 1, pointerType: "pen", ...more });
    };
    const [x, y] = await this.at(model, palm);
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
}

/** Strokes on the demo meshes, as shares of a view's width and height; both look to the right. */
const strokes = {
  camel: { head: [[0.83, 0.14], [0.88, 0.16]], body: [[0.25, 0.38], [0.57, 0.36]], hind: [[0.145, 0.61], [0.1, 0.725]] },
  cow: { head: [[0.84, 0.325], [0.89, 0.363]], body: [[0.2, 0.44], [0.54, 0.42]], hind: [[0.16, 0.6], [0.17, 0.725]] },
};

module.exports = { User, strokes };
