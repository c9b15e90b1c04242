// The prefilter of an engine that runs in a browser, as files: node prefilter.mjs ENGINE PROBE.hdr FOLDER
// Writes FOLDER/LEVEL_FACE.pfm (px nx py ny pz nz), each face's first row in the texture on top, and prints how long the engine took, in seconds
// of the browser's software OpenGL.
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch, openClient, serve } from './browser.mjs';

const [engine, probe, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: prefilter.mjs three|babylon PROBE.hdr FOLDER');
  process.exit(2);
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
