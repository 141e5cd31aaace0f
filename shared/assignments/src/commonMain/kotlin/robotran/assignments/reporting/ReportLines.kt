package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.remark
import robotran.assignments.comparing.similarGroups
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.CollectingMessages
import robotran.assignments.messages.ReportMessages
import robotran.language.Language

/** What a teacher should know about usable hand-ins, one line each, with the pupil's name. */
fun remarkLines(report: ClassReport, language: Language): List<String> {
    val messages = CollectingMessages.of(language)
    return report.results.filter { it !is GradedHandIn.Unusable }.flatMap { result ->
        val submission = result.submission as? Submission.Usable
        submission?.remarks.orEmpty().map { "${result.submission.name}: ${messages.remark(it)}" }
    }
}

/** The similar hand-ins of [report], a sentence for each group. */
fun similarityLines(report: ClassReport, language: Language): List<String> {
    val messages = ReportMessages.of(language)
    return similarGroups(report.pairs).map { group ->
        val names = group.members.map { report.results[it].submission.name }
        // Rounded down: only equal programs have all in common.
        if (group.lowestShare ==
            1.0
        ) {
            messages.equal(names)
        } else {
            messages.similar(names, (group.lowestShare * PERCENT).toInt())
        }
    }
}

private const val PERCENT = 100
