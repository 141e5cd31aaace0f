package robotran.ui.send.microbit

import androidx.compose.runtime.Composable
import robotran.microbitlink.Remains
import robotran.microbitlink.sentences.sentence
import robotran.ui.school.texts.HubSendTexts
import robotran.ui.school.texts.MicrobitSendTexts
import robotran.ui.school.texts.SendTexts
import robotran.ui.send.errorText
import robotran.uikit.*
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.FoundBoard
import robotran.workshop.state.FoundMicroPython
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.MicrobitTransfer

/** What happens in the step of [state], or what is wrong and what to do, in one sentence or two. */
@Composable
internal fun sentenceOf(state: MicrobitSendState): String = when (val step = state.step) {
    MicrobitSendStep.Building -> MicrobitSendTexts.building(spoken)
    is MicrobitSendStep.HasErrors -> MicrobitSendTexts.mistake(spoken)
    MicrobitSendStep.CompilerFailed -> SendTexts.compilerFailed(spoken)

    is MicrobitSendStep.Choosing -> step.problem?.let { sentenceOf(it) }
        ?: if (state.microPython ==
            null
        ) {
            MicrobitSendTexts.chooseMicroPython(spoken)
        } else {
            MicrobitSendTexts.choose(spoken)
        }

    MicrobitSendStep.Looking -> MicrobitSendTexts.looking(spoken)
    is MicrobitSendStep.ManyBoards -> MicrobitSendTexts.manyBoards(spoken)
    MicrobitSendStep.Connecting -> MicrobitSendTexts.connecting(spoken)
    MicrobitSendStep.Found -> state.board?.let { sentenceOf(it) }.orEmpty()

    is MicrobitSendStep.Sending ->
        if (step.isWhole) MicrobitSendTexts.sendingWhole(spoken) else MicrobitSendTexts.sendingMain(spoken)

    is MicrobitSendStep.Cancelled -> MicrobitSendTexts.cancelled(spoken)
    is MicrobitSendStep.Running -> sentenceOf(step)
    MicrobitSendStep.Copying -> MicrobitSendTexts.copying(spoken)
    MicrobitSendStep.Copied -> MicrobitSendTexts.running(spoken)
    is MicrobitSendStep.NotCopied -> MicrobitSendTexts.notCopied(spoken)
    is MicrobitSendStep.HexSaved -> MicrobitSendTexts.savedHex(spoken, step.file)
    is MicrobitSendStep.PythonSaved -> HubSendTexts.savedPython(spoken, step.file)
    is MicrobitSendStep.Failed -> step.error.sentence(spoken)
}

/** What else helps in the step of [state], a paragraph each. */
@Composable
internal fun adviceOf(state: MicrobitSendState): List<String> = when (val step = state.step) {
    is MicrobitSendStep.HasErrors -> listOf(errorText(step.first))
    is MicrobitSendStep.Choosing -> adviceOf(step, state.microPython)
    MicrobitSendStep.Found -> if (state.board?.expected ==
        null
    ) {
        listOf(MicrobitSendTexts.foundHelp(spoken))
    } else {
        emptyList()
    }
    is MicrobitSendStep.Sending -> listOf(MicrobitSendTexts.keepPlugged(spoken))
    is MicrobitSendStep.Cancelled -> listOf(step.remains.sentence(spoken))
    is MicrobitSendStep.Running -> adviceOf(step)
    is MicrobitSendStep.NotCopied -> listOf(step.words).filter {
        it.isNotEmpty()
    }.map { MicrobitSendTexts.boardSays(spoken, it) }
    is MicrobitSendStep.PythonSaved -> listOf(MicrobitSendTexts.pythonWhere(spoken))
    is MicrobitSendStep.Failed -> if (step.remains ==
        Remains.AS_BEFORE
    ) {
        emptyList()
    } else {
        listOf(step.remains.sentence(spoken))
    }
    else -> emptyList()
}

@Composable
private fun sentenceOf(problem: ChoosingProblem): String = when (problem) {
    is ChoosingProblem.OfFile -> MicrobitSendTexts.fileProblem(spoken, problem.file, problem.error.sentence(spoken))
    is ChoosingProblem.OfProgram -> problem.error.sentence(spoken)
    ChoosingProblem.NotSaved -> MicrobitSendTexts.notSaved(spoken)
    ChoosingProblem.NotKept -> MicrobitSendTexts.notKept(spoken)
    ChoosingProblem.NoBoard -> MicrobitSendTexts.noBoard(spoken)
    ChoosingProblem.SeveralBoards -> MicrobitSendTexts.severalBoards(spoken)
}

@Composable
private fun sentenceOf(board: FoundBoard): String =
    board.expected?.let { MicrobitSendTexts.otherKind(spoken, board.board.name, it.name) }
        ?: MicrobitSendTexts.found(spoken, board.board.name)

@Composable
private fun sentenceOf(step: MicrobitSendStep.Running): String {
    val error = step.console.error
    return when {
        error != null -> MicrobitSendTexts.programFailed(spoken, error.python)
        step.isGone -> MicrobitSendTexts.gone(spoken)
        step.console.hasEnded -> MicrobitSendTexts.ended(spoken)
        else -> MicrobitSendTexts.running(spoken)
    }
}

@Composable
private fun adviceOf(step: MicrobitSendStep.Running): List<String> = when {
    step.console.error != null -> listOfNotNull(step.errorLine?.let { HubSendTexts.atLine(spoken, it) })
    step.isGone -> emptyList()
    else -> listOf(MicrobitSendTexts.runningHelp(spoken))
}

@Composable
private fun adviceOf(step: MicrobitSendStep.Choosing, microPython: FoundMicroPython?): List<String> = listOfNotNull(
    MicrobitSendTexts.whereMicroPython(spoken).takeIf { microPython == null },
    MicrobitSendTexts.orSendAtOnce(spoken).takeIf { microPython == null && MicrobitTransfer.USB in step.transfers },
    microPython?.let { MicrobitSendTexts.microPython(spoken, it.file, boardsOf(it)) },
)

/** Such as V1 (1.1.1), V2 (2.1.2). */
private fun boardsOf(microPython: FoundMicroPython): String = microPython.versions.entries
    .sortedBy { it.key }
    .joinToString { (board, version) -> if (version.isEmpty()) board.name else "${board.name} ($version)" }
