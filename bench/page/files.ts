/** The files given to the page: names go in, Files and bytes come out. */

function input(): HTMLInputElement {
  return document.querySelector<HTMLInputElement>('#files')!;
}

/** The file of this name, still on disk. */
export function fileNamed(name: string): File {
  const file = [...(input().files ?? [])].find((one) => one.name === name);
  if (file === undefined) throw new Error(`${name} was not given to the page`);
  return file;
}

/** The bytes of each file of these names, in memory. */
export function bytesOf(names: readonly string[]): Promise<Uint8Array<ArrayBuffer>[]> {
  return Promise.all(
    names.map(async (name) => new Uint8Array(await fileNamed(name).arrayBuffer())),
  );
}
