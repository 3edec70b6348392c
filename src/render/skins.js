/**
 * What the scene is made of, light and dark. The colours that panels share are read from the page's tokens (CSS custom
 * properties of the document's root); those of the arm itself are here.
 *
 * @typedef {typeof MATERIALS.light & { x: string, y: string, z: string, accent: string, ink: string, bad: string, trace: string, traceSlow: string, ramp: readonly string[] }} Skin
 */
const MATERIALS = {
  light: {
    base: '#D3D8DF',
    link: '#F1EFE9',
    wrist: '#E2E4E7',
    flange: '#D3D8DF',
    joint: '#56616F',
    tool: '#8C96A3',
    obstacle: '#7C8DA3',
    edge: '#1B222C',
    edgeOpacity: 0.42,
    roughness: 0.62,
    sky: '#FFFFFF',
    ground: '#AEB7C4',
    hemisphere: 1.7,
    key: 2.1,
    rim: 0.9,
    shadow: 0.17,
    gridMinor: '#7C8896',
    gridMajor: '#5A6675',
    gridMinorOpacity: 0.2,
    gridMajorOpacity: 0.34,
  },
  dark: {
    base: '#6A7583',
    link: '#BFC4CA',
    wrist: '#A2AAB4',
    flange: '#8792A0',
    joint: '#4C5867',
    tool: '#727D8A',
    obstacle: '#8FA3BC',
    edge: '#06080B',
    edgeOpacity: 0.6,
    roughness: 0.58,
    sky: '#DFE8F5',
    ground: '#1A2029',
    hemisphere: 1.25,
    key: 2.3,
    rim: 1.4,
    shadow: 0.45,
    gridMinor: '#9AA6B5',
    gridMajor: '#B9C3D0',
    gridMinorOpacity: 0.1,
    gridMajorOpacity: 0.2,
  },
};

/**
 * @param {'light' | 'dark'} theme
 * @param {(token: string) => string} token  the value of a custom property
 * @returns {Skin}
 */
export const skinOf = (theme, token) => ({
  ...MATERIALS[theme],
  x: token('--axis-x'),
  y: token('--axis-y'),
  z: token('--axis-z'),
  accent: token('--accent'),
  ink: token('--ink'),
  bad: token('--bad'),
  trace: token('--trace'),
  traceSlow: token('--trace-slow'),
  ramp: [1, 2, 3, 4, 5].map((step) => token(`--ramp-${step}`)),
});

/** The skin that the page has on. */
export function currentSkin() {
  const root = document.documentElement;
  const style = getComputedStyle(root);
  return skinOf(root.dataset.bsTheme === 'dark' ? 'dark' : 'light', (name) => style.getPropertyValue(name).trim());
}
