// SPDX-License-Identifier: GPL-3.0-or-later
// A camera about a point of interest: turned like a ball, without an up.
import { PerspectiveCamera, Quaternion, Vector3 } from "three";

const FIELD_OF_VIEW = 35; // degrees, vertical
const NEAREST = 0.01; // of the radius
const FARTHEST = 40;
const FROM = new Vector3(0.45, -0.75, 0.6).normalize(); // where a new mesh is looked at from

export class Camera {
  three = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 100);
  #target = new Vector3();
  #distance = 1;
  #radius = 1;
  #height = 1; // of the view, pixels

  resize(width, height) {
    this.#height = height;
    this.three.aspect = width / Math.max(1, height);
    this.#place();
  }

  /** Shows all within this radius about the origin. */
  fit(radius, isNew = false) {
    this.#radius = radius;
    this.#target.set(0, 0, 0);
    const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * Math.min(1, this.three.aspect);
    this.#distance = (radius / Math.sin(Math.atan(half))) * 1.05;
    if (isNew) {
      this.three.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), FROM);
    }
    this.#place();
  }

  #place() {
    const back = new Vector3(0, 0, 1).applyQuaternion(this.three.quaternion);
    this.three.position.copy(this.#target).addScaledVector(back, this.#distance);
    const depth = this.three.position.length() + 1.5 * this.#radius;
    this.three.far = depth;
    this.three.near = Math.max(this.#distance - this.#target.length() - 1.5 * this.#radius, depth / 5000);
    this.three.updateProjectionMatrix();
    this.three.updateMatrixWorld();
  }

  /** By pixels: a drag over the height of the view turns by half a turn. */
  turn(dx, dy) {
    const share = Math.PI / this.#height;
    const turn = (axis, angle) =>
      new Quaternion().setFromAxisAngle(new Vector3(...axis).applyQuaternion(this.three.quaternion), angle);
    this.three.quaternion.premultiply(turn([0, 1, 0], -dx * share)).premultiply(turn([1, 0, 0], -dy * share)).normalize();
    this.#place();
  }

  move(dx, dy) {
    const right = new Vector3(1, 0, 0).applyQuaternion(this.three.quaternion);
    const up = new Vector3(0, 1, 0).applyQuaternion(this.three.quaternion);
    const pixel = this.pixel * this.#distance;
    this.#target.addScaledVector(right, -dx * pixel).addScaledVector(up, dy * pixel);
    this.#place();
  }

  zoom(factor) {
    this.#distance = Math.min(Math.max(this.#distance * factor, NEAREST * this.#radius), FARTHEST * this.#radius);
    this.#place();
  }

  /** Width of a pixel at distance 1. */
  get pixel() {
    return (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360)) / this.#height;
  }

  /** The ray through a place of the view, in shares of [-1, 1] with y upwards. */
  rayThrough(x, y) {
    const start = this.three.position;
    const direction = new Vector3(x, y, 0.5).unproject(this.three).sub(start).normalize();
    return { start: start.toArray(), direction: direction.toArray() };
  }
}
