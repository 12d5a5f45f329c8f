// Sphinx's weights of search results, with names of functions before pages that mention them.
var Scorer = {
  score: ([, title, , , score, , kind]) => kind === "object" && title.split(".").length === 2 ? score + 10 : score,
  objNameMatch: 100,
  objPartialMatch: 50,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
