package robotran.ui.world

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.rememberTextMeasurer
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetFit
import robotran.ui.sheet.drawSheet
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.WorkshopState

/** The sheet of paper on the desk, as large as it fits. A screen reader reads out where the robot is. */
@Composable
internal fun WorldPane(state: WorkshopState, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val description = describeWorld(state.session)
    val fit = remember(state.world) { SheetFit(state.world, DESK_MARGIN_CENTIMETRES) }
    val labels = rememberTextMeasurer()
    Canvas(modifier.fillMaxSize().testTag("world").semantics { contentDescription = description }) {
        drawSheet(fit.into(size), state.session, sheetColours, labels)
    }
}

/** The desk that is always seen around the paper. */
private const val DESK_MARGIN_CENTIMETRES = 3.0
