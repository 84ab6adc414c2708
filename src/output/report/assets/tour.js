// The page of a tour: one current frame, shown by the picture, the readout, the plots and the graph.
(() => {
  const data = JSON.parse(byId("data").textContent);
  const slider = byId("frame"), picture = byId("picture"), output = byId("number"), play = byId("play"), code = byId("command");
  const strip = [...document.querySelectorAll(".strip button")];
  const readout = byId("readout");
  let current = 0, timer = null;

  /** The last picture at or before a frame; -1: none. */
  function pictureOf(index) {
    let found = -1;
    data.pictureFrames.forEach((frame, i) => { if (frame <= index) found = i; });
    return found;
  }

  function addRow(name, value) {
    const term = document.createElement("dt"), entry = document.createElement("dd");
    term.textContent = name;
    entry.textContent = value;
    readout.append(term, entry);
  }

  function fillReadout(index) {
    readout.replaceChildren();
    const frame = data.graph.frames[index];
    addRow("Frame", String(data.numbers[index]));
    if (frame) addRow("Space of the eye", data.graph.nodes[frame[0]].name);
    for (const plot of data.plots) {
      const head = document.createElement("dt");
      head.className = "part";
      head.textContent = plot.title + (plot.unit ? `, ${plot.unit}` : "");
      readout.append(head);
      for (const series of plot.series) addRow(series.name, figure(series.values[index]));
    }
  }

  function setFrame(index) {
    if (data.numbers.length === 0) return;
    current = Math.min(data.numbers.length - 1, Math.max(0, index));
    slider.value = String(current);
    slider.setAttribute("aria-valuetext", `frame ${data.numbers[current]}`);
    output.textContent = `frame ${data.numbers[current]}`;
    code.textContent = data.commands[current] || "";
    const shown = pictureOf(current);
    strip.forEach((button, i) => {
      if (i === shown) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    });
    if (shown >= 0) {
      const source = strip[shown].querySelector("img");
      if (picture.src !== source.src) picture.src = source.src;
      picture.alt = `Frame ${data.numbers[data.pictureFrames[shown]]}`;
      const list = strip[shown].parentElement, at = strip[shown].offsetLeft - list.offsetLeft;
      if (at < list.scrollLeft || at + strip[shown].offsetWidth > list.scrollLeft + list.clientWidth) list.scrollLeft = at - list.clientWidth / 2;
    }
    fillReadout(current);
    for (const plot of plots) plot.show(current);
    if (graph) graph.show(current);
  }

  const plots = [...document.querySelectorAll("[data-plot]")].map((box) => new Plot(box, data.plots[Number(box.dataset.plot)], data.numbers, setFrame));
  const graph = data.graph.nodes.length > 0 ? new SpaceGraph(byId("graph"), data.graph) : null;

  function stop() {
    clearInterval(timer);
    timer = null;
    play.textContent = "Play";
    play.setAttribute("aria-pressed", "false");
  }

  play.addEventListener("click", () => {
    if (timer !== null) return stop();
    if (current >= data.numbers.length - 1) setFrame(0);
    play.textContent = "Pause";
    play.setAttribute("aria-pressed", "true");
    timer = setInterval(() => {
      if (current >= data.numbers.length - 1) stop();
      else setFrame(current + 1);
    }, 1000 / Math.min(30, Math.max(2, data.fps || 12)));
  });
  slider.addEventListener("input", () => { stop(); setFrame(Number(slider.value)); });
  byId("back").addEventListener("click", () => { stop(); setFrame(current - 1); });
  byId("next").addEventListener("click", () => { stop(); setFrame(current + 1); });
  strip.forEach((button, i) => button.addEventListener("click", () => { stop(); setFrame(data.pictureFrames[i]); }));
  document.querySelectorAll("[data-goto]").forEach((button) => button.addEventListener("click", () => {
    setFrame(Number(button.dataset.goto));
    byId("film").scrollIntoView({ block: "start" });
  }));
  document.addEventListener("keydown", (event) => {
    if (event.target !== document.body || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === "ArrowLeft") { stop(); setFrame(current - 1); }
    else if (event.key === "ArrowRight") { stop(); setFrame(current + 1); }
    else if (event.key === " ") { event.preventDefault(); play.click(); }
  });
  setFrame(0);
})();
