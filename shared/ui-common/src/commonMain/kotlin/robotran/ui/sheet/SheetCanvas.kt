package robotran.ui.sheet

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.DpRect
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.delay
import robotran.uikit.*
import robotran.workshop.state.SheetCamera

/**
 * A sheet with zoom and pan by touch, mouse, wheel and, while focused, the keys `+`, `-`, `0` and the arrows.
 *
 * @param onCamera receives the new camera, and whether the sheet was panned; the caller passes it back as [camera].
 * @param aside the covered edges of the pane; at the min zoom all of the paper is visible beside them.
 * @param touch handles touches on elements; null if touches only pan the sheet.
 * @param overlay draws over the sheet.
 * @param content composables over the sheet, such as focusable elements.
 */
@Composable
fun SheetCanvas(
    shown: ShownWorld,
    camera: SheetCamera,
    onCamera: (SheetCamera, Boolean) -> Unit,
    modifier: Modifier = Modifier,
    aside: DpRect = DpRect(0.dp, 0.dp, 0.dp, 0.dp),
    touch: SheetTouch? = null,
    overlay: DrawScope.(SheetTransform) -> Unit = {},
    content: @Composable BoxScope.(SheetTransform) -> Unit = {},
) {
    val world = shown.world
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val grain = remember(colours) { if (colours.isHighContrast) null else paperGrain(colours.paper) }
    val isStill = LocalLessMotion.current
    val drawings = remember(world) { SheetZoom(world) }
    val labels = rememberTextMeasurer(LABELS_REMEMBERED)
    val look = remember { SheetLook() }
    val fingers by rememberUpdatedState(touch)
    BoxWithConstraints(
        modifier
            .clipToBounds()
            .onKeyEvent { look.onKey(it) }
            .pointerInput(look) { sheetGestures(look) { fingers } },
    ) {
        val window = with(LocalDensity.current) {
            Rect(
                aside.left.toPx(),
                aside.top.toPx(),
                constraints.maxWidth - aside.right.toPx(),
                constraints.maxHeight - aside.bottom.toPx(),
            )
        }
        val view = camera.transform(world.paper, window)
        SideEffect { look.show(camera.within(world.paper, window), world.paper, window, onCamera) }
        var settled by remember { mutableFloatStateOf(view.pixelsPerCentimetre) }
        LaunchedEffect(view.pixelsPerCentimetre) {
            delay(SETTLING_MILLISECONDS)
            settled = view.pixelsPerCentimetre
        }
        Canvas(Modifier.matchParentSize()) {
            val drawing = drawings.at(view.pixelsPerCentimetre, settled == view.pixelsPerCentimetre)
            drawSheet(drawing, shown.drawn, sheetColours, labels, shown.view.shown, view, grain, isStill)
            overlay(view)
        }
        Box(Modifier.matchParentSize()) { content(view) }
    }
}

private const val SETTLING_MILLISECONDS = 150L
private const val LABELS_REMEMBERED = 64
