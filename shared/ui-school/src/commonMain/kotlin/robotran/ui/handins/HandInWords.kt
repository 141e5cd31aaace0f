package robotran.ui.handins

import androidx.compose.runtime.Composable
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.remark
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.messages.CollectingMessages
import robotran.assignments.messages.ReportMessages
import robotran.ui.assignment.worldName
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun
import robotran.workshop.state.HandInsMessage

/** In how many runs all goals were met; where there is only one run, how many goals. */
@Composable
internal fun runsText(graded: GradedHandIn.Graded): String {
    val goals = graded.runs.singleOrNull()?.grade?.goals
        ?: return SchoolTexts.handInsRunsOf(spoken, graded.met, graded.runs.size)
    val met = goals.size - graded.runs.single().grade.unmet.size
    if (goals.size == 1) return SchoolTexts.handInsRunsOne(spoken, met)
    return SchoolTexts.handInsRuns(spoken, met, goals.size)
}

/** The same where the title of a column says the rest. */
@Composable
internal fun shortRunsText(graded: GradedHandIn.Graded): String = if (graded.runs.size == 1) {
    runsText(graded)
} else {
    ReportMessages.of(LocalLanguage.current).countOf(graded.met, graded.runs.size)
}

/** A hand-in as a screen reader tells it. */
@Composable
internal fun spokenRow(row: HandInRow, plan: GradingPlan): String = (
    listOfNotNull(
        row.name,
        row.verdict.words(spoken),
        row.results?.let { runsText(it) },
        row.lines.takeIf { it > 0 }?.let { SchoolTexts.handInsLines(spoken, it) },
        triesOf(row)?.let { SchoolTexts.handInsTries(spoken, it) },
        row.results?.seconds?.let { SchoolTexts.handInsSeconds(spoken, secondsText(it)) },
    ) + worldsOf(row, plan) + remarksOf(row) + listOfNotNull(commentOf(row))
).joinToString(". ") { it.removeSuffix(".") }

/** In how many runs all goals were met in each world, if there are several. */
@Composable
private fun worldsOf(row: HandInRow, plan: GradingPlan): List<String> {
    val graded = row.results?.takeIf { plan.worlds.size > 1 } ?: return emptyList()
    val messages = ReportMessages.of(LocalLanguage.current)
    return plan.worlds.map { world ->
        val runs = graded.runsIn(world.name)
        "${worldName(world.name)}: ${messages.countOf(runs.count { it.grade.passed }, runs.size)}"
    }
}

/** The comment in one line; null for none. */
@Composable
internal fun commentOf(row: HandInRow): String? = row.comment.trim().takeIf { it.isNotEmpty() }?.let {
    SchoolTexts.handInsCommented(spoken, it.replace(LINE_ENDS, " "))
}

/** What the teacher should know: why it cannot run, what is strange about it, which others are like it. */
@Composable
internal fun remarksOf(row: HandInRow): List<String> {
    val messages = CollectingMessages.of(LocalLanguage.current)
    val submission = row.submission
    val reasons = when (val graded = row.graded) {
        is GradedHandIn.HasErrors -> graded.reasons.take(1)
        is GradedHandIn.Failed -> graded.reasons
        else -> listOfNotNull((submission as? Submission.Unusable)?.reason)
    }
    val alike = row.alike.groupBy({ it.isEqual }, { it.name }).map { (isEqual, names) ->
        if (isEqual) {
            SchoolTexts.handInsEqual(
                spoken,
                names.joinToString(),
            )
        } else {
            SchoolTexts.handInsAlike(spoken, names.joinToString())
        }
    }
    val namesake = listOfNotNull(
        if (row.hasNamesake) SchoolTexts.handInsNamesake(spoken, submission.origin) else null,
    )
    return reasons + namesake + alike + submission.remarks.map { messages.remark(it) }
}

internal fun triesOf(row: HandInRow): Int? = (row.submission as? Submission.Usable)?.handIn?.tries

@Composable
internal fun wordsFor(message: HandInsMessage): String = when (message) {
    is HandInsMessage.Brought -> {
        val counts = listOf(
            SchoolTexts::handInsBrought to message.count,
            SchoolTexts::handInsBroughtUnusable to message.unusable,
            SchoolTexts::handInsBroughtKnown to message.others,
        ).filterIndexed { index, (_, count) -> index == 0 || count > 0 }
        (counts.map { (words, count) -> words(spoken, count) } + message.notes).joinToString(" ")
    }

    is HandInsMessage.NothingFound -> {
        message.notes.joinToString(" ").ifEmpty { SchoolTexts.handInsNothingFound(spoken) }
    }

    is HandInsMessage.Removed -> SchoolTexts.handInsRemoved(spoken, message.name)

    is HandInsMessage.NoCodes -> {
        if (message.isPhoto) SchoolTexts.handInsNoCodeInPhoto(spoken) else SchoolTexts.handInsNoCodes(spoken)
    }

    HandInsMessage.CameraNotAllowed -> SchoolTexts.handInsCameraNotAllowed(spoken)
    HandInsMessage.NoCamera -> SchoolTexts.handInsNoCamera(spoken)
    is HandInsMessage.TooMany -> SchoolTexts.handInsTooMany(spoken, message.max, message.maxMegabytes)
    is HandInsMessage.NotKept -> SchoolTexts.handInsNotKept(spoken, message.reason)
    is HandInsMessage.Unreadable -> message.sentence
    is HandInsMessage.Saved -> DocumentTexts.saved(spoken, message.name)

    is HandInsMessage.NotSaved -> {
        if (message.isFull) DocumentTexts.saveFull(spoken) else DocumentTexts.saveFailed(spoken, message.reason)
    }
}

/** The run that tells most: the first in which a goal was not met, or else the first. */
internal fun runToLookAt(graded: GradedHandIn.Graded): HandInRun = (
    graded.runs.firstOrNull {
        !it.grade.passed
    } ?: graded.runs.first()
).let { HandInRun(it.world.name, it.grade.seed) }

private val LINE_ENDS = Regex("\\s*\n\\s*")
