// The names that poisson_tiles.d.ts declares are those that poisson_tiles.js has, class by class.
//
// Usage: node typed_names.js PACKAGE_FOLDER
"use strict";

const fs = require("fs");
const path = require("path");
const folder = path.resolve(process.argv[2]);
const library = require(folder);
const { TileSet, Tiling } = library;
const declarations = fs.readFileSync(`${folder}/poisson_tiles.d.ts`, "utf8");

const set = new TileSet(fs.readFileSync(`${folder}/tile_sets/corner-c3-n64-r075.ptiles`));
const tiling = new Tiling(set);
// Steps of the look-up, which no user needs.
const ofLookUp = ["after", "before", "color", "corners", "edges", "place"];

const namesOf = (object) => [...Object.keys(object), ...Object.getOwnPropertyNames(Object.getPrototypeOf(object))];
const declaredOf = (kind, name) => {
  const body = declarations.split(`export ${kind} ${name} `)[1].split("\n}")[0];
  return [...body.matchAll(/^ {2}(?:readonly )?(\w+)[(:]/gm)].map((match) => match[1]);
};
const expectSame = (what, found, declared) => {
  const [a, b] = [found, declared].map((names) => [...new Set(names)].sort().join(" "));
  if (a !== b || a.length < 8) throw new Error(`${what} has ${a}\ndeclared are ${b}`);
};

expectSame("TileSet", namesOf(set), declaredOf("class", "TileSet"));
expectSame("Tiling", namesOf(tiling).filter((name) => !ofLookUp.includes(name)), declaredOf("class", "Tiling"));
expectSame("a point", Object.keys(tiling.pointsInWindow([0, 0], [1, 1])[0]), declaredOf("interface", "TilePoint"));
expectSame("the nearest point", Object.keys(tiling.nearest([0, 0])),
           [...declaredOf("interface", "TilePoint"), ...declaredOf("interface", "NearestPoint")]);
expectSame("the package", Object.keys(library),
           [...declarations.matchAll(/^export (?:class|function) (\w+)/gm)].map((match) => match[1]));
