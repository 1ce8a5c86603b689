declare module "*.css" {
  const text: string;
  export default text;
}
/** A module and what it imports, as the text of a script. */
declare module "*?text" {
  const text: string;
  export default text;
}
