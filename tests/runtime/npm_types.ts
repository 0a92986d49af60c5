// What a user writes in TypeScript, for its compiler: nothing here is run. Lines after @ts-expect-error must be refused.
import { TileSet, Tiling, hash, NearestPoint, TilePoint } from "poissonlab-runtime";

const tiling: Tiling = new Tiling(new TileSet(new Uint8Array(128)), 7, 16);
const points: TilePoint[] = tiling.pointsInWindow([0, 0], [16, 9], 0.5);
const near: NearestPoint = tiling.nearest([1e9 + 0.5, 3]);
const sum: number = points.map((point) => point.position[0] + point.level).reduce((a, b) => a + b) + near.squared;
const ranks: number = tiling.set.ranks === null ? hash(1, 2, 3, 4) : tiling.set.ranks[0];
const number: number = tiling.tile(3, -4) + tiling.set.classOf(2) + sum + ranks;

// @ts-expect-error a file's name is not its bytes
new TileSet("corner.ptiles");
// @ts-expect-error a window has two corners
tiling.pointsInWindow([0, 0]);
// @ts-expect-error sets do not change
tiling.set.colors = number;
