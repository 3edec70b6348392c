/**
 * Two lint rules for the types in comments, read as TypeScript reads them.
 *
 * @import { Rule } from 'eslint'
 * @import { Node } from 'typescript'
 */
import ts from 'typescript';

/** Bracket imports are not seen by dependency-cruiser in every place where TypeScript allows them. */
export const typesByImportTag = typeRule(
  'Import types with @import at the top of the file, where the import rule sees them.',
  (node) => ts.isImportTypeNode(node) && !node.isTypeOf, // a module's own type has no other spelling
);

export const noAny = typeRule(
  'Say what it is: no type is any, * or Function.',
  (node) =>
    node.kind === ts.SyntaxKind.AnyKeyword ||
    ts.isJSDocAllType(node) ||
    (ts.isTypeReferenceNode(node) && ts.isIdentifier(node.typeName) && node.typeName.text === 'Function'),
  /@ts-(ignore|nocheck)\b/,
);

/**
 * @param {string} message
 * @param {(node: Node) => boolean} isWrong
 * @param {RegExp} [silencer]  a comment that switches the checks off
 * @returns {Rule.RuleModule}
 */
function typeRule(message, isWrong, silencer) {
  return {
    meta: { type: 'problem', schema: [] },
    create: ({ report, filename, sourceCode }) => ({
      Program() {
        const file = ts.createSourceFile(filename, sourceCode.text, ts.ScriptTarget.Latest, true, ts.ScriptKind.JS);
        visitAll(file, (node) => {
          if (isWrong(node)) report({ loc: sourceCode.getLocFromIndex(node.getStart(file)), message });
        });
        for (const { value, loc } of silencer ? sourceCode.getAllComments() : []) {
          if (loc && silencer?.test(value))
            report({ loc, message: `${message} Where that cannot be had, @ts-expect-error with the reason.` });
        }
      },
    }),
  };
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
