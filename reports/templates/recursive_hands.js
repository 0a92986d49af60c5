// The page of recursive Wang tiles: stamps, buttons and files.
"use strict";

const stampSide = 128;

/** A stamp: draw(context) in a square from -1 to 1, y upwards. */
function stampOf(draw) {
  const stamp = Object.assign(document.createElement("canvas"), { width: stampSide, height: stampSide });
  const context = stamp.getContext("2d");
  context.setTransform(stampSide / 2, 0, 0, -stampSide / 2, stampSide / 2, stampSide / 2);
  draw(context);
  return stamp;
}

const dotStamp = (color) => stampOf((context) => {
  context.fillStyle = color;
  context.arc(0, 0, 0.85, 0, 2 * Math.PI);
  context.fill();
});

const leafStamp = (color, vein) => stampOf((context) => {
  context.fillStyle = color;
  context.moveTo(-0.95, 0);
  context.bezierCurveTo(-0.4, 0.7, 0.4, 0.55, 0.95, 0);
  context.bezierCurveTo(0.4, -0.55, -0.4, -0.7, -0.95, 0);
  context.fill();
  context.strokeStyle = vein;
  context.lineWidth = 0.05;
  context.beginPath();
  context.moveTo(-0.95, 0);
  context.lineTo(0.85, 0);
  for (const x of [-0.5, -0.15, 0.2])
    for (const side of [-1, 1]) {
      context.moveTo(x, 0);
      context.lineTo(x + 0.3, side * 0.3);
    }
  context.stroke();
});

/** A picture as large as fits into the square. */
const pictureStamp = (picture) => stampOf((context) => {
  const longest = Math.max(picture.width, picture.height);
  context.scale(1, -1);
  context.drawImage(picture, -picture.width / longest, -picture.height / longest, (2 * picture.width) / longest, (2 * picture.height) / longest);
});

const ownStamps = { given: [], picture: [] };

/** The chosen stamps, and the part of their width that they are as wide as; no stamps before a picture is there. */
function stampsNow() {
  const which = byId("stamps").value;
  const ink = getComputedStyle(canvas).color;
  const all = {
    dots: () => [dotStamp(ink)],
    leaves: () => [["#4c8c2b", "#2f6118"], ["#7fae3a", "#4f7a1d"], ["#c9a227", "#8a6a10"], ["#a8552b", "#6f3212"]].map((colors) => leafStamp(...colors)),
    given: () => ownStamps.given,
    picture: () => ownStamps.picture,
  }[which]();
  return [all, which === "dots" ? 0.5 / 0.85 : 1]; // dots are half as wide as stamps
}

function showStamps() {
  const [all, part] = stampsNow();
  if (all.length > 0) drawing.setStamps(all, part);
  drawing.paper = [...getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).slice(0, 3).map((c) => c / 255), 1];
  redraw();
}

/** Reads the stamps that the page was made with. */
async function readGiven() {
  const urls = Array.from(document.querySelectorAll("#given-stamps span"), (span) => `data:image/png;base64,${span.textContent.trim()}`);
  try {
    for (const url of urls) {
      const image = new Image();
      image.src = url;
      await image.decode();
      ownStamps.given.push(pictureStamp(image));
    }
  } catch (error) {
    byId("said").textContent = "A stamp of this page is no picture that this browser reads";
    ownStamps.given = [];
  }
  byId("stamps").querySelector("[value=given]").hidden = ownStamps.given.length === 0;
  if (ownStamps.given.length > 0) byId("stamps").value = "given";
  showStamps();
}

byId("stamp-picture").addEventListener("change", async (event) => {
  const file = event.target.files[0];
  if (!file) return;
  try {
    ownStamps.picture = [pictureStamp(await createImageBitmap(file))];
  } catch (error) {
    byId("said").textContent = `${file.name}: is no picture that this browser reads`;
    return;
  }
  byId("stamps").querySelector("[value=picture]").hidden = false;
  byId("stamps").value = "picture";
  showStamps();
});

function goHome() {
  Object.assign(state, { tile: [Address.parse("0"), Address.parse("0")], at: [0.5, 0.5], zoom: 256 });
}

byId("place").addEventListener("change", (event) => {
  const place = event.target.value.split(/[\s,;]+/).filter((word) => word !== "").map(Address.parse);
  if (place.length !== 2 || !place.every(Boolean) || place[0].digits.length !== place[1].digits.length) {
    byId("said").textContent = `${event.target.value}: must be two tiles of one level, such as -5:0132 7:3301`;
    return;
  }
  byId("said").textContent = "";
  Object.assign(state, { tile: place, at: [0.5, 0.5], zoom: 256 });
  redraw();
});
for (const slider of ["spacing", "stamp-size", "brush", "brush-size"]) byId(slider).addEventListener("input", redraw);
byId("stamps").addEventListener("change", showStamps);
byId("empty").addEventListener("click", () => newSheet(0));
byId("full").addEventListener("click", () => newSheet(255));

// Diving zooms in without end, and says how many frames a second the browser draws. Words that change with each frame cannot
// be read, and laying them out takes a browser milliseconds: they follow four times a second.
let dive = null;
let saidAt = 0;
let nextDive = 0;
function diveOn(now) {
  if (!dive) return;
  dive.push(now);
  if (dive.length > 60) dive.shift();
  const passed = dive.length > 1 ? now - dive[dive.length - 2] : 0;
  zoomBy(2 ** (Math.min(100, passed) / 1000), 40 * Math.sin(now / 3000), 40 * Math.cos(now / 2000));
  drawPicture();
  if (now - saidAt > 250) sayDive(now);
  nextDive = requestAnimationFrame(diveOn);
}

function sayDive(now) {
  saidAt = now;
  const seconds = (now - dive[0]) / 1000;
  if (seconds > 0.5) byId("frames").textContent = `${((dive.length - 1) / seconds).toFixed(0)} frames a second`;
  showWords();
}

byId("dive").addEventListener("change", (event) => {
  dive = event.target.checked ? [] : null;
  byId("frames").textContent = "";
  cancelAnimationFrame(nextDive); // one frame is asked for at a time
  if (dive) nextDive = requestAnimationFrame(diveOn);
  else showWords();
});

byId("save-csv").addEventListener("click", () => {
  const seen = seenWindow();
  if (perTile() * seen.size[0] * seen.size[1] > mostSaved) {
    byId("said").textContent = "Too many points are in view: give them more room";
    return;
  }
  save(new Blob([csvOf(windowPoints(seen), drawing.stamps)], { type: "text/plain" }), "points.csv");
});
byId("save-png").addEventListener("click", () => transparentPicture().canvas.toBlob((blob) => save(blob, "painting.png")));
byId("save-density").addEventListener("click", () => layerPicture().toBlob((blob) => save(blob, "density.png")));
for (const button of document.querySelectorAll("[data-copy]"))
  button.addEventListener("click", () => {
    const shown = byId(button.dataset.copy);
    if (navigator.clipboard) navigator.clipboard.writeText(shown.href || shown.textContent).catch(() => {});
    getSelection().selectAllChildren(shown);
  });

canvas.addEventListener("webglcontextlost", () => (byId("said").textContent = "The browser took WebGL2 away: open this page again"));
addEventListener("hashchange", readAddress);
addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", showStamps);
byId("stamp-size").value = about.stampSize;
if (!readAddress()) goHome();
showStamps();
readGiven();
drawNow();
