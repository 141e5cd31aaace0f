package robotran.ui.drawer

import androidx.compose.animation.animateContentSize
import androidx.compose.animation.core.snap
import androidx.compose.animation.core.tween
import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.draggable
import androidx.compose.foundation.gestures.rememberDraggableState
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.ProgressBarRangeInfo
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.progressBarRangeInfo
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.setProgress
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.RunPaneState

/**
 * The open drawer below the world; its height is adjustable. Closed, it takes no room: its tabs ([FootTabs]) are
 * always below it, and do not move.
 *
 * @param max the max height.
 */
@Composable
fun RunDrawer(state: RunPaneState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier, max: Dp = 560.dp) {
    val colours = LocalRobotranColours.current
    var height by rememberSaveable { mutableFloatStateOf(DEFAULT_HEIGHT) }
    Column(
        modifier
            .testTag(RunTags.DRAWER)
            .fillMaxWidth()
            .background(colours.pane)
            .animateContentSize(if (LocalLessMotion.current) snap() else tween(Motion.MOVE)),
    ) {
        val tab = state.drawer.tab
        if (tab != null) {
            DrawerGrip(height, max.value, { height = it })
            val shownHeight = height.coerceIn(MIN_HEIGHT, maxOf(MIN_HEIGHT, max.value)).dp
            OneOrTwo(tab, state, onEvent, shownHeight)
            HorizontalDivider()
        }
    }
}

/** [tab] and, if there is room, the second view next to it. */
@Composable
private fun OneOrTwo(tab: DrawerTab, state: RunPaneState, onEvent: (WorkshopEvent) -> Unit, height: Dp) {
    val colours = LocalRobotranColours.current
    BoxWithConstraints(Modifier.fillMaxWidth()) {
        val hasRoom = maxWidth >= MIN_WIDTH_FOR_TWO * LocalDensity.current.fontScale
        val beside = state.drawer.beside.takeIf { hasRoom }
        val showTwo = {
            onEvent(
                RunEvent.DrawerBesideChosen(
                    if (tab == DrawerTab.CHART) {
                        DrawerTab.LOG
                    } else {
                        DrawerTab.CHART
                    },
                ),
            )
        }
        Row(Modifier.fillMaxWidth()) {
            Column(Modifier.weight(1f)) {
                DrawerHead(
                    tab,
                    { onEvent(RunEvent.DrawerChosen(null)) },
                    onTwo = showTwo.takeIf { hasRoom && beside == null },
                )
                HorizontalDivider()
                DrawerContent(tab, state, onEvent, Modifier.fillMaxWidth().height(height))
            }
            if (beside != null) {
                VerticalDivider(Modifier.height(height + Dimensions.TARGET), color = colours.line)
                Column(Modifier.weight(1f)) {
                    BesideTabs(beside, { onEvent(RunEvent.DrawerBesideChosen(it)) })
                    HorizontalDivider()
                    DrawerContent(beside, state, onEvent, Modifier.fillMaxWidth().height(height))
                }
            }
        }
    }
}

/** The drawer's content on a whole pane, for small screens; empty while it is closed. */
@Composable
fun DrawerPage(state: RunPaneState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val tab = state.drawer.tab ?: return
    val colours = LocalRobotranColours.current
    Column(modifier.testTag(RunTags.DRAWER).fillMaxSize().background(colours.pane)) {
        DrawerTabs(tab, { onEvent(RunEvent.DrawerChosen(it)) })
        HorizontalDivider()
        DrawerContent(tab, state, onEvent, Modifier.weight(1f).fillMaxWidth())
    }
}

@Composable
private fun DrawerContent(tab: DrawerTab, state: RunPaneState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    when (tab) {
        DrawerTab.VARIABLES -> VariablesView(state.drawer.variables, onEvent, modifier)
        DrawerTab.LOG -> LogView(state.drawer.log, onEvent, modifier)
        DrawerTab.CHART -> ChartView(state, onEvent, modifier)

        DrawerTab.GOALS -> GoalsView(
            state.session.goals,
            modifier,
            state.world.task,
            state.shortfalls,
            onEvent,
        )

        DrawerTab.WHY -> WhyView(state, onEvent, modifier)
    }
}

/** Changes the drawer's height by dragging or with the arrow keys. */
@Composable
private fun DrawerGrip(height: Float, max: Float, onHeight: (Float) -> Unit) {
    val colours = LocalRobotranColours.current
    val description = RunTexts.drawerHeight(spoken)
    val now by rememberUpdatedState(height)
    val range = MIN_HEIGHT..maxOf(MIN_HEIGHT + 1, max)
    val density = LocalDensity.current.density
    val move = { change: Float -> onHeight((now + change).coerceIn(range)) }
    val drag = rememberDraggableState { move(-it / density) }
    Box(
        Modifier
            .testTag(RunTags.DRAWER_GRIP)
            .fillMaxWidth()
            .height(24.dp)
            .focusRing(12.dp)
            .onKeyEvent { event ->
                val step = STEPS[event.key] ?: return@onKeyEvent false
                if (event.type == KeyEventType.KeyDown) move(step)
                true
            }
            .draggable(drag, Orientation.Vertical)
            .focusable()
            .semantics {
                contentDescription = description
                progressBarRangeInfo = ProgressBarRangeInfo(now.coerceIn(range), range)
                setProgress {
                    onHeight(it.coerceIn(range))
                    true
                }
            }
            .drawBehind {
                drawLine(colours.line, Offset(0f, 0f), Offset(size.width, 0f), 1.dp.toPx())
                val width = 40.dp.toPx()
                val thick = 6.dp.toPx()
                val corner = Offset((size.width - width) / 2, (size.height - thick) / 2)
                drawRoundRect(colours.quiet, corner, Size(width, thick), CornerRadius(thick / 2))
            },
    )
}

/** From this width on there is room for two views at default font size. */
private val MIN_WIDTH_FOR_TWO = 720.dp
private const val DEFAULT_HEIGHT = 240f
private const val MIN_HEIGHT = 120f
private val STEPS = mapOf(Key.DirectionUp to 24f, Key.DirectionDown to -24f)
