package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.platform.LocalClipboardManager
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.kind.BrickKind
import robotran.brick.program.ProgramFailure
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.ProgramView
import robotran.textediting.text.TextDocument
import robotran.ui.program.blocks.FoundLines
import robotran.ui.program.blocks.dialogs.PaneHeight
import robotran.ui.program.blocks.helpKey
import robotran.ui.program.blocks.sizeKeys
import robotran.ui.program.editor.CodeEditor
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.editor.EditorControl
import robotran.ui.program.editor.EditorMarks
import robotran.ui.program.editor.EditorView
import robotran.ui.program.editor.KeyRow
import robotran.ui.programlanguages.texts
import robotran.uikit.*
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.Settings
import robotran.workshop.state.ShownProgramRun
import robotran.workshop.state.hasRoomFor
import robotran.workshop.state.noteOf

/**
 * The program pane: the program tabs, the editor, the diagnostics, and the translation.
 *
 * @param run what the last run says about the shown program.
 * @param maxDiagnostics how many errors without a line there is room for.
 * @param tutorialStep the index of the tutorial's step that is shown; null for none. The palette has its blocks only.
 */
@Composable
fun ProgramPane(
    programs: ProgramsState,
    run: ShownProgramRun,
    settings: Settings,
    maxDiagnostics: Int,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    tutorialStep: Int? = null,
) {
    var renaming by remember { mutableStateOf(false) }
    BoxWithConstraints(modifier.background(LocalRobotranColours.current.pane)) {
        val height = PaneHeight.of(maxHeight, LocalDensity.current.fontScale)
        Column(Modifier.fillMaxSize()) {
            if (height != PaneHeight.VERY_LOW || !programs.isEditingBlocks) {
                if (programs.robots.size > 1) RobotChooser(programs) { onEvent(ProgramEvent.RobotChosen(it)) }
                ProgramTabs(programs, onEvent) { renaming = true }
            }
            if (programs.program.files.size > 1) {
                FileTabs(programs.program.files, programs.shownFile, { onEvent(ProgramEvent.FileChosen(it)) }, {
                    renaming = true
                })
            }
            Box(Modifier.weight(1f)) {
                ShownFile(
                    programs,
                    settings,
                    run.runningLine,
                    run.failure,
                    maxDiagnostics,
                    height,
                    tutorialStep,
                    onEvent,
                    Modifier.fillMaxSize(),
                    onRename = { renaming = true },
                ) {
                    WarningList(run.warnings, maxDiagnostics, run.missingSensors, {
                        onEvent(WorldEditEvent.SensorsPluggedIn(run.robot, it))
                    })
                    programs.closed?.takeIf {
                        programs.closedMessageShown
                    }?.let { ClosedProgram(it, programs.canReopen, onEvent) }
                }
            }
            // An open sheet has the room of all else. On a phone in landscape there is no room beside mistakes.
            val hasRoom = !programs.isEditingBlocks &&
                (height != PaneHeight.VERY_LOW || programs.diagnostics.isEmpty())
            if (height == PaneHeight.HIGH || hasRoom) {
                LocalProgramWarning.current?.invoke(
                    programs.program.name,
                    height.ofWarning * LocalDensity.current.fontScale.coerceIn(1f, 1.5f),
                )
            }
        }
    }
    if (renaming) {
        RenameDialog(
            programs,
            {
                renaming = false
                onEvent(ProgramEvent.FileRenamed(programs.shownFile, it))
            },
            {
                renaming = false
                onEvent(ProgramEvent.FileClosed(programs.shownFile))
            },
        ) { renaming = false }
    }
}

/**
 * The tools, the text and its translation: everything about the current file.
 *
 * @param overFoot the message over the bottom of the text, until it is closed.
 */
