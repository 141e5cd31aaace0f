package robotran.workshop.programs

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockId
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.blockediting.apply
import robotran.blockediting.blocksOf
import robotran.blockediting.describe.describe
import robotran.blockediting.describe.describeChange
import robotran.blockediting.messages.BlockMessages
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.projects.ProgramView
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.Vocabulary
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.blocks.BlockList
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.at
import robotran.workshop.blocks.lineOf
import robotran.workshop.blocks.placeBeyond
import robotran.workshop.blocks.placeNested
import robotran.workshop.blocks.stepped
import robotran.workshop.event.BlockEvent
import robotran.workshop.service.Preferences

/**
 * This memory with the blocks of its text for a robot with [brick], in the language and the words of [preferences], if it
 * is shown in blocks. The same if they are current.
 */
internal fun FileEditorState.withBlocksRead(preferences: Preferences, brick: BrickKind): FileEditorState {
    if (!view.hasBlocks) return this
    val language = preferences.language
    val words = Vocabulary.of(preferences.words)
    val known = blocks ?: return copy(blocks = BlocksState(BlockList(read(language, null, words, brick)), language))
    val isCurrent =
        known.language == language && known.program.shown === words && known.program.brick == brick
    if (known.program.text == draft.text && isCurrent) return this
    val program = read(language, known.program, words, brick)
    // The places of parts have moved with the text.
    val state = known.copy(
        list = BlockList(program, known.list.collapsed),
        language = language,
        cursor = known.cursor?.takeIf { program[it.block] != null },
        part = null,
        selected = known.selected.takeIf { ids -> ids.all { program[it] != null } }.orEmpty(),
        anchor = null,
        isChoosing = false,
        sheet = known.sheet?.takeIf { it == BlockDialog.Palette },
        said = null,
        error = null,
    )
    // Beside the text, the pupil looks at the caret.
    return copy(blocks = state).let { if (view == ProgramView.BOTH) it.withCursorAtCaret() else it }
}

/**
 * This memory with the cursor of its blocks at the line of the caret, if they are shown. Until the blocks of a changed
 * text are read, it stays where it is.
 */
internal fun FileEditorState.withCursorAtCaret(): FileEditorState {
    val known = blocks ?: return this
    if (!view.hasBlocks || known.program.text != draft.text) return this
    val row = known.list.rowOfLine(draft.lines.lineOf(draft.selection.caret))?.let { known.list.rows[it] }
    val cursor = row?.cursor?.takeIf { it != known.cursor } ?: return this
    return copy(blocks = known.at(cursor).copy(sheet = known.sheet?.takeIf { it == BlockDialog.Palette }))
}

/**
 * This memory, which came of [before] by undo or redo, with what that has changed in words for a screen reader. The same
 * if it is not shown in blocks.
 */
internal fun FileEditorState.tellingUndo(before: FileEditorState, isRedo: Boolean): FileEditorState {
    val now = blocks?.takeIf { view.hasBlocks } ?: return this
    val then = before.blocks ?: return this
    val messages = BlockMessages.of(now.language)
    val change = describeChange(then.program, now.program, messages)
    val words = if (isRedo) messages.redone(change) else messages.undone(change)
    return copy(blocks = now.copy(said = saidAfter(then.said, words)))
}

/** [words] for a live region that has said [last]: if that is the same, it would not be told again. */
private fun saidAfter(last: String?, words: String): String = if (words == last) words + UNHEARD else words

/** A no-break space. */
private const val UNHEARD = '\u00A0'

private fun FileEditorState.read(
    language: Language,
    previous: BlockProgram?,
    words: Vocabulary,
    brick: BrickKind,
): BlockProgram = blocksOf(draft.text, RobolangMessages.of(language), previous, words, brick)

/** This memory after [event]. Its blocks must be current. */
internal fun FileEditorState.after(event: BlockEvent): FileEditorState {
    if (event is BlockEvent.ViewChosen) return copy(view = event.view)
    val now = blocks?.takeIf { view.hasBlocks } ?: return this
    return when (event) {
        is BlockEvent.ViewChosen -> this
        is BlockEvent.Edited -> edited(now, event.edit)
        is BlockEvent.Put -> put(now, event.text)
        is BlockEvent.CursorPut -> shownAt(event.cursor?.let { now.at(it).copy(part = event.part) } ?: now.nowhere())
        is BlockEvent.SelectedTo -> copy(blocks = now.selectedTo(event.block))
        is BlockEvent.StackSelected -> copy(blocks = now.selectedStack(event.block))
        is BlockEvent.Stepped -> shownAt(now.stepped(event.step))
        is BlockEvent.MultiSelectChanged -> copy(blocks = now.copy(isChoosing = event.isOn))
        is BlockEvent.Moved -> moved(now, now.placeBeyond(event.isUp))
        is BlockEvent.Nested -> moved(now, now.placeNested(event.isOut))
        is BlockEvent.Folded -> copy(blocks = now.folded(event.block))
        is BlockEvent.Taken -> taken(now, event.block)
        is BlockEvent.Pasted -> pasted(now, event.text)
        is BlockEvent.DialogShown -> showing(now, event.sheet)
        is BlockEvent.SnippetRequested -> copy(blocks = now.copy(error = null))
        is BlockEvent.PaletteGroupSelected -> copy(blocks = now.copy(palette = event.palette))
        is BlockEvent.Dropped -> dropped(now, event.load, event.target)
        BlockEvent.ErrorDismissed -> copy(blocks = now.copy(error = null))
    }
}

