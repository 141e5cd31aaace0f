package robotran.ui.handins

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.messages.CollectingMessages
import robotran.language.Language
import robotran.language.withComma
import robotran.ui.language.LocalLanguage
import robotran.ui.resources.Res
import robotran.ui.resources.hand_ins_alike
import robotran.ui.resources.hand_ins_brought
import robotran.ui.resources.hand_ins_brought_known
import robotran.ui.resources.hand_ins_camera_not_allowed
import robotran.ui.resources.hand_ins_equal
import robotran.ui.resources.hand_ins_lines
import robotran.ui.resources.hand_ins_no_camera
import robotran.ui.resources.hand_ins_no_codes
import robotran.ui.resources.hand_ins_not_kept
import robotran.ui.resources.hand_ins_nothing_found
import robotran.ui.resources.hand_ins_runs
import robotran.ui.resources.hand_ins_runs_of
import robotran.ui.resources.hand_ins_seconds
import robotran.ui.resources.hand_ins_too_many
import robotran.ui.resources.hand_ins_tries
import robotran.ui.resources.documents_save_failed
import robotran.ui.resources.documents_save_full
import robotran.ui.resources.documents_saved
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInRun
import robotran.workshop.state.HandInsMessage
import robotran.world.writeThousandths
import kotlin.math.roundToInt

/** In how many runs all goals were met; where there is only one run, how many goals. */
@Composable
internal fun runsText(graded: GradedHandIn.Graded): String {
    val goals = graded.runs.singleOrNull()?.grade?.goals
        ?: return stringResource(Res.string.hand_ins_runs_of, graded.met, graded.runs.size)
    return stringResource(Res.string.hand_ins_runs, goals.size - graded.runs.single().grade.unmet.size, goals.size)
}

/** A hand-in as a screen reader tells it. */
@Composable
internal fun spokenRow(row: HandInRow): String = (
    listOfNotNull(
        row.name,
        stringResource(row.verdict.words),
        row.results?.let { runsText(it) },
        row.lines.takeIf { it > 0 }?.let { stringResource(Res.string.hand_ins_lines, it) },
        triesOf(row)?.let { stringResource(Res.string.hand_ins_tries, it) },
        row.results?.seconds?.let { stringResource(Res.string.hand_ins_seconds, secondsText(it)) },
    ) + remarksOf(row)
    ).joinToString(". ") { it.removeSuffix(".") }

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
    val alike = row.alike.map {
        stringResource(if (it.isEqual) Res.string.hand_ins_equal else Res.string.hand_ins_alike, it.name)
    }
    return reasons + alike + (submission as? Submission.Usable)?.remarks.orEmpty().map(messages::remark)
}

internal fun triesOf(row: HandInRow): Int? = (row.submission as? Submission.Usable)?.handIn?.tries

/** A number of seconds with one decimal. */
@Composable
internal fun secondsText(seconds: Double): String {
    val text = writeThousandths((seconds * TENTHS).roundToInt() / TENTHS.toDouble())
    return if (LocalLanguage.current == Language.ENGLISH) text else withComma(text)
}

@Composable
internal fun wordsFor(message: HandInsMessage): String = when (message) {
    is HandInsMessage.Brought -> if (message.others == 0) {
        stringResource(Res.string.hand_ins_brought, message.count)
    } else {
        stringResource(Res.string.hand_ins_brought_known, message.count, message.others)
    }

    HandInsMessage.NothingFound -> stringResource(Res.string.hand_ins_nothing_found)

    HandInsMessage.NoCodes -> stringResource(Res.string.hand_ins_no_codes)

    HandInsMessage.CameraNotAllowed -> stringResource(Res.string.hand_ins_camera_not_allowed)

    HandInsMessage.NoCamera -> stringResource(Res.string.hand_ins_no_camera)

    is HandInsMessage.TooMany -> stringResource(Res.string.hand_ins_too_many, message.max, message.maxMegabytes)

    is HandInsMessage.NotKept -> stringResource(Res.string.hand_ins_not_kept, message.reason)

    is HandInsMessage.Unreadable -> message.sentence

    is HandInsMessage.Saved -> stringResource(Res.string.documents_saved, message.name)

    is HandInsMessage.NotSaved -> stringResource(
        if (message.isFull) Res.string.documents_save_full else Res.string.documents_save_failed,
        message.reason,
    )
}

/** The run that tells most: the first in which a goal was not met, or else the first. */
internal fun runToLookAt(graded: GradedHandIn.Graded): HandInRun =
    (graded.runs.firstOrNull { !it.grade.passed } ?: graded.runs.first()).let { HandInRun(it.world.name, it.grade.seed) }

private const val TENTHS = 10
