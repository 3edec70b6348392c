/** Copying the whole table: as what. */

export const COPY_TABLE = {
  format: {
    text: 'Plain text, for a spreadsheet',
    csv: 'CSV',
    markdown: 'Markdown',
    latex: 'LaTeX (tabular)',
    python: 'Python (Robotics Toolbox)',
    matlab: 'MATLAB (rigidBodyTree)',
    json: 'JSON',
  },
  code: 'In metres and radians, with base, tool and joint values.',
  copied: (/** @type {string} */ format) => `Copied the table as ${format}.`,
};
