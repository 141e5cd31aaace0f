package robotran.ui.world

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.drawSheet
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.WorkshopState

/** The sheet of paper on the desk, as large as it fits. A screen reader reads out where the robot is. */
@Composable
internal fun WorldPane(state: WorkshopState, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val description = describeWorld(state.session)
    Canvas(modifier.fillMaxSize().testTag("world").semantics { contentDescription = description }) {
        val paper = state.world.paper
        val transform = SheetTransform.fitting(paper.width, paper.height, DESK_MARGIN_CENTIMETRES, size)
        drawSheet(state.world, state.session, sheetColours, transform)
    }
}

/** The desk that is always seen around the paper. */
private const val DESK_MARGIN_CENTIMETRES = 3.0
