package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.DpRect
import androidx.compose.ui.unit.dp
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.simulation.state.SessionState
import robotran.ui.sheet.ShownWorld
import robotran.ui.sheet.drawShortfallLines
import robotran.ui.sheet.drawShortfallPins
import robotran.ui.sheet3d.SpaceCanvas
import robotran.ui.sheet3d.drawChosenRing
import robotran.ui.sheet3d.drawHandleLine
import robotran.ui.sheet3d.drawPreview3D
import robotran.ui.sheet3d.previewEnd3D
import robotran.ui.sheet3d.toOffset
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetLayer
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/** The world in perspective with its interactive elements: the same as on the sheet. */
@Composable
internal fun TouchableSpace(
    shown: ShownWorld,
    marks: WorldMarks,
    aside: DpRect,
    inputs: FrameThrottledInput,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val world = shown.world
    val session = shown.session
    val view = shown.view
    val preview = marks.preview
    val missing = if (SheetLayer.GOALS in view.shown) marks.shortfalls else emptyList()
    val labels = rememberTextMeasurer()
    val now = rememberUpdatedState(session to view.chosen)
    val choose = rememberUpdatedState { thing: SheetElement? -> onEvent(SheetEvent.ElementChosen(thing)) }
    val hand = remember(world) { HandTouch(world, { now.value }, { choose.value(it) }, inputs) }
    val ring = LocalRobotranColours.current.focus
    val announced = rememberAnnounced(session)
    val description = describeWorld(world, announced)
    val camera = view.cameraKind.words(spoken)
    val asking = askingActions(view, session, onEvent)
    SpaceCanvas(
        shown,
        { onEvent(SheetEvent.SpaceCameraMoved(it)) },
        aside,
        Modifier.fillMaxSize().testTag(WorldTags.WORLD).focusRing(0.dp).focusable().semantics {
            contentDescription = description
            stateDescription = camera
            customActions = asking
        },
        hand,
        onGround = { projection ->
            drawShortfallLines(missing, projection::pixelOf)
            view.chosen?.let { drawRing(it, world, session, ring, projection) }
        },
        overlay = { projection ->
            drawShortfallPins(missing, labels, projection::pixelOf)
            view.chosen?.let { drawHandle(it, world, session, ring, projection) }
            preview?.let { drawPreview3D(it, projection, labels) }
        },
    ) { projection, look ->
        val places = HandlePlaces { pose, reach -> projection.handleAt(pose, reach) }
        ElementHandles(world, session, announced, places, inputs::sendNow, { onEvent(SheetEvent.ElementChosen(it)) })
        val end = preview?.let { previewEnd3D(it, projection) }
        if (preview != null && end != null) {
            PreviewHandle(preview, end, { look.onPlane(it, 0.0) }) { onEvent(BlockEvent.Put("$it")) }
        }
    }
}

/** The pixel of a place on the paper; null if it is behind the camera. */
private fun Projection.pixelOf(point: Point): Offset? = toScreen(Vector3(point.x, point.y, 0.0))?.toOffset()

/** What is behind the camera keeps a place in the middle of the picture, so that keys and readers still reach it. */
private fun Projection.handleAt(pose: Pose, reach: Double): HandlePlace {
    val middle = Vector3(pose.x, pose.y, HANDLE_HEIGHT)
    val pixel = toScreen(middle) ?: return HandlePlace(Offset(centre.x.toFloat(), centre.y.toFloat()), 0f)
    val radius = (scaleAt(middle) * reach).coerceAtMost(minOf(size.width, size.height) / 2)
    return HandlePlace(
        Offset(
            pixel.x.coerceIn(0.0, size.width).toFloat(),
            pixel.y.coerceIn(0.0, size.height).toFloat(),
        ),
        radius.toFloat(),
    )
}

private fun DrawScope.drawRing(
    thing: SheetElement,
    world: World,
    session: SessionState,
    colour: Color,
    projection: Projection,
) {
    val pose = poseOf(thing, world, session) ?: return
    drawChosenRing(Point(pose.x, pose.y), reachOf(thing, world) + RING_GAP, colour, projection)
}

private fun DrawScope.drawHandle(
    thing: SheetElement,
    world: World,
    session: SessionState,
    colour: Color,
    projection: Projection,
) {
    val pose = poseOf(thing, world, session) ?: return
    val handle = handleOf(thing, world, session) ?: return
    val reach = reachOf(thing, world) + RING_GAP
    val (place, way) = drawHandleLine(Point(pose.x, pose.y), handle, reach, colour, projection) ?: return
    drawTurnHandle(place, way, colour)
}

/** In centimetres. */
private const val RING_GAP = 0.6
private const val HANDLE_HEIGHT = 3.0
