package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages

/** [remark] in a sentence. */
fun CollectingMessages.remark(remark: SubmissionRemark): String = when (remark) {
    is SubmissionRemark.Changed -> changed()
    is SubmissionRemark.WorldChanged -> worldChanged()
    is SubmissionRemark.OwnWorld -> ownWorld()
    is SubmissionRemark.Unchanged -> unchanged()
    is SubmissionRemark.TeachersFile -> teachersFile()
    is SubmissionRemark.IsSolution -> isSolution()
    is SubmissionRemark.OtherName -> otherName(remark.entered)
    is SubmissionRemark.LanguageNotAllowed -> languageNotAllowed(remark.program)
    is SubmissionRemark.WordsNotAllowed -> wordsNotAllowed(remark.words)
    is SubmissionRemark.BestCounts -> bestCounts(remark.chosen, remark.all)
    is SubmissionRemark.ChosenInApp -> chosenInApp(remark.chosen, remark.all)
    is SubmissionRemark.BesideProject -> besideProject(remark.programs)
    is SubmissionRemark.FewerTries -> fewerTries(remark.origins)
    is SubmissionRemark.NotTried -> notTried(remark.origins)
    is SubmissionRemark.PartUnusable -> partUnusable(remark.reason)
    is SubmissionRemark.CompiledLeftOut -> compiledLeftOut(remark.classes)
    is SubmissionRemark.ReadAllTheSame -> remark.sentence
}