/** This memory with [blocks] and the caret of the text at the line of their cursor, so that both views show it. */
private fun FileEditorState.shownAt(blocks: BlocksState): FileEditorState {
    val line = blocks.cursor?.let(blocks.program::lineOf)
    if (line == null || blocks.cursor == this.blocks?.cursor) return copy(blocks = blocks)
    val place = blocks.part?.start ?: line.parts.firstOrNull()?.span?.start ?: line.span.start
    return copy(draft = draft.withCaret(place), history = history.closed(), blocks = blocks)
}

private fun BlocksState.folded(block: BlockId): BlocksState {
    val collapsed = if (block in list.collapsed) list.collapsed - block else list.collapsed + block
    return copy(list = BlockList(program, collapsed)).at(BlockCursor.At(block))
}

private fun FileEditorState.showing(now: BlocksState, sheet: BlockDialog?): FileEditorState {
    val base = if (sheet is BlockDialog.Part) UndoBase(draft, history) else null
    val here = (sheet as? BlockDialog.Part)?.let { now.cursorAt(it.span) } ?: now.cursor
    val at = if (here == null || here == now.cursor) now else now.at(here)
    // Where a sheet was opened is where the keyboard goes on, and where a value of the palette goes.
    val state = if (sheet is BlockDialog.Part) at.copy(part = sheet.span) else at
    val opensPalette = sheet == BlockDialog.Palette && now.sheet != BlockDialog.Palette
    val palette = if (opensPalette) now.palette.copy(query = "") else now.palette
    return shownAt(state.copy(sheet = sheet, palette = palette, error = null)).copy(undoBase = base)
}

/** The row that [part] is in. */
internal fun BlocksState.cursorAt(part: SourceSpan): BlockCursor? =
    list.rowOfLine(program.lineAt(part.start).index)?.let { list.rows[it].cursor }

private fun FileEditorState.put(now: BlocksState, text: String): FileEditorState {
    val sheet = now.sheet as? BlockDialog.Part ?: return this
    return edited(now, BlockEdit.Replace(sheet.span, text))
}

private fun FileEditorState.moved(now: BlocksState, place: BlockPlace?): FileEditorState {
    val run = now.run ?: return this
    return if (place == null) this else edited(now, BlockEdit.Move(run, place))
}

internal fun FileEditorState.edited(now: BlocksState, edit: BlockEdit): FileEditorState =
    when (val result = apply(now.program, edit)) {
        is BlockEditResult.Failure -> copy(blocks = now.copy(error = result.reason))

        is BlockEditResult.Success -> {
            val said = describe(now.program, edit, result, BlockMessages.of(now.language))
            madeOf(
                now.copy(said = saidAfter(now.said, said), isChoosing = now.isChoosing && edit !is BlockEdit.Delete),
                result,
                staysInLine = edit.isInLine,
            )
        }
    }

private fun FileEditorState.madeOf(
    now: BlocksState,
    done: BlockEditResult.Success,
    staysInLine: Boolean,
): FileEditorState {
    val program = done.program
    val part = done.selection.takeIf { staysInLine && program.partAt(it) != null }
    val sheet = when (now.sheet) {
        is BlockDialog.Part -> part?.let { BlockDialog.Part(it) }
        BlockDialog.Palette -> BlockDialog.Palette
        is BlockDialog.Actions, is BlockDialog.Line, is BlockDialog.Note, null -> null
    }
    val after = now.copy(
        list = BlockList(program, now.list.collapsed),
        cursor = if (staysInLine) now.cursor else done.selected.lastOrNull()?.let { BlockCursor.At(it) },
        part = part.takeIf { now.part != null },
        selected = done.selected,
        anchor = null,
        isChoosing = now.isChoosing,
        sheet = sheet,
        error = null,
    )
    if (program.text == draft.text) return copy(blocks = after)
    val text = TextDocument(program.text, TextSelection(done.selection.start, done.selection.end))
    val base = undoBase?.takeIf { staysInLine && now.sheet is BlockDialog.Part } ?: UndoBase(draft, history)
    return copy(
        draft = text,
        history = base.history.recorded(base.draft, text, EditKind.OTHER),
        breakpoints = movedBreakpoints(breakpoints, now.program, done),
        blocks = after,
        undoBase = base.takeIf { sheet is BlockDialog.Part },
    )
}

/** Whether the edit changes what a line says and leaves the lines where they are. */
private val BlockEdit.isInLine: Boolean
    get() = when (this) {
        is BlockEdit.Replace, is BlockEdit.MoveValue, is BlockEdit.ClearValue, is BlockEdit.UseNewName,
        is BlockEdit.ChangeForm, is BlockEdit.AddItem, is BlockEdit.RemoveItem, is BlockEdit.AddParameter,
        is BlockEdit.RemoveParameter, is BlockEdit.SetNote, is BlockEdit.Rename,
        -> true
        is BlockEdit.Insert, is BlockEdit.Move, is BlockEdit.Duplicate, is BlockEdit.Delete, is BlockEdit.Wrap,
        is BlockEdit.Unwrap, is BlockEdit.AddElse, is BlockEdit.RemoveElse, is BlockEdit.ReplaceLine,
        is BlockEdit.ApplyFix,
        -> false
    }
