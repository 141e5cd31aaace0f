package robotran.blockediting

/**
 * Makes [edit] a change of the text of [program]. Only the lines that the edit is about change; moved lines change their
 * indentation. Afterwards the text has exactly the blocks that the edit is to make: if a block without `end` is in the
 * way, its `end` is written, too, and if that is not enough, the edit is refused.
 */
fun apply(program: BlockProgram, edit: BlockEdit): BlockEditResult = when (edit) {
    is BlockEdit.Insert -> RunEdits(program).insert(edit)
    is BlockEdit.Move -> RunEdits(program).move(edit)
    is BlockEdit.Duplicate -> RunEdits(program).duplicate(edit)
    is BlockEdit.Delete -> RunEdits(program).delete(edit)
    is BlockEdit.Wrap -> ConstructEdits(program).wrap(edit)
    is BlockEdit.Unwrap -> ConstructEdits(program).unwrap(edit)
    is BlockEdit.AddElse -> ConstructEdits(program).addElse(edit)
    is BlockEdit.RemoveElse -> ConstructEdits(program).removeElse(edit)
    is BlockEdit.Replace -> PartEdits(program).replace(edit)
    is BlockEdit.MoveValue -> PartEdits(program).move(edit)
    is BlockEdit.ClearValue -> PartEdits(program).clear(edit)
    is BlockEdit.UseNewName -> NewNames(program).use(edit)
    is BlockEdit.ChangeForm -> changedForm(program, edit)
    is BlockEdit.AddItem -> ItemEdits(program).add(edit)
    is BlockEdit.RemoveItem -> ItemEdits(program).remove(edit)
    is BlockEdit.AddParameter -> ItemEdits(program).addParameter(edit)
    is BlockEdit.RemoveParameter -> ItemEdits(program).removeParameter(edit)
    is BlockEdit.SetNote -> LineEdits(program).setNote(edit)
    is BlockEdit.ReplaceLine -> LineEdits(program).replaceLine(edit)
    is BlockEdit.ApplyFix -> LineEdits(program).applyFix(edit)
    is BlockEdit.Rename -> renamed(program, edit)
}

/**
 * The text of [run] for the clipboard, without the indentation of its first line and with `\n` line ends; null if there
 * is no such run. A block without `end` gets one.
 */
fun copied(program: BlockProgram, run: BlockRun): String? {
    val lines = program.linesOf(run) ?: return null
    val rows = program.outline.rows(program.lineCount).subList(lines.first, lines.last + 1)
    val base = baseIndentation(rows)
    val copy = rows.map { it.moved(base, indentation = "", depth = -rows.first().depth) }
    return copy.closed(unclosed(copy), program).joinToString("") { it.content + "\n" }
}
