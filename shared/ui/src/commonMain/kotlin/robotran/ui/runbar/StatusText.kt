package robotran.ui.runbar

import androidx.compose.runtime.Composable
import robotran.ui.texts.RunTexts
import robotran.ui.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.state.GoalCount
import robotran.workshop.state.WorkshopStatus
import robotran.world.messages.sentence

/** [status] in simple words for pupils. */
@Composable
internal fun statusText(status: WorkshopStatus): String = when (status) {
    WorkshopStatus.Ready -> ScreenTexts.statusReady(spoken)
    WorkshopStatus.Empty -> ScreenTexts.statusEmpty(spoken)
    WorkshopStatus.Changed -> ScreenTexts.statusChanged(spoken)
    WorkshopStatus.Solved -> RunTexts.statusSolved(spoken)
    is WorkshopStatus.TimeUp -> RunTexts.timeUp(spoken, status.seconds)
    WorkshopStatus.Off -> ScreenTexts.statusOff(spoken)
    WorkshopStatus.Compiling -> ScreenTexts.statusCompiling(spoken)
    WorkshopStatus.NoCompiler -> ScreenTexts.statusNoCompiler(spoken)
    WorkshopStatus.CompilerFailed -> ScreenTexts.statusCompilerFailed(spoken)
    is WorkshopStatus.HasErrors -> errorText(status.line, status.file)
    is WorkshopStatus.RobotImpossible -> status.draft.error.sentence(LocalLanguage.current)

    is WorkshopStatus.OffPaper -> {
        status.robot?.let { ScreenTexts.statusOffPaperRobot(spoken, it) }
            ?: ScreenTexts.statusOffPaper(spoken)
    }

    is WorkshopStatus.Running -> {
        if (status.line > 0) {
            ScreenTexts.statusRunningLine(spoken, status.line)
        } else {
            ScreenTexts.statusRunning(spoken)
        }
    }

    is WorkshopStatus.Paused -> {
        if (status.line > 0) {
            RunTexts.statusPausedLine(spoken, status.line)
        } else {
            RunTexts.statusPaused(spoken)
        }
    }

    is WorkshopStatus.Ended -> {
        if (status.stopped) ScreenTexts.statusStopped(spoken) else endedText(status.goals)
    }

    is WorkshopStatus.Failed -> failedText(status.line, status.file, status.message)
}

/** Reports success only if the goals are met, too. */
@Composable
private fun endedText(goals: GoalCount): String = when {
    goals.allMet -> ScreenTexts.statusEnded(spoken)
    goals.failed == 0 -> ScreenTexts.statusEndedUndecided(spoken)
    goals.all == 1 -> ScreenTexts.statusEndedGoalNotMet(spoken)
    else -> ScreenTexts.statusEndedGoalsNotMet(spoken, goals.met, goals.all)
}

@Composable
private fun errorText(line: Int, file: String?): String = when {
    line == 0 -> ScreenTexts.statusMistakeAnywhere(spoken)
    file == null -> ScreenTexts.statusMistake(spoken, line)
    else -> ScreenTexts.statusMistakeInFile(spoken, line, file)
}

@Composable
private fun failedText(line: Int, file: String?, message: String): String = when {
    line == 0 -> message
    file == null -> ScreenTexts.statusFailed(spoken, line, message)
    else -> ScreenTexts.mistakeInLineOfFile(spoken, file, line, message)
}
