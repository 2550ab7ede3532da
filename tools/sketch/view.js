// One model: its surface, what is drawn over it, and the camera that looks at it. Nothing is drawn until `request`
// says that something changed.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { css } from "../report/colors.js";
import { extents, fitting_distance, make_camera, make_renderer, turn_around } from "../report/panes.js";
import { Surface, surface_material } from "../report/surface.js";

const hidden_below = 0.01; // of the model's diagonal
const upright = new THREE.Vector3(0, 1, 0);
const svg = "http://www.w3.org/2000/svg";
const dot_size = 0.009;

function row_major(matrix) {
  return matrix.clone().transpose().elements.slice();
}

function hex(color) {
  return new THREE.Color(...color);
}

export class View {
  /** @param picture SVG over the canvas; @param facts of the model, as the server gives them; @param mesh its positions and facets */
  constructor(canvas, picture, facts, mesh) {
    this.canvas = canvas;
    this.names = document.createElementNS(svg, "g");
    this.line = document.createElementNS(svg, "polyline");
    for (const [name, value] of Object.entries({ fill: "none", "stroke-width": 4, "stroke-linecap": "round", "stroke-linejoin": "round" })) {
      this.line.setAttribute(name, value);
    }
    picture.replaceChildren(this.line, this.names);
    this.facts = facts;
    this.surface = new Surface(mesh, []);
    const [x, , z] = extents([this.surface]);
    // Seen from its longer side at first, what looked to the front now to the right.
    this.home = x < z ? -Math.PI / 2 : 0;
    this.own_half = this.half = this.extents_seen(this.surface);
    this.material = surface_material();
    this.scene = new THREE.Scene();
    this.overlay = new THREE.Group();
    const drawn = new THREE.Mesh(this.surface.geometry, this.material);
    drawn.frustumCulled = false;
    this.scene.add(drawn, this.overlay);
    this.renderer = make_renderer(canvas);
    this.camera = make_camera();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = 0.3;
    this.controls.maxDistance = 10;
    this.fitted = 0;
    this.pending = false;
    this.turned = () => {}; // called when the user turns the model
    this.controls.addEventListener("change", () => {
      this.request();
      this.turned();
    });
    new ResizeObserver(() => this.request()).observe(canvas);
  }

  extents_seen(surface) {
    const [x, y, z] = extents([surface]);
    return this.home === 0 ? [x, y, z] : [z, y, x];
  }

  /** Steps back so far that other positions of the vertices are seen, too; null: as far as the model's own need. */
  make_room(positions) {
    const other = positions ? this.extents_seen({ positions }) : [0, 0, 0];
    this.half = this.own_half.map((extent, i) => Math.max(extent, other[i]));
    this.request();
  }

