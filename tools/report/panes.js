// Two views side by side (one above the other on narrow screens) on one canvas, turned together. Nothing is drawn
// until `request` says that something changed.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { surface_material } from "./surface.js";

const turn_step = Math.PI / 24; // of an arrow key
const zoom_step = 1.15;
const view_angle = 28; // degrees
const margin = 1.08; // around the models

// Colours are given as they are to appear.
THREE.ColorManagement.enabled = false;

export function make_renderer(canvas) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.setClearColor(0x000000, 0);
  return renderer;
}

export function make_camera() {
  return new THREE.PerspectiveCamera(view_angle, 1, 0.05, 50);
}

/** Half the extents of all these surfaces along the axes of the page; models lie around the origin. */
export function extents(surfaces) {
  const half = [0.01, 0.01, 0.01];
  for (const { positions } of surfaces) {
    for (let i = 0; i < positions.length; ++i) half[i % 3] = Math.max(half[i % 3], Math.abs(positions[i]));
  }
  return half;
}

/** From how far a view of this aspect shows a box with these half extents. */
export function fitting_distance([x, y, z], aspect) {
  const slope = Math.tan(THREE.MathUtils.degToRad(view_angle) / 2);
  return margin * Math.max(x / aspect, y) / slope + z;
}

/** Turns the camera of orbit controls around what it looks at, by angles about the upright and the sideways axis. */
export function turn_around(controls, sideways, upwards) {
  const offset = controls.object.position.clone().sub(controls.target);
  const spherical = new THREE.Spherical().setFromVector3(offset);
  spherical.theta += sideways;
  spherical.phi = Math.min(Math.max(spherical.phi + upwards, 0.01), Math.PI - 0.01);
  controls.object.position.copy(controls.target).add(offset.setFromSpherical(spherical));
  controls.update();
}

function set_aspect(camera, aspect) {
  camera.aspect = aspect;
  camera.updateProjectionMatrix();
}

class Pane {
  constructor() {
    this.scene = new THREE.Scene();
    this.material = surface_material();
    this.surface = null;
    this.lines = new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.3 });
    this.spot = new THREE.Mesh(
      new THREE.SphereGeometry(0.018, 20, 14),
      new THREE.MeshBasicMaterial({ color: 0xe8007a }),
    );
    this.spot.visible = false;
  }

  /** @param marks lists of {positions, color, size} to draw as dots */
  show(surface, marks, edges) {
    this.scene.clear();
    this.surface = surface;
    if (!surface) return;
    const mesh = new THREE.Mesh(surface.geometry, this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    const folded = surface.folded_mesh();
    if (folded) this.scene.add(folded);
    if (edges) this.scene.add(new THREE.LineSegments(surface.edge_geometry(), this.lines));
    for (const { positions, color, size } of marks) {
      const dot = new THREE.SphereGeometry(size, 14, 10);
      const dots = new THREE.InstancedMesh(dot, new THREE.MeshBasicMaterial({ color }), positions.length / 3);
      const place = new THREE.Matrix4();
      for (let i = 0; i < positions.length; i += 3) {
        dots.setMatrixAt(i / 3, place.makeTranslation(positions[i], positions[i + 1], positions[i + 2]));
      }
      this.scene.add(dots);
    }
    this.scene.add(this.spot);
  }
}

export class Panes {
  /** @param half extents of what is shown, see `extents` */
  constructor(canvas, half) {
    this.canvas = canvas;
    this.half = half;
    this.fitted = 0; // the distance at which everything was last seen
    this.panes = [new Pane(), new Pane()];
    this.renderer = make_renderer(canvas);
    this.renderer.autoClear = false;
    this.camera = make_camera();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.request());
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 20;
    this.pending = false;
    new ResizeObserver(() => this.request()).observe(canvas);
    canvas.addEventListener("keydown", (event) => this.key(event));
    // The wheel scrolls the page until one works with the views.
    this.controls.enableZoom = false;
    canvas.addEventListener("focus", () => (this.controls.enableZoom = true));
    canvas.addEventListener("blur", () => (this.controls.enableZoom = false));
  }

  request() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.draw();
    });
  }

  /** The rectangle of a view on the canvas, in CSS pixels from its upper left corner. */
  rectangle(index) {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    return width >= height
      ? { x: (index * width) / 2, y: 0, width: width / 2, height }
      : { x: 0, y: (index * height) / 2, width, height: height / 2 };
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.fit();
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.panes.forEach((pane, i) => {
      const r = this.rectangle(i);
      const below = height - r.y - r.height;
      this.renderer.setViewport(r.x, below, r.width, r.height);
      this.renderer.setScissor(r.x, below, r.width, r.height);
      set_aspect(this.camera, r.width / r.height);
      this.renderer.render(pane.scene, this.camera);
    });
  }

  /** Keeps what the user sees when the views change their shape. */
  fit() {
    const { width, height } = this.rectangle(0);
    const distance = fitting_distance(this.half, width / height);
    if (distance === this.fitted) return;
    if (this.fitted === 0) {
      this.camera.position.set(0, 0, distance);
    } else {
      this.camera.position.sub(this.controls.target).multiplyScalar(distance / this.fitted).add(this.controls.target);
    }
    this.fitted = distance;
    this.controls.update();
  }

  reset() {
    this.controls.target.set(0, 0, 0);
    this.camera.position.set(0, 0, this.fitted);
    this.camera.up.set(0, 1, 0);
    this.controls.update();
    this.request();
  }

  turn(sideways, upwards) {
    turn_around(this.controls, sideways, upwards);
    this.request();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).divideScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.request();
  }

  key(event) {
    const actions = {
      ArrowLeft: () => this.turn(-turn_step, 0),
      ArrowRight: () => this.turn(turn_step, 0),
      ArrowUp: () => this.turn(0, -turn_step),
      ArrowDown: () => this.turn(0, turn_step),
      "+": () => this.zoom(zoom_step),
      "=": () => this.zoom(zoom_step),
      "-": () => this.zoom(1 / zoom_step),
      0: () => this.reset(),
    };
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action();
  }

  /** What lies under the pointer: {pane, facet, barycentric}; null for nothing. */
  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    for (let i = 0; i < 2; ++i) {
      const r = this.rectangle(i);
      if (x < r.x || x >= r.x + r.width || y < r.y || y >= r.y + r.height) continue;
      const surface = this.panes[i].surface;
      if (!surface) return null;
      set_aspect(this.camera, r.width / r.height);
      this.camera.updateMatrixWorld();
      const origin = this.camera.position;
      const direction = new THREE.Vector3((2 * (x - r.x)) / r.width - 1, 1 - (2 * (y - r.y)) / r.height, 0.5)
        .unproject(this.camera)
        .sub(origin)
        .normalize();
      const hit = surface.hit(origin.toArray(), direction.toArray());
      return hit && { pane: i, ...hit };
    }
    return null;
  }

  /** Puts the spot of a view at a point; null hides it. */
  mark(index, point) {
    const spot = this.panes[index].spot;
    spot.visible = point !== null;
    if (point) spot.position.set(...point);
    this.request();
  }
}