@Composable
private fun ShownFile(
    state: ProgramsState,
    settings: Settings,
    runningLine: Int,
    failure: ProgramFailure?,
    maxDiagnostics: Int,
    height: PaneHeight,
    tutorialStep: Int?,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
    onRename: () -> Unit,
    overFoot: @Composable () -> Unit,
) {
    val now by rememberUpdatedState(state to settings)
    val event by rememberUpdatedState(onEvent)
    val rename by rememberUpdatedState(onRename)
    val focus = remember { FocusRequester() }
    val find = remember { FindState() }
    // Each file has its own scroll position and input state; a new file of the same name starts afresh.
    val key = listOf(state.shownRobot, state.shownProgram, state.shownFile, state.programs.size, state.program.language)
    val view = remember(key) { EditorView() }
    val control = remember(key) {
        val hasRoom = { draft: TextDocument -> now.first.let { it.program.hasRoomFor(it.shownFile, draft) } }
        EditorControl(state.program.language, view, state.brick, hasRoom) { draft, kind ->
            event(ProgramEvent.DraftChanged(draft, kind))
        }
    }
    control.help =
        rememberWordHelp(
            state.program.language,
            state.program.language.support.code.brickOf(state.draft.lines) ?: state.brick,
        )
    control.brick = state.brick
    // The commands of the menu work on the text, also while it is shown in blocks only.
    control.follow(state.draft)
    control.clipboard = LocalClipboardManager.current
    val help = { word: String -> onEvent(LearningEvent.HelpRequested(word, 0)) }
    val actions =
        remember(control) {
            PaneActions(control, find, focus, { now.first }, { now.second }, { event(it) }, { rename() })
        }
    LaunchedEffect(state.searchRequested) {
        if (!state.searchRequested) return@LaunchedEffect
        actions.perform(EditorCommand.Plain.FIND)
        event(ProgramEvent.SearchOpened)
    }
    val matches = remember(state.draft.text, find.isOpen, find.search) { find.matchesIn(state.draft.text) }
    actions.matches = matches
    val found = remember(matches, state.draft) { FoundLines.of(state.draft, matches) }
    val isVeryLow = height == PaneHeight.VERY_LOW
    val isSheetAlone = state.isEditingBlocks && isVeryLow
    Column(modifier) {
        if (!isSheetAlone) {
            EditorTools(
                state,
                { shown, kind -> onEvent(ProgramEvent.TranslationShown(shown, kind)) },
                { onEvent(BlockEvent.ViewChosen(it)) },
                { onEvent(if (state.brick.receivesPrograms) SendEvent.Requested else DocumentEvent.KitRequested) },
            ) {
                // Completions need the caret's focus, which the menu has taken.
                if (it == EditorCommand.Plain.COMPLETE) focus.requestFocus()
                if (!control.perform(it)) actions.perform(it)
            }
        }
        if (find.isOpen && !isSheetAlone) {
            val place =
                matches.indexOfFirst {
                    it.start == state.draft.selection.start && it.end == state.draft.selection.end
                } +
                    1
            FindBar(find, matches.size, place, actions)
        }
        HorizontalDivider()
        val highlighted = state.translation?.takeIf { state.isTranslated }
        val line = state.draft.lines.lineOf(state.draft.selection.caret) + 1
        val failedLine = failure?.sourceLine ?: 0
        val partners = if (highlighted == null) emptySet() else setOf(line)
        val marks =
            remember(state.notes, state.file.name, state.breakpoints, matches, runningLine, failedLine, partners) {
                marksOf(state, runningLine, partners).copy(failedLine = failedLine, matches = matches)
            }
        SideBySideOrStacked(
            state.translationShown && state.translationKind != null && !isSheetAlone,
            state.isEditingBlocks,
            Modifier.weight(1f),
            { part ->
                // Where there would be no room for blocks: these have notes, and the run bar tells of the first error.
                val hasErrors = when (height) {
                    PaneHeight.HIGH -> true
                    PaneHeight.LOW -> !state.isEditingBlocks && state.view != ProgramView.BOTH
                    PaneHeight.VERY_LOW -> !state.view.hasBlocks
                }
                val usePenbot = { brick: BrickKind -> onEvent(WorldEditEvent.PenbotChosen(state.shownRobot, brick)) }
                TextAndDiagnostics(state, maxDiagnostics, actions, overFoot, hasErrors, usePenbot, part) {
                    val notes = remember(state.notes, state.file.name, failure) { notesOf(state, failure) }
                    BlocksAndText(
                        state.view,
                        state.isEditingBlocks,
                        isVeryLow,
                        { where ->
                            state.blocks?.let { blocks ->
                                BlocksPane(
                                    state,
                                    blocks,
                                    notes,
                                    runningLine,
                                    settings.codeSize,
                                    tutorialStep,
                                    focus.takeIf { !state.view.hasText },
                                    onEvent,
                                    actions::fix,
                                    help,
                                    found,
                                    actions::zoom,
                                    isVeryLow,
                                    where.helpKey(blocks, help).sizeKeys(actions::perform),
                                )
                            }
                        },
                        { where ->
                            CodeEditor(
                                control = control,
                                view = view,
                                draft = state.draft,
                                hint = state.program.language.texts.hint(spoken),
                                marks = marks,
                                notes = notes,
                                pointedOut = state.errorPointedOut,
                                codeSize = settings.codeSize,
                                focus = focus,
                                onCommand = { (it as? EditorCommand.Plain)?.let(actions::perform) },
                                onBreakpoint = { onEvent(ProgramEvent.BreakpointToggled(it)) },
                                onZoom = actions::zoom,
                                onFix = actions::fix,
                                modifier = where,
                            )
                        },
                    )
                }
            },
            { part ->
                TranslationPane(
                    translation = state.translation,
                    kind = state.translationKind ?: state.program.language,
                    isNow = state.isTranslated,
                    highlighted = highlighted?.linesOf(state.file.name, line)?.toSet().orEmpty(),
                    running = highlighted?.linesOf(state.file.name, runningLine)?.toSet().orEmpty(),
                    codeSize = settings.codeSize,
                    onLine = { shown ->
                        val origin = highlighted?.originOf(shown)
                        if (origin?.file == state.file.name) actions.goToLine(origin.line)
                    },
                    onNote = { actions.goToLine(it.line) },
                    onZoom = actions::zoom,
                    onKeep = highlighted?.takeIf { state.hasRoom }?.let { kept ->
                        { onEvent(ProgramEvent.ProgramAdded(Program.of(kept.fileName, kept.text))) }
                    },
                    modifier = part,
                )
            },
        )
        // At the bottom, so that its keys do not move when diagnostics appear.
        if (state.view.hasText && control.hasFocus && control.isTouched) KeyRow(control)
    }
}

