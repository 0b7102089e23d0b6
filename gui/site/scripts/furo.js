// Stands for the theme's own script, which Debian has as a module that browsers refuse to load from a folder. Does what
// pages need of it: the button that switches between the light and the dark look, and remembers.
const themes = ["auto", "light", "dark"];

function switchTheme() {
  const next = themes[(themes.indexOf(document.body.dataset.theme) + 1) % themes.length];
  document.body.dataset.theme = next;
  localStorage.setItem("theme", next);
}

window.addEventListener("DOMContentLoaded", () => {
  document.documentElement.classList.remove("no-js");
  for (const button of document.getElementsByClassName("theme-toggle")) button.addEventListener("click", switchTheme);
});
