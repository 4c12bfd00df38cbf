// Memory as the system counts it (Linux only): of a program the peak of its resident memory; of a page the peak
// of its processes' less what they took before. What a page can ask about itself leaves much out.
import { existsSync, readFileSync } from 'node:fs';

function kilobytes(pid, field) {
  const status = readFileSync(`/proc/${pid}/status`, 'utf8');
  return Number(new RegExp(`^${field}:\\s*(\\d+) kB`, 'm').exec(status)?.[1] ?? 0);
}

/** Bytes of a process at the peak; null where they cannot be known or it has ended. */
export function peakBytesOf(pid) {
  try {
    return kilobytes(pid, 'VmHWM') * 1024 || null;
  } catch {
    return null;
  }
}

/** The renderers of one browser, from now on. */
export class RendererMemory {
  constructor(pids) {
    this.before = pids.map((pid) => ({ pid, kb: kilobytes(pid, 'VmRSS') }));
  }

  static async of(browser) {
    if (!existsSync('/proc/self/status')) return new RendererMemory([]);
    const session = await browser.newBrowserCDPSession();
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    const renderers = processInfo.filter(({ type }) => type === 'renderer');
    return new RendererMemory(renderers.map(({ id }) => id));
  }

  /** Bytes at the peak; null where they cannot be known. */
  peakBytes() {
    return this.grownBytes('VmHWM');
  }

  /** Bytes now; null where they cannot be known. */
  nowBytes() {
    return this.grownBytes('VmRSS');
  }

  /** A spare renderer takes no part and adds nothing. */
  grownBytes(field) {
    const grown = this.before
      .filter(({ pid }) => existsSync(`/proc/${pid}/status`))
      .map(({ pid, kb }) => kilobytes(pid, field) - kb);
    return grown.length === 0 ? null : Math.max(...grown) * 1024;
  }
}
