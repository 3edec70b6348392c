/**
 * The published schema and our table brought to one form, so that a test can compare them. The schema is read with the
 * bare parser: nothing of ours stands between.
 *
 * @import { ElementRule } from '../../../src/io/robotXmlTable.js'
 * @import { Facets } from '../../../src/io/valueTypes.js'
 *
 * @typedef {object} Description
 * @property {string} name
 * @property {number} min
 * @property {number} max
 * @property {Record<string, { required: boolean, default: string | null, facets: Facets }>} attributes
 * @property {string} order
 * @property {number | null} maxChildren
 * @property {Description[]} children
 * @property {Facets | null} text
 * @property {boolean} isForeign
 */
import { parseXml, XmlElement } from '@rgrove/parse-xml';

/** @param {ElementRule} rule @returns {Description} */
export function describeRule(rule) {
  const { name, min, max, attributes, order, maxChildren = null, children, text, foreign } = rule;
  const inside = children.map(describeRule);
  return {
    name,
    min,
    max,
    attributes: Object.fromEntries(
      attributes.map((attribute) => [
        attribute.name,
        {
          required: attribute.required,
          default: attribute.default === undefined ? null : attribute.type.write(attribute.default),
          facets: attribute.type.facets,
        },
      ]),
    ),
    order: order === 'choice' || children.length > 0 || foreign ? order : 'all',
    maxChildren,
    children: order === 'choice' ? inside.map(uncounted) : inside,
    text: text?.type.facets ?? null,
    isForeign: foreign !== undefined,
  };
}

/** In a choice the choice is counted, not what is chosen. @param {Description} description */
const uncounted = (description) => ({ ...description, min: 1, max: 1 });

/** @param {string} xsd @returns {Description} */
export function describeSchema(xsd) {
  const schema = /** @type {XmlElement} */ (parseXml(xsd).root);
  const named = new Map(elementsIn(schema).map((element) => [element.attributes.name, element]));
  return describeElement(/** @type {XmlElement} */ (named.get('robotModel')), named);
}

/** @param {XmlElement} element @returns {XmlElement[]} */
const elementsIn = (element) => element.children.filter((child) => child instanceof XmlElement);

/** @param {XmlElement} element @param {...string} names @returns {XmlElement | undefined} */
const childOf = (element, ...names) => elementsIn(element).find(({ name }) => names.includes(name.replace('xs:', '')));

const count = (/** @type {string | undefined} */ text) => (text === 'unbounded' ? Infinity : Number(text ?? 1));

/** @param {XmlElement} element @param {Map<string, XmlElement>} named @returns {Description} */
function describeElement(element, named) {
  const { name, type, minOccurs, maxOccurs } = element.attributes;
  const occurs = { name, min: count(minOccurs), max: count(maxOccurs) };
  const own = type ? named.get(type) : childOf(element, 'complexType', 'simpleType');
  if (!own || own.name === 'xs:simpleType') return { ...occurs, ...content([]), text: facetsOf(own, type, named) };
  return { ...occurs, ...describeType(own, named) };
}

/** @param {XmlElement[]} attributes @param {Map<string, XmlElement>} [named] @returns {Omit<Description, 'name' | 'min' | 'max'>} */
function content(attributes, named = new Map()) {
  const described = attributes.map((attribute) => {
    const { name, type, use, default: usual = null } = attribute.attributes;
    const facets = facetsOf(type ? named.get(type) : childOf(attribute, 'simpleType'), type, named);
    return /** @type {const} */ ([name, { required: use === 'required', default: usual, facets }]);
  });
  return {
    attributes: Object.fromEntries(described),
    order: 'all',
    maxChildren: null,
    children: [],
    text: null,
    isForeign: false,
  };
}

/** @param {XmlElement} type @param {Map<string, XmlElement>} named @returns {Omit<Description, 'name' | 'min' | 'max'>} */
function describeType(type, named) {
  const wrapper = childOf(type, 'simpleContent', 'complexContent');
  const extension = wrapper && childOf(wrapper, 'extension');
  const holder = extension ?? type;
  const attributes = elementsIn(holder).filter(({ name }) => name === 'xs:attribute');
  const plain = content(attributes, named);
  if (extension) {
    const { base } = extension.attributes;
    if (base.startsWith('xs:')) return { ...plain, text: facetsOf(undefined, base, named) };
    const inherited = describeType(/** @type {XmlElement} */ (named.get(base)), named);
    return { ...inherited, attributes: { ...plain.attributes, ...inherited.attributes } };
  }
  const group = childOf(type, 'all', 'sequence', 'choice');
  if (!group) return plain;
  const order = group.name.replace('xs:', '');
  const children = elementsIn(group).filter(({ name }) => name === 'xs:element');
  const any = childOf(group, 'any');
  return {
    ...plain,
    order,
    maxChildren: order === 'choice' ? count(group.attributes.maxOccurs) : null,
    children: children.map((child) => describeElement(child, named)),
    isForeign: any?.attributes.namespace === '##other' && any.attributes.maxOccurs === 'unbounded',
  };
}

/**
 * @param {XmlElement | undefined} simpleType  or else a built-in type
 * @param {string | undefined} name
 * @param {Map<string, XmlElement>} named
 * @returns {Facets}
 */
function facetsOf(simpleType, name, named) {
  if (!simpleType) return { base: String(name).replace('xs:', '') };
  const restriction = /** @type {XmlElement} */ (childOf(simpleType, 'restriction'));
  const inner = childOf(restriction, 'simpleType');
  const list = inner && childOf(inner, 'list');
  /** @type {Record<string, string[]>} */
  const values = {};
  for (const facet of elementsIn(restriction)) {
    if (facet.attributes.value !== undefined)
      (values[facet.name.replace('xs:', '')] ??= []).push(facet.attributes.value);
  }
  const { length, minLength = length, maxLength = length, pattern, enumeration } = values;
  const number = (/** @type {string} */ facet) => (values[facet] ? { [facet]: Number(values[facet][0]) } : {});
  if (list) {
    const { itemType } = list.attributes;
    return {
      ...facetsOf(named.get(itemType), itemType, named),
      list: { min: Number(minLength[0]), max: Number(maxLength[0]) },
    };
  }
  return {
    base: restriction.attributes.base.replace('xs:', ''),
    ...(pattern && { pattern: pattern[0] }),
    ...(enumeration && { enumeration }),
    ...number('maxLength'),
    ...number('minInclusive'),
    ...number('minExclusive'),
    ...number('maxInclusive'),
  };
}
