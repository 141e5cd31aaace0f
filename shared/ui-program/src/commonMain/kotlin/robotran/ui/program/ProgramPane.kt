package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.program.blocks.dialogs.PaneHeight
import robotran.uikit.*
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.Settings
import robotran.workshop.state.ShownProgramRun

/**
 * The program pane: the program tabs, the editor, the diagnostics, and the translation.
 *
 * @param run what the last run says about the shown program.
 * @param maxDiagnostics how many errors without a line there is room for.
 * @param tutorialStep the index of the tutorial's step that is shown; null for none. The palette has its blocks only.
 */
@Composable
fun ProgramPane(
    programs: ProgramsState,
    run: ShownProgramRun,
    settings: Settings,
    maxDiagnostics: Int,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    tutorialStep: Int? = null,
) {
    var renaming by remember { mutableStateOf(false) }
    val file = rememberOpenFile(programs, settings, onEvent) { renaming = true }
    BoxWithConstraints(modifier.background(LocalRobotranColours.current.pane)) {
        val height = PaneHeight.of(maxHeight, LocalDensity.current.fontScale)
        Column(Modifier.fillMaxSize()) {
            if (height != PaneHeight.VERY_LOW || !programs.isEditingBlocks) {
                if (programs.robots.size > 1) RobotChooser(programs) { onEvent(ProgramEvent.RobotChosen(it)) }
                ProgramTabs(programs, onEvent) { renaming = true }
            }
            if (programs.program.files.size > 1) {
                FileTabs(programs.program.files, programs.shownFile, { onEvent(ProgramEvent.FileChosen(it)) }, {
                    renaming = true
                })
            }
            Box(Modifier.weight(1f)) {
                ShownFile(file, programs, run, settings.codeSize, height, maxDiagnostics, tutorialStep, onEvent)
            }
            // An open sheet has the room of all else. On a phone in landscape there is no room beside mistakes.
            val hasRoom = !programs.isEditingBlocks &&
                (height != PaneHeight.VERY_LOW || programs.diagnostics.isEmpty())
            if (height == PaneHeight.HIGH || hasRoom) {
                LocalProgramWarning.current?.invoke(
                    programs.program.name,
                    height.ofWarning * LocalDensity.current.fontScale.coerceIn(1f, 1.5f),
                )
            }
        }
    }
    if (renaming) Renaming(programs, onEvent) { renaming = false }
}

@Composable
private fun Renaming(programs: ProgramsState, onEvent: (ProgramEvent) -> Unit, onClose: () -> Unit) = RenameDialog(
    programs,
    {
        onClose()
        onEvent(ProgramEvent.FileRenamed(programs.shownFile, it))
    },
    {
        onClose()
        onEvent(ProgramEvent.FileClosed(programs.shownFile))
    },
    onClose,
)

/** How high the warning below the program may be. */
private val PaneHeight.ofWarning: Dp
    get() = when (this) {
        PaneHeight.HIGH -> 160.dp
        PaneHeight.LOW -> 80.dp
        PaneHeight.VERY_LOW -> 48.dp
    }
