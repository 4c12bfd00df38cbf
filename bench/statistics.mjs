// Numbers for reading: series go in; medians with their extremes, and tables of text, come out.

/** `{ median, min, max }` of the values; null without values. */
export function spread(values) {
  if (values.length === 0) return null;
  const sorted = [...values].sort((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  const median = (sorted[Math.floor(middle)] + sorted[Math.ceil(middle)]) / 2;
  return { median, min: sorted[0], max: sorted.at(-1) };
}

/** MB/s of each run. */
export function speeds(bytes, times_ms) {
  return times_ms.map((ms) => bytes / 1e6 / (ms / 1e3));
}

/**
 * How many times shorter some runs are than others: median by median, and the quickest by the quickest,
 * which other work on the machine disturbs least.
 */
export function ratios(times_ms, others_ms) {
  const [ours, theirs] = [spread(times_ms), spread(others_ms)];
  return { ofMedians: theirs.median / ours.median, ofQuickest: theirs.min / ours.min };
}

/** A number with one decimal below 10, none above. */
export function digits(value) {
  return value < 10 ? value.toFixed(1) : value.toFixed(0);
}

/** `median (min–max)`, or a dash. */
export function told(found) {
  if (found === null) return '–';
  return `${digits(found.median)} (${digits(found.min)}–${digits(found.max)})`;
}

/** A Markdown table whose columns line up. */
export function table(header, rows) {
  const all = [header, ...rows].map((row) => row.map(String));
  const widths = header.map((_, column) => Math.max(...all.map((row) => row[column].length)));
  const line = (row) => `| ${row.map((cell, column) => cell.padEnd(widths[column])).join(' | ')} |`;
  const rule = `|${widths.map((width) => '-'.repeat(width + 2)).join('|')}|`;
  return [line(all[0]), rule, ...all.slice(1).map(line)].join('\n');
}
