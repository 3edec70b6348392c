/**
 * npm start: builds the page, serves the build and prints its address until Ctrl-C.
 * Options: --port 4173 (or the next free one), --host to be reached from other machines too.
 */
import { parseArgs } from 'node:util';
import { ensureDependencies } from './ensureDependencies.mjs';

const HELP =
  'Usage: npm start -- [--port 4173] [--host [address]]; without --host, only this machine reaches the page.';

/** @param {string[]} args */
function readOptions(args) {
  // parseArgs wants a value for every text option, and --host may stand alone.
  const spelled = args.flatMap((arg, i) =>
    arg === '--host' && (args[i + 1] ?? '--').startsWith('--') ? ['--host', '0.0.0.0'] : [arg],
  );
  const options = /** @type {const} */ ({
    port: { type: 'string', default: '4173' },
    host: { type: 'string', default: '127.0.0.1' },
  });
  const { port, host } = parseArgs({ args: spelled, options }).values;
  const number = Number(port);
  if (!Number.isInteger(number) || number < 0 || number > 65535) {
    throw new Error(`Expected a port from 0 to 65535, got ${port}. ${HELP}`);
  }
  return { port: number, host };
}

async function main() {
  const { port, host } = readOptions(process.argv.slice(2));
  ensureDependencies();
  const { build, preview } = await import('vite');

  console.log('Building Denavit …');
  await build({ logLevel: 'warn' });
  const server = await preview({ logLevel: 'silent', preview: { port, host, open: false } });
  const addresses = [...(server.resolvedUrls?.local ?? []), ...(server.resolvedUrls?.network ?? [])];
  const got = Number(new URL(addresses[0]).port || 80);
  if (port !== 0 && got !== port) console.log(`Port ${port} is taken, so this is port ${got}.`);
  console.log(`\n  Denavit is at ${addresses.join('  and at ')}\n\n  Ctrl-C ends it.`);

  process.once('SIGINT', () => {
    server.close().finally(() => process.exit(0));
  });
}

try {
  await main();
} catch (error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  const explained =
    code === 'EACCES'
      ? `This port needs more rights than you have; choose one above 1023. ${HELP}`
      : code === 'EADDRNOTAVAIL' || code === 'ENOTFOUND'
        ? `This machine does not have that address. ${HELP}`
        : code?.startsWith('ERR_PARSE_ARGS')
          ? `${message} ${HELP}`
          : message;
  console.error(explained);
  process.exit(1);
}
