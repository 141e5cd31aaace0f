package robotran.ui.world

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowColumn
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.sheet.KEY_ZOOM
import robotran.ui.sheet.ShownWorld
import robotran.ui.sheet3d.leastZoom
import robotran.ui.texts.CommonTexts
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.measuring.measuringFrom
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetViewState
import robotran.workshop.state.SpaceCamera
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
    shown: ShownWorld,
    inputs: FrameThrottledInput,
    upright: Boolean,
    withZoom: Boolean,
    canShow: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val world = shown.world
    val view = shown.view
    val buttons: @Composable () -> Unit = {
        if (withZoom) {
            if (view.isIn3D) SpaceZoomButtons(view, onEvent) else ZoomButtons(view.camera, onEvent)
        }
        IconButton(SheetIcons.WHOLE, SheetTexts.whole(spoken), WorldTags.SHEET_WHOLE, IconButtonKind.FLOATING) {
            onEvent(SheetEvent.WholeSheetRequested)
        }
        ViewMenu(view, shown.session, onEvent)
        if (view.tellsRuns) {
            IconButton(
                SheetIcons.WORDS,
                SheetTexts.whereAmI(spoken),
                WorldTags.ofControls(WorldTags.WHERE_AM_I),
                IconButtonKind.FLOATING,
            ) { onEvent(askFor(WordsKind.WHERE, view, shown.session)) }
        }
        val isMeasuring = view.measuring != null
        IconSwitch(SheetIcons.MEASURE, SheetTexts.measure(spoken), WorldTags.SHEET_MEASURE, isMeasuring) {
            val ruler = if (isMeasuring) null else measuringFrom(world, shown.session, robotToFollow(view))
            onEvent(SheetEvent.MeasuringChanged(ruler))
        }
        if (noticesSurroundings(world)) AmbientConditionsMenu(world, shown.session.surroundings, inputs)
        IconSwitch(SheetIcons.SPACE, SheetTexts.spaceView(spoken), WorldTags.SHEET_3D, view.isIn3D) {
            onEvent(SheetEvent.SpaceSwitched(!view.isIn3D))
        }
        if (canShow) {
            IconButton(
                SheetIcons.SHOW,
                CommonTexts.showWork(spoken),
                WorldTags.SHOW,
                IconButtonKind.FLOATING,
            ) { onEvent(ExportEvent.Requested) }
        }
    }
    val gap = Arrangement.spacedBy(GAP)
    if (upright) FlowColumn(modifier, gap, gap) { buttons() } else FlowRow(modifier, gap, gap) { buttons() }
}

@Composable
private fun ZoomButtons(camera: SheetCamera, onEvent: (SheetEvent) -> Unit) {
    ZoomButtons(camera.zoom > SheetCamera.MIN_ZOOM, camera.zoom < SheetCamera.MAX_ZOOM) { factor ->
        val zoom = (camera.zoom * factor).coerceIn(SheetCamera.MIN_ZOOM, SheetCamera.MAX_ZOOM)
        onEvent(SheetEvent.CameraMoved(camera.copy(zoom = zoom), pushed = false))
    }
}

/** A robot's eye has no zoom. */
@Composable
private fun SpaceZoomButtons(view: SheetViewState, onEvent: (SheetEvent) -> Unit) {
    val camera = view.spaceCamera
    val hasZoom = view.cameraKind != CameraKind.ROBOT_EYE
    val least = leastZoom(view.cameraKind)
    ZoomButtons(hasZoom && camera.zoom > least, hasZoom && camera.zoom < SpaceCamera.MAX_ZOOM) { factor ->
        val zoom = (camera.zoom * factor).coerceIn(least, SpaceCamera.MAX_ZOOM)
        onEvent(SheetEvent.SpaceCameraMoved(camera.copy(zoom = zoom)))
    }
}

@Composable
private fun ZoomButtons(canGoFurther: Boolean, canGoNearer: Boolean, zoom: (Double) -> Unit) {
    IconButton(
        SheetIcons.NEARER,
        SheetTexts.nearer(spoken),
        WorldTags.SHEET_NEARER,
        IconButtonKind.FLOATING,
        enabled = canGoNearer,
    ) {
        zoom(KEY_ZOOM)
    }
    IconButton(
        SheetIcons.FURTHER,
        SheetTexts.further(spoken),
        WorldTags.SHEET_FURTHER,
        IconButtonKind.FLOATING,
        enabled = canGoFurther,
    ) {
        zoom(1 / KEY_ZOOM)
    }
}

/** Whether a sheet of [width] by [height] has room for zoom buttons, which two fingers can replace. */
internal fun hasZoomButtons(width: Dp, height: Dp): Boolean =
    width >= MIN_WIDTH_FOR_ZOOM && height >= MIN_HEIGHT_FOR_ZOOM

/** The number of columns of the buttons of [world] beside a sheet of this [height]. */
internal fun sheetButtonColumns(world: World, withZoom: Boolean, withWords: Boolean, height: Dp): Int {
    val optional = listOf(noticesSurroundings(world), withWords).count { it }
    val buttons = BUTTONS + (if (withZoom) ZOOM_BUTTONS else 0) + optional
    val inColumn = (height / SHEET_BUTTON_STEP).toInt().coerceAtLeast(1)
    return (buttons + inColumn - 1) / inColumn
}

/** The whole sheet, how it is looked at, measure, 3D, and show, which an embedded page leaves out. */
private const val BUTTONS = 5
private const val ZOOM_BUTTONS = 2
private val MIN_WIDTH_FOR_ZOOM = 480.dp
private val MIN_HEIGHT_FOR_ZOOM = 400.dp
private val GAP = 8.dp

/** A button and the gap to the next. */
internal val SHEET_BUTTON_STEP = Dimensions.TARGET + GAP
