package robotran.workshop.programs

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockId
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.blockediting.apply
import robotran.blockediting.blocksOf
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.SourceSpan
import robotran.textediting.EditKind
import robotran.textediting.text.Draft
import robotran.textediting.text.TextSelection
import robotran.workshop.blocks.BlockCursor
import robotran.workshop.blocks.BlockList
import robotran.workshop.blocks.BlockLoad
import robotran.workshop.blocks.BlockSheet
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.at
import robotran.workshop.blocks.lineOf
import robotran.workshop.blocks.placeBeyond
import robotran.workshop.blocks.placeForNew
import robotran.workshop.blocks.stepped
import robotran.workshop.event.BlockEvent

/** This memory with the blocks of its text in [language], if it is shown in blocks. The same if they are current. */
internal fun ProgramFileMemory.withBlocksRead(language: Language): ProgramFileMemory {
    if (!view.hasBlocks) return this
    val known = blocks ?: return copy(blocks = BlocksState(BlockList(read(language, previous = null)), language))
    if (known.program.text == draft.text && known.language == language) return this
    val program = read(language, known.program)
    // The places of parts have moved with the text.
    val state = known.copy(
        list = BlockList(program, known.list.collapsed),
        language = language,
        cursor = known.cursor?.takeIf { program[it.block] != null },
        part = null,
        selected = known.selected.takeIf { ids -> ids.all { program[it] != null } }.orEmpty(),
        sheet = known.sheet?.takeIf { it == BlockSheet.Palette },
        drag = null,
        refusal = null,
    )
    return copy(blocks = state)
}

private fun ProgramFileMemory.read(language: Language, previous: BlockProgram?): BlockProgram =
    blocksOf(draft.text, RobolangMessages.of(language), previous)

/** This memory after [event]. Its blocks must be current. */
internal fun ProgramFileMemory.after(event: BlockEvent): ProgramFileMemory {
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
        is BlockEvent.Moved -> moved(now, event.isUp)
        is BlockEvent.Folded -> copy(blocks = now.folded(event.block))
        is BlockEvent.Taken -> inserted(now, event.block.textFor(now.program), now.placeForNew)
        is BlockEvent.Pasted -> inserted(now, event.text, now.placeForNew)
        is BlockEvent.SheetShown -> showing(now, event.sheet)
        is BlockEvent.DoneNow -> copy(blocks = now.copy(refusal = null))
        is BlockEvent.PaletteTurned -> copy(blocks = now.copy(palette = event.palette))
        is BlockEvent.Dragged -> copy(blocks = now.copy(drag = event.drag))
        BlockEvent.Dropped -> dropped(now)
        BlockEvent.DragCancelled -> copy(blocks = now.copy(drag = null))
        BlockEvent.RefusalDismissed -> copy(blocks = now.copy(refusal = null))
    }
}

/** This memory with [blocks] and the caret of the text at the line of their cursor, so that both views show it. */
private fun ProgramFileMemory.shownAt(blocks: BlocksState): ProgramFileMemory {
    val line = blocks.cursor?.let(blocks.program::lineOf)
    if (line == null || blocks.cursor == this.blocks?.cursor) return copy(blocks = blocks)
    val place = blocks.part?.start ?: line.parts.firstOrNull()?.span?.start ?: line.span.start
    return copy(draft = draft.withCaret(place), history = history.closed(), blocks = blocks)
}

private fun BlocksState.nowhere(): BlocksState = copy(cursor = null, part = null, selected = emptyList())

private fun BlocksState.selectedTo(block: BlockId): BlocksState {
    val place = program.placeOf(block) ?: return this
    val anchor = selected.firstOrNull()?.let(program::placeOf) ?: return at(BlockCursor.At(block))
    if (anchor.parent != place.parent || anchor.slot != place.slot) return at(BlockCursor.At(block))
    val siblings = program.blocksAt(place.parent, place.slot).orEmpty()
    val range = minOf(anchor.index, place.index)..maxOf(anchor.index + selected.lastIndex, place.index)
    return copy(cursor = BlockCursor.At(block), part = null, selected = siblings.slice(range).map { it.id })
}

private fun BlocksState.selectedStack(block: BlockId): BlocksState {
    val place = program.placeOf(block) ?: return this
    val siblings = program.blocksAt(place.parent, place.slot).orEmpty()
    return copy(cursor = BlockCursor.At(block), part = null, selected = siblings.drop(place.index).map { it.id })
}

