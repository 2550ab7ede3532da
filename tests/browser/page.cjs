// Opens a page in a headless browser and looks at what it draws.
const { chromium, firefox } = require("playwright-core");

const browser_name = process.env.PARTWISE_BROWSER || "chromium";

/** Starts Chromium or, for PARTWISE_BROWSER=firefox-esr, Firefox as Debian has it; both draw by software. */
function launch() {
  if (browser_name === "chromium") {
    return chromium.launch({
      executablePath: "/usr/bin/chromium",
      args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
  }
  return firefox.launch({
    executablePath: "/usr/bin/firefox-esr",
    channel: "moz-firefox", // driven by WebDriver BiDi, as any Firefox can be
    env: { ...process.env, MOZ_WEBGL_FORCE_EGL: "1" }, // GLX would need an X server
    firefoxUserPrefs: { "webgl.force-enabled": true, "services.settings.server": "data:,none" }, // which it asks by itself
  });
}

/** A page with all that it complains of, and all addresses that it asks for. */
async function open_page(browser, file, { colorScheme = "light", width = 1280, height = 720 } = {}) {
  const page = await browser.newPage({ viewport: { width, height }, colorScheme });
  const complaints = [];
  const requests = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!request.url().startsWith("data:")) requests.push(request.url());
  });
  await page.goto("file://" + file);
  return { page, complaints, requests };
}

/** Lets the page draw what was asked for. */
async function settled(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))));
}

/** A picture of the two views, kept in the page under a name. Captions, above and below, are left out. */
async function shoot(page, name) {
  await settled(page);
  const png = (await page.locator("#canvas").screenshot()).toString("base64");
  await page.evaluate(async ([key, data]) => {
    const image = new Image();
    image.src = "data:image/png;base64," + data;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const top = 30;
    (window.shots ??= {})[key] = context.getImageData(0, top, image.width, image.height - 2 * top);
  }, [name, png]);
}

/** Share of a half's pixels (0 left, 1 right) that `rule` ([r, g, b] -> boolean, as text) holds for. */
function share(page, name, half, rule) {
  return page.evaluate(([key, side, text]) => {
    const holds = new Function("r", "g", "b", `return ${text};`);
    const { width, height, data } = window.shots[key];
    const [from, to] = side === 0 ? [2, width / 2 - 2] : [width / 2 + 2, width - 2];
    let count = 0;
    for (let y = 0; y < height; ++y) {
      for (let x = Math.ceil(from); x < to; ++x) {
        const i = 4 * (y * width + x);
        if (holds(data[i], data[i + 1], data[i + 2])) ++count;
      }
    }
    return count / (height * (to - from));
  }, [name, half, rule]);
}

/** Share of a half's pixels that differ visibly between two pictures. */
function difference(page, a, b, half) {
  return page.evaluate(([first, second, side]) => {
    const [p, q] = [window.shots[first], window.shots[second]];
    if (p.width !== q.width || p.height !== q.height) return 1;
    const [from, to] = side === 0 ? [2, p.width / 2 - 2] : [p.width / 2 + 2, p.width - 2];
    let count = 0;
    for (let y = 0; y < p.height; ++y) {
      for (let x = Math.ceil(from); x < to; ++x) {
        const i = 4 * (y * p.width + x);
        if ([0, 1, 2].some((c) => Math.abs(p.data[i + c] - q.data[i + c]) > 8)) ++count;
      }
    }
    return count / (p.height * (to - from));
  }, [a, b, half]);
}

/** Share of a half that is not background. */
async function covered(page, name, half) {
  const [r, g, b] = await page.evaluate((key) => Array.from(window.shots[key].data.slice(0, 3)), name);
  return share(page, name, half, `Math.abs(r - ${r}) + Math.abs(g - ${g}) + Math.abs(b - ${b}) > 24`);
}

module.exports = { browser_name, launch, open_page, shoot, share, difference, covered, settled };
