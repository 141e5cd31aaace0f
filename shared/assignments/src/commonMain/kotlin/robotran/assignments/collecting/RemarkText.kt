package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages

/** [remark] in a sentence. */
fun CollectingMessages.remark(remark: SubmissionRemark): String = when (remark) {
    is SubmissionRemark.Changed -> changed()
    is SubmissionRemark.OtherAssignment -> otherAssignment(remark.title)
    is SubmissionRemark.WorldChanged -> worldChanged()
    is SubmissionRemark.OwnWorld -> ownWorld()
    is SubmissionRemark.Unchanged -> unchanged()
    is SubmissionRemark.LanguageNotAllowed -> languageNotAllowed(remark.program)
    is SubmissionRemark.WordsNotAllowed -> wordsNotAllowed(remark.words)
    is SubmissionRemark.OlderLeftOut -> olderLeftOut(remark.count)
    is SubmissionRemark.ReadAllTheSame -> remark.sentence
}
