// SPDX-License-Identifier: GPL-3.0-or-later
// Types of bspline-curve. Arrays of points have 3 numbers of each, arrays of faces 3 ids of each, one after the other.

/** Where the module's .wasm is, or its bytes; if not given, beside index.js. Await it before anything else. */
export function init(source?: string | URL | ArrayBuffer | ArrayBufferView): Promise<void>;

/** What is wrong with an input, and what helps. */
export class InputError extends Error {
  /** "pick-too-far", "unreadable-file" … as in Python; "cancelled", "memory", "internal", "crashed". */
  readonly code: string;
  /** Ids of the faces, vertices or picks concerned, from 0 on. */
  readonly elements: number[];
}

/** 3 numbers of each point: a typed array, or a list of numbers or of lists of 3. */
export type Points = Float64Array | Float32Array | readonly number[] | readonly (readonly number[])[];
export type Ids = Int32Array | Uint32Array | readonly number[] | readonly (readonly number[])[];
/** Called now and then with a share of [0, 1] and the name of a stage; gives up by returning false. */
export type Progress = (fraction: number, stage: string) => unknown;

/** Kinds of fields, see docs/FIELDS.md. */
export type FieldKind =
  | "normal-variation" | "maximal-curvature" | "ridge" | "valley" | "crease-distance" | "boundary-distance" | "quality"
  | "obstacle";

/** See docs/PARAMETERS.md, which has all of them. */
export interface CurveOptions {
  closed?: boolean;
  degree?: 2 | 3 | 4;
  /** 0: as smooth as possible … 1: as straight as possible. */
  tension?: number;
  /** A length, or "1.5 edges". */
  pick_tolerance?: number | string;
  /** Picks at which the curve turns, from 0 on, or "all". */
  corners?: Ids | "all";
  /** Directions in which the curve passes picks, by their numbers from 0 on; of a corner two, before it and after it. */
  tangents?: { [pick: number]: readonly number[] | readonly [readonly number[] | null, readonly number[] | null] };
  field_weight?: number;
  samples?: number;
  preset?: "default" | "paper";
  [advanced: string]: unknown;
}

export interface MeshOptions {
  /** Refuses a mesh that would have to be mended. */
  strict?: boolean;
  /** Joins vertices within so many diagonals. */
  weld?: number;
  /** Leaves edges open that lie on each other. */
  slits?: boolean;
  shell?: "local" | "full" | "simplified" | "preset";
  progress?: Progress;
}

declare abstract class Held {
  /** Frees its memory at once. What nothing refers to is freed some time later. */
  free(): void;
}

/** A validated triangle mesh, prepared for curves; it does not change. Throws InputError. */
export class Mesh extends Held {
  constructor(vertices: Points, faces: Ids, options?: MeshOptions);
  /** A file: .ply, .obj, .off or .stl, by the end of its name. */
  static read(name: string, bytes: ArrayBuffer | Uint8Array, options?: MeshOptions): Mesh;
  readonly vertices: Float64Array;
  readonly faces: Int32Array;
  /** Of vertices, 0 to 255, 3 of each; null: the file has none. */
  readonly colours: Uint8Array | null;
  /** u and v of the 3 corners of each face; null: the file has none. */
  readonly texture_coordinates: Float64Array | null;
  readonly diagonal: number;
  readonly components: number;
  /** What was mended; empty: nothing. */
  readonly mending: string;
  readonly notes: string[];
  /** A smooth curve through points; `start`: a curve through as many, each near, to go on from. */
  curve(
    picks: Points,
    options?: CurveOptions & { field?: FieldKind | "none" | "auto" | Float64Array; avoid?: Ids; start?: Curve; progress?: Progress },
  ): Curve;
  /** A smooth curve along a line near the mesh, nowhere farther from it than the deviation. */
  fit(line: Points, options?: FitOptions & { closed?: boolean }): Curve;
  /** Likewise along the boundaries of some faces, or between `labels`, one of each face. */
  fit_boundary(faces: Ids | null, options?: FitOptions & { labels?: Ids }): { curves: Curve[]; notes: string[] };
  /** Curves of a file, exactly where they were drawn, or projected. */
  read_curves(name: string, bytes: ArrayBuffer | Uint8Array): { curves: Curve[]; notes: string[] };
  /** A value for each vertex. */
  field(kind?: FieldKind, options?: { quality?: Float64Array; region?: Ids; progress?: Progress; [option: string]: unknown }): Float64Array;
  /** The closest points of the mesh. */
  project(points: Points): { faces: Int32Array; barycentrics: Float64Array; points: Float64Array };
  /** Makes curves edges of a copy of the mesh. */
  imprint(curves: Curve | Curve[], options?: { snap?: number; progress?: Progress }): Imprint;
  /** imprint(curves).cut(options) */
  cut(curves: Curve | Curve[], options?: CutOptions & { snap?: number }): Pieces;
  /** imprint(curves).segment(options) */
  segment(curves: Curve | Curve[], options?: { split?: boolean; snap?: number }): Pieces;
  /** The bytes of a file; its format by the end of its name. */
  save(name: string): Uint8Array;
}

