// Balls of radius 1 as a .glb file, for engines that take their materials from glTF: one node a material, named by it.

/** Rings of a sphere whose normals are its positions. */
function sphere(rings, segments) {
  const positions = [], indices = [];
  for (let i = 0; i <= rings; ++i)
    for (let j = 0; j <= segments; ++j) {
      const theta = Math.PI * i / rings, phi = 2 * Math.PI * j / segments;
      positions.push(Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi));
    }
  for (let i = 0; i < rings; ++i)
    for (let j = 0; j < segments; ++j) {
      const a = i * (segments + 1) + j, b = a + segments + 1;
      indices.push(a, b, b + 1, a, b + 1, a + 1);
    }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** @param roughnesses of the metal balls; a white one without reflection is added */
export function ballsGlb(roughnesses) {
  const { positions, indices } = sphere(160, 320);
  const binary = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(indices.buffer)]);
  const materials = roughnesses.map(roughness => ({
    name: 'metal' + Math.round(100 * roughness),
    pbrMetallicRoughness: { metallicFactor: 1, roughnessFactor: roughness },
  }));
  materials.push({
    name: 'diffuse',
    pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 1 },
    extensions: { KHR_materials_ior: { ior: 1 } }, // F0 = 0
  });
  const json = {
    asset: { version: '2.0' },
    extensionsUsed: ['KHR_materials_ior'],
    scene: 0,
    scenes: [{ nodes: materials.map((_, i) => i) }],
    nodes: materials.map((material, i) => ({ name: material.name, mesh: i })),
    meshes: materials.map((_, i) => ({ primitives: [{ attributes: { POSITION: 0, NORMAL: 0 }, indices: 1, material: i }] })),
    materials,
    accessors: [
      { bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3', min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: positions.byteLength, target: 34962 },
      { buffer: 0, byteOffset: positions.byteLength, byteLength: indices.byteLength, target: 34963 },
    ],
    buffers: [{ byteLength: binary.length }],
  };
  const padded = (buffer, fill) => Buffer.concat([buffer, Buffer.alloc((4 - buffer.length % 4) % 4, fill)]);
  const chunk = (type, data) => {
    const header = Buffer.alloc(8);
    header.writeUInt32LE(data.length, 0);
    header.writeUInt32LE(type, 4);
    return Buffer.concat([header, data]);
  };
  const chunks = Buffer.concat([chunk(0x4e4f534a, padded(Buffer.from(JSON.stringify(json)), 0x20)), chunk(0x004e4942, padded(binary, 0))]);
  const header = Buffer.alloc(12);
  header.writeUInt32LE(0x46546c67, 0);
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(12 + chunks.length, 8);
  return Buffer.concat([header, chunks]);
}
