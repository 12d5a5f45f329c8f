// Sphinx's weights of search results: names of functions first, then guides, then other pages.
var Others = /^(s\d.*|changelog|contributing|design|errata|language|ledger|security|statements)$/;
var Scorer = {
  score: ([page, title, , , score, , kind]) => {
    if (kind === "object") return title.split(".").length === 2 ? score + 10 : score;
    return Others.test(page) ? score : score + 12;
  },
  objNameMatch: 100,
  objPartialMatch: 50,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
