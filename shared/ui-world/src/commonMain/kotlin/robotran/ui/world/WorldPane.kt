package robotran.ui.world

import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.DpRect
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetCanvas
import robotran.ui.sheet.ShownWorld
import robotran.ui.sheet.drawDrawingFrame
import robotran.ui.sheet.drawPreview
import robotran.ui.sheet.drawShortfalls
import robotran.ui.sheet.drawStrayed
import robotran.ui.sheet.previewEnd
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.blocks.SheetPreview
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.placesToMeasure
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetLayer
import robotran.workshop.state.SheetViewState
import robotran.workshop.state.SheetWords
import robotran.workshop.state.ShortfallMark
import robotran.workshop.state.strayedRobots
import robotran.world.World
import robotran.world.geometry.Point

/**
 * What is shown over a world.
 *
 * @property preview what a number that is edited would do; null for nothing.
 * @property shortfalls what was missing for the goals.
 * @property isSolved whether the task is solved: then the drawing has a frame, and the robot dances when it becomes so,
 * which the hand does not feel.
 */
class WorldMarks(
    val preview: SheetPreview? = null,
    val shortfalls: List<ShortfallMark> = emptyList(),
    val isSolved: Boolean = false,
)

/**
 * The sheet of paper on the desk with its interactive elements, and the buttons of the view.
 *
 * @param canShow whether there is a button to show what was made.
 */
@Composable
fun WorldPane(
    world: World,
    session: SessionState,
    view: SheetViewState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    marks: WorldMarks = WorldMarks(),
    canShow: Boolean = true,
) {
    val shown = ShownWorld(world, session, dancing(session, marks.isSolved), view)
    val sentences = rememberSentences(view.words, shown)
    val inputs = rememberOncePerFrame { onEvent(RunEvent.SessionTouched(it)) }
    val focus = remember { FocusRequester() }
    val closeWords = {
        // What had the focus goes.
        focus.requestFocus()
        onEvent(SheetEvent.WordsChanged(null))
    }
    BoxWithConstraints(modifier.fillMaxSize()) {
        val room = SheetRoom.of(world, maxWidth, maxHeight, view.tellsRuns)
        Column(Modifier.fillMaxSize()) {
            // Beside the buttons, which stay where they are.
            if (view.words != null) {
                WordsPanel(shown, sentences, closeWords, onEvent, Modifier.padding(start = room.aside.left))
            }
            Box(Modifier.weight(1f).focusRequester(focus)) {
                if (view.isIn3D) {
                    TouchableSpace(shown, marks, room.aside, inputs, onEvent)
                } else {
                    TouchableSheet(shown, marks, ExploredWords(sentences, closeWords), room.aside, inputs, onEvent)
                }
            }
        }
        SheetControls(
            shown,
            inputs,
            room.isUpright,
            hasZoomButtons(maxWidth, maxHeight),
            canShow,
            onEvent,
            Modifier.align(Alignment.BottomStart).padding(start = MARGIN, bottom = 8.dp, end = 8.dp),
        )
        BumpAnnouncement(world, session)
        WordsAnnouncement(view.words, sentences)
    }
}

/** What the explorer says, and what puts it away. */
private class ExploredWords(val sentences: List<String>, val close: () -> Unit)

@Composable
private fun TouchableSheet(
    shown: ShownWorld,
    marks: WorldMarks,
    explored: ExploredWords,
    aside: DpRect,
    inputs: FrameThrottledInput,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val world = shown.world
    val session = shown.session
    val view = shown.view
    val preview = marks.preview
    val cross = (view.words as? SheetWords.Explored)?.place
    val explorer = rememberExplorer(world, onEvent)
    val labels = rememberTextMeasurer()
    val strayed = remember(world, session) { strayedRobots(world, session) }
    val now = rememberUpdatedState(session to view.chosen)
    val choose = rememberUpdatedState { thing: SheetElement? -> onEvent(SheetEvent.ElementChosen(thing)) }
    val measuring = view.measuring
    val things = if (measuring == null) emptyList() else remember(world, session) { placesToMeasure(world, session) }
    val measured = rememberUpdatedState(measuring?.let { it to things })
    val measure = { changed: Measuring? -> onEvent(SheetEvent.MeasuringChanged(changed)) }
    val putMeasure = rememberUpdatedState(measure)
    val ruler = remember(world) {
        MeasuringTouch({ measured.value }) { putMeasure.value(it) }
    }
    val measuringLabels = measuring?.let { measuringLabels(it) }
    val hand = remember(world) { HandTouch(world, { now.value }, { choose.value(it) }, inputs) }
    val ring = LocalRobotranColours.current.focus
    val announced = rememberAnnounced(session)
    val description = describeWorld(world, announced)
    val asking = askingActions(view, session, onEvent)
    SheetCanvas(
        shown,
        cameraNow(view, session),
        { camera, pushed -> onEvent(SheetEvent.CameraMoved(camera, pushed)) },
        Modifier.fillMaxSize().testTag(WorldTags.WORLD).focusRing(0.dp).focusable().semantics {
            contentDescription = description
            customActions = asking
        },
        aside,
        if (cross != null) {
            explorer
        } else if (measuring == null) {
            hand
        } else {
            ruler
        },
        overlay = { sheet ->
            if (marks.isSolved) drawDrawingFrame(session, world.paper, sheet)
            if (SheetLayer.GOALS in view.shown) drawShortfalls(marks.shortfalls, sheet, labels)
            drawStrayed(strayed, world, sheet)
            view.chosen?.let { drawChosen(it, world, session, sheet, ring) }
            if (measuring != null && measuringLabels != null) drawMeasuring(measuring, measuringLabels, sheet, labels)
            preview?.let { drawPreview(it, sheet, labels) }
            cross?.let { drawExploringCross(it, sheet, ring) }
        },
    ) { sheet ->
        val places = HandlePlaces { pose, reach -> HandlePlace(sheet.toPixels(pose.x, pose.y), sheet.toPixels(reach)) }
        ElementHandles(world, session, announced, places, inputs::sendNow, { onEvent(SheetEvent.ElementChosen(it)) })
        if (cross != null) {
            ExploringCross(cross, explored.sentences.joinToString(" "), sheet) { place ->
                val moved = place?.let { SheetWords.Explored(explorable(it, world)) }
                if (moved == null) explored.close() else onEvent(SheetEvent.WordsChanged(moved))
            }
        }
        if (measuring != null) MeasuringHandles(measuring, things, sheet, measure)
        if (preview != null) {
            PreviewHandle(preview, previewEnd(preview, sheet), sheet::toCentimetres) { onEvent(BlockEvent.Put("$it")) }
        }
    }
}

@Composable
private fun rememberExplorer(world: World, onEvent: (WorkshopEvent) -> Unit): ExploringTouch {
    val send by rememberUpdatedState(onEvent)
    return remember(world) { ExploringTouch(world) { send(SheetEvent.WordsChanged(SheetWords.Explored(it))) } }
}

/** Centred on the followed robot. */
private fun cameraNow(view: SheetViewState, session: SessionState): SheetCamera {
    val followed = view.followed?.let { session.robots.getOrNull(it) } ?: return view.camera
    return view.camera.copy(centre = with(followed.robot.pose) { Point(x, y) })
}

private val MARGIN = 16.dp
