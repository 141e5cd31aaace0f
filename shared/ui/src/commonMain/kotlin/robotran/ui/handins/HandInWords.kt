package robotran.ui.handins

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.remark
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.messages.CollectingMessages
import robotran.assignments.messages.ReportMessages
import robotran.ui.assignment.worldName
import robotran.ui.language.LocalLanguage
import robotran.ui.resources.*
import robotran.ui.runbar.secondsText
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun
import robotran.workshop.state.HandInsMessage

/** In how many runs all goals were met; where there is only one run, how many goals. */
@Composable
internal fun runsText(graded: GradedHandIn.Graded): String {
    val goals = graded.runs.singleOrNull()?.grade?.goals
        ?: return stringResource(Res.string.hand_ins_runs_of, graded.met, graded.runs.size)
    val met = goals.size - graded.runs.single().grade.unmet.size
    if (goals.size == 1) return stringResource(Res.string.hand_ins_runs_one, met)
    return stringResource(Res.string.hand_ins_runs, met, goals.size)
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
        stringResource(row.verdict.words),
        row.results?.let { runsText(it) },
        row.lines.takeIf { it > 0 }?.let { stringResource(Res.string.hand_ins_lines, it) },
        triesOf(row)?.let { stringResource(Res.string.hand_ins_tries, it) },
        row.results?.seconds?.let { stringResource(Res.string.hand_ins_seconds, secondsText(it)) },
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
    stringResource(Res.string.hand_ins_commented, it.replace(LINE_ENDS, " "))
}

/** What the teacher should know: why it cannot run, what is strange about it, which others are like it. */
@Composable
internal fun remarksOf(row: HandInRow): List<String> {
    val messages = CollectingMessages.of(LocalLanguage.current)
    val submission = row.submission
    val reasons = when (val graded = row.graded) {
        is GradedHandIn.HasMistakes -> graded.reasons.take(1)
        is GradedHandIn.Failed -> graded.reasons
        else -> listOfNotNull((submission as? Submission.Unusable)?.reason)
    }
    val alike = row.alike.groupBy({ it.isEqual }, { it.name }).map { (isEqual, names) ->
        stringResource(if (isEqual) Res.string.hand_ins_equal else Res.string.hand_ins_alike, names.joinToString())
    }
    val namesake = listOfNotNull(
        if (row.hasNamesake) stringResource(Res.string.hand_ins_namesake, submission.origin) else null,
    )
    return reasons + namesake + alike + submission.remarks.map { messages.remark(it) }
}

internal fun triesOf(row: HandInRow): Int? = (row.submission as? Submission.Usable)?.handIn?.tries

@Composable
internal fun wordsFor(message: HandInsMessage): String = when (message) {
    is HandInsMessage.Brought -> {
        val counts = listOf(
            Res.string.hand_ins_brought to message.count,
            Res.string.hand_ins_brought_unusable to message.unusable,
            Res.string.hand_ins_brought_known to message.others,
        ).filterIndexed { index, (_, count) -> index == 0 || count > 0 }
        (counts.map { (words, count) -> stringResource(words, count) } + message.notes).joinToString(" ")
    }

    is HandInsMessage.NothingFound -> {
        message.notes.joinToString(" ").ifEmpty { stringResource(Res.string.hand_ins_nothing_found) }
    }

    is HandInsMessage.Removed -> stringResource(Res.string.hand_ins_removed, message.name)

    is HandInsMessage.NoCodes -> {
        stringResource(if (message.isPhoto) Res.string.hand_ins_no_code_in_photo else Res.string.hand_ins_no_codes)
    }

    HandInsMessage.CameraNotAllowed -> stringResource(Res.string.hand_ins_camera_not_allowed)
    HandInsMessage.NoCamera -> stringResource(Res.string.hand_ins_no_camera)
    is HandInsMessage.TooMany -> stringResource(Res.string.hand_ins_too_many, message.max, message.maxMegabytes)
    is HandInsMessage.NotKept -> stringResource(Res.string.hand_ins_not_kept, message.reason)
    is HandInsMessage.Unreadable -> message.sentence
    is HandInsMessage.Saved -> stringResource(Res.string.documents_saved, message.name)

    is HandInsMessage.NotSaved -> {
        stringResource(
            if (message.isFull) Res.string.documents_save_full else Res.string.documents_save_failed,
            message.reason,
        )
    }
}

/** The run that tells most: the first in which a goal was not met, or else the first. */
internal fun runToLookAt(graded: GradedHandIn.Graded): HandInRun = (
    graded.runs.firstOrNull {
        !it.grade.passed
    } ?: graded.runs.first()
).let { HandInRun(it.world.name, it.grade.seed) }

private val LINE_ENDS = Regex("\\s*\n\\s*")
