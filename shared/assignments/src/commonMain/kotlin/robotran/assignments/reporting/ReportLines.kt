package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.assignments.comparing.SimilarPair
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

/** The marked pairs of [report], one sentence each. */
fun similarityLines(report: ClassReport, language: Language): List<String> {
    val messages = ReportMessages.of(language)
    return report.pairs.filter { it.isMarked }.map { similarityLine(report, it, messages) }
}

private fun similarityLine(report: ClassReport, pair: SimilarPair, messages: ReportMessages): String {
    val (first, second) = listOf(pair.first, pair.second).map { report.results[it].submission.name }
    // Rounded down: only equal programs have all in common.
    return if (pair.isEqual) {
        messages.equal(first, second)
    } else {
        messages.similar(first, second, (pair.share * PERCENT).toInt())
    }
}

private const val PERCENT = 100
