// The prefilter of an engine that runs in a browser, as files: node prefilter.mjs ENGINE PROBE.hdr FOLDER
// Writes FOLDER/LEVEL_FACE.pfm (px nx py ny pz nz), each face's first row in the texture on top - of PlayCanvas FOLDER/atlas.png, its bytes as
// they are - and prints how long the engine took, in seconds of the browser's software OpenGL.
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';
import { launch, openClient, serve } from './browser.mjs';

const [engine, probe, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: prefilter.mjs three|babylon|playcanvas PROBE.hdr FOLDER');
  process.exit(2);
}
/** Of PNG's chunks; bit by bit, for it is one picture. */
function crc32(bytes) {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit)
      sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

/** A .png file of RGBA bytes. */
function png(rgba, edge) {
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type), data]), size = Buffer.alloc(4), sum = Buffer.alloc(4);
    size.writeUInt32BE(data.length);
    sum.writeUInt32BE(crc32(body));
    return Buffer.concat([size, body, sum]);
  };
  const head = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, 8, 6, 0, 0, 0]), rows = Buffer.alloc(edge * (4 * edge + 1)); // each row begins with its filter, 0
  head.writeUInt32BE(edge, 0);
  head.writeUInt32BE(edge, 4);
  for (let y = 0; y < edge; ++y)
    rgba.copy(rows, y * (4 * edge + 1) + 1, 4 * edge * y, 4 * edge * (y + 1));
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head), chunk('IDAT', deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
}

const root = mkdtempSync(join(tmpdir(), 'mirrorball-prefilter-'));
copyFileSync(probe, join(root, 'probe.hdr'));
mkdirSync(folder, { recursive: true });
const browser = await launch();
const server = await serve(root);
try {
  const page = await openClient(browser, server.url, 'prefilter', { folder: '/out', name: 'probe', engine });
  const floats = buffer => new Float32Array(buffer.buffer, buffer.byteOffset, buffer.length / 4);
  const [size, levels, milliseconds] = floats(await page.picture({}));
  if (levels === 0)
    writeFileSync(join(folder, 'atlas.png'), png(Buffer.from(floats(await page.picture({ atlas: true }))), size));
  for (let level = 0; level < levels; ++level)
    for (const [face, word] of ['px', 'nx', 'py', 'ny', 'pz', 'nz'].entries()) {
      const edge = Math.max(1, size >> level), rgb = floats(Buffer.from(await page.picture({ level, face })));
      const rows = Buffer.alloc(rgb.length * 4); // a PFM's rows run from the bottom
      for (let y = 0; y < edge; ++y)
        Buffer.from(rgb.buffer, rgb.byteOffset + 12 * edge * y, 12 * edge).copy(rows, 12 * edge * (edge - 1 - y));
      writeFileSync(join(folder, `${level}_${word}.pfm`), Buffer.concat([Buffer.from(`PF\n${edge} ${edge}\n-1.0\n`), rows]));
    }
  console.log((milliseconds / 1000).toFixed(3));
} finally {
  await browser.close();
  server.close();
  rmSync(root, { recursive: true, force: true });
}
