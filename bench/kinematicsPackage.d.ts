/** The package has no types of its own; it is CommonJS with a default export inside. */
declare module 'kinematics' {
  interface Kinematics {
    /** Six angles for a place and three angles of orientation: one solution. */
    inverse(x: number, y: number, z: number, a: number, b: number, c: number): number[];
    /** The places of the joints; the last with the angles of orientation. */
    forward(r0: number, r1: number, r2: number, r3: number, r4: number, r5: number): number[][];
  }
  const exports: { default: new (geometry: number[][]) => Kinematics };
  export default exports;
}
