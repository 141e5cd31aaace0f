package robotran.ui.desktop

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyShortcut
import androidx.compose.ui.window.FrameWindowScope
import androidx.compose.ui.window.MenuBar
import androidx.compose.ui.window.MenuScope
import robotran.brick.program.StepKind
import robotran.editing.RobotTexts
import robotran.robotediting.RobotEdit
import robotran.simulation.Breakpoint
import robotran.ui.language.InLanguage
import robotran.ui.program.texts.EditorTexts
import robotran.ui.run.texts.RunTexts
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.LearningTexts
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.HubTexts
import robotran.ui.texts.NqcTexts
import robotran.ui.theme.coloursOf
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.appLanguage
import robotran.workshop.state.DocumentState
import robotran.workshop.state.LearningPage
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState
import robotran.worldediting.WorldEdit
import java.awt.event.KeyEvent
import javax.swing.JFrame

/** The platform's menu of a window with the workshop [state], in the app language. */
@Composable
fun FrameWindowScope.WorkshopMenuBar(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    openAnother: () -> Unit,
    close: () -> Unit,
    quit: () -> Unit,
) {
    val colours = coloursOf(state.settings.theme, isSystemInDarkTheme())
    InLanguage(state.settings.language) {
        // A visible window does not lay out a new menu bar or repaint a replaced one by itself.
        LaunchedEffect(window) {
            window.rootPane.revalidate()
            window.rootPane.repaint()
        }
        LaunchedEffect(window, colours, state.settings.language, state.document.recentFiles) {
            if (!IS_MAC) colourMenuBar(window, colours)
        }
        MenuBar {
            Menu(DocumentTexts.menuFile(spoken)) {
                FileItems(state.document, onEvent, openAnother, close, quit)
            }
            Menu(DocumentTexts.menuEdit(spoken)) {
                EditItems(undoTarget(state), window, onEvent)
            }
            Menu(DocumentTexts.menuRun(spoken)) {
                RunItems(
                    state.run,
                    state.caretLine,
                    hasRunBar = state.worldEdit == null,
                    onEvent,
                )
            }
            Menu(DocumentTexts.menuView(spoken)) {
                Choice(DocumentTexts::editWorld, enabled = state.worldEdit == null) {
                    onEvent(WorldEditEvent.EditorOpened)
                }
                Choice(DocumentTexts::worlds) { onEvent(LearningEvent.PageRequested(LearningPage.WORLDS)) }
                Separator()
                Choice(DocumentTexts::settings, control(Key.Comma)) { onEvent(SettingsEvent.SettingsShown(true)) }
            }
            Menu(DocumentTexts.menuHelp(spoken)) {
                Choice(DocumentTexts::tutorial, KeyShortcut(Key.F1, shift = true)) {
                    onEvent(LearningEvent.PageRequested(LearningPage.TUTORIAL))
                }
                Choice(LearningTexts::map) { onEvent(LearningEvent.PageRequested(LearningPage.MAP)) }
                Choice(LearningTexts::examples) { onEvent(LearningEvent.PageRequested(LearningPage.EXAMPLES)) }
                Choice(LearningTexts::help) { onEvent(LearningEvent.PageRequested(LearningPage.HELP)) }
                Choice(DocumentTexts::firstPage) { onEvent(LearningEvent.PageRequested(LearningPage.FIRST_RUN)) }
                Separator()
                Choice(LearningTexts::teachers) { onEvent(LearningEvent.PageRequested(LearningPage.TEACHERS)) }
                Choice(DocumentTexts::about) { onEvent(DocumentEvent.AboutRequested(VERSION)) }
            }
        }
    }
}

/** The window title: the project's name, with a dot while there are changes not saved to its file. */
@Composable
fun windowTitle(workshop: Workshop?): String {
    val state = workshop?.state ?: return APP
    val document = state.document
    val name = document.name.ifEmpty { DocumentTexts.untitled(appLanguage(state.settings.language)) }
    val dot = if (document.fileName != null && !document.saved) "● " else ""
    return "$dot$name – $APP"
}

