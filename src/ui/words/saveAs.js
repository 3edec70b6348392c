/** The dialog in which the document, or a picture of it, is saved in some format. */

/** What a format is called, and who reads it; formats are known by their id. */
export const FORMATS = {
  denavit: { name: 'Robot model XML', detail: 'Everything: this page reads it back as it is' },
  urdf: { name: 'URDF', detail: 'ROS, MoveIt, Gazebo, Drake, MuJoCo, Isaac Sim, MATLAB' },
  sdf: { name: 'SDFormat', detail: 'Gazebo, Drake' },
  sdformat: { name: 'SDFormat', detail: 'Gazebo, Drake' },
  mjcf: { name: 'MJCF', detail: 'MuJoCo' },
  rlkin: { name: 'rlkin', detail: 'Robotics Library: a Denavit–Hartenberg table, too' },
  csv: { name: 'Postures as CSV', detail: 'Recorded postures and the present one, for a spreadsheet' },
  png: { name: 'Picture of the scene', detail: 'PNG, as it is seen now' },
};

export const SAVE_AS = {
  title: 'Save as',
  format: 'Format',
  keepsAll: 'Everything in the document is kept.',
  lost: 'What it does not hold, or changes:',
  refused: 'This document cannot be written so:',
  file: 'File name',
  bytes: (/** @type {string} */ n) => `${n} bytes`,
  kilobytes: (/** @type {string} */ n) => `${n} kB`,
  pixels: (/** @type {number} */ width, /** @type {number} */ height) => `${width} × ${height} pixels`,
  background: 'Background',
  floor: 'Floor',
  labels: 'Names and dimensions',
  show: 'In the picture',
  picture: 'The picture that will be saved',
  copy: 'Copy',
  copyName: (/** @type {string} */ file) => `Copy ${file} as text`,
  copyPicture: 'Copy the picture',
  copied: (/** @type {string} */ name) => `${name} is copied.`,
  save: 'Save',
  cancel: 'Cancel',
};
