(function () {
  "use strict";
  var root = document.documentElement;
  var items = all("[data-item]");
  var sections = all("section.page");
  var searchBox = get("search");
  var kindBox = get("kind");
  var viewer = get("viewer");
  var page = "";  // the one that is shown; "" is all of them
  var open = null;  // the item in the viewer

  function get(id) { return document.getElementById(id); }
  function all(selector, within) {
    return Array.prototype.slice.call((within || document).querySelectorAll(selector));
  }
  function sheetOf(item) { return item.querySelector(".sheet"); }
  function shown() { return items.filter(function (item) { return !item.hidden && sheetOf(item); }); }

  // ---- search and filters

  var haystacks = items.map(function (item) {
    return (item.textContent + " " + item.dataset.words).toLowerCase();
  });

  function filter() {
    var words = searchBox.value.toLowerCase().split(/\s+/).filter(Boolean);
    var kind = kindBox.value;
    var found = 0, pictures = 0;
    items.forEach(function (item, i) {
      var fits = words.every(function (word) { return haystacks[i].indexOf(word) >= 0; }) &&
          (!kind || item.dataset.kinds.split(" ").indexOf(kind) >= 0) &&
          (!page || item.dataset.page === page);
      item.hidden = !fits;
      if (!sheetOf(item)) return;
      ++pictures;
      if (fits) ++found;
    });
    var searching = words.length > 0 || kind !== "";
    root.classList.toggle("searching", searching);
    var something = false;
    sections.forEach(function (section) {
      var any = all("[data-item]", section).some(function (item) { return !item.hidden; });
      section.hidden = (page !== "" && section.dataset.page !== page) || (searching && !any);
      all(".grid", section).forEach(function (grid) {
        grid.hidden = all("[data-item]", grid).every(function (item) { return item.hidden; });
      });
      if (!section.hidden) something = true;
    });
    get("nothing").hidden = something;
    get("count").textContent = found === pictures ? pictures + " pictures" : found + " of " + pictures;
    all(".pages a").forEach(function (link) {
      link.setAttribute("aria-current", String(link.dataset.show === page));
    });
  }

  function showPage(name) {
    page = name;
    filter();
    document.querySelector(".pages a[aria-current='true']").scrollIntoView({ block: "nearest", inline: "nearest" });
    var bar = document.querySelector(".bar");
    if (window.scrollY > bar.offsetTop) window.scrollTo(0, document.querySelector(".masthead").offsetHeight);
  }

  searchBox.addEventListener("input", filter);
  kindBox.addEventListener("change", filter);
  get("search-form").addEventListener("submit", function (event) {
    event.preventDefault();
    var first = shown()[0];
    if (first) sheetOf(first).focus();
  });
  get("reset").addEventListener("click", function () {
    searchBox.value = "";
    kindBox.value = "";
    showPage("");
    searchBox.focus();
  });
  all(".pages a").forEach(function (link) {
    link.addEventListener("click", function (event) {
      event.preventDefault();
      showPage(link.dataset.show);
    });
  });

  all("main a[href^='#page-']").forEach(function (link) {
    link.addEventListener("click", function () { showPage(""); });
  });

  // ---- the viewer

  function copy(text, button) {
    var done = function (good) {
      button.textContent = good ? "Copied" : "Press Ctrl+C";
      get("copied").textContent = good ? "The command is copied." : "";
      setTimeout(function () { button.textContent = "Copy"; }, 1600);
    };
    var bySelection = function () {
      var range = document.createRange();
      range.selectNodeContents(button.parentNode.querySelector("code"));
      var selection = window.getSelection();
      selection.removeAllRanges();
      selection.addRange(range);
      var good = false;
      try { good = document.execCommand("copy"); } catch (e) { /* the text is selected at least */ }
      done(good);
    };
    if (navigator.clipboard && window.isSecureContext) {
      navigator.clipboard.writeText(text).then(function () { done(true); }, bySelection);
    } else {
      bySelection();
    }
  }

  function commandItem(source) {
    var li = document.createElement("li");
    var caption = source.querySelector("span");
    if (caption) li.appendChild(caption.cloneNode(true));
    var row = document.createElement("div");
    row.className = "command";
    row.appendChild(source.querySelector("code").cloneNode(true));
    var button = document.createElement("button");
    button.type = "button";
    button.textContent = "Copy";
    var text = source.querySelector("code").textContent;
    button.setAttribute("aria-label", "Copy: " + text);
    button.addEventListener("click", function () { copy(text, button); });
    row.appendChild(button);
    li.appendChild(row);
    return li;
  }

  function fill(target, sources) {
    target.textContent = "";
    sources.forEach(function (node) { target.appendChild(node.cloneNode(true)); });
  }

  function show(item) {
    open = item;
    var sheet = sheetOf(item), heading = item.querySelector("h4, figcaption");
    var picture = get("viewer-picture");
    picture.src = sheet.getAttribute("href");
    picture.alt = sheet.querySelector("img").alt;
    viewer.querySelector(".stage").style.cssText = sheet.getAttribute("style");
    fill(get("viewer-caption"), Array.prototype.filter.call(heading.childNodes, function (node) {
      return node.className !== "kind";
    }));
    var help = item.querySelector(".help");
    get("viewer-help").textContent = help ? help.textContent : "";
    var download = get("download");
    download.href = sheet.getAttribute("href");
    download.setAttribute("download", sheet.getAttribute("href").split("/").pop());
    get("download-size").textContent = sheet.dataset.size;
    var commands = get("viewer-commands");
    commands.textContent = "";
    all(".commands li", item).forEach(function (li) { commands.appendChild(commandItem(li)); });
    var list = shown(), at = list.indexOf(item);
    get("position").textContent = (at + 1) + " / " + list.length;
    get("previous").disabled = at <= 0;
    get("next").disabled = at + 1 >= list.length;
    viewer.classList.toggle("wide", !item.classList.contains("card"));
    if (!viewer.open) viewer.showModal();
    viewer.querySelector(".label").scrollTop = 0;
    setHash("#" + item.id);
  }

  function turn(by) {
    var list = shown(), next = list[list.indexOf(open) + by];
    if (next) show(next);
  }

  function setHash(hash) {
    try { history.replaceState(null, "", hash || location.pathname + location.search); } catch (e) { /* in a frame */ }
  }

  document.addEventListener("click", function (event) {
    var sheet = event.target.closest && event.target.closest("[data-item] .sheet");
    if (!sheet || event.button !== 0 || event.metaKey || event.ctrlKey || event.shiftKey) return;
    event.preventDefault();
    show(sheet.closest("[data-item]"));
  });
  get("previous").addEventListener("click", function () { turn(-1); });
  get("next").addEventListener("click", function () { turn(1); });
  function afterClosing() {
    if (!open || viewer.open) return;
    setHash("");
    sheetOf(open).focus();
    open = null;
  }
  function close() {
    viewer.close();
    afterClosing();
  }
  get("close").addEventListener("click", close);
  viewer.addEventListener("click", function (event) { if (event.target === viewer) close(); });
  viewer.addEventListener("close", afterClosing);  // by Esc

  // ---- keys

  // The nearest picture above or below, or the one before or behind.
  function neighbour(from, key) {
    var list = shown(), at = list.indexOf(from);
    if (key === "ArrowLeft") return list[at - 1];
    if (key === "ArrowRight") return list[at + 1];
    var here = sheetOf(from).getBoundingClientRect(), best = null, least = Infinity;
    list.forEach(function (item) {
      var there = sheetOf(item).getBoundingClientRect();
      var down = key === "ArrowDown" ? there.top - here.bottom : here.top - there.bottom;
      if (down < 0) return;
      var aside = Math.abs((there.left + there.right) - (here.left + here.right)) / 2;
      if (down * 4 + aside < least) {
        least = down * 4 + aside;
        best = item;
      }
    });
    return best;
  }

  document.addEventListener("keydown", function (event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    var key = event.key, arrow = /^Arrow/.test(key);
    if (viewer.open) {
      if (key === "ArrowLeft") turn(-1);
      if (key === "ArrowRight") turn(1);
      return;
    }
    if (document.activeElement === searchBox) {
      if (key === "Escape") {
        searchBox.value = "";
        filter();
        searchBox.blur();
      } else if (key === "ArrowDown" && shown()[0]) {
        event.preventDefault();
        sheetOf(shown()[0]).focus();
      }
      return;
    }
    if (/^(SELECT|INPUT|TEXTAREA)$/.test(document.activeElement.tagName)) return;
    if (key === "/") {
      event.preventDefault();
      searchBox.focus();
      searchBox.select();
    } else if (arrow) {
      var from = document.activeElement.closest("[data-item]");
      var to = from && sheetOf(from) === document.activeElement ? neighbour(from, key) : null;
      if (!to) return;
      event.preventDefault();
      sheetOf(to).focus();
    }
  });

  // ---- light and dark

  var themeButton = get("theme");
  var systemDark = window.matchMedia("(prefers-color-scheme: dark)");
  function isDark() { return root.dataset.theme ? root.dataset.theme === "dark" : systemDark.matches; }
  function showTheme() { themeButton.setAttribute("aria-pressed", String(isDark())); }
  themeButton.addEventListener("click", function () {
    root.dataset.theme = isDark() ? "light" : "dark";
    try { localStorage.setItem("edaha-theme", root.dataset.theme); } catch (e) { /* for this visit only */ }
    showTheme();
  });
  systemDark.addEventListener("change", showTheme);
  showTheme();

  filter();
  var wanted = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (wanted && items.indexOf(wanted) >= 0 && sheetOf(wanted)) show(wanted);
})();
