/** A file by its name, or by the end of its path, with .kl or without; \ and / are the same. @param {Readonly<Record<string, string>>} files @param {string} name */
export function fileNamed(files, name) {
  const key = keyOf(Object.keys(files), name);
  return key === undefined ? undefined : files[key];
}

/** What the file is called among those that there are; some know no signs in names: kunit.h is kunit_h there. @param {readonly string[]} keys @param {string} name */
export function keyOf(keys, name) {
  const wanted = name.replaceAll('\\', '/').toLowerCase();
  const isIt = (/** @type {string} */ key) => {
    const path = key.replaceAll('\\', '/').toLowerCase();
    return [path, path.replace(/\.kl$/, '')].some(
      (one) => `/${one}`.endsWith(`/${wanted}`) || wanted.endsWith(`/${one}`),
    );
  };
  const bare = plain(wanted);
  return keys.find(isIt) ?? keys.find((key) => plain(key.toLowerCase()) === bare);
}

const plain = (/** @type {string} */ path) => path.replace(/^.*\//, '').replace(/\.kl$/, '').replace(/\W+/g, '_');

const INCLUDE = /^[ \t]*%[ \t]*include[ \t]+["'<]?([^\s"'>]+)/gim;

/** The files that a text includes, as it calls them. @param {string} text */
export const includesOf = (text) =>
  [...text.matchAll(INCLUDE)].map(({ 0: { length }, 1: path, index }) => ({ path, from: index, to: index + length }));
