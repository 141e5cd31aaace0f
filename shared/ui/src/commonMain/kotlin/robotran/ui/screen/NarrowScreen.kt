package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.assignment.howFar
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.BrickHint
import robotran.ui.brick.MIN_BRICK_WIDTH
import robotran.ui.common.AutosaveBanner
import robotran.ui.drawer.DrawerPage
import robotran.ui.drawer.TaskAndGoals
import robotran.ui.learning.TutorialPane
import robotran.ui.learning.TutorialStrip
import robotran.ui.program.ProgramPane
import robotran.ui.program.blocks.LocalSheetPicture
import robotran.ui.runbar.RunBar
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.world.MiniSheet
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState

/** Phone: one pane at a time below three tabs, or the tutorial in its place; the run bar is always at the bottom. */
@Composable
internal fun NarrowScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val tutorial = state.learning.tutorial
    val isTutorialOpen = tutorial != null && !tutorial.isFolded
    val perform = { event: WorkshopEvent ->
        if (isTutorialOpen && makesRoom(event)) onEvent(LearningEvent.TutorialFolded(true))
        onEvent(event)
    }
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val isLow = maxHeight < LOW
        Column(Modifier.fillMaxSize()) {
            Row(
                Modifier.background(LocalRobotranColours.current.pane),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                MainMenu(state.document, state.worldEdit != null, onEvent, withProject = true)
                PaneTabs(state.pane.takeUnless { isTutorialOpen }, state.diagnostics.isNotEmpty(), {
                    perform(ScreenEvent.PaneChosen(it))
                }, Modifier.weight(1f))
            }
            HorizontalDivider()
            if (isTutorialOpen) {
                Box(Modifier.weight(1f)) {
                    TutorialPane(
                        state.learning,
                        perform,
                        Modifier.fillMaxSize(),
                        onProgram = { perform(ScreenEvent.PaneChosen(Pane.PROGRAM)) },
                    )
                    NoticeOver(state.notice, state.document, onEvent)
                }
            } else {
                if (tutorial != null) TutorialStrip(state.learning, onEvent)
                PaneAlone(state, onEvent, Modifier.weight(1f))
            }
            NarrowRunBar(state, perform, isLow)
            RunAnnouncements(state)
        }
    }
}

/** In a scope of its own, which each frame of a run composes. */
@Composable
private fun NarrowRunBar(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, isLow: Boolean) =
    RunBar(state.run, state.status, state.caretLine, onEvent, isLow = isLow)

/** Whether [event] should show a pane instead of the tutorial. */
private fun makesRoom(event: WorkshopEvent): Boolean =
    event is ScreenEvent.PaneChosen || event == RunEvent.RunPressed || event == LearningEvent.StepTried ||
        event == LearningEvent.SolutionRequested(shown = true)

/** With notices over it, where they hide least. */
@Composable
private fun PaneAlone(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier) {
    val isSheet = state.pane == Pane.WORLD && state.part { run.drawer.tab } == null
    Box(modifier) {
        when {
            isSheet -> WorldWithStrip(state, onEvent)

            state.pane == Pane.PROGRAM -> CompositionLocalProvider(LocalSheetPicture provides sheetPicture(state)) {
                ProgramPane(
                    state.programs,
                    state.part { shownProgramRun },
                    state.settings,
                    MAX_DIAGNOSTICS,
                    onEvent,
                    Modifier.fillMaxSize(),
                    tutorialStep = state.learning.loadedStep,
                )
            }

            state.pane == Pane.WORLD -> DrawerPage(state.run, {
                onEvent(it)
                // The drawer covers the sheet.
                if (it is RunEvent.ShortfallShown) onEvent(RunEvent.DrawerChosen(null))
            })

            // A notice would cover the ports.
            else -> Column(Modifier.fillMaxSize()) {
                Box(Modifier.weight(1f)) { BrickAlone(state.run, onEvent) }
                state.notice?.let { NoticeBar(it, onEvent, Modifier.padding(8.dp)) }
            }
        }
        if (!isSheet) NoticeOver(state.notice.takeIf { state.pane != Pane.BRICK }, state.document, onEvent)
    }
}

/** What an edited number does, because the sheet is not beside the program. */
private fun sheetPicture(state: WorkshopState): (@Composable (Dp, Modifier) -> Unit)? =
    state.sheetPreview?.let { preview ->
        { height, place -> MiniSheet(state.world, state.run.drawn, preview, height, place) }
    }

