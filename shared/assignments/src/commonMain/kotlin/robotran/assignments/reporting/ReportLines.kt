package robotran.assignments.reporting

import robotran.assignments.collecting.remark
import robotran.assignments.comparing.similarGroups
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.CollectingMessages
import robotran.assignments.messages.ReportMessages
import robotran.language.Language

/** What a teacher should know about hand-ins, one line each, with the pupil's name. */
fun remarkLines(report: ClassReport, language: Language): List<String> = report.results.indices
    .flatMap { index -> warnings(report, index, language).map { "${report.results[index].submission.name}: $it" } }

/** Why the hand-in [index] has no grade, and what else a teacher should know about it, in sentences or lines. */
internal fun remarksOf(report: ClassReport, index: Int, language: Language): List<String> =
    reasonsOf(report.results[index]) + warnings(report, index, language)

/** Why [result] has no grade, in sentences or lines. */
internal fun reasonsOf(result: GradedHandIn): List<String> = when (result) {
    is GradedHandIn.Unusable -> listOf(result.submission.reason)
    is GradedHandIn.HasErrors -> result.reasons
    is GradedHandIn.Failed -> result.reasons
    is GradedHandIn.Graded -> emptyList()
}

private fun warnings(report: ClassReport, index: Int, language: Language): List<String> {
    val messages = CollectingMessages.of(language)
    val submission = report.results[index].submission
    val same = report.countOfName(submission.name)
    val ofName = listOfNotNull(messages.sameName(same, submission.origin).takeIf { same > 1 })
    return ofName + submission.remarks.map { messages.remark(it) }
}

/** The similar hand-ins of [report], a sentence for each group. */
fun similarityLines(report: ClassReport, language: Language): List<String> {
    val messages = ReportMessages.of(language)
    return similarGroups(report.pairs).map { group ->
        val names = group.members.map { report.results[it].submission.name }
        val share = group.lowestShare
        if (share == 1.0) messages.equal(names) else messages.similar(names, percentOf(share))
    }
}

/**
 * Whose programs are equal or nearly so to those of the result [index] of [report], such as `Ben (100 %)`.
 *
 * @param maxNames how many names are shown; the number of the others follows, such as `+6`.
 */
internal fun similarTo(report: ClassReport, index: Int, maxNames: Int = Int.MAX_VALUE): String {
    val names = report.pairs.filter { it.isMarked && index in listOf(it.first, it.second) }.map { pair ->
        val other = if (pair.first == index) pair.second else pair.first
        "${report.results[other].submission.name} (${percentOf(pair.share)} %)"
    }
    val rest = names.size - maxNames
    return names.take(maxNames).joinToString() + if (rest > 0) " +$rest" else ""
}

/** Rounded down: only equal programs have all in common. */
private fun percentOf(share: Double): Int = (share * PERCENT).toInt()

private const val PERCENT = 100
