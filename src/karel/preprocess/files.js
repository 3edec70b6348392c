/** A file by its name, or by the end of its path, with .kl or without; \ and / are the same. @param {Readonly<Record<string, string>>} files @param {string} name */
export function fileNamed(files, name) {
  const wanted = name.replaceAll('\\', '/').toLowerCase();
  const isIt = (/** @type {string} */ key) => {
    const path = key.replaceAll('\\', '/').toLowerCase();
    return [path, path.replace(/\.kl$/, '')].some(
      (one) => `/${one}`.endsWith(`/${wanted}`) || wanted.endsWith(`/${one}`),
    );
  };
  const key = Object.keys(files).find(isIt);
  return key === undefined ? undefined : files[key];
}
