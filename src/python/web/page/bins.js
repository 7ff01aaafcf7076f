// SPDX-License-Identifier: BSD-3-Clause
// A log in equal steps of time or depth: least, mean and largest of each signal, null where there is none. The same as bins.py has it.
export class BinLog {
  constructor() {
    this.clear();
  }

  clear() {
    this.width = 1;
    this.first = null;
    this.signals = {};
    this.length = 0;
  }

  take(change) {
    if (change.new) {
      this.clear();
      this.width = change.width;
      this.first = change.from;
    }
    if (this.first === null) return;
    for (const [name, tables] of Object.entries(change.signals)) {
      const kept = (this.signals[name] = this.signals[name] || [[], [], []]);
      tables.forEach((table, n) => {
        kept[n].length = change.from - this.first;
        for (const value of table) kept[n].push(value);
      });
      this.length = kept[0].length;
    }
  }

  get begin() {
    return this.first === null ? 0 : this.first * this.width;
  }

  get end() {
    return this.first === null ? 0 : (this.first + this.length) * this.width;
  }

  /// Rows between two keys, put together so that there are at most `most`: {keys, low, mean, high} of a signal; no extreme is lost.
  rows(name, from, to, most) {
    const found = { keys: [], low: [], mean: [], high: [] };
    const tables = this.signals[name];
    if (!tables) return found;
    const begin = Math.max(0, Math.floor(from / this.width) - this.first);
    const end = Math.min(this.length, Math.ceil(to / this.width) - this.first);
    const group = Math.max(1, Math.ceil((end - begin) / most));
    for (let row = begin - (begin + this.first) % group; row < end; row += group) {
      const merged = merge(tables, Math.max(row, 0), Math.min(row + group, this.length));
      found.keys.push((this.first + row + 0.5 * group) * this.width);
      found.low.push(merged[0]);
      found.mean.push(merged[1]);
      found.high.push(merged[2]);
    }
    return found;
  }

  /// Least and largest of a signal between two keys; null where it has no value.
  extremes(name, from, to) {
    const rows = this.rows(name, from, to, 1);
    const low = rows.low.filter((value) => value !== null);
    const high = rows.high.filter((value) => value !== null);
    return low.length ? [Math.min(...low), Math.max(...high)] : null;
  }
}

function merge(tables, begin, end) {
  let low = null, high = null, sum = 0, count = 0;
  for (let row = begin; row < end; row++) {
    if (tables[1][row] === null) continue;
    low = low === null ? tables[0][row] : Math.min(low, tables[0][row]);
    high = high === null ? tables[2][row] : Math.max(high, tables[2][row]);
    sum += tables[1][row];
    count += 1;
  }
  return [low, count ? sum / count : null, high];
}
