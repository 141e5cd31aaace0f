package robotran.ui.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.program.ProgramPane
import robotran.workshop.event.ProgramEvent
import robotran.workshop.state.WorkshopState

@Preview
@Composable
internal fun RobolangProgramPreview() = PreviewWorkshop { SizedProgramPane(it) }

@Preview
@Composable
internal fun ProgramWithErrorPreview() =
    PreviewWorkshop({ handle(ProgramEvent.ProgramEdited("forwrd 20\nturn left 90")) }) { SizedProgramPane(it) }

@Preview
@Composable
internal fun TranslationPreview() = PreviewWorkshop({ handle(ProgramEvent.TranslationShown(true)) }) {
    SizedProgramPane(it)
}

@Composable
private fun SizedProgramPane(state: WorkshopState) = ProgramPane(
    state.programs,
    state.shownProgramRun,
    state.settings,
    maxDiagnostics = 3,
    onEvent = {},
    Modifier.size(420.dp, 400.dp),
)
