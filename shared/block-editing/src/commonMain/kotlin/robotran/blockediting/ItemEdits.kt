package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueUse
import robotran.textediting.TextEdit

/** Edits of what stands between brackets, separated by commas: elements of lists, parameters and the values for them. */
internal class ItemEdits(private val program: BlockProgram) {
    fun add(edit: BlockEdit.AddItem): BlockEditResult {
        val items = listAt(edit.list) ?: return refused(BlockEditError.NotFound)
        val item = program.inWords(edit.item.trim())
        if (edit.index !in 0..items.items.size) return refused(BlockEditError.NotFound)
        val change = items.added(edit.index, item)
        val start = change.start + change.inserted.indexOf(item)
        val result = resultOf(program, listOf(change), SourceSpan(start, start + item.length))
        val placed = (result as? BlockEditResult.Success)?.let { it.program.partAt(it.selection) as? PhrasePart.Value }
        return if (placed == null || item.isEmpty()) refused(BlockEditError.NoValue(item, error = null)) else result
    }

    fun remove(edit: BlockEdit.RemoveItem): BlockEditResult {
        val items = listAt(edit.list) ?: return refused(BlockEditError.NotFound)
        if (edit.index !in items.items.indices) return refused(BlockEditError.NotFound)
        if (items.items.size == 1) return refused(BlockEditError.LastItem)
        val change = items.removed(edit.index)
        return resultOf(program, listOf(change), SourceSpan(change.start, change.start))
    }

    fun addParameter(edit: BlockEdit.AddParameter): BlockEditResult {
        val uses = bracketsOf(edit.routine) ?: return refused(BlockEditError.NotFound)
        val name = edit.name.trim()
        if (!isName(name, program.vocabulary)) return refused(BlockEditError.NoName(name))
        if (program.freeName(name) != name) return refused(BlockEditError.NameTaken(name))
        val changes = uses.map { (use, items) ->
            items.added(items.items.size, if (use == edit.routine) name else ValueUse.ANY.example)
        }.sortedBy { it.start }
        return resultOf(program, changes, declaredAfter(edit.routine, changes))
    }

    fun removeParameter(edit: BlockEdit.RemoveParameter): BlockEditResult {
        val uses = bracketsOf(edit.routine) ?: return refused(BlockEditError.NotFound)
        val declared = uses.first { it.first == edit.routine }.second
        if (edit.index !in declared.items.indices) return refused(BlockEditError.NotFound)
        val removed = uses.map { it.second }.filter { edit.index in it.items.indices }.map { it.removed(edit.index) }
        val changes = withoutInner(removed.sortedBy { it.start })
        return resultOf(program, changes, declaredAfter(edit.routine, changes))
    }

    /** A call in a value that is deleted goes with it. */
    private fun withoutInner(changes: List<TextEdit>): List<TextEdit> {
        var end = 0
        return changes.filter { change ->
            (change.start >= end).also { if (it) end = change.start + change.removed.length }
        }
    }

    private fun declaredAfter(routine: SourceSpan, changes: List<TextEdit>): SourceSpan {
        val start = routine.start + changes.filter { it.start < routine.start }.sumOf { it.growth }
        return SourceSpan(start, start + routine.length)
    }

    private fun listAt(span: SourceSpan): Items? = (program.partAt(span) as? PhrasePart.Value)?.value?.takeIf {
        it.form == ValueForm.LIST
    }?.let { itemsIn(it.parts) }

    /** Each use of the routine that is declared at [routine], with the brackets behind it. */
    private fun bracketsOf(routine: SourceSpan): List<Pair<SourceSpan, Items>>? {
        val name = program.outline.names.firstOrNull { it.declaredAt == routine && it.isRoutine } ?: return null
        val uses = name.uses.mapNotNull { use ->
            partsAround(program.lineAt(use.start).parts, use)?.let(::itemsIn)?.let { use to it }
        }
        // The declaration has none if its line has a mistake.
        return uses.takeIf { found -> found.any { it.first == routine } }
    }

    private fun partsAround(parts: List<PhrasePart>, name: SourceSpan): List<PhrasePart>? {
        val index = parts.indexOfFirst { it is PhrasePart.NamePart && it.span == name }
        if (index >= 0) return parts.drop(index + 1)
        return parts.firstNotNullOfOrNull { part ->
            (part as? PhrasePart.Value)?.takeIf { name in it.span }?.let { partsAround(it.value.parts, name) }
        }
    }

    /** The items between the first bracket of [parts] and the next closing one; null if there are no brackets. */
    private fun itemsIn(parts: List<PhrasePart>): Items? {
        val closing =
            parts.firstOrNull { it is PhrasePart.Word && it.span.textIn(program.text) in CLOSING } ?: return null
        val inside = parts.drop(1).takeWhile { it !== closing }
        return Items(inside.filter { it !is PhrasePart.Word }.map { it.span }, closing.span.start)
    }

    /** What is between two brackets, of which the second one stands at [end]. */
    private inner class Items(val items: List<SourceSpan>, private val end: Int) {
        fun added(index: Int, item: String): TextEdit = when {
            items.isEmpty() -> TextEdit(end, "", item)
            index < items.size -> TextEdit(items[index].start, "", "$item, ")
            else -> TextEdit(items.last().end, "", ", $item")
        }

        fun removed(index: Int): TextEdit {
            val start = if (index == 0) items[0].start else items[index - 1].end
            val end = if (index == 0) items.getOrNull(1)?.start ?: items[0].end else items[index].end
            return TextEdit(start, program.text.substring(start, end), "")
        }
    }

    private companion object {
        val CLOSING = setOf(")", "]")
    }
}
