package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.assignment.HandInDialog
import robotran.ui.assignment.making.AssignmentEditorPage
import robotran.ui.assignment.making.MakingPlace
import robotran.ui.course.CoursePages
import robotran.ui.documents.DocumentDialogs
import robotran.ui.documents.documentShortcut
import robotran.ui.export.ExportDialog
import robotran.ui.handins.HandInsPage
import robotran.ui.learning.LearningPages
import robotran.ui.parts.ScreenLayout
import robotran.ui.robot.RobotEditPane
import robotran.ui.runbar.LocalBrickKind
import robotran.ui.runbar.RunBar
import robotran.ui.runbar.SoundSwitch
import robotran.ui.runbar.runShortcut
import robotran.ui.send.SendDialog
import robotran.ui.send.hub.HubSendDialog
import robotran.ui.send.microbit.MicrobitSendDialog
import robotran.ui.settings.SettingsPage
import robotran.ui.world.LocalHearsRun
import robotran.ui.world.escapedWords
import robotran.ui.world.wordsShortcut
import robotran.ui.worldedit.WorldEditPane
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.WindowForm
import robotran.workshop.state.WorkshopState

/** The main screen: panes side by side or stacked if there is room, otherwise one at a time. Pages cover it. */
@Composable
fun WorkshopScreen(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    var isNarrow by remember { mutableStateOf(false) }
    val shortcut = { event: KeyEvent ->
        val wanted = documentShortcut(event) ?: runShortcut(event).takeIf { isRunAllowed(state, it) }
        wanted?.let(onEvent) != null || askForWords(event, state, isNarrow, onEvent)
    }
    val escape = { event: KeyEvent -> escapedWords(event, state.sheet)?.let(onEvent) != null }
    TakesUntakenKeys { shortcut(it) || escape(it) }
    BoxWithConstraints(
        modifier.fillMaxSize().background(LocalRobotranColours.current.pane)
            .onPreviewKeyEvent(shortcut).onKeyEvent(escape),
    ) {
        // Larger text needs the room of a larger screen.
        val scale = state.settings.textScale.coerceAtMost(LocalDensity.current.fontScale)
        val layout = ScreenLayout.of(maxWidth, maxHeight + LocalKeyboardHeight.current, scale)
        SideEffect { isNarrow = layout == ScreenLayout.NARROW }
        val ofPanes = paneBackEvents(state, isWide = layout != ScreenLayout.NARROW)
        BackGesture(ofPanes.size) { ofPanes.firstOrNull()?.let(onEvent) }
        val isBroad = maxWidth >= BROAD_WIDTH * scale && maxHeight >= BROAD_HEIGHT
        val form = if (isBroad) WindowForm.BROAD else WindowForm.ACROSS
        var foot by remember { mutableStateOf(0) }
        val runBar = @Composable {
            RunBar(state.run, state.status, state.caretLine, onEvent, Modifier.onSizeChanged { foot = it.height }) {
                SoundSwitch(state.soundOn, { onEvent(SettingsEvent.SoundSwitched(it)) })
            }
        }
        val isCovered = state.isCovered
        // Hides the covered content from screen readers.
        Box(if (isCovered) Modifier.fillMaxSize().clearAndSetSemantics { } else Modifier.fillMaxSize()) {
            ProvideForPrograms(state, onEvent) {
                CompositionLocalProvider(
                    LocalBrickKind provides state.part { run.brick.kind },
                    LocalHearsRun provides state.part { settings.hearsRun },
                ) {
                    Panes(state, layout, form, onEvent, runBar)
                }
            }
        }
        val footHeight = with(LocalDensity.current) { foot.toDp() }.takeIf { layout != ScreenLayout.NARROW } ?: 0.dp
        Pages(state, footHeight, onEvent)
    }
}

