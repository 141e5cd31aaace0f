package robotran.ui.runbar

import androidx.compose.runtime.Composable
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.state.GoalCount
import robotran.workshop.state.WorkshopStatus
import robotran.world.messages.sentence

/** [status] in simple words for pupils. */
@Composable
internal fun statusText(status: WorkshopStatus): String = when (status) {
    WorkshopStatus.Ready -> RunTexts.statusReady(spoken)
    WorkshopStatus.Empty -> RunTexts.statusEmpty(spoken)
    WorkshopStatus.Changed -> RunTexts.statusChanged(spoken)
    WorkshopStatus.Solved -> RunTexts.statusSolved(spoken)
    WorkshopStatus.SolvedHere -> RunTexts.outcomeSolvedHere(spoken)
    is WorkshopStatus.TimeUp -> RunTexts.timeUp(spoken, status.seconds)
    WorkshopStatus.Off -> RunTexts.statusOff(spoken)
    WorkshopStatus.Compiling -> RunTexts.statusCompiling(spoken)
    WorkshopStatus.NoCompiler -> RunTexts.statusNoCompiler(spoken)
    WorkshopStatus.CompilerFailed -> RunTexts.statusCompilerFailed(spoken)
    is WorkshopStatus.HasErrors -> errorText(status.line, status.file)
    is WorkshopStatus.RobotImpossible -> status.draft.error.sentence(LocalLanguage.current)

    is WorkshopStatus.OffPaper -> {
        status.robot?.let { RunTexts.statusOffPaperRobot(spoken, it) }
            ?: RunTexts.statusOffPaper(spoken)
    }

    is WorkshopStatus.Running -> {
        if (status.line > 0) {
            RunTexts.statusRunningLine(spoken, status.line)
        } else {
            RunTexts.statusRunning(spoken)
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
        if (status.stopped) RunTexts.statusStopped(spoken) else endedText(status.goals)
    }

    is WorkshopStatus.Failed -> failedText(status.line, status.file, status.message)
}

/** Reports success only if the goals are met, too. */
@Composable
private fun endedText(goals: GoalCount): String = when {
    goals.allMet -> RunTexts.statusEnded(spoken)
    goals.failed == 0 -> RunTexts.statusEndedUndecided(spoken)
    goals.all == 1 -> RunTexts.statusEndedGoalNotMet(spoken)
    else -> RunTexts.statusEndedGoalsNotMet(spoken, goals.met, goals.all)
}

@Composable
private fun errorText(line: Int, file: String?): String = when {
    line == 0 -> RunTexts.statusMistakeAnywhere(spoken)
    file == null -> RunTexts.statusMistake(spoken, line)
    else -> RunTexts.statusMistakeInFile(spoken, line, file)
}

@Composable
private fun failedText(line: Int, file: String?, message: String): String = when {
    line == 0 -> message
    file == null -> RunTexts.statusFailed(spoken, line, message)
    else -> CommonTexts.mistakeInLineOfFile(spoken, file, line, message)
}
