// Debian's Chromium without a display, drawing by SwiftShader, and a server for what it loads.
import { createServer } from 'node:http';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import puppeteer from 'puppeteer-core';

const here = dirname(fileURLToPath(import.meta.url));
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.json': 'application/json', '.png': 'image/png' };

/** Serves node_modules as /npm, clients, the folder with the exports as /out, and files in memory by their path. */
export async function serve(exportsFolder, memory = {}) {
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname));
    const send = (body, type) => {
      response.writeHead(200, { 'content-type': type, 'cache-control': 'no-store' });
      response.end(body);
    };
    if (memory[path])
      return send(memory[path], 'application/octet-stream');
    const file = path.startsWith('/npm/') ? join(here, 'node_modules', path.slice(5))
      : path.startsWith('/clients/') ? join(here, path) : path.startsWith('/out/') ? join(exportsFolder, path.slice(5)) : null;
    if (!file || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404);
      return response.end();
    }
    send(readFileSync(file), types[extname(file)] ?? 'application/octet-stream');
  });
  await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

export const chromium = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);

export function launch() {
  return puppeteer.launch({
    executablePath: chromium,
    args: ['--headless=new', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox', '--disable-dev-shm-usage'],
    protocolTimeout: 280000,
  });
}

/** A page with a client that has started; errors of the page are thrown by whatever is asked of it. */
export async function openClient(browser, url, client, settings) {
  const page = await browser.newPage();
  const said = [];
  page.on('console', message => said.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', error => said.push('error: ' + error.message));
  page.on('requestfailed', request => said.push('failed: ' + request.url()));
  page.on('response', response => { if (response.status() >= 400) said.push(`${response.status()}: ${response.url()}`); });
  await page.goto(`${url}/clients/page.html`);
  await page.waitForFunction(() => window.ready);
  try {
    await page.evaluate((c, s) => window.start(c, s), client, settings);
  } catch (error) {
    throw new Error(`${client}: ${error.message.split('\n')[0]}\n${said.slice(-12).join('\n')}`);
  }
  return {
    said,
    close: () => page.close(),
    async picture(what) {
      const text = await page.evaluate(w => window.picture(w), what);
      return Buffer.from(text, 'base64');
    },
  };
}
