package robotran.ui.runbar

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.language.Language
import robotran.language.withComma
import robotran.ui.language.LocalLanguage
import robotran.ui.resources.*
import robotran.workshop.state.GoalCount
import robotran.workshop.state.WorkshopStatus
import robotran.world.messages.sentence
import kotlin.math.abs
import kotlin.math.roundToLong

/** [status] in simple words for pupils. */
@Composable
internal fun statusText(status: WorkshopStatus): String = when (status) {
    WorkshopStatus.Ready -> stringResource(Res.string.status_ready)
    WorkshopStatus.Empty -> stringResource(Res.string.status_empty)
    WorkshopStatus.Changed -> stringResource(Res.string.status_changed)
    WorkshopStatus.Solved -> stringResource(Res.string.status_solved)
    is WorkshopStatus.TimeUp -> stringResource(Res.string.time_up, status.seconds)
    WorkshopStatus.Off -> stringResource(Res.string.status_off)
    WorkshopStatus.Compiling -> stringResource(Res.string.status_compiling)
    WorkshopStatus.NoCompiler -> stringResource(Res.string.status_no_compiler)
    WorkshopStatus.CompilerFailed -> stringResource(Res.string.status_compiler_failed)
    is WorkshopStatus.HasErrors -> mistakenText(status.line, status.file)
    is WorkshopStatus.RobotImpossible -> status.draft.error.sentence(LocalLanguage.current)

    is WorkshopStatus.OffPaper -> {
        status.robot?.let { stringResource(Res.string.status_off_paper_robot, it) }
            ?: stringResource(Res.string.status_off_paper)
    }

    is WorkshopStatus.Running -> {
        if (status.line > 0) {
            stringResource(Res.string.status_running_line, status.line)
        } else {
            stringResource(Res.string.status_running)
        }
    }

    is WorkshopStatus.Paused -> {
        if (status.line > 0) {
            stringResource(Res.string.run_status_paused_line, status.line)
        } else {
            stringResource(Res.string.run_status_paused)
        }
    }

    is WorkshopStatus.Ended -> {
        if (status.stopped) stringResource(Res.string.status_stopped) else endedText(status.goals)
    }

    is WorkshopStatus.Failed -> failedText(status.line, status.file, status.message)
}

/** Reports success only if the goals are met, too. */
@Composable
private fun endedText(goals: GoalCount): String = when {
    goals.allMet -> stringResource(Res.string.status_ended)
    goals.failed == 0 -> stringResource(Res.string.status_ended_undecided)
    goals.all == 1 -> stringResource(Res.string.status_ended_goal_not_met)
    else -> stringResource(Res.string.status_ended_goals_not_met, goals.met, goals.all)
}

@Composable
private fun mistakenText(line: Int, file: String?): String = when {
    line == 0 -> stringResource(Res.string.status_mistake_anywhere)
    file == null -> stringResource(Res.string.status_mistake, line)
    else -> stringResource(Res.string.status_mistake_in_file, line, file)
}

@Composable
private fun failedText(line: Int, file: String?, message: String): String = when {
    line == 0 -> message
    file == null -> stringResource(Res.string.status_failed, line, message)
    else -> stringResource(Res.string.mistake_in_line_of_file, file, line, message)
}

/** [value] with exactly one decimal, such as `-0.5` or `12.0`, the same on every platform. */
internal fun oneDecimal(value: Double): String {
    val tenths = (value * 10).roundToLong()
    val sign = if (tenths < 0) "-" else ""
    return "$sign${abs(tenths) / 10}.${abs(tenths) % 10}"
}

/** Seconds with one decimal place, as the reader's language writes it. */
@Composable
internal fun secondsText(milliseconds: Long): String = secondsText(milliseconds / MILLISECONDS_PER_SECOND)

/** [seconds] with one decimal place, as the reader's language writes it. */
@Composable
internal fun secondsText(seconds: Double): String = oneDecimal(seconds).let {
    if (LocalLanguage.current == Language.ENGLISH) it else withComma(it)
}

private const val MILLISECONDS_PER_SECOND = 1000.0
