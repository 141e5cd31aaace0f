package robotran.ui.program

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import robotran.brick.kind.ProgramUpload
import robotran.brick.program.ProgramFailure
import robotran.language.source.SourceSpan
import robotran.programs.Program
import robotran.programs.ProgramTranslation
import robotran.projects.ProgramView
import robotran.ui.program.blocks.FoundLines
import robotran.ui.program.blocks.LineRemarks
import robotran.ui.program.blocks.dialogs.PaneHeight
import robotran.ui.program.blocks.helpKey
import robotran.ui.program.blocks.sizeKeys
import robotran.ui.program.editor.CodeEditor
import robotran.ui.program.editor.EditorMarks
import robotran.ui.program.editor.EditorText
import robotran.ui.program.editor.KeyRow
import robotran.ui.programlanguages.texts
import robotran.uikit.*
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.InlineDiagnostic
import robotran.workshop.state.ProgramsState
import robotran.workshop.state.ShownProgramRun
import robotran.workshop.state.noteOf

/** The tools, the text and its translation: everything about the current file. */
@Composable
internal fun ShownFile(
    file: OpenFile,
    state: ProgramsState,
    run: ShownProgramRun,
    codeSize: Float,
    height: PaneHeight,
    maxDiagnostics: Int,
    tutorialStep: Int?,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val matches = file.rememberMatches(state.draft.text)
    val isSheetAlone = state.isEditingBlocks && height == PaneHeight.VERY_LOW
    Column(Modifier.fillMaxSize()) {
        if (!isSheetAlone) Tools(file, state, matches, onEvent)
        HorizontalDivider()
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
                TextAndDiagnostics(
                    state,
                    maxDiagnostics,
                    file.actions,
                    { OverFoot(state, run, maxDiagnostics, onEvent) },
                    hasErrors,
                    { onEvent(WorldEditEvent.PenbotChosen(state.shownRobot, it)) },
                    part,
                ) {
                    Program(file, state, run, matches, codeSize, tutorialStep, height == PaneHeight.VERY_LOW, onEvent)
                }
            },
            { part -> Translation(file, state, run.runningLine, codeSize, onEvent, part) },
        )
        // At the bottom, so that its keys do not move when diagnostics appear.
        if (state.view.hasText && file.control.hasFocus && file.control.isTouched) KeyRow(file.control)
    }
}

@Composable
private fun Tools(file: OpenFile, state: ProgramsState, matches: List<SourceSpan>, onEvent: (WorkshopEvent) -> Unit) {
    EditorTools(
        state,
        { shown, kind -> onEvent(ProgramEvent.TranslationShown(shown, kind)) },
        { onEvent(BlockEvent.ViewChosen(it)) },
        {
            val canSend = state.brick.programUpload != ProgramUpload.NONE
            onEvent(if (canSend) SendEvent.Requested else DocumentEvent.KitRequested)
        },
        { onEvent(ProgramEvent.WordsChosen(it)) },
        { onEvent(SettingsEvent.WordsChosen(it)) },
        file::perform,
    )
    if (file.find.isOpen) {
        val selected = state.draft.selection
        val place = matches.indexOfFirst { it.start == selected.start && it.end == selected.end } + 1
        FindBar(file.find, matches.size, place, file.actions)
    }
}

/** The messages over the bottom of the text, until they are closed. */
@Composable
private fun OverFoot(
    state: ProgramsState,
    run: ShownProgramRun,
    maxDiagnostics: Int,
    onEvent: (WorkshopEvent) -> Unit,
) {
    WarningList(run.warnings, maxDiagnostics, run.missingSensors, {
        onEvent(WorldEditEvent.SensorsPluggedIn(run.robot, it))
    })
    state.closed?.takeIf { state.closedMessageShown }?.let { ClosedProgram(it, state.canReopen, onEvent) }
}

