package robotran.ui.worldedit

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.boundsInRoot
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.rememberTextMeasurer
import robotran.editing.WorldEditorTexts
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetZoom
import robotran.ui.sheet.drawSheet
import robotran.ui.sheet.drawSights
import robotran.uikit.*
import robotran.workshop.state.SheetLayer
import robotran.worldediting.ElementKind

/** The sheet of the world editor, with touch and keyboard input. Screen readers announce the selection. */
@Composable
internal fun EditSheet(
    editor: EditorScope,
    view: EditView,
    session: SessionState,
    focus: FocusRequester,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val world = editor.world
    val zoom = remember(world) { SheetZoom(world) }
    val resting = remember(world, session.brick) { initialStateOf(world, session) }
    val labels = rememberTextMeasurer()
    val latest = rememberUpdatedState(editor)
    val name = WorldEditorTexts.sheet(spoken)
    val chosen = selectionText(editor.editing)
    val shown = if (editor.editing.snapping.grid > 0) setOf(SheetLayer.GOALS, SheetLayer.GRID) else SheetLayer.DEFAULT
    val isRobotChosen = editor.editing.selection.any { it.kind == ElementKind.ROBOT }
    Canvas(
        modifier
            .fillMaxSize()
            .testTag("edit-sheet")
            .focusRing()
            .onGloballyPositioned { view.window = it.boundsInRoot() }
            .semantics {
                contentDescription = name
                stateDescription = chosen
                liveRegion = LiveRegionMode.Polite
            }
            .focusRequester(focus)
            .onKeyEvent { event -> editForKey(event, latest.value.editing)?.let { latest.value.make(it) } != null }
            .focusable()
            .pointerInput(view) { editByTouch(view, { latest.value }, { focus.requestFocus() }) }
            .pointerInput(view) { zoomByWheel(view) { latest.value } }
            .clipToBounds(),
    ) {
        if (view.window.isEmpty) return@Canvas
        val transform = view.transform(world.paper)
        drawSheet(
            zoom.at(transform.pixelsPerCentimetre, settled = true),
            resting,
            sheetColours,
            labels,
            shown,
            transform,
        )
        // Whoever puts a robot somewhere wants to know what it sees there.
        if (isRobotChosen) drawSights(world, resting, transform)
        drawEditing(editor.editing, transform, view, colours)
    }
    LaunchedEffect(focus) { focus.requestFocus() }
}
