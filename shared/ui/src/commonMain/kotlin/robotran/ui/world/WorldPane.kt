package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.DpRect
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetCanvas
import robotran.ui.sheet.drawPreview
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.focusRing
import robotran.workshop.blocks.SheetPreview
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetViewState
import robotran.world.World
import robotran.world.geometry.Point

/**
 * The sheet of paper on the desk with its interactive elements, and the buttons of the view.
 *
 * @param preview what a number that is edited would do; null for nothing.
 */
@Composable
internal fun WorldPane(
    world: World,
    session: SessionState,
    view: SheetViewState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    preview: SheetPreview? = null,
) {
    val inputs = rememberOncePerFrame { onEvent(RunEvent.SessionTouched(it)) }
    BoxWithConstraints(modifier.fillMaxSize()) {
        // The buttons are on the side with more space beside the paper.
        val upright = maxWidth / maxHeight > (world.paper.width / world.paper.height).toFloat()
        val withZoom = maxWidth >= MIN_WIDTH_FOR_ZOOM && maxHeight >= MIN_HEIGHT_FOR_ZOOM
        val edge = Dimensions.TARGET + MARGIN
        val aside = if (upright) DpRect(edge, 0.dp, 0.dp, 0.dp) else DpRect(0.dp, 0.dp, 0.dp, edge)
        TouchableSheet(world, session, view, aside, inputs, preview, onEvent)
        SheetControls(
            world,
            view,
            session.surroundings,
            inputs,
            upright,
            withZoom,
            onEvent,
            Modifier.align(Alignment.BottomStart).padding(start = MARGIN, bottom = 8.dp, end = 8.dp),
        )
        BumpAnnouncement(world, session)
    }
}

@Composable
private fun TouchableSheet(
    world: World,
    session: SessionState,
    view: SheetViewState,
    aside: DpRect,
    inputs: FrameThrottledInput,
    preview: SheetPreview?,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val labels = rememberTextMeasurer()
    val now = rememberUpdatedState(session to view.chosen)
    val choose = rememberUpdatedState { thing: SheetElement? -> onEvent(SheetEvent.ElementChosen(thing)) }
    val hand = remember(world) { HandTouch(world, { now.value }, { choose.value(it) }, inputs) }
    val ring = LocalRobotranColours.current.focus
    val danced = rememberDance(session)
    val announced = rememberAnnounced(session)
    val description = describeWorld(world, announced)
    SheetCanvas(
        world,
        session,
        cameraNow(view, session),
        { camera, pushed -> onEvent(SheetEvent.CameraMoved(camera, pushed)) },
        Modifier.fillMaxSize().testTag("world").focusRing(0.dp).focusable().semantics {
            contentDescription = description
        },
        view.shown,
        aside,
        hand,
        danced,
        overlay = { sheet ->
            view.chosen?.let { drawChosen(it, world, session, sheet, ring) }
            preview?.let { drawPreview(it, sheet, labels) }
        },
    ) { sheet ->
        ElementHandles(world, session, announced, sheet, inputs::sendNow, { onEvent(SheetEvent.ElementChosen(it)) })
        if (preview != null) PreviewHandle(preview, sheet) { onEvent(BlockEvent.Put("$it")) }
    }
}

/** Centred on the followed robot. */
private fun cameraNow(view: SheetViewState, session: SessionState): SheetCamera {
    val followed = view.followed?.let { session.robots.getOrNull(it) } ?: return view.camera
    return view.camera.copy(centre = with(followed.robot.pose) { Point(x, y) })
}

private val MARGIN = 16.dp
private val MIN_WIDTH_FOR_ZOOM = 480.dp
private val MIN_HEIGHT_FOR_ZOOM = 400.dp