/** The program as text, as blocks, or as both. */
@Composable
private fun Program(
    file: OpenFile,
    state: ProgramsState,
    run: ShownProgramRun,
    matches: List<SourceSpan>,
    codeSize: Float,
    tutorialStep: Int?,
    isVeryLow: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val notes = remember(state.notes, state.file.name, run.failure) { notesOf(state, run.failure) }
    BlocksAndText(
        state.view,
        state.isEditingBlocks,
        isVeryLow,
        { where ->
            state.blocks?.let { blocks ->
                val found = remember(matches, state.draft) { FoundLines.of(state.draft, matches) }
                val lines = remember(state.breakpoints, run.runningLine, notes, found) {
                    LineRemarks(state.breakpoints, run.runningLine, notes, found)
                }
                val keys = where.helpKey(blocks, file.actions::help).sizeKeys(file.actions::perform)
                BlocksPane(state, lines, file, codeSize, tutorialStep, isVeryLow, onEvent, keys)
            }
        },
        { where ->
            val partners = if (state.currentTranslation == null) emptySet() else setOf(state.caretLine)
            val failedLine = run.failure?.sourceLine
            val marks = remember(
                state.notes,
                state.file.name,
                state.breakpoints,
                matches,
                run.runningLine,
                failedLine,
                partners,
            ) { marksOf(state, run, matches, partners) }
            val hint = state.program.language.texts.hint(spoken)
            val text = EditorText(state.draft, hint, marks, notes, state.errorPointedOut)
            CodeEditor(file.control, text, codeSize, file.focus, file.actions, where)
        },
    )
}

@Composable
private fun Translation(
    file: OpenFile,
    state: ProgramsState,
    runningLine: Int,
    codeSize: Float,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
) {
    val current = state.currentTranslation
    val kind = state.translationKind ?: return
    TranslationPane(
        ShownTranslation(
            state.translation,
            kind,
            state.isTranslated,
            highlighted = current?.linesOf(state.file.name, state.caretLine)?.toSet().orEmpty(),
            running = current?.linesOf(state.file.name, runningLine)?.toSet().orEmpty(),
        ),
        codeSize,
        onLine = { shown ->
            val origin = current?.originOf(shown)
            if (origin?.file == state.file.name) file.actions.goToLine(origin.line)
        },
        onNote = { file.actions.goToLine(it.line) },
        onZoom = file.actions::zoom,
        onKeep = current?.let { keeping(it, state) }?.let { event -> { onEvent(event) } },
        modifier,
    )
}

/** What keeps [translation]: as a program if it is one and has room, otherwise in a file. */
private fun keeping(translation: ProgramTranslation, state: ProgramsState): WorkshopEvent? = when {
    translation.language.programs == null -> DocumentEvent.TranslationSaved(translation)
    state.hasRoom -> ProgramEvent.ProgramAdded(Program.of(translation.fileName, translation.text))
    else -> null
}

/** The translation, if it is that of the program as it is now. */
private val ProgramsState.currentTranslation: ProgramTranslation? get() = translation?.takeIf { isTranslated }

/** The line of the caret, from 1. */
private val ProgramsState.caretLine: Int get() = draft.lines.lineOf(draft.selection.caret) + 1

/** Whether a sheet is open over the blocks. */
internal val ProgramsState.isEditingBlocks: Boolean get() = view.hasBlocks && blocks?.sheet != null

/** The diagnostics at the lines of the current file, in order. */
private fun notesOf(state: ProgramsState, failure: ProgramFailure?): List<InlineDiagnostic> {
    val read = state.notes.filter { it.diagnostic.file == state.file.name }
    return if (failure == null) read else (read + noteOf(failure, state.file.name)).sortedBy { it.line ?: 0 }
}

/** @param partners the lines, from 1, that belong together with some of the translation. */
private fun marksOf(
    state: ProgramsState,
    run: ShownProgramRun,
    matches: List<SourceSpan>,
    partners: Set<Int>,
): EditorMarks {
    val (warnings, diagnostics) = state.notes.filter {
        it.diagnostic.file == state.file.name
    }.partition { it.isWarning }
    return EditorMarks(
        runningLine = run.runningLine,
        failedLine = run.failure?.sourceLine ?: 0,
        diagnostics = diagnostics.mapNotNull { it.diagnostic.range },
        warnings = warnings.mapNotNull { it.diagnostic.range },
        breakpoints = state.breakpoints,
        matches = matches,
        partners = partners,
    )
}
