package robotran.workshop.programs

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditError
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.blockediting.apply
import robotran.blockediting.blocksOf
import robotran.blockediting.palette.PaletteBlock
import robotran.blockediting.palette.textAt
import robotran.language.Language
import robotran.language.source.SourceSpan
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.PhrasePart
import robotran.workshop.blocks.BlockTarget
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.at
import robotran.workshop.blocks.blocksIn
import robotran.workshop.blocks.placeForNew

/** Adds a block of the palette at the cursor; a value needs a part of a line with the cursor. */
internal fun FileEditorState.taken(now: BlocksState, block: PaletteBlock): FileEditorState {
    if (!block.isValue) return inserted(now, block.textFor(now.program), now.placeForNew)
    val part = now.part ?: return copy(blocks = now.copy(error = BlockEditError.NoPlaceForValue))
    return valuePut(now, block, part)
}

internal fun FileEditorState.pasted(now: BlocksState, text: String): FileEditorState {
    val value = now.part?.let { BlockEdit.Replace(it, text.trim()) }
    return if (value != null && '\n' !in text.trim() && apply(now.program, value) is BlockEditResult.Success) {
        edited(now, value)
    } else {
        inserted(now, text, now.placeForNew)
    }
}

/** Lets go of [load] at [target]. If it cannot go there, all stays as it was. */
internal fun FileEditorState.dropped(now: BlocksState, load: DragPayload, target: BlockTarget): FileEditorState =
    when (target) {
        is BlockTarget.Between -> droppedBetween(now, load, target.place)
        is BlockTarget.Socket -> droppedInto(now, load, target.span)
        BlockTarget.Bin -> droppedIntoBin(now, load)
    } ?: this

private fun FileEditorState.droppedBetween(now: BlocksState, load: DragPayload, place: BlockPlace) = when (load) {
    is DragPayload.Blocks -> edited(now, BlockEdit.Move(load.run, place))
    is DragPayload.New -> if (load.block.isValue) null else inserted(now, load.block.textFor(now.program), place)
    is DragPayload.Value -> null
}

private fun FileEditorState.droppedInto(now: BlocksState, load: DragPayload, span: SourceSpan) = when (load) {
    is DragPayload.Blocks -> null
    is DragPayload.New -> if (load.block.isValue) valuePut(now, load.block, span) else null
    is DragPayload.Value -> valueEdited(now, BlockEdit.MoveValue(load.span, span))
}

private fun FileEditorState.droppedIntoBin(now: BlocksState, load: DragPayload) = when (load) {
    is DragPayload.Blocks ->
        edited(now, BlockEdit.Delete(now.program.blocksIn(load.run).mapTo(mutableSetOf()) { it.id }))
    is DragPayload.New -> null
    is DragPayload.Value -> valueEdited(now, BlockEdit.ClearValue(load.span))
}

private fun FileEditorState.valuePut(now: BlocksState, block: PaletteBlock, span: SourceSpan): FileEditorState {
    val part = now.program.partAt(span) as? PhrasePart.Value
    return valueEdited(now, BlockEdit.Replace(span, part?.let { block.textAt(it, now.program) } ?: block.template))
}

/** Applies [edit] and puts the cursor at the value that it has put somewhere. */
private fun FileEditorState.valueEdited(now: BlocksState, edit: BlockEdit): FileEditorState {
    val done = edited(now, edit)
    val blocks = done.blocks ?: return done
    if (blocks.error != null) return done
    val selection = done.draft.selection
    val span = SourceSpan(selection.start, selection.end)
    val row = blocks.cursorAt(span) ?: return done
    return done.copy(blocks = blocks.at(row).copy(part = span.takeIf { blocks.program.partAt(it) != null }))
}

/** Inserts lines at [place], or outside of all blocks if they may only stand there. */
private fun FileEditorState.inserted(now: BlocksState, text: String, place: BlockPlace): FileEditorState {
    val isOutermost = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH)).blocks.any {
        it.head.form?.isOutermost == true
    }
    return edited(now, BlockEdit.Insert(text, if (isOutermost) now.program.outside(place) else place))
}

private fun BlockProgram.outside(place: BlockPlace): BlockPlace =
    generateSequence(place) { inner -> inner.parent?.let { placeOf(it) }?.next }.last()
