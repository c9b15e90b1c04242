// Proves exports in the engines: exports by the command line, pictures of balls by each engine in Chromium, judged by engine_proof.
//   node prove.mjs --mirrorball PROGRAM --proof PROGRAM [--engines three,babylon] [--probes P,...] [--short] [--own] [--plant FAULT] [--size N]
// Exits with 1 where a figure is beyond its limit.
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { ballsGlb } from './balls.mjs';
import { launch, openClient, serve } from './browser.mjs';

const { values: o } = parseArgs({ options: {
  mirrorball: { type: 'string' }, proof: { type: 'string' }, engines: { type: 'string', default: 'three,filament,babylon,babylon-rh,playcanvas,model-viewer' },
  probes: { type: 'string', default: 'builtin:axes' }, short: { type: 'boolean' }, own: { type: 'boolean' }, plant: { type: 'string' },
  size: { type: 'string', default: '128' }, keep: { type: 'string' },
} });
const size = Number(o.size);
const roughnesses = o.short ? [0, 0.5] : [0, 0.1, 0.25, 0.5, 0.75, 1];
const playCanvasRoughnesses = o.short ? [0, 0.5] : [0, 0.2, 0.4, 0.6, 0.8, 1];

// What differs between clients: module, settings, where the eye stands, kinds of pictures.
const clients = {
  three: { client: 'three', kinds: ['diffuse', 'sh'], own: {} },
  filament: { client: 'filament', kinds: ['diffuse'], own: { cmgen: true } },
  babylon: { client: 'babylon', kinds: ['diffuse'], eye: -1, leftHanded: true, own: { own: 'source.hdr' } },
  'babylon-rh': { client: 'babylon', kinds: ['diffuse'], settings: { rightHanded: true }, own: { own: 'source.hdr', yaw: 180 } },
  'model-viewer': { client: 'model-viewer', kinds: ['diffuse'] },
  playcanvas: { client: 'playcanvas', kinds: ['diffuse'], roughnesses: playCanvasRoughnesses, own: { own: 'source.hdr' } },
};

const root = o.keep ?? mkdtempSync(join(tmpdir(), 'mirrorball-engines-'));
mkdirSync(root, { recursive: true });
const browser = await launch();
const server = await serve(root, { '/balls.glb': ballsGlb(roughnesses) });
let failed = 0;
const table = [];

async function prove(word, probe, index) {
  const { client, kinds, settings = {}, eye = 1, leftHanded = false, own, roughnesses: its = roughnesses } = clients[word];
  const folder = `${word}-${index}`, path = join(root, folder);
  mkdirSync(path, { recursive: true });
  if (o.plant)
    execFileSync(o.proof, ['plant', o.plant, client, probe, path]);
  else
    execFileSync(o.mirrorball, ['export', '--probe', probe, '--for', client, '--name', client, '-o', path], { stdio: ['ignore', 'ignore', 'ignore'] });
  const pictures = [];
  const take = async (extra, isOwn) => {
    const page = await openClient(browser, server.url, client, { folder: `/out/${folder}`, name: client, size, ...settings, ...extra });
    const wanted = [...its.map(roughness => ({ kind: 'metal', roughness })), ...kinds.filter(kind => !isOwn || kind !== 'sh').map(kind => ({ kind }))];
    for (const what of wanted) {
      const file = join(path, `${isOwn ? 'own' : 'ours'}-${what.kind}-${what.roughness ?? ''}.raw`);
      writeFileSync(file, await page.picture(what));
      pictures.push({ ...what, file, own: isOwn });
    }
    await page.close();
  };
  await take({}, false);
  if (o.own && own && !o.plant && !(own.cmgen && spawnSync('cmgen', ['--version']).error)) {
    const extra = { own: true, ...own };
    if (own.cmgen) { // Filament's own tool, whose pair stands beside a copy of our script
      const theirs = join(path, 'own');
      execFileSync(o.mirrorball, ['convert', probe, '-o', join(path, 'source.hdr'), '--to', 'latlong', '--size', '512']);
      execFileSync('cmgen', ['-q', '-x', theirs, '-f', 'ktx', '--size=256', join(path, 'source.hdr')], { stdio: 'ignore' });
      for (const part of ['ibl', 'skybox'])
        renameSync(join(theirs, `own_${part}.ktx`), join(theirs, `${client}_${part}.ktx`));
      copyFileSync(join(path, `${client}_filament.js`), join(theirs, `${client}_filament.js`));
      extra.folder = `/out/${folder}/own`;
    } else if (own.own) {
      execFileSync(o.mirrorball, ['convert', probe, '-o', join(path, own.own), '--to', 'latlong', '--size', '512', '--yaw', own.yaw ?? 0]);
    }
    await take(extra, true);
  }
  const manifest = join(path, 'manifest.json');
  writeFileSync(manifest, JSON.stringify({ engine: client, probe, size, eye, left_handed: leftHanded, pictures }));
  const run = spawnSync(o.proof, ['judge', manifest], { encoding: 'utf8' });
  if (run.status !== 0 && run.status !== 1)
    throw new Error(run.stderr.trim());
  return JSON.parse(run.stdout);
}

try {
  for (const [index, probe] of o.probes.split(',').entries())
    for (const word of o.engines.split(',')) {
      let figures;
      try {
        figures = await prove(word, probe, index);
      } catch (error) {
        figures = { 'loads and draws': { value: error.message.split('\n').slice(0, 4).join(' | ').slice(0, 300), passed: false } };
      }
      table.push({ engine: word, probe, figures });
      for (const [name, { value, limit, expected, passed }] of Object.entries(figures)) {
        failed += !passed;
        const shown = typeof value === 'number' ? value.toFixed(4) : value;
        console.log(`${passed ? 'ok  ' : 'FAIL'} ${word.padEnd(11)} ${probe.split('/').pop().padEnd(22)} ${name.padEnd(30)} ${shown}${limit !== undefined ? ` (limit ${limit.toFixed(4)})` : ''}${expected ? ` (expected ${expected})` : ''}`);
      }
    }
} finally {
  await browser.close();
  server.close();
  if (!o.keep)
    rmSync(root, { recursive: true, force: true });
}
console.log(failed ? `${failed} figures are beyond their limits` : 'every figure is within its limit');
process.exit(failed ? 1 : 0);