@Composable
private fun MenuScope.FileItems(
    document: DocumentState,
    onEvent: (WorkshopEvent) -> Unit,
    openAnother: () -> Unit,
    close: () -> Unit,
    quit: () -> Unit,
) {
    Choice(CommonTexts::newProject, control(Key.N)) { onEvent(DocumentEvent.NewRequested) }
    Choice(HubTexts::otherRobot) { onEvent(DocumentEvent.RobotChoiceRequested) }
    Choice(DocumentTexts::newWindow, control(Key.N, shift = true), onClick = openAnother)
    Separator()
    Choice(CommonTexts::myWork, control(Key.O, shift = true)) { onEvent(DocumentEvent.ProjectListRequested) }
    Choice(DocumentTexts::open, control(Key.O)) { onEvent(DocumentEvent.OpenRequested) }
    Menu(DocumentTexts.recent(spoken), enabled = document.recentFiles.isNotEmpty()) {
        for (file in document.recentFiles) Item(file.name) { onEvent(DocumentEvent.SavedProjectChosen(file.id)) }
    }
    Choice(DocumentTexts::openLink) { onEvent(DocumentEvent.LinkPastingRequested) }
    Separator()
    Choice(DocumentTexts::save, control(Key.S)) { onEvent(DocumentEvent.SaveRequested) }
    Choice(CommonTexts::saveAs, control(Key.S, shift = true)) { onEvent(DocumentEvent.SaveAsRequested) }
    Choice(DocumentTexts::rename) { onEvent(DocumentEvent.RenameRequested) }
    Separator()
    Choice(RobotTexts::buildMenu) { onEvent(RobotEditEvent.BenchOpened()) }
    Choice(CommonTexts::showWork) { onEvent(ExportEvent.Requested) }
    Choice(DocumentTexts::share) { onEvent(DocumentEvent.LinkRequested) }
    Choice(CommonTexts::sendToRobot, enabled = document.canSend) { onEvent(SendEvent.Requested) }
    Choice(DocumentTexts::replay) { onEvent(DocumentEvent.ReplayRequested) }
    Choice(DocumentTexts::programFile) { onEvent(DocumentEvent.ProgramFileRequested) }
    val kit = if (document.hasFirmwareImage) NqcTexts::documentsFirmwareImage else CommonTexts::sendingKit
    Choice(kit) { onEvent(DocumentEvent.KitRequested) }
    Separator()
    Choice(DocumentTexts::closeWindow, control(Key.W), onClick = close)
    // macOS has it in the menu of the app.
    if (!IS_MAC) Choice(DocumentTexts::quit, control(Key.Q), onClick = quit)
}

/** Undo and Redo of the program, or of the world or the robot while it is edited. */
private fun undoTarget(state: WorkshopState): Pair<WorkshopEvent, WorkshopEvent> = when {
    state.robotEdit != null -> RobotEditEvent.Edited(RobotEdit.Undo) to RobotEditEvent.Edited(RobotEdit.Redo)
    state.worldEdit != null -> WorldEditEvent.Edited(WorldEdit.Undo) to WorldEditEvent.Edited(WorldEdit.Redo)
    else -> ProgramEvent.Undone to ProgramEvent.Redone
}

/** @param undo what Undo and Redo do. */
@Composable
private fun MenuScope.EditItems(
    undo: Pair<WorkshopEvent, WorkshopEvent>,
    window: JFrame,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Choice(DocumentTexts::undo, control(Key.Z)) { onEvent(undo.first) }
    Choice(DocumentTexts::redo, control(Key.Z, shift = true)) { onEvent(undo.second) }
    Separator()
    Choice(EditorTexts::cut, control(Key.X)) { pressShortcut(window, KeyEvent.VK_X) }
    Choice(EditorTexts::copy, control(Key.C)) { pressShortcut(window, KeyEvent.VK_C) }
    Choice(EditorTexts::paste, control(Key.V)) { pressShortcut(window, KeyEvent.VK_V) }
    Choice(DocumentTexts::selectAll, control(Key.A)) { pressShortcut(window, KeyEvent.VK_A) }
    Separator()
    Choice(EditorTexts::find, control(Key.F), undo.first == ProgramEvent.Undone) {
        onEvent(ProgramEvent.SearchRequested)
    }
    Choice(EditorTexts::format, control(Key.F, shift = true), undo.first == ProgramEvent.Undone) {
        onEvent(ProgramEvent.Formatted)
    }
}

/** The same keys as `runShortcut`, and F5. */
@Composable
private fun MenuScope.RunItems(
    run: RunPaneState,
    caretLine: Breakpoint,
    hasRunBar: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Choice(DocumentTexts::runNow, KeyShortcut(Key.F5), hasRunBar) { onEvent(RunEvent.RunPressed) }
    Choice(DocumentTexts::stopNow, KeyShortcut(Key.F5, shift = true), hasRunBar && run.stoppable) {
        onEvent(RunEvent.StopPressed)
    }
    val pause = if (run.isPlaying) RunTexts::pause else RunTexts::goOn
    Choice(pause, KeyShortcut(Key.F6), hasRunBar && run.pausable) { onEvent(RunEvent.PausePressed) }
    Separator()
    Choice(RunTexts::stepInto, KeyShortcut(Key.F7), hasRunBar) { onEvent(RunEvent.StepPressed(StepKind.INTO)) }
    Choice(RunTexts::stepOver, control(Key.F7), hasRunBar) { onEvent(RunEvent.StepPressed(StepKind.OVER)) }
    Choice(RunTexts::stepOut, KeyShortcut(Key.F7, shift = true), hasRunBar) {
        onEvent(RunEvent.StepPressed(StepKind.OUT))
    }
    Choice(RunTexts::toLine, enabled = hasRunBar) { onEvent(RunEvent.RunToLine(caretLine)) }
}

@Composable
private fun MenuScope.Choice(
    label: Label,
    shortcut: KeyShortcut? = null,
    enabled: Boolean = true,
    onClick: () -> Unit,
) = Item(label(spoken), enabled = enabled, shortcut = shortcut, onClick = onClick)

/** With the platform's modifier key for shortcuts. */
private fun control(key: Key, shift: Boolean = false) =
    if (IS_MAC) KeyShortcut(key, meta = true, shift = shift) else KeyShortcut(key, ctrl = true, shift = shift)

private val IS_MAC = System.getProperty("os.name").orEmpty().startsWith("Mac")
private const val APP = "Robotran"

/** Known to an installed app only. */
private val VERSION = System.getProperty("jpackage.app-version").orEmpty()
