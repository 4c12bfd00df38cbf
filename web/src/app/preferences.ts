/**
 * What the page remembers of a person's taste between visits: language, theme, open panels. A browser
 * that refuses storage simply forgets.
 */
export interface Preferences {
  readonly get: (key: string) => string | null;
  readonly set: (key: string, value: string) => void;
}

const prefix = 'keypose.';

export function createPreferences(storage: () => Storage): Preferences {
  const attempt = <T>(use: (storage: Storage) => T): T | null => {
    try {
      return use(storage());
    } catch {
      return null;
    }
  };
  return {
    get: (key) => attempt((store) => store.getItem(prefix + key)),
    set: (key, value) => {
      attempt((store) => store.setItem(prefix + key, value));
    },
  };
}
