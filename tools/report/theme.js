// Light and dark: as the system has it, until the button says otherwise.

const dark = matchMedia("(prefers-color-scheme: dark)");

export function is_dark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : dark.matches;
}

/** Sets up the button; `changed` is called whenever the theme is another. */
export function theme_button(button, changed) {
  const refresh = () => {
    button.textContent = is_dark() ? "Light" : "Dark";
    button.setAttribute("aria-label", is_dark() ? "Switch to the light theme" : "Switch to the dark theme");
    changed();
  };
  button.addEventListener("click", () => {
    document.documentElement.dataset.theme = is_dark() ? "light" : "dark";
    refresh();
  });
  dark.addEventListener("change", refresh);
  refresh();
}
