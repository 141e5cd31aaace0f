package robotran.ui.robot

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.rememberTextMeasurer
import robotran.editing.RobotTexts
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetZoom
import robotran.ui.sheet.drawSheet
import robotran.ui.sheet.drawSights
import robotran.ui.sheet.transform
import robotran.ui.world.tags.WorldTags
import robotran.ui.worldedit.initialStateOf
import robotran.uikit.*
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.SheetCamera
import robotran.world.World
import robotran.world.geometry.Point
import kotlin.math.min

/** The robot where it stands, with what its sensors see there. */
@Composable
internal fun RobotOnSheet(state: RobotEditState, world: World, session: SessionState, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val robot = state.editing.robot
    val shown = remember(world, robot) {
        world.copy(
            robots = world.robots.mapIndexed { number, place ->
                if (number == state.robot) place.copy(description = robot) else place
            },
        )
    }
    val zoom = remember(shown) { SheetZoom(shown) }
    val resting = remember(shown, session.brick) { initialStateOf(shown, session) }
    val labels = rememberTextMeasurer()
    val name = RobotTexts.onSheet(spoken)
    Canvas(
        modifier.fillMaxSize().testTag(WorldTags.ROBOT_SHEET).named(name).clipToBounds(),
    ) {
        if (size.isEmpty()) return@Canvas
        val start = shown.robots.getOrNull(state.robot)?.start ?: return@Canvas
        val paper = shown.paper
        val closer = (min(paper.width, paper.height) / SHOWN).coerceIn(SheetCamera.MIN_ZOOM, SheetCamera.MAX_ZOOM)
        val camera = SheetCamera(closer, Point(start.x, start.y))
        val transform = camera.transform(paper, Rect(Offset.Zero, size))
        drawSheet(
            zoom.at(transform.pixelsPerCentimetre, settled = true),
            resting,
            sheetColours,
            labels,
            emptySet(),
            transform,
        )
        drawSights(shown, resting, transform)
    }
}

/** So much of the paper is shown around the robot, in centimetres. */
private const val SHOWN = 120.0