export interface FitOptions {
  /** A length, or "1.5 edges"; 0: a mean edge, and no smoother than the line's own noise asks for. */
  deviation?: number | string;
  /** Where the line turns by so many degrees, the curve has a corner; 180: none. */
  corner_angle?: number;
  degree?: 2 | 3 | 4;
  tension?: number;
  samples?: number;
  max_segment_length?: number;
  progress?: Progress;
}

export type Unit = "mm" | "cm" | "m" | "um" | "in" | "ft";

/** A polyline on a mesh, and the B-spline that was projected onto it; it does not change. */
export class Curve extends Held {
  private constructor();
  readonly closed: boolean;
  readonly points: Float64Array;
  /** Where the points are: a face, and 3 barycentric coordinates. */
  readonly faces: Int32Array;
  readonly barycentrics: Float64Array;
  /** Parameters of the points. */
  readonly t: Float64Array;
  /** Which points the picks are. */
  readonly picks: Int32Array;
  /** Which picks are corners. */
  readonly corners: Int32Array;
  readonly degree: number;
  readonly knots: Float64Array;
  readonly control_points: Float64Array;
  readonly pick_parameters: Float64Array;
  readonly length: number;
  /** Whether it passes the picks and is within its tolerance of the surface. */
  readonly usable: boolean;
  readonly status: string;
  readonly seconds: number;
  /** Of an offset curve: largest error, in distances. */
  readonly deviation: number;
  readonly notes: string[];
  pick_points(): Float64Array;
  redraw(picks: Points, options?: { progress?: Progress }): Curve;
  move(pick: number, position: readonly number[] | Float64Array, options?: { progress?: Progress }): Curve;
  /** Curves at a distance along the surface, the longest first. */
  offset(distance: number, side?: "left" | "right" | "both", options?: { progress?: Progress }): Curve[];
  /** The bytes of a file: .json, .ply, .obj, .dxf, .vtu, .csv, .step, .iges … */
  save(name: string, unit?: Unit): Uint8Array;
  static save(curves: Curve[], name: string, unit?: Unit): Uint8Array;
}

export interface CutOptions {
  keep?: "all" | "largest" | "smallest" | "inside" | "outside" | "seed";
  /** For keep "seed": "x y z; x y z …" */
  seed?: string;
  drop_untouched?: boolean;
  fill?: "none" | "flat" | "smooth";
  split?: boolean;
  /** Lengths in the unit of the mesh. A relief moves the parts to keep along their normals, and keeps the whole mesh. */
  relief?: number;
  profile?: "step" | "ramp" | "round";
  profile_width?: number;
  /** Parts become closed walls, outwards or, below 0, inwards. */
  thickness?: number;
  /** Parts become solids: their rims go to a plane so far beyond them, or at a height along a direction "x y z". */
  base?: number;
  base_direction?: string;
  base_height?: number;
  progress?: Progress;
}

export interface Pieces {
  /** `labels`: for each face its part; `parts`: those that the piece has. */
  pieces: { mesh: Mesh; labels: Int32Array; parts: number[] }[];
  dropped: number[];
  filled_holes: number;
  notes: string[];
}

/** Curves as edges of a copy of a mesh, and the parts between them. */
export class Imprint extends Held {
  private constructor();
  readonly vertices: Float64Array;
  readonly faces: Int32Array;
  /** For each face, that of the mesh which it is part of. */
  readonly parents: Int32Array;
  /** For each face its part, from the largest area on. */
  readonly labels: Int32Array;
  readonly crossings: Int32Array;
  readonly largest_move: number;
  readonly parts: { faces: number; area: number; perimeter: number; centroid: number[]; euler: number }[];
  mesh(): Mesh;
  /** The mesh opened along the curves, whole or in parts, holes filled. */
  cut(options?: CutOptions): Pieces;
  /** The same without opening it. */
  segment(options?: { split?: boolean; progress?: Progress }): Pieces;
}

/** A ray into the scene through the pointer's pixel. */
export interface PointerRay {
  start: readonly number[];
  direction: readonly number[];
  /** Width of a pixel: at distance 1 from the start, or anywhere where the view is orthographic. */
  pixel: number;
  orthographic?: boolean;
  snaps?: boolean;
  removes?: boolean;
  /** A drag draws a line freehand, which becomes a curve, or replaces the stretch of the one that it begins and ends at. */
  strokes?: boolean;
}

