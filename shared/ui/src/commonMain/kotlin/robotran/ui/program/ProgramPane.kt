package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.program_hint
import robotran.ui.resources.program_hint_java
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.ProgramEvent
import robotran.ui.workshop.ProgramLanguage
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState

/**
 * The programs to choose from, the one to write in, and under it what is wrong with it.
 *
 * @param mostMistakes how many mistakes there is room for.
 */
@Composable
internal fun ProgramPane(state: WorkshopState, mostMistakes: Int, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    Column(modifier.background(LocalRobotranColours.current.pane)) {
        ProgramTabs(state, onEvent)
        if (state.program.files.size > 1) FileTabs(state.program.files, state.programs.shownFile, { onEvent(ProgramEvent.FileChosen(it)) })
        ProgramEditor(
            text = state.programText,
            hint = stringResource(hintFor(state.program.language)),
            runningLine = state.runningLine,
            mistakes = state.mistakes.filter { it.file == state.file.name }.mapNotNull { it.range },
            onEdit = { onEvent(ProgramEvent.ProgramEdited(it)) },
            modifier = Modifier.weight(1f),
        )
        if (state.mistakes.isNotEmpty()) {
            MistakeList(state.mistakes, state.program.files.size > 1, mostMistakes, state.programs.mistakePointedOut, {
                onEvent(ProgramEvent.FixApplied(it))
            })
        }
        if (state.remarks.isNotEmpty()) RemarkList(state.remarks, mostMistakes)
        state.programs.closedProgram?.let { ClosedProgram(it.name, state.programs.hasRoom) { onEvent(ProgramEvent.ProgramReopened) } }
    }
}

private fun hintFor(language: ProgramLanguage): StringResource = when (language) {
    ProgramLanguage.ROBOLANG -> Res.string.program_hint
    ProgramLanguage.JAVA -> Res.string.program_hint_java
}
