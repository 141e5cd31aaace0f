package robotran.ui.worldedit

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.common.AutosaveBanner
import robotran.ui.parts.ScreenLayout
import robotran.ui.texts.ScreenTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.WorldEditState
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef

/** The world editor, which replaces the workshop: palette, sheet, and properties of the elements. */
@Composable
internal fun WorldEditPane(
    state: WorldEditState,
    session: SessionState,
    document: DocumentState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val making = EditorScope(state.editing, onEvent)
    val view = remember { EditView() }
    val focus = remember { FocusRequester() }
    val title = ScreenTexts.editWorld(spoken)
    val newTitle = WorldEditorTexts.newTitle(spoken)
    var corner by remember { mutableStateOf(Offset.Zero) }
    BoxWithConstraints(
        modifier
            .fillMaxSize()
            .testTag("world-edit")
            .semantics { paneTitle = title }
            .onGloballyPositioned { corner = it.positionInRoot() }
            .onKeyEvent { event -> editForCommand(event)?.let(making::make) != null }
            .background(LocalRobotranColours.current.desk),
    ) {
        val scale = LocalDensity.current.fontScale
        val sheet: @Composable (Modifier) -> Unit = {
            BoxWithConstraints(it) {
                EditSheet(making, view, session, focus)
                val over = Modifier.padding(8.dp).heightIn(max = maxHeight / 2)
                EditHints(state, making, Modifier.align(Alignment.TopCenter).then(over))
                AutosaveBanner(document, onEvent, Modifier.align(Alignment.BottomCenter).then(over))
            }
        }
        Column(Modifier.fillMaxSize()) {
            val withWords = this@BoxWithConstraints.maxWidth >= WORDS_WIDTH * scale
            EditBar(making, view, withWords, canTry = state.origin?.variation == null)
            state.origin?.let { AssignmentBanner(it, onEvent) }
            HorizontalDivider()
            val put = { focus.requestFocus() }
            val width = this@BoxWithConstraints.maxWidth
            val height = this@BoxWithConstraints.maxHeight
            val columns = if (width >= TWO_COLUMNS * scale) 2 else 1
            val isUpright = ScreenLayout.of(width, height + LocalKeyboardHeight.current, scale) == ScreenLayout.UPRIGHT
            when {
                isUpright && width < TWO_COLUMNS -> Under(making, view, newTitle, put, height, sheet)

                width >= WIDE + PANEL_WIDTH * (scale - 1) -> Beside(
                    making,
                    view,
                    newTitle,
                    put,
                    panelWidth(scale),
                    columns,
                    sheet,
                )

                else -> Below(making, view, newTitle, put, height, sheet)
            }
        }
        view.carried?.let { CarriedSign(it, corner) }
    }
}

/** Tablet in landscape and laptop: palette, sheet, panel. */
@Composable
private fun Beside(
    editor: EditorScope,
    view: EditView,
    newTitle: String,
    onPut: () -> Unit,
    panel: Dp,
    columns: Int,
    sheet: @Composable (Modifier) -> Unit,
) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf(EditTab.CHOSEN) }
    FollowSelection(editor, tab) { tab = it }
    Row(Modifier.fillMaxSize()) {
        PaletteStrip(editor, view, columns, onPut, Modifier.fillMaxHeight().background(colours.pane))
        VerticalDivider()
        sheet(Modifier.weight(1f))
        VerticalDivider()
        Column(Modifier.width(panel)) {
            EditTabs(tab) { tab = it }
            EditPanel(editor, tab, { tab = it }, newTitle)
        }
    }
}

/** Tablet in portrait: the palette beside the sheet, the panel below both. */
@Composable
private fun Under(
    editor: EditorScope,
    view: EditView,
    newTitle: String,
    onPut: () -> Unit,
    height: Dp,
    sheet: @Composable (Modifier) -> Unit,
) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf(EditTab.CHOSEN) }
    FollowSelection(editor, tab) { tab = it }
    Column(Modifier.fillMaxSize()) {
        Row(Modifier.weight(1f)) {
            PaletteStrip(editor, view, columns = 1, onPut, Modifier.fillMaxHeight().background(colours.pane))
            VerticalDivider()
            sheet(Modifier.weight(1f))
        }
        HorizontalDivider()
        EditTabs(tab) { tab = it }
        EditPanel(editor, tab, { tab = it }, newTitle, Modifier.height(height * PANEL_SHARE_UPRIGHT))
    }
}

/** Phone: the sheet, below it the palette and the tabs; a touch on a tab opens its content. */
@Composable
private fun Below(
    editor: EditorScope,
    view: EditView,
    newTitle: String,
    onPut: () -> Unit,
    height: Dp,
    sheet: @Composable (Modifier) -> Unit,
) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf<EditTab?>(null) }
    FollowSelection(editor, tab) { if (tab != null) tab = it }
    Column(Modifier.fillMaxSize()) {
        sheet(Modifier.weight(1f))
        HorizontalDivider()
        PaletteStrip(editor, view, columns = null, onPut, Modifier.fillMaxWidth().background(colours.pane))
        HorizontalDivider()
        EditTabs(tab) { tab = if (tab == it) null else it }
        tab?.let { open -> EditPanel(editor, open, { tab = it }, newTitle, Modifier.height(height * PANEL_SHARE)) }
    }
}

/** Shows the selection in the panel; a goal selected in the list of goals stays there. */
@Composable
private fun FollowSelection(editor: EditorScope, tab: EditTab?, onTab: (EditTab) -> Unit) {
    val selection: Set<ElementRef> = editor.editing.selection
    LaunchedEffect(selection) {
        val stays = tab == EditTab.GOALS && selection.all { it.kind == ElementKind.GOAL }
        if (selection.isNotEmpty() && !stays && !(tab == EditTab.THINGS && editor.editing.isMultiSelect)) {
            onTab(EditTab.CHOSEN)
        }
    }
}

private fun panelWidth(scale: Float): Dp = PANEL_WIDTH * (1 + (scale - 1) / 2)

private val PANEL_WIDTH = 340.dp
private val WIDE = 800.dp
private val WORDS_WIDTH = 900.dp
private val TWO_COLUMNS = 1200.dp
private const val PANEL_SHARE = 0.42f
private const val PANEL_SHARE_UPRIGHT = 0.36f
