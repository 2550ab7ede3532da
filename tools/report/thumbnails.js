// Small pictures of surfaces, drawn one after the other by one renderer.
import * as THREE from "three";
import { extents, fitting_distance, make_camera, make_renderer } from "./panes.js";
import { surface_material } from "./surface.js";

export class Thumbnails {
  constructor(width, height) {
    const canvas = document.createElement("canvas");
    this.renderer = make_renderer(canvas);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera = make_camera();
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.material = surface_material();
  }

  /** A picture as a data URL. */
  draw(surface) {
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(surface.geometry, this.material));
    this.camera.position.z = fitting_distance(extents([surface]), this.camera.aspect);
    this.renderer.render(scene, this.camera);
    const picture = this.renderer.domElement.toDataURL("image/png");
    surface.geometry.dispose();
    return picture;
  }
}
