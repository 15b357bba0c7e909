// Uses the page of a gallery as a person would, and leaves in #probe what did not go as it should,
// one line each, or "all is well". Appended to a copy of the page by gallery_page_test.cpp.
(async function () {
  "use strict";
  const complaints = [];
  const get = (id) => document.getElementById(id);
  const all = (selector, within) => [...(within || document).querySelectorAll(selector)];
  const check = (good, what) => { if (!good) complaints.push(what); };
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));
  const press = (key) => {
    const event = new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true });
    document.activeElement.dispatchEvent(event);
  };
  const items = all("[data-item]");
  const pictures = items.filter((item) => item.querySelector(".sheet"));
  const sheet = (item) => item.querySelector(".sheet");
  const isSeen = (item) => item.getClientRects().length > 0;
  const seen = () => items.filter(isSeen);
  const same = (a, b) => a.length === b.length && a.every((item, i) => item === b[i]);
  const search = (text) => {
    get("search").value = text;
    get("search").dispatchEvent(new Event("input", { bubbles: true }));
  };
  const choose = (kind) => {
    get("kind").value = kind;
    get("kind").dispatchEvent(new Event("change", { bubbles: true }));
  };

  const loads = (image) => new Promise((done) => {
    const end = () => done(image.naturalWidth > 0);
    if (image.complete) end();
    image.addEventListener("load", end);
    image.addEventListener("error", end);
  });

  async function everyPictureLoads() {
    await Promise.all(pictures.map(async (item) => {
      const thumbnail = sheet(item).querySelector("img");
      thumbnail.loading = "eager";
      check(await loads(thumbnail), "no thumbnail: " + thumbnail.getAttribute("src"));
      check(Math.abs(thumbnail.naturalWidth - thumbnail.getAttribute("width")) < 1 &&
            Math.abs(thumbnail.naturalHeight - thumbnail.getAttribute("height")) < 1,
            "another size than it says: " + thumbnail.getAttribute("src"));
      const full = new Image();
      full.src = sheet(item).href;
      check(await loads(full), "no picture: " + sheet(item).getAttribute("href"));
    }));
    complaints.sort();
  }

  function searchFinds() {
    for (const item of [pictures[0], pictures[pictures.length - 1]]) {
      search(item.id.toUpperCase());
      check(isSeen(item), "search does not find " + item.id);
      check(seen().every((each) => each.dataset.words.includes(item.id)), "search finds more than " + item.id);
    }
    search("nothing is called that");
    check(seen().length === 0 && !get("nothing").hidden, "an empty search shows something");
    get("reset").click();
    check(same(seen(), items) && get("nothing").hidden, "reset does not show everything");
    check(get("count").textContent.startsWith(pictures.length + " "), "the count is wrong");
  }

  function filtersChoose() {
    for (const link of all(".pages a")) {
      link.click();
      const page = link.dataset.show;
      check(same(seen(), items.filter((item) => !page || item.dataset.page === page)),
            "the filter shows other pictures than those of " + page);
      check(link.getAttribute("aria-current") === "true", "the filter does not say it is on: " + page);
    }
    all(".pages a")[0].click();
    for (const option of all("#kind option")) {
      choose(option.value);
      const fits = (item) => !option.value || item.dataset.kinds.split(" ").includes(option.value);
      check(same(seen(), items.filter(fits)), "the filter shows other kinds than " + option.value);
      check(seen().length > 0, "the filter shows nothing for " + option.value);
    }
    choose("");
  }

  function keysMove() {
    press("/");
    check(document.activeElement === get("search"), "/ does not lead to the search box");
    search("x");
    press("Escape");
    check(get("search").value === "" && document.activeElement !== get("search"), "Escape does not leave the search box");
    sheet(pictures[0]).focus();
    press("ArrowRight");
    check(document.activeElement === sheet(pictures[1]), "the right arrow does not lead to the next picture");
    press("ArrowLeft");
    check(document.activeElement === sheet(pictures[0]), "the left arrow does not lead back");
    press("ArrowDown");
    const here = document.activeElement.getBoundingClientRect().top;
    check(here >= sheet(pictures[0]).getBoundingClientRect().bottom, "the down arrow does not lead down");
    press("ArrowUp");
    check(document.activeElement === sheet(pictures[0]), "the up arrow does not lead back");
  }

  async function viewerShows() {
    const viewer = get("viewer");
    let copied = "";
    Object.defineProperty(navigator, "clipboard", {
      value: { writeText: (text) => { copied = text; return Promise.resolve(); } } });
    const expectItem = async (item) => {
      const file = sheet(item).getAttribute("href");
      check(viewer.open, "the viewer is not open");
      check(await loads(get("viewer-picture")) && get("viewer-picture").getAttribute("src") === file,
            "the viewer does not show " + file);
      check(get("download").getAttribute("href") === file &&
            get("download").getAttribute("download") === file.split("/").pop(), "no download of " + file);
      const commands = all(".commands code", item).map((code) => code.textContent);
      const shown = all("#viewer-commands code").map((code) => code.textContent);
      check(commands.length > 0 && same(commands, shown), "other commands than those of " + file);
      all("#viewer-commands button")[0].click();
      await pause(1);
      check(copied === commands[0], "the button does not copy the command of " + file);
      check(location.hash === "#" + item.id, "the address does not name " + item.id);
    };
    sheet(pictures[0]).focus();
    document.activeElement.click();  // as Enter does
    await expectItem(pictures[0]);
    check(get("previous").disabled, "there is a picture before the first");
    get("next").click();
    await expectItem(pictures[1]);
    press("ArrowLeft");
    await expectItem(pictures[0]);
    press("ArrowRight");
    get("close").click();
    check(!viewer.open, "the viewer does not close");
    check(document.activeElement === sheet(pictures[1]), "the focus is not on the picture that was shown");
    check(location.hash === "", "the address still names a picture");
  }

  function pageIsSound() {
    check(all("img").every((image) => image.hasAttribute("alt")), "a picture has no alternative text");
    check(all("main img").every((image) => image.alt !== ""), "a picture's alternative text is empty");
    check(all("button").every((button) => button.textContent.trim() || button.getAttribute("aria-label")),
          "a button has no name");
    check(all("input, select").every((input) => input.labels.length > 0), "an input has no label");
    const ids = all("[id]").map((element) => element.id);
    check(new Set(ids).size === ids.length, "an id is there twice");
    const page = document.scrollingElement;
    check(page.scrollWidth <= page.clientWidth, "the page is wider than the window");
  }

  function lightAndDark() {
    const paper = () => getComputedStyle(document.body).backgroundColor;
    const before = paper(), pressed = get("theme").getAttribute("aria-pressed");
    get("theme").click();
    check(paper() !== before && get("theme").getAttribute("aria-pressed") !== pressed, "the page does not change its light");
    get("theme").click();
    check(paper() === before, "the page does not change its light back");
  }

  try {
    pageIsSound();
    lightAndDark();
    searchFinds();
    filtersChoose();
    keysMove();
    await viewerShows();
    await everyPictureLoads();
  } catch (error) {
    complaints.push("the probe stopped: " + error);
  }
  const result = document.createElement("pre");
  result.id = "probe";
  result.textContent = complaints.length > 0 ? complaints.join("\n") : "all is well";
  document.body.append(result);
})();