@Composable
private fun BoxScope.NoticeOver(notice: Notice?, document: DocumentState, onEvent: (WorkshopEvent) -> Unit) {
    Column(
        Modifier.align(Alignment.BottomCenter).padding(8.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterHorizontally,
    ) {
        notice?.let { NoticeBar(it, onEvent) }
        AutosaveBanner(document, onEvent, Modifier.heightIn(max = MAX_BANNER_HEIGHT))
    }
}

/** The brick's strip is below the paper, or beside it if there is more room. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun WorldWithStrip(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val showBrick = { onEvent(ScreenEvent.PaneChosen(Pane.BRICK)) }
    val textScale = LocalDensity.current.fontScale
    BoxWithConstraints(Modifier.fillMaxSize().background(LocalRobotranColours.current.desk)) {
        val isBroad = maxWidth > maxHeight
        if (isBroad && isStripBeside(maxWidth, maxHeight, textScale)) {
            Row(Modifier.fillMaxSize(), verticalAlignment = Alignment.Bottom) {
                SheetStage(state, onEvent, MessageOptions(onWholeBrick = showBrick), Modifier.weight(1f))
                Column(horizontalAlignment = Alignment.End) {
                    WorldTaskAndGoals(state, onEvent, isSlim = true)
                    StripWithSize(state.run, onEvent, showBrick)
                }
            }
        } else {
            Column(Modifier.fillMaxSize(), horizontalAlignment = Alignment.CenterHorizontally) {
                SheetStage(state, onEvent, MessageOptions(onWholeBrick = showBrick), Modifier.weight(1f))
                if (isBroad) {
                    // In one row if they fit, since the paper is low.
                    FlowRow {
                        WorldTaskAndGoals(
                            state,
                            onEvent,
                            Modifier.align(Alignment.CenterVertically),
                            isSlim = true,
                            hasName = this@BoxWithConstraints.maxWidth >= NAMED_GOALS,
                        )
                        StripWithSize(state.run, onEvent, showBrick)
                    }
                } else {
                    WorldTaskAndGoals(state, onEvent)
                    StripWithSize(state.run, onEvent, showBrick)
                }
            }
        }
    }
}

/** Whether the strip is beside the paper: if the words of a card fit there, or if more of the paper is seen. */
private fun isStripBeside(width: Dp, height: Dp, textScale: Float): Boolean =
    width - STRIP_WIDTH >= MIN_CARD * textScale || STRIP_WIDTH.value * height.value < width.value * STRIP_HEIGHT.value

@Composable
private fun WorldTaskAndGoals(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    isSlim: Boolean = false,
    hasName: Boolean = true,
) = TaskAndGoals(
    state.hasTask,
    state.taskShown,
    state.session.goals,
    onEvent,
    modifier.padding(start = 12.dp, end = if (hasName) 12.dp else 0.dp),
    isSlim,
    howFar(state.assignment),
    hasName,
)

/** The small brick with the button that shows the whole one. */
@Composable
private fun StripWithSize(run: RunPaneState, onEvent: (WorkshopEvent) -> Unit, onWholeBrick: () -> Unit) {
    Row(Modifier.padding(start = 12.dp, top = 8.dp, bottom = 8.dp), verticalAlignment = Alignment.CenterVertically) {
        Strip(run, onEvent, isLow = true)
        IconButton(PaneIcons.BRICK_WHOLE, ScreenTexts.brickWhole(spoken), ScreenTags.BRICK_SIZE, onClick = onWholeBrick)
    }
}

/** As large as the space beside, or below, its message allows. */
@Composable
private fun BrickAlone(run: RunPaneState, onEvent: (WorkshopEvent) -> Unit) {
    BoxWithConstraints(Modifier.fillMaxSize().background(LocalRobotranColours.current.desk), Alignment.Center) {
        val isAcross = maxWidth > maxHeight
        val hint = HINT_HEIGHT * LocalDensity.current.fontScale.coerceAtLeast(1f)
        val high = maxHeight - MARGIN * 2 - if (isAcross) 0.dp else hint + MARGIN
        val width = minOf(maxWidth - MARGIN * 2, high * BRICK_ASPECT).coerceIn(MIN_BRICK_WIDTH, MAX_BRICK_WIDTH)
        if (isAcross) {
            Row(Modifier.fillMaxSize().padding(horizontal = MARGIN), Arrangement.spacedBy(MARGIN), Alignment.Top) {
                Box(Modifier.weight(1f).padding(vertical = MARGIN).verticalScroll(rememberScrollState())) {
                    BrickHint(run.brick, isSolved = run.isSolved)
                }
                WholeBrick(
                    run,
                    onEvent,
                    Modifier.verticalScroll(rememberScrollState()).padding(vertical = MARGIN).width(width),
                )
                Spacer(Modifier.weight(1f))
            }
        } else {
            Column(Modifier.verticalScroll(rememberScrollState()).padding(MARGIN), Arrangement.spacedBy(MARGIN)) {
                Box(Modifier.width(width).height(hint).verticalScroll(rememberScrollState()), Alignment.BottomStart) {
                    BrickHint(run.brick, isSolved = run.isSolved)
                }
                WholeBrick(run, onEvent, Modifier.width(width))
            }
        }
    }
}

/** An on-screen keyboard covers half of the pane: more errors would hide the program. */
private const val MAX_DIAGNOSTICS = 2
private val MARGIN = 16.dp

/** At the default font size, for words of ten letters. */
private val MIN_CARD = 190.dp

/** The small brick with its button. */
private val STRIP_WIDTH = 250.dp
private val STRIP_HEIGHT = 80.dp

/** Below this height, as on a phone held across, the run bar has one row. */
private val LOW = 480.dp

/** From this width on the goals, with their name, and the strip fit in one row. */
private val NAMED_GOALS = 420.dp

/** The rest scrolls. */
private val MAX_BANNER_HEIGHT = 200.dp
private val MAX_BRICK_WIDTH = 440.dp

/** Space for four lines of the brick's message. */
private val HINT_HEIGHT = 112.dp
