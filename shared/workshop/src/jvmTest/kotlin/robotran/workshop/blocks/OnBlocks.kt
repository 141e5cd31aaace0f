package robotran.workshop.blocks

import kotlinx.coroutines.runBlocking
import robotran.blockediting.BlockEdit
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteBlock
import robotran.language.source.SourceSpan
import robotran.projects.ProgramView
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.openWorkshop

/** Runs [check] on a workshop that shows [text] in blocks. */
internal fun onBlocks(text: String, check: OnBlocks.() -> Unit) {
    val workshop = runBlocking { openWorkshop() }
    try {
        val blocks = OnBlocks(workshop)
        blocks.write(text)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        blocks.check()
    } finally {
        workshop.close()
    }
}

/** A workshop whose blocks are addressed by their words. */
internal class OnBlocks(val workshop: Workshop) {
    val text: String get() = workshop.state.programs.draft.text
    val state: BlocksState get() = checkNotNull(workshop.state.programs.blocks)

    /** The words of the row that the keyboard is at; null if it is at none. */
    val row: String? get() = state.cursor?.let { state.program.lineOf(it) }?.let { it.span.textIn(text).trim() }

    /** The words of the part of that row that the keyboard is at. */
    val part: String? get() = state.part?.textIn(text)

    fun write(text: String) = send(ProgramEvent.DraftChanged(TextDocument(text), EditKind.OTHER))

    fun send(event: ProgramEvent) = workshop.handle(event)

    fun edit(edit: BlockEdit) = send(BlockEvent.Edited(edit))

    fun take(id: String) = send(BlockEvent.Taken(fromPalette(id)))

    fun fromPalette(id: String): PaletteBlock = Palette.blocks.first { it.id == id }

    /** The first block with these [words]. */
    fun block(words: String) = state.program.all.first { it.head.span.textIn(text).trim() == words }.id

    /** Puts the cursor at the first row with these [words]. */
    fun goTo(words: String) {
        val found = state.list.rows.first { each -> each.line?.span?.textIn(text)?.trim() == words }
        send(BlockEvent.CursorPut(found.cursor))
    }

    /** The place of the part [words] of the first row that says [line]. */
    fun span(line: String, words: String): SourceSpan {
        val parts = state.program.outline.lines.first { it.span.textIn(text).trim() == line }.editableParts
        return parts.first { it.span.textIn(text) == words }.span
    }

    /** Carries [load] to [target] and lets go. */
    fun drag(load: DragPayload, target: BlockTarget) = send(BlockEvent.Dropped(load, target))

    /** Opens the sheet of the part [words] of the row [line]. */
    fun open(line: String, words: String) {
        goTo(line)
        val parts = checkNotNull(state.program.lineOf(checkNotNull(state.cursor))).editableParts
        send(BlockEvent.DialogShown(BlockDialog.Part(parts.first { it.span.textIn(text) == words }.span)))
    }
}