/** The editor that is open, or the panes of the desk. */
@Composable
private fun Panes(
    state: WorkshopState,
    layout: ScreenLayout,
    form: WindowForm,
    onEvent: (WorkshopEvent) -> Unit,
    runBar: @Composable () -> Unit,
) {
    val edit = state.worldEdit
    val bench = state.robotEdit
    when {
        edit != null && bench != null -> RobotEditPane(
            bench,
            edit,
            state.session,
            state.document,
            onEvent,
        ) {
            val ofFile = state.notice?.takeIf { it is Notice.FileSaved || it is Notice.FileNotSaved }
            ofFile?.let { NoticeBar(it, onEvent) }
        }

        edit != null -> Box {
            WorldEditPane(edit, state.session, state.document, onEvent)
            state.notice?.takeIf { it is Notice.RobotKeptAsDraft }?.let {
                val place = Modifier.align(Alignment.TopCenter).widthIn(max = NOTICE_WIDTH)
                NoticeBar(it, onEvent, place.padding(top = BELOW_BAR).padding(8.dp))
            }
        }

        layout == ScreenLayout.WIDE -> WideScreen(state, form, onEvent, runBar)
        layout == ScreenLayout.UPRIGHT -> UprightScreen(state, onEvent, runBar)
        else -> NarrowScreen(state, onEvent)
    }
}

/** The pages and dialogs over the panes. */
@Composable
private fun Pages(state: WorkshopState, footHeight: Dp, onEvent: (WorkshopEvent) -> Unit) {
    val makingPlace = remember { MakingPlace() }
    val hasGoals = state.document.hasGoals
    LearningPages(state.learning, state.settings.programView, state.course.saved, hasGoals, onEvent, footHeight)
    state.course.page?.let { CoursePages(it, onEvent) }
    state.making?.let { AssignmentEditorPage(it, makingPlace, onEvent) }
    if (state.settingsShown) {
        SettingsPage(state.settings, state.siteRequested, asksForSite = !state.hasPage, onEvent)
    }
    state.handIns?.let { HandInsPage(it, onEvent) }
    val ofPages = pageBackEvents(state)
    // Composed only when a page opens, so that earlier handlers, such as that of the find bar, stay active until
    // then.
    if (ofPages.isNotEmpty()) BackGesture(ofPages.size) { onEvent(ofPages.first()) }
    DocumentDialogs(state.document, { noticeText(it) }, onEvent)
    state.send?.let { SendDialog(it, onEvent) }
    state.hubSend?.let { HubSendDialog(it, onEvent) }
    state.microbitSend?.let { MicrobitSendDialog(it, onEvent) }
    state.show?.let { ExportDialog(it, state.world, state.session, onEvent) }
    state.handIn?.let { HandInDialog(it, state.document.hasShareSheet, onEvent) }
}

/** From this size on, at default font size, there is room for the whole brick beside a large sheet. */
private val BROAD_WIDTH = 1600.dp
private val BROAD_HEIGHT = 800.dp

/** Leaves the bar of the world editor, with its Done, free. */
private val BELOW_BAR = 64.dp

/** Leaves the palette and the tabs of the world editor on a tablet free. */
private val NOTICE_WIDTH = 560.dp

/** Whether a page covers the panes. */
private val WorkshopState.isCovered: Boolean
    get() = settingsShown || making != null || handIns != null || course.page != null ||
        learning.page?.coversAll == true

/**
 * Tells in words what the key asks for, where the sheet is or, if something else has its room, will be. Returns whether
 * the key does so.
 */
private fun askForWords(
    event: KeyEvent,
    state: WorkshopState,
    isNarrow: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
): Boolean {
    val wanted = wordsShortcut(event, state.sheet, state.session) ?: return false
    if (!state.hasRunBar || state.isCovered) return false
    if (isNarrow && state.learning.tutorial?.isFolded == false) onEvent(LearningEvent.TutorialFolded(true))
    if (isNarrow) onEvent(ScreenEvent.PaneChosen(Pane.WORLD))
    if (!isNarrow && state.fullPane != null && state.fullPane != Pane.WORLD) onEvent(ScreenEvent.PaneFilled(null))
    onEvent(wanted)
    return true
}

/** Whether neither the world editor nor the page of an assignment covers the run bar. */
private val WorkshopState.hasRunBar: Boolean get() = worldEdit == null && making == null

/** Whether the run bar, if visible, would currently allow [event]. */
private fun isRunAllowed(state: WorkshopState, event: RunEvent?): Boolean = state.hasRunBar && when (event) {
    RunEvent.StopPressed -> state.stoppable
    RunEvent.PausePressed -> state.run.pausable
    else -> true
}
