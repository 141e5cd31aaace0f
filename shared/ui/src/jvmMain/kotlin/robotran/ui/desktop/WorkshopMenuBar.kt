package robotran.ui.desktop

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyShortcut
import androidx.compose.ui.window.FrameWindowScope
import androidx.compose.ui.window.MenuBar
import androidx.compose.ui.window.MenuScope
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.brick.kind.BrickKind
import robotran.brick.program.StepKind
import robotran.robotediting.RobotEdit
import robotran.simulation.Breakpoint
import robotran.ui.language.InLanguage
import robotran.ui.language.textIn
import robotran.ui.resources.*
import robotran.ui.theme.coloursOf
import robotran.workshop.Workshop
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.ShowEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.LearningPage
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.WorkshopState
import robotran.worldediting.Edit
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
            Menu(stringResource(Res.string.documents_menu_file)) {
                FileItems(state.document, onEvent, openAnother, close, quit)
            }
            Menu(stringResource(Res.string.documents_menu_edit)) {
                EditItems(undoTarget(state), window, onEvent)
            }
            Menu(stringResource(Res.string.documents_menu_run)) {
                RunItems(
                    state.run,
                    state.caretLine,
                    isDesk = state.worldEdit == null,
                    onEvent,
                )
            }
            Menu(stringResource(Res.string.documents_menu_view)) {
                Choice(Res.string.documents_edit_world, enabled = state.worldEdit == null) {
                    onEvent(WorldEditEvent.EditorOpened)
                }
                Choice(Res.string.documents_worlds) { onEvent(LearningEvent.PageRequested(LearningPage.WORLDS)) }
                Separator()
                Choice(Res.string.documents_settings, control(Key.Comma)) { onEvent(SettingsEvent.SettingsShown(true)) }
            }
            Menu(stringResource(Res.string.documents_menu_help)) {
                Choice(Res.string.documents_tutorial, KeyShortcut(Key.F1, shift = true)) {
                    onEvent(LearningEvent.PageRequested(LearningPage.TUTORIAL))
                }
                Choice(Res.string.learning_map) { onEvent(LearningEvent.PageRequested(LearningPage.MAP)) }
                Choice(Res.string.learning_examples) { onEvent(LearningEvent.PageRequested(LearningPage.EXAMPLES)) }
                Choice(Res.string.learning_help) { onEvent(LearningEvent.PageRequested(LearningPage.HELP)) }
                Choice(Res.string.documents_first_page) { onEvent(LearningEvent.PageRequested(LearningPage.FIRST_RUN)) }
                Separator()
                Choice(Res.string.documents_about) { onEvent(DocumentEvent.AboutRequested(VERSION)) }
            }
        }
    }
}

/** The window title: the project's name, with a dot while there are changes not saved to its file. */
@Composable
fun windowTitle(workshop: Workshop?): String {
    val state = workshop?.state ?: return APP
    val document = state.document
    val name = document.name.ifEmpty { textIn(state.settings.language, Res.string.documents_untitled) }
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
    Choice(Res.string.documents_new, control(Key.N)) { onEvent(DocumentEvent.NewRequested) }
    Choice(Res.string.documents_new_nxt) { onEvent(DocumentEvent.NewWithBrick(BrickKind.NXT)) }
    Choice(Res.string.documents_new_window, control(Key.N, shift = true), onClick = openAnother)
    Separator()
    Choice(Res.string.documents_my_work, control(Key.O, shift = true)) { onEvent(DocumentEvent.ProjectListRequested) }
    Choice(Res.string.course_list) { onEvent(CourseEvent.ListRequested) }
    Choice(Res.string.documents_open, control(Key.O)) { onEvent(DocumentEvent.OpenRequested) }
    Menu(stringResource(Res.string.documents_recent), enabled = document.recentFiles.isNotEmpty()) {
        for (file in document.recentFiles) Item(file.name) { onEvent(DocumentEvent.SavedProjectChosen(file.id)) }
    }
    Choice(Res.string.documents_open_link) { onEvent(DocumentEvent.LinkPastingRequested) }
    Separator()
    Choice(Res.string.documents_save, control(Key.S)) { onEvent(DocumentEvent.SaveRequested) }
    Choice(Res.string.documents_save_as, control(Key.S, shift = true)) { onEvent(DocumentEvent.SaveAsRequested) }
    Choice(Res.string.documents_rename) { onEvent(DocumentEvent.RenameRequested) }
    Separator()
    Choice(Res.string.robot_build_menu) { onEvent(RobotEditEvent.BenchOpened()) }
    Choice(Res.string.show_title) { onEvent(ShowEvent.Requested) }
    Choice(Res.string.make_title) { onEvent(AssignmentEvent.MakingRequested) }
    Choice(Res.string.documents_share) { onEvent(DocumentEvent.LinkRequested) }
    Choice(Res.string.send_robot, enabled = document.canSend) { onEvent(SendEvent.Requested) }
    Choice(Res.string.documents_replay) { onEvent(DocumentEvent.ReplayRequested) }
    Choice(Res.string.documents_program_file) { onEvent(DocumentEvent.ProgramFileRequested) }
    val kit = if (document.hasFirmwareImage) Res.string.documents_firmware_image else Res.string.documents_kit
    Choice(kit) { onEvent(DocumentEvent.KitRequested) }
    Separator()
    Choice(Res.string.hand_ins_menu, enabled = document.hasGoals) { onEvent(HandInsEvent.Requested) }
    Separator()
    Choice(Res.string.documents_close_window, control(Key.W), onClick = close)
    // macOS has it in the menu of the app.
    if (!IS_MAC) Choice(Res.string.documents_quit, control(Key.Q), onClick = quit)
}

