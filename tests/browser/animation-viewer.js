// A page that plays a .glb as any viewer built on three.js does; bundled by animation.cjs, which drives it.
import * as three from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

let renderer, scene, camera, mixer, mesh;

/** Loads the file's bytes (base64), shows its first moment, and says what the loader made of it. */
export async function load(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer, "");
  const meshes = [];
  gltf.scene.traverse((object) => object.isMesh && meshes.push(object));
  mesh = meshes[0];
  mixer = new three.AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) mixer.clipAction(clip).play();

  renderer = new three.WebGLRenderer({ canvas: document.querySelector("canvas"), preserveDrawingBuffer: true });
  renderer.setClearColor(0xffffff);
  scene = new three.Scene().add(gltf.scene, new three.HemisphereLight(0xffffff, 0x404040, 3));
  const { center, radius } = new three.Box3().setFromObject(gltf.scene).getBoundingSphere(new three.Sphere());
  camera = new three.PerspectiveCamera(40, renderer.domElement.width / renderer.domElement.height, radius / 10, 10 * radius);
  camera.position.set(1, 0.3, 0.8).setLength(2 * radius).add(center);
  camera.lookAt(center);
  show(0);
  return {
    meshes: meshes.length,
    vertices: mesh.geometry.attributes.position.count,
    corners: mesh.geometry.index.count,
    attributes: Object.keys(mesh.geometry.attributes).sort(),
    targets: mesh.morphTargetInfluences.length,
    targetNames: Object.keys(mesh.morphTargetDictionary),
    animations: gltf.animations.map((clip) => ({ duration: clip.duration, tracks: clip.tracks.length })),
  };
}

/** Draws the moment `seconds` after the beginning. */
export function show(seconds) {
  mixer.setTime(seconds);
  renderer.render(scene, camera);
}

/** All vertices as they are drawn now, in the model's coordinates. */
export function positions() {
  const place = new three.Vector3();
  return Array.from({ length: mesh.geometry.attributes.position.count }, (_, v) => mesh.getVertexPosition(v, place).toArray());
}
