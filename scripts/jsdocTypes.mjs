/**
 * Two lint rules for the types in comments, read as TypeScript reads them. Only a file whose comments have the word that either
 * rule is about is parsed: that takes longer than all other rules together.
 *
 * @import { Rule, SourceCode } from 'eslint'
 * @import { Node, SourceFile } from 'typescript'
 */
import ts from 'typescript';

/** Bracket imports are not seen by dependency-cruiser in every place where TypeScript allows them. */
export const typesByImportTag = typeRule(
  'Import types with @import at the top of the file, where the import rule sees them.',
  /\bimport\s*\(/,
  (node) => ts.isImportTypeNode(node) && !node.isTypeOf, // a module's own type has no other spelling
);

export const noAny = typeRule(
  'Say what it is: no type is any, * or Function.',
  /\bany\b|\bFunction\b|\*/,
  (node) =>
    node.kind === ts.SyntaxKind.AnyKeyword ||
    ts.isJSDocAllType(node) ||
    (ts.isTypeReferenceNode(node) && ts.isIdentifier(node.typeName) && node.typeName.text === 'Function'),
  /@ts-(ignore|nocheck)\b/,
);

/**
 * @param {string} message
 * @param {RegExp} sign  without which in a comment nothing is wrong
 * @param {(node: Node) => boolean} isWrong
 * @param {RegExp} [silencer]  a comment that switches the checks off
 * @returns {Rule.RuleModule}
 */
function typeRule(message, sign, isWrong, silencer) {
  return {
    meta: { type: 'problem', schema: [] },
    create: ({ report, filename, sourceCode }) => ({
      Program() {
        if (commentTexts(sourceCode).some((text) => sign.test(text))) {
          const file = parsed(filename, sourceCode);
          visitAll(file, (node) => {
            if (isWrong(node)) report({ loc: sourceCode.getLocFromIndex(node.getStart(file)), message });
          });
        }
        for (const { value, loc } of silencer ? sourceCode.getAllComments() : []) {
          if (loc && silencer?.test(value))
            report({ loc, message: `${message} Where that cannot be had, @ts-expect-error with the reason.` });
        }
      },
    }),
  };
}

/** Of comments that hold types, from where they begin, without the stars at the beginnings of lines. @param {SourceCode} sourceCode */
const commentTexts = (sourceCode) =>
  sourceCode
    .getAllComments()
    .filter(({ type, value }) => type === 'Block' && value.startsWith('*'))
    .map(({ value }) => value.slice(Math.max(0, value.search(/\{|@(type|enum|this|satisfies)\b/))))
    .map((value) => value.replace(/^\s*\*+/gm, ''));

/** For both rules once. @type {WeakMap<SourceCode, SourceFile>} */
const files = new WeakMap();

/** @param {string} filename @param {SourceCode} sourceCode */
function parsed(filename, sourceCode) {
  const known = files.get(sourceCode);
  if (known) return known;
  const file = ts.createSourceFile(filename, sourceCode.text, ts.ScriptTarget.Latest, false, ts.ScriptKind.JS);
  files.set(sourceCode, file);
  return file;
}

/**
 * @param {Node} node
 * @param {(node: Node) => void} visit
 */
function visitAll(node, visit) {
  visit(node);
  const { jsDoc = [] } = /** @type {{ jsDoc?: Node[] }} */ (/** @type {unknown} */ (node)); // not in the published types
  for (const comment of jsDoc) visitAll(comment, visit);
  ts.forEachChild(node, (child) => visitAll(child, visit));
}
