'use strict';
(() => {
  // Sorting: a button in each head. Names by the reader's language, numbers by size, and what is empty comes last.
  const words = new Intl.Collator(undefined, { numeric: true, sensitivity: 'base' });
  const textOf = (row, at) => {
    const cell = row.cells[at];
    return cell.dataset.key ?? cell.textContent.trim();
  };
  const order = (isNumber) => (a, b) => {
    if (!isNumber) return words.compare(a, b);
    const [x, y] = [parseFloat(a), parseFloat(b)];
    return x < y ? -1 : x > y ? 1 : 0;
  };
  const sort = (table, head, at) => {
    const isNumber = head.hasAttribute('data-number');
    // What is large is what is looked for; a second press turns it around.
    const first = isNumber ? 'descending' : 'ascending';
    const before = head.getAttribute('aria-sort');
    const direction = before === null ? first : before === 'ascending' ? 'descending' : 'ascending';
    const sign = direction === 'ascending' ? 1 : -1;
    const compare = order(isNumber);
    const isEmpty = (text) => text === '' || (isNumber && Number.isNaN(parseFloat(text)));
    const rows = [...table.tBodies[0].rows].map((row) => ({ row, text: textOf(row, at) }));
    rows.sort((a, b) => isEmpty(a.text) - isEmpty(b.text) || sign * compare(a.text, b.text));
    table.tBodies[0].append(...rows.map(({ row }) => row));
    for (const other of table.tHead.rows[0].cells) other.removeAttribute('aria-sort');
    head.setAttribute('aria-sort', direction);
  };
  for (const table of document.querySelectorAll('table.sortable')) {
    [...table.tHead.rows[0].cells].forEach((head, at) => {
      const button = head.querySelector('button');
      button.disabled = false;
      button.addEventListener('click', () => sort(table, head, at));
    });
  }

  // Searching: rows that do not match are hidden, and how many do is said.
  const field = document.getElementById('search');
  const rows = [...document.getElementById('class').tBodies[0].rows];
  const plain = (text) => text.normalize('NFKD').replace(/\p{M}/gu, '').toLowerCase();
  const known = rows.map((row) => plain(`${row.cells[0].textContent} ${row.cells[1].textContent} ${row.dataset.words}`));
  const search = () => {
    const wanted = plain(field.value).split(/\s+/);
    let matches = 0;
    rows.forEach((row, at) => {
      const isMatch = wanted.every((word) => known[at].includes(word));
      row.hidden = !isMatch;
      matches += isMatch;
    });
    document.getElementById('matches').textContent = field.value.trim() === '' ? '' : `${matches} of ${rows.length} match`;
  };
  field.closest('.search').hidden = false;
  field.addEventListener('input', search);
  // A browser may keep what was typed before the page was loaded anew.
  if (field.value) search();
})();