/** Undo and Redo of the program, or of the world or the robot while it is edited. */
private fun undoTarget(state: WorkshopState): Pair<WorkshopEvent, WorkshopEvent> = when {
    state.robotEdit != null -> RobotEditEvent.Edited(RobotEdit.Undo) to RobotEditEvent.Edited(RobotEdit.Redo)
    state.worldEdit != null -> WorldEditEvent.Edited(Edit.Undo) to WorldEditEvent.Edited(Edit.Redo)
    else -> ProgramEvent.Undone to ProgramEvent.Redone
}

/** @param undo what Undo and Redo do. */
@Composable
private fun MenuScope.EditItems(
    undo: Pair<WorkshopEvent, WorkshopEvent>,
    window: JFrame,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Choice(Res.string.documents_undo, control(Key.Z)) { onEvent(undo.first) }
    Choice(Res.string.documents_redo, control(Key.Z, shift = true)) { onEvent(undo.second) }
    Separator()
    Choice(Res.string.editor_cut, control(Key.X)) { pressShortcut(window, KeyEvent.VK_X) }
    Choice(Res.string.editor_copy, control(Key.C)) { pressShortcut(window, KeyEvent.VK_C) }
    Choice(Res.string.editor_paste, control(Key.V)) { pressShortcut(window, KeyEvent.VK_V) }
    Choice(Res.string.documents_select_all, control(Key.A)) { pressShortcut(window, KeyEvent.VK_A) }
    Separator()
    Choice(Res.string.editor_find, control(Key.F), undo.first == ProgramEvent.Undone) {
        onEvent(ProgramEvent.SearchRequested)
    }
    Choice(Res.string.editor_format, control(Key.F, shift = true), undo.first == ProgramEvent.Undone) {
        onEvent(ProgramEvent.Formatted)
    }
}

/** The same keys as `runShortcut`, and F5. */
@Composable
private fun MenuScope.RunItems(
    run: RunPaneState,
    caretLine: Breakpoint,
    isDesk: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Choice(Res.string.documents_run_now, KeyShortcut(Key.F5), isDesk) { onEvent(RunEvent.RunPressed) }
    Choice(Res.string.documents_stop_now, KeyShortcut(Key.F5, shift = true), isDesk && run.stoppable) {
        onEvent(RunEvent.StopPressed)
    }
    val pause = if (run.isPlaying) Res.string.run_pause else Res.string.run_go_on
    Choice(pause, KeyShortcut(Key.F6), isDesk && run.pausable) { onEvent(RunEvent.PausePressed) }
    Separator()
    Choice(Res.string.run_step_into, KeyShortcut(Key.F7), isDesk) { onEvent(RunEvent.StepPressed(StepKind.INTO)) }
    Choice(Res.string.run_step_over, control(Key.F7), isDesk) { onEvent(RunEvent.StepPressed(StepKind.OVER)) }
    Choice(Res.string.run_step_out, KeyShortcut(Key.F7, shift = true), isDesk) {
        onEvent(RunEvent.StepPressed(StepKind.OUT))
    }
    Choice(Res.string.run_to_line, enabled = isDesk) { onEvent(RunEvent.RunToLine(caretLine)) }
}

@Composable
private fun MenuScope.Choice(
    words: StringResource,
    shortcut: KeyShortcut? = null,
    enabled: Boolean = true,
    onClick: () -> Unit,
) = Item(stringResource(words), enabled = enabled, shortcut = shortcut, onClick = onClick)

/** With the platform's modifier key for shortcuts. */
private fun control(key: Key, shift: Boolean = false) =
    if (IS_MAC) KeyShortcut(key, meta = true, shift = shift) else KeyShortcut(key, ctrl = true, shift = shift)

private val IS_MAC = System.getProperty("os.name").orEmpty().startsWith("Mac")
private const val APP = "Robotran"

/** Known to an installed app only. */
private val VERSION = System.getProperty("jpackage.app-version").orEmpty()