  request() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.draw();
    });
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.fit();
    this.renderer.render(this.scene, this.camera);
  }

  /** Keeps what the user sees when the view changes its shape. */
  fit() {
    const distance = fitting_distance(this.half, this.camera.aspect);
    if (distance === this.fitted) return;
    const { target } = this.controls;
    if (this.fitted === 0) {
      this.camera.position.set(0, 0, distance).applyAxisAngle(upright, this.home);
    } else {
      this.camera.position.sub(target).multiplyScalar(distance / this.fitted).add(target);
    }
    this.fitted = distance;
    this.camera.lookAt(target);
    this.camera.updateMatrixWorld();
  }

  /** Looks from where another view does, compared with how both looked at first. */
  follow(other) {
    const turn = this.home - other.home;
    const from = other.camera.position.clone().sub(other.controls.target).applyAxisAngle(upright, turn);
    this.controls.target.copy(other.controls.target).applyAxisAngle(upright, turn);
    this.camera.position.copy(from).multiplyScalar(this.fitted / other.fitted).add(this.controls.target);
    this.camera.lookAt(this.controls.target);
    this.camera.updateMatrixWorld();
    this.request();
  }

  reset() {
    this.controls.target.set(0, 0, 0);
    this.camera.position.set(0, 0, this.fitted).applyAxisAngle(upright, this.home);
    this.controls.update();
    this.request();
  }

  /** Turns by steps of angle about the upright and the sideways axis. */
  turn(sideways, upwards) {
    turn_around(this.controls, sideways, upwards);
  }

  /** The camera of a stroke (partwise/sketch-1), which sees the model in its own units. */
  stroke_camera() {
    this.camera.updateMatrixWorld();
    const { center, diagonal } = this.facts;
    const from_model = new THREE.Matrix4()
      .makeScale(1 / diagonal, 1 / diagonal, 1 / diagonal)
      .multiply(new THREE.Matrix4().makeTranslation(-center[0], -center[1], -center[2]));
    return {
      view: row_major(this.camera.matrixWorldInverse.clone().multiply(from_model)),
      projection: row_major(this.camera.projectionMatrix),
      viewport: [this.canvas.clientWidth, this.canvas.clientHeight],
    };
  }

  /** The pixel of this view under the pointer. */
  pixel(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** What a pixel shows: {facet, barycentric, point}; null for the background. */
  pick([x, y]) {
    return this.#hit_through(
      this.camera.matrixWorld.clone().multiply(this.camera.projectionMatrixInverse),
      (2 * x) / this.canvas.clientWidth - 1,
      1 - (2 * y) / this.canvas.clientHeight,
    );
  }

  #hit_through(from_clip, x, y) {
    const near = new THREE.Vector3(x, y, -1).applyMatrix4(from_clip);
    const along = new THREE.Vector3(x, y, 1).applyMatrix4(from_clip).sub(near).normalize();
    const hit = this.surface.hit(near.toArray(), along.toArray());
    return hit && { ...hit, point: this.surface.point(hit.facet, hit.barycentric) };
  }

  /** Model units to the frame of the page. */
  #placed(point) {
    return point.map((value, i) => (value - this.facts.center[i]) / this.facts.diagonal);
  }

  vertex(v) {
    return Array.from(this.surface.positions.subarray(3 * v, 3 * v + 3));
  }

  /** Where an entry of a sketch (marker or anchor) lies. */
  place_of(entry) {
    if (entry.vertex !== undefined) return this.vertex(entry.vertex);
    if (entry.face !== undefined) return this.surface.point(entry.face, entry.barycentric);
    return this.#placed(entry.point);
  }

  /** The vertex nearest to a hit. */
  corner(hit) {
    const largest = hit.barycentric.indexOf(Math.max(...hit.barycentric));
    return this.surface.facets[3 * hit.facet + largest];
  }

  /** The points of a stroke on the surface, in pieces where it left the model. */
  stroke_pieces(stroke) {
    if (stroke.vertices) return [stroke.vertices.map((v) => this.vertex(v))];
    if (stroke.points) return [stroke.points.map((p) => this.#placed(p))];
    const { view, projection, viewport } = stroke.camera;
    const { center, diagonal } = this.facts;
    const to_model = new THREE.Matrix4()
      .makeTranslation(...center)
      .multiply(new THREE.Matrix4().makeScale(diagonal, diagonal, diagonal));
    const from_clip = new THREE.Matrix4()
      .set(...projection)
      .multiply(new THREE.Matrix4().set(...view))
      .multiply(to_model)
      .invert();
    const pieces = [[]];
    for (const [x, y] of stroke.screen) {
      const hit = this.#hit_through(from_clip, (2 * x) / viewport[0] - 1, 1 - (2 * y) / viewport[1]);
      if (hit) pieces.at(-1).push(hit.point);
      else if (pieces.at(-1).length > 0) pieces.push([]);
    }
    return pieces.filter((piece) => piece.length > 0);
  }

  /** Colours the facets: `labels` gives each one's part, `colors` that part's colour; without labels all are plain. */
  paint(labels, colors, plain) {
    const asked = JSON.stringify([colors, plain]);
    if (labels === this.surface.labels && asked === this.painted) return; // nothing new: it takes long on a large model
    this.painted = asked;
    this.surface.labels = labels;
    this.surface.parts = colors.map((color) => ({ color }));
    this.surface.paint(labels ? "parts" : "plain", plain);
    this.request();
  }

  /** Positions of another view's frame, turned so that this view shows at first what that one does. */
  turned_from(other, positions) {
    const turn = this.home - other.home;
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const turned = new Float32Array(positions.length);
    for (let i = 0; i < positions.length; i += 3) {
      const [x, y, z] = positions.subarray(i, i + 3);
      turned.set([c * x + s * z, y, c * z - s * x], i);
    }
    return turned;
  }

  move_vertices(positions) {
    this.surface.place(positions);
    this.request();
  }

  /**
   * Replaces what lies over the surface.
   * @param curves a list of {points, closed, color, width}, the width in diagonals of the model
   * @param dots a list of {point, color, hollow}
   */
  cover(curves, dots) {
    this.overlay.traverse((object) => object.geometry?.dispose());
    this.overlay.clear();
    for (const { points, closed, color, width } of curves) this.overlay.add(this.#tube(points, closed, color, width));
    for (const { point, color, hollow } of dots) {
      const shape = hollow
        ? new THREE.TorusGeometry(dot_size, dot_size / 4, 8, 20)
        : new THREE.SphereGeometry(dot_size, 16, 12);
      const dot = new THREE.Mesh(shape, new THREE.MeshBasicMaterial({ color: hex(color) }));
      dot.position.set(...point);
      // Rings face the user.
      if (hollow) dot.onBeforeRender = () => dot.quaternion.copy(this.camera.quaternion);
      this.overlay.add(dot);
    }
    this.request();
  }

  #tube(points, closed, color, width) {
    const material = new THREE.MeshBasicMaterial({ color: hex(color) });
    const places = points.map((p) => new THREE.Vector3(...p));
    if (places.length === 1) {
      const dot = new THREE.Mesh(new THREE.SphereGeometry(width, 10, 8), material);
      dot.position.copy(places[0]);
      return dot;
    }
    const path = new THREE.CurvePath();
    const corners = closed ? [...places, places[0]] : places;
    for (let i = 1; i < corners.length; ++i) {
      if (corners[i].distanceTo(corners[i - 1]) > 0) path.add(new THREE.LineCurve3(corners[i - 1], corners[i]));
    }
    if (path.curves.length === 0) return this.#tube(points.slice(0, 1), false, color, width);
    const segments = Math.min(corners.length, 2000);
    return new THREE.Mesh(new THREE.TubeGeometry(path, segments, width, 5, false), material);
  }

  /** Where a point appears, in pixels. */
  project(point) {
    const { x, y } = new THREE.Vector3(...point).project(this.camera);
    return [((x + 1) / 2) * this.canvas.clientWidth, ((1 - y) / 2) * this.canvas.clientHeight];
  }

  /** Whether no other part of the surface hides a point from the user. */
  is_visible(point) {
    const hit = this.pick(this.project(point));
    const distance = (p) => this.camera.position.distanceTo(new THREE.Vector3(...p));
    return !hit || distance(hit.point) > distance(point) - hidden_below;
  }

  /** Draws the stroke that is being made, given in pixels. */
  trail(pixels, color) {
    this.line.setAttribute("points", pixels.map((p) => p.join(",")).join(" "));
    this.line.setAttribute("stroke", css(color));
  }

  /** Writes next to points of the surface; texts are a list of {point, text}. */
  name(texts) {
    this.names.replaceChildren(...texts.map(({ point, text }) => {
      const [x, y] = this.project(point);
      const label = document.createElementNS(svg, "text");
      label.setAttribute("x", x + 9);
      label.setAttribute("y", y - 6);
      label.textContent = text;
      return label;
    }));
  }
}
