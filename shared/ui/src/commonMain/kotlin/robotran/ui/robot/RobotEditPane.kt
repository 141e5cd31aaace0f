package robotran.ui.robot

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
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
import robotran.ui.texts.RobotTexts
import robotran.ui.worldedit.CarriedSign
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorldEditState

/** The workbench, which covers the world editor: palette, plan, and the figures of the robot. */
@Composable
internal fun RobotEditPane(
    state: RobotEditState,
    world: WorldEditState,
    session: SessionState,
    document: DocumentState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    notice: @Composable () -> Unit,
) {
    val scope = RobotScope(state.editing, onEvent)
    val view = remember(state.number) { PlanView(state.editing.robot) }
    val focus = remember { FocusRequester() }
    val title = RobotTexts.bench(spoken)
    var corner by remember { mutableStateOf(Offset.Zero) }
    BoxWithConstraints(
        modifier
            .fillMaxSize()
            .testTag("robot-bench")
            .semantics { paneTitle = title }
            .onGloballyPositioned { corner = it.positionInRoot() }
            .onKeyEvent { event -> robotEditForCommand(event)?.let(scope::make) != null }
            .background(LocalRobotranColours.current.desk),
    ) {
        val scale = LocalDensity.current.fontScale
        val width = maxWidth
        val height = maxHeight
        val plan: @Composable (Modifier) -> Unit = {
            BoxWithConstraints(it) {
                if (state.sheetShown) {
                    RobotOnSheet(state, world.world, session)
                } else {
                    RobotPlanCanvas(scope, view, state.colour, focus)
                }
                val over = Modifier.padding(8.dp).heightIn(max = maxHeight / 2)
                // Where the back of the robot is: most is built in front.
                RobotHints(state, world, scope, Modifier.align(Alignment.BottomCenter).then(over))
                Column(Modifier.align(Alignment.TopCenter).then(over), Arrangement.spacedBy(8.dp)) {
                    notice()
                    AutosaveBanner(document, onEvent)
                }
            }
        }
        val put = { if (!state.sheetShown) focus.requestFocus() }
        val parts = BenchParts(scope, view, put, plan)
        Column(Modifier.fillMaxSize()) {
            RobotBar(scope, view, state.sheetShown, withWords = width >= WORDS_WIDTH * scale)
            HorizontalDivider()
            val isUpright = ScreenLayout.of(width, height + LocalKeyboardHeight.current, scale) == ScreenLayout.UPRIGHT
            when {
                isUpright -> Under(parts, height)
                width >= WIDE + PANEL_WIDTH * (scale - 1) -> Beside(parts, PANEL_WIDTH * (1 + (scale - 1) / 2))
                else -> Below(parts, height)
            }
        }
        view.carried?.let { CarriedSign(it, corner) }
    }
}

/** What the layouts put side by side. */
private class BenchParts(
    val scope: RobotScope,
    val view: PlanView,
    val onPut: () -> Unit,
    val plan: @Composable (Modifier) -> Unit,
)

/** Tablet in landscape and laptop: palette, plan, panel. */
@Composable
private fun Beside(parts: BenchParts, panel: Dp) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf(RobotTab.CHOSEN) }
    FollowChosen(parts.scope) { tab = it }
    Row(Modifier.fillMaxSize()) {
        Palette(parts, upright = true, Modifier.fillMaxHeight().background(colours.pane))
        VerticalDivider()
        parts.plan(Modifier.weight(1f))
        VerticalDivider()
        Column(Modifier.width(panel)) {
            RobotTabs(tab) { tab = it }
            RobotPanel(parts.scope, tab, { tab = it })
        }
    }
}

/** Tablet in portrait: the palette beside the plan, the panel below both. */
@Composable
private fun Under(parts: BenchParts, height: Dp) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf(RobotTab.CHOSEN) }
    FollowChosen(parts.scope) { tab = it }
    Column(Modifier.fillMaxSize()) {
        Row(Modifier.weight(1f)) {
            Palette(parts, upright = true, Modifier.fillMaxHeight().background(colours.pane))
            VerticalDivider()
            parts.plan(Modifier.weight(1f))
        }
        HorizontalDivider()
        RobotTabs(tab) { tab = it }
        RobotPanel(parts.scope, tab, { tab = it }, Modifier.height(height * PANEL_SHARE_UPRIGHT))
    }
}

/** Phone: the plan, below it the palette and the tabs; a touch on a tab opens its content. */
@Composable
private fun Below(parts: BenchParts, height: Dp) {
    val colours = LocalRobotranColours.current
    var tab by remember { mutableStateOf<RobotTab?>(null) }
    FollowChosen(parts.scope) { if (tab != null) tab = it }
    Column(Modifier.fillMaxSize()) {
        parts.plan(Modifier.weight(1f))
        HorizontalDivider()
        Palette(parts, upright = false, Modifier.fillMaxWidth().background(colours.pane))
        HorizontalDivider()
        RobotTabs(tab) { tab = if (tab == it) null else it }
        tab?.let { open -> RobotPanel(parts.scope, open, { tab = it }, Modifier.height(height * PANEL_SHARE)) }
    }
}

@Composable
private fun Palette(parts: BenchParts, upright: Boolean, modifier: Modifier) =
    RobotPalette(parts.scope, parts.view, upright, parts.onPut, modifier)

/** Shows what is chosen in the panel. */
@Composable
private fun FollowChosen(scope: RobotScope, onTab: (RobotTab) -> Unit) {
    val chosen = scope.editing.chosen
    LaunchedEffect(chosen) { if (chosen != null) onTab(RobotTab.CHOSEN) }
}

private val PANEL_WIDTH = 340.dp
private val WIDE = 800.dp
private val WORDS_WIDTH = 900.dp
private const val PANEL_SHARE = 0.42f
private const val PANEL_SHARE_UPRIGHT = 0.36f
