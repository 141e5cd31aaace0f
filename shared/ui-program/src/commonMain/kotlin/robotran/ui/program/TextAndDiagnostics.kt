package robotran.ui.program

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import robotran.brick.kind.BrickKind
import robotran.workshop.state.ProgramsState

/**
 * The text with the errors below it. When errors appear, only the text becomes shorter, from the bottom, so nothing
 * else moves.
 *
 * @param hasErrors whether the errors are shown.
 * @param onPenbot makes the shown robot the penbot with another brick.
 */
@Composable
internal fun TextAndDiagnostics(
    state: ProgramsState,
    maxDiagnostics: Int,
    actions: PaneActions,
    overFoot: @Composable () -> Unit,
    hasErrors: Boolean,
    onPenbot: (BrickKind) -> Unit,
    modifier: Modifier,
    text: @Composable () -> Unit,
) {
    Column(modifier) {
        Box(Modifier.weight(1f).fillMaxWidth()) {
            text()
            Column(Modifier.align(Alignment.BottomCenter)) { overFoot() }
        }
        state.otherBrick?.let { brick -> OtherBrickBar(brick) { onPenbot(brick) } }
        // The bar about the other brick says the same as a mistake without a place. With a program to begin with, it
        // says all that a pupil needs who has only come here with the program of another world.
        val isShown = state.otherBrick != null &&
            (LocalBeginning.current != null || state.diagnostics.all { it.range == null })
        if (hasErrors && state.diagnostics.isNotEmpty() && !isShown) {
            val pointedOut = state.errorPointedOut
            DiagnosticStrip(
                state.program,
                state.diagnostics,
                state.file.name,
                maxDiagnostics,
                pointedOut,
                actions::goToNextNote,
                actions::fix,
            )
        }
    }
}