private fun BlocksState.folded(block: BlockId): BlocksState {
    val collapsed = if (block in list.collapsed) list.collapsed - block else list.collapsed + block
    return copy(list = BlockList(program, collapsed)).at(BlockCursor.At(block))
}

private fun ProgramFileMemory.showing(now: BlocksState, sheet: BlockSheet?): ProgramFileMemory {
    val base = if (sheet is BlockSheet.Part) UndoBase(draft, history) else null
    val here = (sheet as? BlockSheet.Part)?.let { now.cursorAt(it.span) } ?: now.cursor
    val state = if (here == null || here == now.cursor) now else now.at(here)
    return copy(blocks = state.copy(sheet = sheet, refusal = null), undoBase = base)
}

/** The row that [part] is in. */
private fun BlocksState.cursorAt(part: SourceSpan): BlockCursor? =
    list.rowOfLine(program.lineAt(part.start).index)?.let { list.rows[it].cursor }

private fun ProgramFileMemory.put(now: BlocksState, text: String): ProgramFileMemory {
    val sheet = now.sheet as? BlockSheet.Part ?: return this
    return edited(now, BlockEdit.Replace(sheet.span, text))
}

private fun ProgramFileMemory.moved(now: BlocksState, isUp: Boolean): ProgramFileMemory {
    val place = now.placeBeyond(isUp) ?: return this
    val run = now.run ?: return this
    return edited(now, BlockEdit.Move(run, place))
}

private fun ProgramFileMemory.dropped(now: BlocksState): ProgramFileMemory {
    val drag = now.drag ?: return this
    val place = drag.place ?: return copy(blocks = now.copy(drag = null))
    return when (val load = drag.load) {
        is BlockLoad.Blocks -> edited(now, BlockEdit.Move(load.run, place))
        is BlockLoad.New -> inserted(now, load.block.textFor(now.program), place)
    }
}

/** Inserts lines at [place], or outside of all blocks if they may only stand there. */
private fun ProgramFileMemory.inserted(now: BlocksState, text: String, place: BlockPlace): ProgramFileMemory {
    val isOutermost = blocksOf(text).blocks.any { it.head.form?.isOutermost == true }
    return edited(now, BlockEdit.Insert(text, if (isOutermost) now.program.outside(place) else place))
}

private fun BlockProgram.outside(place: BlockPlace): BlockPlace =
    generateSequence(place) { inner -> inner.parent?.let { placeOf(it) }?.next }.last()

private fun ProgramFileMemory.edited(now: BlocksState, edit: BlockEdit): ProgramFileMemory =
    when (val result = apply(now.program, edit)) {
        is BlockEditResult.Refused -> copy(blocks = now.copy(drag = null, refusal = result.reason))
        is BlockEditResult.Done -> madeOf(now, result, staysInLine = edit.isInLine)
    }

private fun ProgramFileMemory.madeOf(
    now: BlocksState,
    done: BlockEditResult.Done,
    staysInLine: Boolean,
): ProgramFileMemory {
    val program = done.program
    val part = done.selection.takeIf { staysInLine && program.partAt(it) != null }
    val sheet = when (now.sheet) {
        is BlockSheet.Part -> part?.let { BlockSheet.Part(it) }
        BlockSheet.Palette -> BlockSheet.Palette
        is BlockSheet.Actions, is BlockSheet.Line, is BlockSheet.Note, null -> null
    }
    val after = now.copy(
        list = BlockList(program, now.list.collapsed),
        cursor = if (staysInLine) now.cursor else done.selected.lastOrNull()?.let { BlockCursor.At(it) },
        part = part.takeIf { now.part != null },
        selected = done.selected,
        sheet = sheet,
        drag = null,
        refusal = null,
    )
    if (program.text == draft.text) return copy(blocks = after)
    val text = Draft(program.text, TextSelection(done.selection.start, done.selection.end))
    val base = undoBase?.takeIf { staysInLine && now.sheet is BlockSheet.Part } ?: UndoBase(draft, history)
    return copy(
        draft = text,
        history = base.history.recorded(base.draft, text, EditKind.OTHER),
        breakpoints = movedBreakpoints(breakpoints, now.program, done),
        blocks = after,
        undoBase = base.takeIf { sheet is BlockSheet.Part },
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