/** How high the warning below the program may be. */
private val PaneHeight.ofWarning: Dp
    get() = when (this) {
        PaneHeight.HIGH -> 160.dp
        PaneHeight.LOW -> 80.dp
        PaneHeight.VERY_LOW -> 48.dp
    }

/** Whether a sheet is open over the blocks. */
private val ProgramsState.isEditingBlocks: Boolean get() = view.hasBlocks && blocks?.sheet != null

/** The diagnostics at the lines of the current file, in order. */
private fun notesOf(state: ProgramsState, failure: ProgramFailure?): List<InlineDiagnostic> {
    val read = state.notes.filter { it.diagnostic.file == state.file.name }
    return if (failure == null) read else (read + noteOf(failure, state.file.name)).sortedBy { it.line ?: 0 }
}

private fun marksOf(state: ProgramsState, runningLine: Int, partners: Set<Int>): EditorMarks {
    val (warnings, diagnostics) = state.notes.filter {
        it.diagnostic.file == state.file.name
    }.partition { it.isWarning }
    return EditorMarks(
        runningLine = runningLine,
        diagnostics = diagnostics.mapNotNull { it.diagnostic.range },
        warnings = warnings.mapNotNull { it.diagnostic.range },
        breakpoints = state.breakpoints,
        partners = partners,
    )
}
