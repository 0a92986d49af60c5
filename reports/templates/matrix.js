// Which pictures a table of series shows: spectra, zone plates, curves or points.
"use strict";

function showKind(section, kind) {
  for (const button of section.querySelectorAll(".switch button"))
    button.setAttribute("aria-pressed", String(button.dataset.kind === kind));
  for (const image of section.querySelectorAll(".matrix img")) image.hidden = image.dataset.kind !== kind;
}

for (const section of document.querySelectorAll(".matrix-section"))
  for (const button of section.querySelectorAll(".switch button"))
    button.addEventListener("click", () => showKind(section, button.dataset.kind));
