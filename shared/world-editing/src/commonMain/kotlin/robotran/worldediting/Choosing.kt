package robotran.worldediting

internal fun WorldEditing.chosen(edit: WorldEdit): WorldEditing = when (edit) {
    is WorldEdit.TapAt -> tapped(edit)

    is WorldEdit.Select -> {
        when {
            edit.thing == null -> if (edit.adding) this else copy(selection = emptySet())
            world.piece(edit.thing) == null -> this
            else -> choosing(setOf(edit.thing), edit.adding)
        }
    }

    is WorldEdit.SelectWithin -> {
        val before = if (edit.adding) selection else emptySet()
        copy(selection = before + withGroups(world.elementsWithin(edit.area), groups))
    }

    WorldEdit.SelectAll -> copy(selection = world.listed().filter { world.piece(it)?.form != null }.toSet())
    is WorldEdit.SelectNext -> next(edit.backwards)
    else -> this
}

private fun WorldEditing.tapped(edit: WorldEdit.TapAt): WorldEditing {
    val there = world.elementsAt(edit.place, edit.reach)
    val adding = edit.adding || isMultiSelect
    if (there.isEmpty()) return if (adding) this else copy(selection = emptySet())
    if (adding) return choosing(setOf(there.first()), adding = true)
    val chosen = there.indexOf(only)
    return choosing(setOf(there[(chosen + 1) % there.size]), adding = false)
}

/** When adding to the selection, an element that is already selected becomes unselected. */
private fun WorldEditing.choosing(things: Set<ElementRef>, adding: Boolean): WorldEditing {
    val whole = withGroups(things, groups)
    return copy(
        selection = when {
            !adding -> whole
            selection.containsAll(whole) -> selection - whole
            else -> selection + whole
        },
    )
}

private fun WorldEditing.next(backwards: Boolean): WorldEditing {
    val all = world.listed()
    val ordered = if (backwards) all.asReversed() else all
    val last = ordered.indexOfLast { it in selection }
    return choosing(setOf(ordered[(last + 1) % ordered.size]), adding = false)
}
