package robotran.ui.world

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowColumn
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.simulation.state.AmbientConditions
import robotran.ui.resources.Res
import robotran.ui.resources.sheet_follow
import robotran.ui.resources.sheet_further
import robotran.ui.resources.sheet_nearer
import robotran.ui.resources.sheet_whole
import robotran.ui.resources.show_title
import robotran.ui.sheet.KEY_ZOOM
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.ShowEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElementKind
import robotran.workshop.state.SheetViewState
import robotran.world.World

/**
 * The buttons at the edge of the sheet. They wrap if they do not fit in one line, such as on a small screen with large
 * text.
 *
 * @param upright whether they are arranged vertically.
 * @param canShow whether there is a button to show what was made.
 * @param withZoom whether there is room for zoom buttons, which two fingers can replace.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun SheetControls(
    world: World,
    view: SheetViewState,
    surroundings: AmbientConditions,
    inputs: FrameThrottledInput,
    upright: Boolean,
    withZoom: Boolean,
    canShow: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val buttons: @Composable () -> Unit = {
        if (withZoom) ZoomButtons(view.camera, onEvent)
        SheetButton(SheetIcons.WHOLE, stringResource(Res.string.sheet_whole), "sheet-whole") {
            onEvent(SheetEvent.WholeSheetRequested)
        }
        val follows = view.followed != null
        SheetButton(SheetIcons.FOLLOW, stringResource(Res.string.sheet_follow), "sheet-follow", on = follows) {
            onEvent(SheetEvent.FollowChosen(if (follows) null else robotToFollow(view)))
        }
        LayerMenu(view.shown) { layer, on -> onEvent(SheetEvent.LayerSwitched(layer, on)) }
        if (noticesSurroundings(world)) AmbientConditionsMenu(world, surroundings, inputs)
        if (canShow) {
            SheetButton(SheetIcons.SHOW, stringResource(Res.string.show_title), "show") { onEvent(ShowEvent.Requested) }
        }
    }
    val gap = Arrangement.spacedBy(GAP)
    if (upright) FlowColumn(modifier, gap, gap) { buttons() } else FlowRow(modifier, gap, gap) { buttons() }
}

@Composable
private fun ZoomButtons(camera: SheetCamera, onEvent: (SheetEvent) -> Unit) {
    fun zoom(factor: Double) {
        val zoom = (camera.zoom * factor).coerceIn(SheetCamera.MIN_ZOOM, SheetCamera.MAX_ZOOM)
        onEvent(SheetEvent.CameraMoved(camera.copy(zoom = zoom), pushed = false))
    }
    val isNearest = camera.zoom >= SheetCamera.MAX_ZOOM
    val isFurthest = camera.zoom <= SheetCamera.MIN_ZOOM
    SheetButton(SheetIcons.NEARER, stringResource(Res.string.sheet_nearer), "sheet-nearer", enabled = !isNearest) {
        zoom(KEY_ZOOM)
    }
    SheetButton(SheetIcons.FURTHER, stringResource(Res.string.sheet_further), "sheet-further", enabled = !isFurthest) {
        zoom(1 / KEY_ZOOM)
    }
}

/** The selected robot, or else the pupil's own. */
private fun robotToFollow(view: SheetViewState): Int =
    view.chosen?.takeIf { it.kind == SheetElementKind.ROBOT }?.number ?: 0

private val GAP = 8.dp
