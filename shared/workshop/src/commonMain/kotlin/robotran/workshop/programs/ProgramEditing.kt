package robotran.workshop.programs

import robotran.brick.program.BrickProgram
import robotran.language.source.Diagnostic
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.ProjectLimits
import robotran.robolang.wording.ChangedWords
import robotran.robolang.wording.changeWords
import robotran.robolang.words.Vocabulary
import robotran.textediting.EditKind
import robotran.textediting.editBetween
import robotran.textediting.text.TextDocument
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.service.fileNameFor
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.hasRoomFor
import robotran.workshop.state.withPlainLineEnds

/**
 * User actions on the programs of the shown robot.
 *
 * @param hasRoom whether the project can still be saved if a text takes the place of another one.
 */
internal class ProgramEditing(
    private val preferences: Preferences,
    private val navigator: ScreenNavigator,
    private val notices: Notices,
    private val hasRoom: (old: String, new: String) -> Boolean,
) {
    private val fixes = QuickFixes()

    /** Whether the user tried to run a program with errors since the last edit. */
    var errorPointedOut = false
        private set

    /** Whether an action waits for the compiler. */
    val waitsForCompiler: Boolean get() = fixes.waitsForCompiler

    /** Handles [event] in the programs of [robot], the shown one. */
    fun handle(event: ProgramEvent, robot: RobotPrograms) {
        when (event) {
            is ProgramEvent.ProgramEdited -> write(robot, robot.editorState.draft.changedTo(event.text), EditKind.OTHER)
            is ProgramEvent.DraftChanged -> write(robot, event.draft, event.kind)
            ProgramEvent.Undone -> robot.editorState.undone()?.let { rememberUndo(robot, it, isRedo = false) }
            ProgramEvent.Redone -> robot.editorState.redone()?.let { rememberUndo(robot, it, isRedo = true) }
            ProgramEvent.Formatted -> format(robot)
            is ProgramEvent.WordsChosen -> changeWords(robot, event.vocabulary)
            is ProgramEvent.BreakpointToggled -> remember(robot, robot.editorState.withBreakpointToggled(event.line))
            is BlockEvent -> editBlocks(robot, event)
            is ProgramEvent.FixApplied -> write(robot, fixes.apply(robot, event.diagnostic))
            is ProgramEvent.ProgramChosen -> if (event.slot in robot.list.entries.indices) choose(robot, event.slot)
            is ProgramEvent.FileChosen ->
                if (event.index in robot.entry.editorStates.indices) robot.shownFile = event.index
            is ProgramEvent.ProgramAdded -> add(robot, opened(event.program.withPlainLineEnds()))

            is ProgramEvent.NewProgramRequested ->
                add(robot, opened(newProgram(event.language, robot.list.programs, robot.brick)))

            ProgramEvent.FileAdded -> addFile(robot)
            is ProgramEvent.FileRenamed -> rename(robot, event)
            is ProgramEvent.FileClosed -> closeFile(robot, event.index)
            is ProgramEvent.ProgramClosed -> close(robot, event.slot)
            ProgramEvent.ProgramReopened -> reopen(robot)
            ProgramEvent.ClosedMessageDismissed -> robot.closedMessageShown = false
            ProgramEvent.SearchRequested, ProgramEvent.SearchOpened -> Unit
            is ProgramEvent.RobotChosen, is ProgramEvent.TranslationShown -> resetEditState()
        }
    }

    /** Shows the errors of the program in [slot]. */
    fun pointOutErrors(robot: RobotPrograms, slot: Int) {
        if (slot != robot.shownProgram) choose(robot, slot)
        pointOut(robot, robot.list.diagnostics(slot).firstOrNull())
    }

    /** Shows [diagnostic] in the shown program of [robot]. */
    fun pointOut(robot: RobotPrograms, diagnostic: Diagnostic?) {
        val index = robot.entry.program.files.indexOfFirst { it.name == diagnostic?.file }
        if (index >= 0) robot.shownFile = index
        diagnostic?.range?.let { range ->
            val draft = robot.editorState.draft
            if (range.line > draft.lines.count) return@let
            write(robot, draft.withCaret(draft.lines.offset(range.line - 1, range.column - 1)), EditKind.OTHER)
        }
        errorPointedOut = true
        navigator.show(Pane.PROGRAM)
    }

    private fun write(robot: RobotPrograms, draft: TextDocument, kind: EditKind) {
        if (!robot.entry.program.hasRoomFor(robot.shownFile, draft)) return notices.show(TOO_LONG)
        if (!hasRoom(robot.editorState.draft.text, draft.text)) return notices.show(Notice.ProjectTooLong)
        val plain = draft.text.withPlainLineEnds()
        val written = if (plain == draft.text) draft else TextDocument(plain, draft.selection)
        val within = written.copy(selection = written.selection.within(written.text.length))
        if (within.text != robot.editorState.draft.text) resetEditState()
        remember(robot, robot.editorState.written(within, kind))
    }

    private fun editBlocks(robot: RobotPrograms, event: BlockEvent) {
        if (!robot.entry.program.language.support.hasBlocks) return
        val after = robot.editorState.after(event)
        if (!robot.entry.program.hasRoomFor(robot.shownFile, after.draft)) return notices.show(TOO_LONG)
        if (!hasRoom(robot.editorState.draft.text, after.draft.text)) return notices.show(Notice.ProjectTooLong)
        if (after.draft.text != robot.editorState.draft.text) resetEditState()
        remember(robot, after)
    }

    private fun remember(robot: RobotPrograms, editorState: FileEditorState) = robot.change(editorState, preferences)

    private fun rememberUndo(robot: RobotPrograms, editorState: FileEditorState, isRedo: Boolean) {
        val read = editorState.withBlocksRead(preferences, robot.brick)
        remember(robot, read.tellingUndo(before = robot.editorState, isRedo))
    }

    private fun format(robot: RobotPrograms) {
        val draft = robot.editorState.draft
        val text = robot.entry.program.language.support.code.format(draft.text) ?: return
        val line = draft.lines.lineOf(draft.selection.caret)
        val laidOut = TextDocument(text)
        val column = draft.lines.columnOf(draft.selection.caret)
        write(
            robot,
            laidOut.withCaret(laidOut.lines.offset(minOf(line, laidOut.lines.count - 1), column)),
            EditKind.OTHER,
        )
    }

    private fun changeWords(robot: RobotPrograms, vocabulary: Vocabulary) {
        if (!robot.entry.program.language.support.hasBlocks) return
        when (val result = changeWords(robot.editorState.draft.text, vocabulary)) {
            is ChangedWords.Success -> write(robot, robot.editorState.draft.changedTo(result.text), EditKind.OTHER)
            is ChangedWords.NamesInTheWay -> notices.show(Notice.NamesInTheWay(vocabulary.language, result.names))
        }
    }

    /** Called when the programs were compiled or compilation failed; runs the actions in [robot] that waited for it. */
    fun programsCompiled(robot: RobotPrograms) = write(robot, fixes.programsCompiled(robot))

    private fun write(robot: RobotPrograms, fixed: QuickFixResult) = when (fixed) {
        is QuickFixResult.NewText -> write(robot, robot.editorState.draft.changedTo(fixed.text), EditKind.OTHER)
        QuickFixResult.Outdated -> notices.show(Notice.FixOutdated)
        QuickFixResult.Nothing -> Unit
    }

    private fun resetEditState() {
        errorPointedOut = false
        fixes.cancel()
    }

    private fun choose(robot: RobotPrograms, slot: Int) {
        robot.shownProgram = slot
        robot.shownFile = 0
        resetEditState()
    }

    /** [program], shown as the pupil chose last. */
    private fun opened(program: Program) = ProgramBuffer(program, preferences.settings.programView)

    private fun add(robot: RobotPrograms, entry: ProgramBuffer) {
        if (robot.list.entries.size >= BrickProgram.MAX_PROGRAMS) return
        val text = entry.program.files.joinToString("\n") { it.text }
        if (!hasRoom("", text)) return notices.show(Notice.ProjectTooLong)
        robot.list.insert(robot.list.entries.size, entry)
        choose(robot, robot.list.entries.lastIndex)
        navigator.show(Pane.PROGRAM)
    }

    /** Gives [robot] exactly [programs]; files of the same name keep what they were, to be undone. */
    fun replaceAll(robot: RobotPrograms, programs: List<Program>) {
        val before = robot.list.entries
        val plain = programs.map { it.withPlainLineEnds() }
        robot.list.replace(
            plain.map { program ->
                before.firstOrNull { it.program.name == program.name }?.changedTo(program) ?: opened(program)
            },
        )
        robot.closed = null
        choose(robot, 0)
    }

    private fun addFile(robot: RobotPrograms) {
        val program = robot.entry.program
        val new = program.language.support.files.newFile(program.files, robot.brick) ?: return
        new.lineOfFirst?.let { insertFirst(robot, it) }
        val file = new.file
        val entry = robot.entry
        val files = entry.program.files.zip(entry.editorStates) + (file to FileEditorState(TextDocument(file.text)))
        robot.list.change(robot.shownProgram, entry.withFiles(files))
        robot.shownFile = robot.entry.editorStates.lastIndex
    }

    /** Makes [line] the first one of the program. */
    private fun insertFirst(robot: RobotPrograms, line: String) {
        val main = robot.entry.editorStates.first()
        val draft = main.draft.changedTo("$line\n${main.draft.text}")
        robot.list.change(robot.shownProgram, robot.entry.with(0, main.written(draft, EditKind.OTHER)))
    }

    private fun rename(robot: RobotPrograms, event: ProgramEvent.FileRenamed) {
        val entry = robot.entry
        if (event.index !in entry.editorStates.indices) return
        if (nameError(robot.list.programs, robot.shownProgram, event.index, event.name) != null) return
        robot.list.change(
            robot.shownProgram,
            entry.withFileRenamed(
                event.index,
                fileNameFor(event.name, entry.program.files[event.index].name, entry.program.language),
            ),
        )
    }

    private fun closeFile(robot: RobotPrograms, index: Int) {
        val files = robot.entry.program.files.zip(robot.entry.editorStates)
        if (index !in files.indices || files.size == 1) return
        robot.closed = ClosedFile.OfProgram(robot.shownProgram, index, files[index].first, files[index].second)
        robot.list.change(
            robot.shownProgram,
            robot.entry.withFiles(files.filterIndexed { other, _ -> other != index }),
        )
        robot.shownFile = robot.shownFile.let { if (it > index) it - 1 else it }.coerceAtMost(files.size - 2)
    }

    private fun close(robot: RobotPrograms, slot: Int) {
        val entries = robot.list.entries
        if (slot !in entries.indices || entries.size == 1) return
        robot.closed = ClosedFile.Program(entries[slot])
        robot.list.remove(slot)
        choose(robot, robot.shownProgram.let { if (it > slot || it > robot.list.entries.lastIndex) it - 1 else it })
    }

    private fun reopen(robot: RobotPrograms) {
        if (!robot.canReopen) return
        val closed = robot.closed ?: return
        robot.closed = null
        when (closed) {
            is ClosedFile.Program -> add(robot, closed.entry)

            is ClosedFile.OfProgram -> {
                val entry = robot.list.entries[closed.slot]
                val files = entry.program.files.zip(entry.editorStates).toMutableList()
                files.add(minOf(closed.index, files.size), closed.file to closed.editorState)
                robot.list.change(closed.slot, entry.withFiles(files))
                robot.shownProgram = closed.slot
                robot.shownFile = minOf(closed.index, files.lastIndex)
            }
        }
    }
}

/** This draft with [text] and the caret next to the same text as before. */
internal fun TextDocument.changedTo(text: String): TextDocument {
    val edit = editBetween(this.text, text.withPlainLineEnds()) ?: return this
    return TextDocument(edit.applyTo(this.text)).withCaret(edit.moved(selection.caret))
}

/** In thousands, since each language formats larger numbers differently. */
private val TOO_LONG = Notice.ProgramTooLong(
    ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS / THOUSAND,
    ProjectLimits.MAXIMUM_LINES / THOUSAND,
)
private const val THOUSAND = 1_000