export type SessionKey =
  | "add" | "move" | "next" | "previous" | "next_curve" | "remove" | "close" | "new_curve" | "kind" | "undo" | "redo" | "cancel";

export type SessionEvent =
  | ({ event: "press" | "move" | "release" } & PointerRay)
  | ({ event: "key"; key: SessionKey } & PointerRay)
  | { event: "leave" };

/** The options that a session draws with. */
export interface DrawnOptions {
  closed?: boolean;
  degree?: number;
  tension?: number;
  pick_tolerance?: number | string;
  field?: string;
  field_weight?: number;
  avoid?: string;
  avoid_threshold?: number;
}

/** Smooth in the fairest direction, smooth in a direction of its own, a corner, or one with a direction on either side. */
export type PickKind = "automatic" | "aligned" | "corner" | "free";
/** In the order of their numbers. */
export const PICK_KINDS: readonly PickKind[];

export interface SketchCurve {
  id: number;
  name: string;
  colour: [number, number, number];
  hidden: boolean;
  options: Required<DrawnOptions>;
  picks: Float64Array;
  /** Of each pick, the number of its PickKind. */
  kinds: Int32Array;
  /**
   * Of each pick, 3 numbers: the direction in which the curve goes on and that in which it comes, which differ at corners
   * alone, zero where there is none; the normal of its face.
   */
  tangents: Float64Array;
  tangents_before: Float64Array;
  normals: Float64Array;
  /** How far from automatic picks the curve may pass, in the unit of the mesh. */
  leeway: number;
  /** What is to be shown; empty: there is no curve yet. */
  points: Float64Array;
  length: number;
  settled: boolean;
  usable: boolean;
  notes: string[];
  /** Why there is none, and the picks concerned. */
  problem?: { message: string; picks: number[] };
}

export interface SessionState {
  curves: SketchCurve[];
  /** Index of the curve that picks are added to; -1: none. */
  active: number;
  selected: number;
  /** `handle`: of the pick's direction, 1 the one ahead, -1 the one behind, 0: none. */
  hovered: { curve: number; pick: number; after: number; handle: number };
  /** The line that is being drawn freehand; empty: none. */
  stroke: Float64Array;
  dragging: boolean;
  can_undo: boolean;
  can_redo: boolean;
  snapped: string;
  preview: Float64Array | null;
  is_settled: boolean;
}

/** Drawing with a mouse, a pen or fingers, without a window. */
export class Session extends Held {
  /**
   * `radii`: how near the pointer must come, in pixels; `handles`: so far from the selected pick are the handles of its
   * direction, 0: there are none.
   */
  constructor(mesh: Mesh, options?: DrawnOptions & { radii?: { pick: number; curve: number }; handles?: number });
  readonly mesh: Mesh;
  readonly state: SessionState;
  /** Whether the session took it; what it did not take is the camera's. */
  event(event: SessionEvent): boolean;
  /** Solves one curve that waits; whether what is to be seen changed. */
  update(): boolean;
  /** Solves all. */
  settle(): void;
  /** `tangents_before`: of corners where the curve comes in another direction than it goes on in. */
  add_curve(picks: Points, options?: DrawnOptions & { corners?: Ids; tangents?: Points; tangents_before?: Points }): void;
  /** The same for several, as one step of the history. */
  add_curves(curves: (DrawnOptions & { picks: Points; corners?: Ids; tangents?: Points; tangents_before?: Points })[]): void;
  /** Of a pick of the active curve. */
  set_kind(pick: number, kind: PickKind): void;
  set_options(options: DrawnOptions, how?: { live?: boolean }): void;
  set_look(curve: number, look: { name?: string; colour?: [number, number, number]; hidden?: boolean }): void;
  set_colour(colour: [number, number, number]): void;
  select(curve: number, pick?: number): void;
  new_curve(): void;
  remove_curve(curve: number): void;
  set_closed(closed: boolean): void;
  undo(): void;
  redo(): void;
  /** Adds the curves of a file; what is not as it was saved. */
  open(name: string, bytes: ArrayBuffer | Uint8Array, how?: { first?: boolean }): string[];
  /** The bytes of a drawing, to be gone on with: .json, .obj or .dxf. */
  save(name: string): Uint8Array;
  /** The bytes of a file of all picks: .pp for MeshLab, .mrk.json for 3D Slicer, .csv, .xyz. */
  save_picks(name: string): Uint8Array;
  /** One that is settled, to be used. */
  curve(index: number): Curve;
}
