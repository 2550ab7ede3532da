// One surface of the run as something to draw: corners of facets, each with normal, colour and pattern coordinates.
import * as THREE from "three";
import { MeshBVH } from "three-mesh-bvh";
import { numbers } from "./arrays.js";
import { field_color, folded, lightened } from "./colors.js";

const vertex_shader = `
attribute vec3 color;
attribute vec3 pattern;
varying vec3 v_normal;
varying vec3 v_color;
varying vec3 v_pattern;
void main() {
  v_normal = normalMatrix * normal;
  v_color = color;
  v_pattern = pattern;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragment_shader = `
uniform float cell;
uniform float contrast;
uniform float dimmed;
varying vec3 v_normal;
varying vec3 v_color;
varying vec3 v_pattern;
const float pi = 3.14159265;
void main() {
  vec3 n = normalize(v_normal);
  float outside = gl_FrontFacing ? 1.0 : -1.0;
  n *= outside;
  float key = max(dot(n, normalize(vec3(-0.35, 0.55, 0.8))), 0.0);
  float fill = max(dot(n, normalize(vec3(0.7, 0.1, 0.6))), 0.0);
  vec3 color = v_color;
  if (cell > 0.0) {
    vec3 p = v_pattern / cell;
    vec3 edge = clamp(sin(pi * p) / (pi * fwidth(p) + 1e-6), -1.0, 1.0);
    color = mix(color, color * 0.42, 0.5 + 0.5 * edge.x * edge.y * edge.z);
  }
  if (outside < 0.0) color = mix(color, vec3(0.35), dimmed);
  float light = 0.36 + 0.6 * key + 0.14 * fill;
  gl_FragColor = vec4(color * mix(0.95, light, contrast), 1.0);
}`;

export function surface_material() {
  return new THREE.ShaderMaterial({
    // Size of a cell of the pattern, 0 for none; how strong the shading is, less where colours are values; how much
    // the inside is greyed.
    uniforms: { cell: { value: 0 }, contrast: { value: 1 }, dimmed: { value: 0.6 } },
    vertexShader: vertex_shader,
    fragmentShader: fragment_shader,
    side: THREE.DoubleSide,
    // Edges and marks lie on the surface: they win.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}

/** A colour as one number, of which the lowest octet comes first in memory. */
function octets(color) {
  const [r, g, b] = color.map((c) => Math.round(255 * Math.min(Math.max(c, 0), 1)));
  return (r | (g << 8) | (b << 16) | (255 << 24)) >>> 0;
}

function vertex_normals(positions, facets) {
  const normals = new Float32Array(positions.length);
  for (let i = 0; i < facets.length; i += 3) {
    const n = facet_normal(positions, facets, i);
    for (let j = 0; j < 3; ++j) {
      for (let c = 0; c < 3; ++c) normals[3 * facets[i + j] + c] += n[c];
    }
  }
  return normals; // the shader brings them to length 1
}

function facet_normal(p, facets, i) {
  const a = 3 * facets[i], b = 3 * facets[i + 1], c = 3 * facets[i + 2];
  const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
  const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
  return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
}

export class Surface {
  /** @param facts what the page knows of the surface; `positions` replaces those it has. */
  constructor(facts, parts) {
    this.facts = facts;
    this.parts = parts;
    this.family = facts.family;
    this.positions = numbers(facts.positions);
    this.facets = numbers(facts.facets);
    this.labels = numbers(facts.parts);
    this.pattern = numbers(facts.pattern);
    this.geometry = new THREE.BufferGeometry();
    for (const name of ["position", "normal", "pattern"]) {
      this.geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * this.facets.length), 3));
    }
    // Four octets a corner: threes are slow to read. The fourth is not used.
    this.geometry.setAttribute("color", new THREE.BufferAttribute(new Uint8Array(4 * this.facets.length), 4, true));
    this.spread(this.pattern ?? this.positions, "pattern");
    this.place(this.positions);
  }

  get linked_facets() {
    return this.facts.caps_from ?? this.facets.length / 3;
  }

  /** Gives every corner the three numbers of its vertex. */
  spread(values, name) {
    const attribute = this.geometry.getAttribute(name);
    for (let i = 0; i < this.facets.length; ++i) {
      const v = 3 * this.facets[i];
      for (let c = 0; c < 3; ++c) attribute.array[3 * i + c] = values[v + c];
    }
    attribute.needsUpdate = true;
  }

  /** Moves the vertices. */
  place(positions) {
    this.positions = positions;
    this.tree = null;
    this.spread(positions, "position");
    if (this.facts.flat) {
      const normals = this.geometry.getAttribute("normal");
      for (let i = 0; i < this.facets.length; i += 3) {
        const n = facet_normal(positions, this.facets, i);
        for (let j = 0; j < 9; ++j) normals.array[3 * i + j] = n[j % 3];
      }
      normals.needsUpdate = true;
    } else {
      this.spread(vertex_normals(positions, this.facets), "normal");
    }
    this.geometry.computeBoundingSphere();
    this.edges?.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  }

  /** Whether `paint` has something to show in this way. */
  can_paint(mode) {
    if (mode === "plain" || mode === "parts") return true;
    if (mode === "pattern") return this.pattern !== null;
    return Boolean(this.facts.fields?.[mode]);
  }

  /** Colours the facets: plain, parts, pattern, or the name of a field. */
  paint(mode, plain) {
    const shown = this.can_paint(mode) ? mode : "plain";
    const field = this.facts.fields?.[shown];
    const values = numbers(field?.values);
    const parts = shown === "parts" ? this.parts.map(({ color }) => color) : [plain];
    const packed = [parts, parts.map((c) => lightened(c, 0.75))].map((colors) => Uint32Array.from(colors, octets));
    const corners = new Uint32Array(this.geometry.getAttribute("color").array.buffer);
    for (let i = 0; i < corners.length; ++i) {
      const facet = (i / 3) | 0;
      const light = facet >= this.linked_facets ? 1 : 0;
      if (field) {
        const c = field_color(shown, values[field.per === "facet" ? facet : this.facets[i]], field);
        corners[i] = octets(light ? lightened(c, 0.75) : c);
      } else {
        corners[i] = packed[light][shown === "parts" ? this.labels[facet] : 0];
      }
    }
    this.geometry.getAttribute("color").needsUpdate = true;
    return shown;
  }

  /** Every edge once, as a geometry for lines. */
  edge_geometry() {
    if (this.edges) return this.edges;
    const pairs = [];
    const seen = new Set();
    for (let i = 0; i < this.facets.length; ++i) {
      const a = this.facets[i];
      const b = this.facets[i % 3 === 2 ? i - 2 : i + 1];
      const key = a < b ? a * 4294967296 + b : b * 4294967296 + a;
      if (seen.has(key)) continue;
      seen.add(key);
      pairs.push(a, b);
    }
    this.edges = new THREE.BufferGeometry();
    this.edges.setAttribute("position", new THREE.BufferAttribute(this.positions, 3));
    this.edges.setIndex(pairs);
    return this.edges;
  }

  /** The folded facets, red, a little lifted; null when there are none. */
  folded_mesh() {
    if (!this.facts.folded) return null;
    // They show their inside, being turned over: as red as any.
    const material = surface_material();
    material.uniforms.dimmed.value = 0;
    material.uniforms.contrast.value = 0.4;
    const geometry = new THREE.BufferGeometry();
    const positions = numbers(this.facts.folded.positions);
    const colors = new Float32Array(positions.length);
    for (let i = 0; i < positions.length; i += 3) colors.set(folded, i);
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
    geometry.setAttribute("pattern", new THREE.BufferAttribute(positions, 3));
    geometry.computeVertexNormals();
    return new THREE.Mesh(geometry, material);
  }

  /** The point with barycentric coordinates [u, v, w] in a facet. */
  point(facet, [u, v, w]) {
    const [a, b, c] = [0, 1, 2].map((j) => 3 * this.facets[3 * facet + j]);
    const p = this.positions;
    return [0, 1, 2].map((i) => u * p[a + i] + v * p[b + i] + w * p[c + i]);
  }

  /** The first facet that a ray meets, with barycentric coordinates; null for none. The first call takes longer. */
  hit(origin, direction) {
    this.tree ??= this.#search_tree();
    const ray = new THREE.Ray(new THREE.Vector3(...origin), new THREE.Vector3(...direction));
    const found = this.tree.raycastFirst(ray, THREE.DoubleSide);
    return found && { facet: found.faceIndex, barycentric: this.#coordinates(found.faceIndex, found.point) };
  }

  #search_tree() {
    const shape = new THREE.BufferGeometry();
    shape.setAttribute("position", new THREE.BufferAttribute(this.positions, 3));
    shape.setIndex(new THREE.BufferAttribute(this.facets, 1));
    return new MeshBVH(shape, { indirect: true }); // which keeps the order of the facets
  }

  #coordinates(facet, point) {
    const [a, b, c] = [0, 1, 2].map((j) => new THREE.Vector3().fromArray(this.positions, 3 * this.facets[3 * facet + j]));
    return THREE.Triangle.getBarycoord(point, a, b, c, new THREE.Vector3()).toArray();
  }
}
