package robotran.ui.editing

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.parts.ScreenLayout
import robotran.uikit.*

/**
 * What an editor puts side by side.
 *
 * @param P its tabs.
 * @property columns max number of columns of its palette.
 * @property chosen what is chosen; [tabFor] is the tab that shows it, given the open one.
 * @property palette its palette with this number of columns; null for a row.
 */
internal class EditorParts<P : EditorTab>(
    val tabs: List<P>,
    val tabWidth: Dp,
    val columns: Int,
    val chosen: Any?,
    val tabFor: (open: P?) -> P?,
    val canvas: @Composable (Modifier) -> Unit,
    val palette: @Composable (columns: Int?, Modifier) -> Unit,
    val panel: @Composable (tab: P, onTab: (P) -> Unit, Modifier) -> Unit,
)

/**
 * An editor, which covers the workshop: a bar, and below it palette, canvas and panel in the way that suits the screen.
 *
 * @param onCommand handles a key that nothing in the editor has consumed.
 */
@Composable
internal fun <P : EditorTab> EditorFrame(
    tag: String,
    title: String,
    parts: EditorParts<P>,
    carried: CarriedItem?,
    onCommand: (KeyEvent) -> Boolean,
    modifier: Modifier,
    bar: @Composable ColumnScope.(withWords: Boolean) -> Unit,
) {
    var corner by remember { mutableStateOf(Offset.Zero) }
    BoxWithConstraints(
        modifier
            .fillMaxSize()
            .testTag(tag)
            .semantics { paneTitle = title }
            .onGloballyPositioned { corner = it.positionInRoot() }
            .onKeyEvent(onCommand)
            .background(LocalRobotranColours.current.desk),
    ) {
        val scale = LocalDensity.current.fontScale
        val width = maxWidth
        val height = maxHeight
        Column(Modifier.fillMaxSize()) {
            bar(width >= WORDS_WIDTH * scale)
            HorizontalDivider()
            val isUpright = ScreenLayout.of(width, height + LocalKeyboardHeight.current, scale) == ScreenLayout.UPRIGHT
            val columns = if (width >= TWO_COLUMNS * scale) parts.columns else 1
            when {
                isUpright && (parts.columns == 1 || width < TWO_COLUMNS) -> Under(parts, height)
                width >= WIDE + PANEL_WIDTH * (scale - 1) -> Beside(parts, columns, PANEL_WIDTH * (1 + (scale - 1) / 2))
                else -> Below(parts, height)
            }
        }
        carried?.let { CarriedSign(it, corner) }
    }
}

/** Tablet in landscape and laptop: palette, canvas, panel. */
@Composable
private fun <P : EditorTab> Beside(parts: EditorParts<P>, columns: Int, panel: Dp) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf(parts.tabs.first()) }
    FollowChosen(parts, tab) { tab = it }
    Row(Modifier.fillMaxSize()) {
        parts.palette(columns, Modifier.fillMaxHeight().background(colours.pane))
        VerticalDivider()
        parts.canvas(Modifier.weight(1f))
        VerticalDivider()
        Column(Modifier.width(panel)) {
            EditorTabs(parts.tabs, tab, parts.tabWidth) { tab = it }
            parts.panel(tab, { tab = it }, Modifier)
        }
    }
}

/** Tablet in portrait: the palette beside the canvas, the panel below both. */
@Composable
private fun <P : EditorTab> Under(parts: EditorParts<P>, height: Dp) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf(parts.tabs.first()) }
    FollowChosen(parts, tab) { tab = it }
    Column(Modifier.fillMaxSize()) {
        Row(Modifier.weight(1f)) {
            parts.palette(1, Modifier.fillMaxHeight().background(colours.pane))
            VerticalDivider()
            parts.canvas(Modifier.weight(1f))
        }
        HorizontalDivider()
        EditorTabs(parts.tabs, tab, parts.tabWidth) { tab = it }
        parts.panel(tab, { tab = it }, Modifier.height(height * PANEL_SHARE_UPRIGHT))
    }
}

/** Phone: the canvas, below it the palette and the tabs; a touch on a tab opens its content. */
@Composable
private fun <P : EditorTab> Below(parts: EditorParts<P>, height: Dp) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf<P?>(null) }
    FollowChosen(parts, tab) { if (tab != null) tab = it }
    Column(Modifier.fillMaxSize()) {
        parts.canvas(Modifier.weight(1f))
        HorizontalDivider()
        parts.palette(null, Modifier.fillMaxWidth().background(colours.pane))
        HorizontalDivider()
        EditorTabs(parts.tabs, tab, parts.tabWidth) { tab = if (tab == it) null else it }
        tab?.let { open -> parts.panel(open, { tab = it }, Modifier.height(height * PANEL_SHARE)) }
    }
}

/** Shows what is chosen in the panel. */
@Composable
private fun <P : EditorTab> FollowChosen(parts: EditorParts<P>, open: P?, onTab: (P) -> Unit) =
    LaunchedEffect(parts.chosen) { parts.tabFor(open)?.let(onTab) }

private val PANEL_WIDTH = 340.dp
private val WIDE = 800.dp
private val WORDS_WIDTH = 900.dp
private val TWO_COLUMNS = 1200.dp
private const val PANEL_SHARE = 0.42f
private const val PANEL_SHARE_UPRIGHT = 0.36f
