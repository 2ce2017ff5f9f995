// What the water of a cell has reached since the start.
struct CellRecord {
    real highest;  // surface, m above level 0, while the cell was wet
    real fastest;  // speed, m/s, while it was wet
    real arrival;  // s
};

// With the state at `time` added: surface e and speed, whether the cell is wet, and whether water that was not there at
// the start has arrived. Until a first value comes, a record is a NaN or lies beyond all values: min and max give the
// other of the two then.
KERNEL CellRecord with_state(CellRecord r, real e, real speed, bool wet, bool arrived, real time) {
    r.highest = wet ? max(r.highest, e) : r.highest;
    r.fastest = wet ? max(r.fastest, speed) : r.fastest;
    r.arrival = arrived ? min(r.arrival, time) : r.arrival;
    return r;
}
