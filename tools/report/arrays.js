// What the tool put into the page: facts as JSON, and one block of numbers from which `numbers` cuts arrays.

export const facts = JSON.parse(document.getElementById("facts").textContent);

/** Octets of base64. */
export function decoded(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

const block = decoded(document.getElementById("arrays").textContent).buffer;
const types = { f32: Float32Array, u32: Uint32Array, u8: Uint8Array };

/** The array at a place {type, offset, count}, or an array itself; null for none. */
export function numbers(place) {
  if (ArrayBuffer.isView(place)) return place;
  return place ? new types[place.type](block, place.offset, place.count) : null;
}
