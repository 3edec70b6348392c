/** libxml2, to judge what we write and read. It knows nothing of our table. */
import { readFileSync } from 'node:fs';
import { validateXML } from 'xmllint-wasm';

const read = (/** @type {string} */ path) => readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8');

export const PUBLISHED_SCHEMA = read('public/schema/robot-model-1.0.xsd');
export const DRAFT_SCHEMA = read('tests/fixtures/xml/robot-model-1.0-draft.xsd');

/**
 * @param {readonly string[]} texts
 * @param {string} [schema]
 * @returns {Promise<string[][]>} for each text what libxml2 has against it; nothing when it is valid
 */
export async function schemaErrors(texts, schema = PUBLISHED_SCHEMA) {
  if (texts.length === 0) return [];
  const xml = texts.map((contents, i) => ({ fileName: `${i}.xml`, contents }));
  const { errors } = await validateXML({ xml, schema: [schema], maxMemoryPages: 4096 });
  return xml.map(({ fileName }) =>
    errors.filter(({ loc }) => loc?.fileName === fileName).map(({ message }) => message),
  );
}
