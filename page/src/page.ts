/** The page around the pictures: folds, contents, and the table of the program's lines. */

/** Open the fold that an address names. */
function openFor(address: string | null): void {
  const target = address && address.length > 1 ? document.getElementById(address.slice(1)) : null;
  const fold = target?.querySelector("details");
  if (fold) fold.open = true;
}

/** Sort the rows by a column; again: the other way round. */
function sort(head: HTMLTableCellElement): void {
  const table = head.closest("table")!, body = table.tBodies[0], down = head.getAttribute("aria-sort") !== "descending";
  const value = (row: HTMLTableRowElement): number => {
    const text = row.cells[head.cellIndex].textContent;
    return text === "-" ? -Infinity : Number(text);
  };
  table.querySelectorAll("th").forEach(other => other.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  body.append(...[...body.rows].sort((a, b) => (down ? -1 : 1) * (value(a) - value(b)) || 0));
}

/** Mark a line's row; `scroll` also brings it into view. */
function mark(line: number, scroll: boolean): void {
  const row = document.querySelector<HTMLElement>(`#lines tr[data-line="${line}"]`), note = document.getElementById("picked");
  document.querySelectorAll("#lines tr.picked").forEach(other => other.classList.remove("picked"));
  if (note) note.textContent = `Line ${line}${row ? `: ${row.querySelector("code")!.textContent}` : " is not in the table"}`;
  const box = row?.closest(".lines");
  row?.classList.add("picked");
  if (row && box && scroll) box.scrollTop = row.offsetTop - box.clientHeight / 2;
}

/** Bring the page to life; `picked` is called with each line that the reader picks. Return how to pick a line. */
export function alive(picked: (line: number) => void): (line: number) => void {
  const note = document.getElementById("picked");
  if (note) note.textContent = "Click on a line of the program below.";
  const pick = (line: number, scroll = true): void => {
    mark(line, scroll);
    picked(line);
  };
  document.querySelectorAll<HTMLAnchorElement>("a[href^='#']").forEach(link => link.addEventListener("click", () => {
    openFor(link.getAttribute("href"));
    if (link.dataset.pick) pick(Number(link.dataset.pick));
  }));
  document.querySelectorAll("#lines th button").forEach(button => button.addEventListener("click", () => sort(button.closest("th")!)));
  document.querySelector("#lines tbody")?.addEventListener("click", event => {
    const row = (event.target as Element).closest<HTMLElement>("tr[data-line]");
    if (row) pick(Number(row.dataset.line), false);
  });
  document.querySelector<HTMLElement>(".lines")?.addEventListener("keydown", event => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key], rows = [...document.querySelectorAll<HTMLElement>("#lines tr[data-line]")];
    if (!step || (event.target as Element).closest("button") || !rows.length) return;
    const now = rows.findIndex(row => row.classList.contains("picked"));
    pick(Number(rows[Math.min(Math.max(now < 0 ? 0 : now + step, 0), rows.length - 1)].dataset.line));
    event.preventDefault();
  });
  openFor(location.hash);
  return pick;
}
