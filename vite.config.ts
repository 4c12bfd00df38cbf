// How the app is served and built. In: web/. Out: dist/, which works under any sub-path of any host.
import { defineConfig, type Plugin } from 'vite';

/** While developing, Vite puts styles into the page and talks over a socket: the policy allows both. */
function developmentPolicy(): Plugin {
  return {
    name: 'development-policy',
    apply: 'serve',
    transformIndexHtml: (html, { server }) =>
      server
        ? html
            .replace("style-src 'self'", "style-src 'self' 'unsafe-inline'")
            .replace("connect-src 'self'", "connect-src 'self' ws:")
        : html,
  };
}

export default defineConfig({
  root: 'web',
  base: './',
  plugins: [developmentPolicy()],
  worker: { format: 'es' },
  build: {
    outDir: '../dist',
    emptyOutDir: true,
    target: 'es2022',
    // The policy of index.html allows no data: scripts or fetches.
    assetsInlineLimit: 0,
    // three.js is larger than the usual limit; `npm run sizes` watches what a visitor downloads.
    chunkSizeWarningLimit: 800,
  },
});
