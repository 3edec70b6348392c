/**
 * The linear forms that vanish on four vectors of eight numbers, as minors would give them: a change of the vectors by a
 * matrix of determinant 1 leaves the minors of the forms alone, and minors of the forms are, but for one sign, minors of
 * the vectors (Plücker coordinates). So they vary as polynomials do where the vectors do.
 */
const ROWS = 4;
const COLUMNS = 8;

/**
 * By Householder's reflections (Golub & Van Loan, section 5.2): four of them make a rotation Q, so the determinant of the
 * vectors and the last four columns of Q is the product of R's diagonal, with its sign.
 * @param {Float64Array} P      4 × 8, a vector a row; overwritten
 * @param {Float64Array} forms  4 × 8, filled: a form a row, orthogonal; unit but for the last
 * @returns {number} the volume that the vectors span over the product of their lengths: 0 if they depend on one another
 */
export function writeAnnihilator(P, forms) {
  const reflections = new Float64Array(ROWS * COLUMNS);
  let volume = 1;
  let lengths = 1;
  for (let k = 0; k < ROWS; k++) lengths *= Math.hypot(...P.subarray(COLUMNS * k, COLUMNS * (k + 1)));
  for (let k = 0; k < ROWS; k++) {
    const row = P.subarray(COLUMNS * k, COLUMNS * (k + 1));
    const v = reflections.subarray(COLUMNS * k, COLUMNS * (k + 1));
    v.set(row.subarray(k), k);
    const length = Math.hypot(...v);
    const diagonal = v[k] > 0 ? -length : length;
    v[k] -= diagonal;
    volume *= diagonal;
    for (let i = k; i < ROWS; i++) reflect(v, P.subarray(COLUMNS * i, COLUMNS * (i + 1)));
  }
  for (let i = 0; i < ROWS; i++) {
    const form = forms.subarray(COLUMNS * i, COLUMNS * (i + 1));
    form.fill(0);
    form[ROWS + i] = i === ROWS - 1 ? volume : 1;
    for (let k = ROWS - 1; k >= 0; k--) reflect(reflections.subarray(COLUMNS * k, COLUMNS * (k + 1)), form);
  }
  return Math.abs(volume) / lengths;
}

/** @param {Float64Array} v  normal of the mirror @param {Float64Array} x  changed in place */
function reflect(v, x) {
  let square = 0;
  let product = 0;
  for (let i = 0; i < COLUMNS; i++) {
    square += v[i] * v[i];
    product += v[i] * x[i];
  }
  if (square === 0) return;
  const twice = (2 * product) / square;
  for (let i = 0; i < COLUMNS; i++) x[i] -= twice * v[i];
}
