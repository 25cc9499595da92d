// This file stands in the head of every page, before all other scripts.

// Formulas: MathJax sets those that MkDocs marks.
window.MathJax = {
  messageStyle: "none",
  showMathMenu: false,
  tex2jax: { inlineMath: [["\\(", "\\)"]], displayMath: [["\\[", "\\]"]], ignoreClass: ".*", processClass: "arithmatex" },
  SVG: { scale: 95 }
};

// Pages that are opened as files have a search, too: browsers start no workers from files and read none. A frame without an
// address, which has the page's own rights, stands for the worker, and a script has the index.
if (location.protocol === "file:") {
  const base = new URL(".", document.currentScript.src);
  document.write(`<script src="${new URL("search/search_index.js", base)}"></` + "script>");
  window.IFrameWorker = window.Worker = class extends EventTarget {
    constructor(url) {
      super();
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      document.body.append(this.frame);
      const inside = this.frame.contentWindow;
      inside.document.open();
      inside.postMessage = data => this.dispatchEvent(new MessageEvent("message", { data }));
      inside.document.write(`<script src="${url}"></` + "script>");
      inside.document.close();
      this.ready = new Promise(resolve => { this.frame.onload = resolve; });
    }
    postMessage(data) {
      this.ready.then(() => this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data })));
    }
    terminate() { this.frame.remove(); }
    set onmessage(call) { this.addEventListener("message", call); }
  };
}
