// Undo and redo without end, over whole states.

export class History {
  constructor(state) {
    this.states = [state];
    this.at = 0;
  }

  get state() {
    return this.states[this.at];
  }

  get can_undo() {
    return this.at > 0;
  }

  get can_redo() {
    return this.at + 1 < this.states.length;
  }

  push(state) {
    this.states.splice(this.at + 1, Infinity, state);
    ++this.at;
  }

  undo() {
    if (this.can_undo) --this.at;
  }

  redo() {
    if (this.can_redo) ++this.at;
  }
}
