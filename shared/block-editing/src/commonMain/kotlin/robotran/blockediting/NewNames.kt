package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.NameRole
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse
import robotran.textediting.TextEdit

/** Declares names where they are used. */
internal class NewNames(private val program: BlockProgram) {
    fun use(edit: BlockEdit.UseNewName): BlockEditResult {
        val part = program.partAt(edit.part) ?: return refused(BlockEditError.NotFound)
        val name = edit.name.trim()
        if (!isName(name, program.vocabulary)) return refused(BlockEditError.NoName(name))
        if (program.freeName(name) != name) return refused(BlockEditError.NameTaken(name))
        val line = program.lineAt(edit.part.start).index
        val declared = when (part) {
            is PhrasePart.Value -> declareVariable(name, part.use, line)
            is PhrasePart.NamePart -> declare(name, part.role, line)
            is PhrasePart.Word, is PhrasePart.Choice, is PhrasePart.Text -> null
        }
        if (declared == null) return refused(BlockEditError.NotFound)
        if (declared !is BlockEditResult.Success) return declared
        val used = apply(program, BlockEdit.Replace(edit.part, name))
        if (used !is BlockEditResult.Success) return used
        val changes = (declared.changes + used.changes).sortedBy { it.start }
        val shift = declared.changes.filter { it.start <= edit.part.start }.sumOf(TextEdit::growth)
        val start = edit.part.start + shift
        return resultOf(program, changes, SourceSpan(start, start + name.length))
    }

    private fun declare(name: String, role: NameRole, line: Int): BlockEditResult? = when (role) {
        NameRole.READS, NameRole.ASSIGNS -> declareVariable(name, ValueUse.ANY, line)
        NameRole.CALLS_PROCEDURE -> declareRoutine("procedure $name()\nend")
        NameRole.CALLS_FUNCTION -> declareRoutine("function $name()\n${INDENTATION}return 5\nend")
        NameRole.DECLARES, NameRole.DECLARES_ROUTINE -> null
    }

    /** Behaviours begin after the declarations at the start of a program, so that is where a new one goes. */
    private fun declareVariable(name: String, use: ValueUse, line: Int): BlockEditResult {
        val outermost = program.blocks.indexOfFirst { line in it.lines }
        val leading = program.blocks.indexOfFirst { it.head.form !in LEADING && it.head.role.isStatement }
        val end = if (leading < 0) program.blocks.size else leading
        val above = program.blocks.subList(0, end).indexOfLast { it.head.form in LEADING } + 1
        val first = if (above > 0) above else program.blocks.indexOfFirst { it !is Block.Comment }
        val place = BlockPlace(null, 0, minOf(maxOf(first, 0), outermost))
        return apply(program, BlockEdit.Insert("var $name = ${use.example}", place))
    }

    private fun declareRoutine(lines: String): BlockEditResult =
        apply(program, BlockEdit.Insert("\n$lines", checkNotNull(program.endOf(parent = null))))

    private companion object {
        val LEADING = setOf(LineForm.ROBOT, LineForm.DECLARE_VARIABLE, LineForm.DECLARE_CONSTANT)
    }
}
