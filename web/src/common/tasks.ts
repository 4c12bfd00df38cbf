/** Pieces of work in; each done in a task of its own, one after the other, so that none takes long. */
export function inTasks([first, ...others]: readonly (() => void)[]): void {
  if (!first) return;
  setTimeout(() => {
    inTasks(others);
    first();
  });
}
