// Line plots over frames, as SVG. A plot shares the current frame with the whole page.
const kColours = 8;

/** Round steps of an axis from 0 to at least `most`: a list of values. */
function ticks(most, wanted) {
  const rough = Math.max(most, 1e-9) / wanted;
  const unit = Math.pow(10, Math.floor(Math.log10(rough)));
  const step = [1, 2, 5, 10].map((f) => f * unit).find((s) => s >= rough);
  const list = [];
  for (let i = 0; list.length === 0 || list[list.length - 1] < most; ++i) list.push(i * step);
  return list;
}

/** Powers of ten from at most `least` to at least `most`. */
function powers(least, most) {
  const list = [];
  for (let e = Math.floor(Math.log10(least)); list.length < 2 || list[list.length - 1] < most; ++e) list.push(Math.pow(10, e));
  return list;
}

class Plot {
  /** `data`: title, unit, series; `numbers`: frame numbers; `choose(index)`: sets the page's current frame. */
  constructor(box, data, numbers, choose) {
    Object.assign(this, { data, numbers, choose, current: 0, hovered: null });
    this.hidden = data.series.map(() => false);
    this.log = this.isWide();
    this.legend = box.querySelector(".legend");
    this.root = box.querySelector(".plot");
    this.makeLegend();
    new ResizeObserver(() => this.draw()).observe(this.root);
    this.root.addEventListener("pointermove", (event) => this.hover(this.indexAt(event)));
    this.root.addEventListener("pointerleave", () => this.hover(null));
    this.root.addEventListener("click", (event) => this.choose(this.indexAt(event)));
  }

  /** True if the largest values of two lines differ by a factor of 50: a linear axis would flatten one of them. */
  isWide() {
    const tops = this.data.series.map((series) => Math.max(...series.values.filter((v) => v > 0))).filter((v) => v > 0);
    return tops.length > 1 && Math.max(...tops) > 50 * Math.min(...tops);
  }

  makeLegend() {
    this.values = this.data.series.map((series, i) => {
      const button = document.createElement("button");
      button.type = "button";
      button.setAttribute("aria-pressed", "true");
      const sample = svg("svg", { width: 18, height: 8, "aria-hidden": "true" }, button);
      svg("path", { d: "M0 4H18", ...this.stroke(i), "stroke-width": 2.5, fill: "none" }, sample);
      button.append(series.name + " ");
      const value = document.createElement("b");
      button.append(value);
      button.addEventListener("click", () => {
        this.hidden[i] = !this.hidden[i];
        button.setAttribute("aria-pressed", String(!this.hidden[i]));
        this.draw();
      });
      this.legend.append(button);
      return value;
    });
    const log = document.createElement("button");
    log.type = "button";
    log.className = "log";
    log.textContent = "Log";
    log.setAttribute("aria-label", "Logarithmic axis");
    log.setAttribute("aria-pressed", String(this.log));
    log.addEventListener("click", () => {
      this.log = !this.log;
      log.setAttribute("aria-pressed", String(this.log));
      this.draw();
    });
    this.legend.append(log);
  }

  stroke(i) {
    return { stroke: `var(--s${i % kColours})`, "stroke-dasharray": i < kColours ? "none" : "5 3" };
  }

  x(index) {
    const last = Math.max(1, this.numbers.length - 1);
    return this.left + (index / last) * (this.right - this.left);
  }

  y(value) {
    const share = this.log
      ? Math.max(0, Math.log(Math.max(value, this.least) / this.least) / Math.log(this.most / this.least))
      : value / this.most;
    return this.bottom - share * (this.bottom - this.top);
  }

  indexAt(event) {
    const box = this.root.getBoundingClientRect();
    const share = (event.clientX - box.left - this.left) / Math.max(1, this.right - this.left);
    return Math.round(Math.min(1, Math.max(0, share)) * (this.numbers.length - 1));
  }

  draw() {
    const width = this.root.clientWidth, height = this.root.clientHeight;
    if (width === 0) return;
    this.root.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.root.replaceChildren();
    let most = 0, least = Infinity;
    this.data.series.forEach((series, i) => {
      if (this.hidden[i]) return;
      for (const value of series.values) {
        if (value > most) most = value;
        if (value > 0 && value < least) least = value;
      }
    });
    // Below a millionth of the largest value, a logarithmic axis shows rounding of clocks only.
    const steps = this.log && most > 0 ? powers(Math.max(least, most * 1e-6), most) : ticks(most || 1, 4);
    this.least = steps[0];
    this.most = steps[steps.length - 1];
    Object.assign(this, { left: 46, right: width - 10, top: 18, bottom: height - 30 });
    this.drawAxes(steps);
    this.data.series.forEach((series, i) => {
      if (!this.hidden[i]) this.drawLine(series.values, i);
    });
    this.hoverLine = svg("line", { class: "hover", y1: this.top, y2: this.bottom, visibility: "hidden" }, this.root);
    this.cursor = svg("line", { class: "cursor", y1: this.top, y2: this.bottom }, this.root);
    this.show(this.current);
  }

  drawAxes(steps) {
    for (const value of steps) {
      const y = this.y(value);
      svg("line", { class: "grid", x1: this.left, x2: this.right, y1: y, y2: y }, this.root);
      const text = value >= 10000 ? `${figure(value / 1000)}k` : figure(value);
      svg("text", { x: this.left - 6, y: y + 4, "text-anchor": "end" }, this.root).textContent = text;
    }
    svg("text", { x: 4, y: 10 }, this.root).textContent = this.data.unit;
    const last = this.numbers.length - 1, room = Math.max(1, Math.floor((this.right - this.left) / 60));
    const step = Math.max(1, Math.round(ticks(Math.max(1, last), room)[1]));
    for (let index = 0; index <= last; index += step) {
      svg("text", { x: this.x(index), y: this.bottom + 15, "text-anchor": "middle" }, this.root).textContent = this.numbers[index];
    }
    svg("text", { x: (this.left + this.right) / 2, y: this.bottom + 28, "text-anchor": "middle" }, this.root).textContent = "frame";
  }

  drawLine(values, i) {
    let path = "", open = false;
    values.forEach((value, index) => {
      if (value !== null) path += `${open ? "L" : "M"}${this.x(index).toFixed(1)} ${this.y(value).toFixed(1)}`;
      open = value !== null;
    });
    if (values.length === 1 && values[0] !== null) path += "h6";
    svg("path", { d: path, "data-series": this.data.series[i].name, ...this.stroke(i) }, this.root);
  }

  /** The legend shows the values of this frame. */
  read(index) {
    this.values.forEach((element, i) => { element.textContent = figure(this.data.series[i].values[index]); });
  }

  show(index) {
    this.current = index;
    if (!this.cursor) return;
    this.cursor.setAttribute("x1", this.x(index));
    this.cursor.setAttribute("x2", this.x(index));
    if (this.hovered === null) this.read(index);
  }

  hover(index) {
    this.hovered = index;
    if (!this.hoverLine) return;
    this.hoverLine.setAttribute("visibility", index === null ? "hidden" : "visible");
    if (index !== null) {
      this.hoverLine.setAttribute("x1", this.x(index));
      this.hoverLine.setAttribute("x2", this.x(index));
    }
    this.read(index === null ? this.current : index);
  }
}
