// On every page: guides are open on paper, whatever their state on the screen.
"use strict";

const closedGuides = [];

function openGuides() {
  for (const guide of document.querySelectorAll("details.guide:not([open])")) {
    closedGuides.push(guide);
    guide.open = true;
  }
}

function closeGuidesAgain() {
  for (const guide of closedGuides.splice(0)) guide.open = false;
}

window.addEventListener("beforeprint", openGuides);
window.addEventListener("afterprint", closeGuidesAgain);
window.matchMedia("print").addEventListener("change", (event) => (event.matches ? openGuides() : closeGuidesAgain()));
