/** Saving a map of the workspace. */

export const SAVE_MAP = {
  volumeTitle: 'Save the volume',
  sectionTitle: 'Save the section',
  format: 'Format',
  formats: {
    places: { name: 'Places as CSV', detail: 'x, y and z of each sampled posture’s tool point' },
    cubes: { name: 'Cubes as CSV', detail: 'The middle of each cube, with all that is known of it' },
    cloud: { name: 'Points as PLY', detail: 'MeshLab, CloudCompare, Blender' },
    surface: { name: 'Solid as PLY', detail: 'Its surface as triangles: MeshLab, CloudCompare, Blender' },
    stl: { name: 'Solid as STL', detail: 'Its surface as triangles: any CAD program' },
    outlines: { name: 'Boundary as CSV', detail: 'u and v of each point of the outlines, holes marked' },
    svg: { name: 'Drawing as SVG', detail: 'In its true size, holes left open: drawing and CAD programs' },
  },
  unit: (/** @type {string} */ unit) =>
    `Lengths are in ${unit}, seen from the world; the formats themselves have no unit.`,
  sectionUnit: (/** @type {string} */ unit) => `Lengths are in ${unit}, in the plane of the section.`,
  partial: 'The map was cancelled: what there is so far is saved.',
  estimated: 'An estimate, as the panel says.',
  writing: 'Writing…',
  save: 'Save',
  cancel: 'Cancel',
};
