package robotran.worldediting

import robotran.editing.dropped
import robotran.editing.letGo
import robotran.editing.redone
import robotran.editing.undone
import robotran.world.World

/**
 * The state after [edit]. An invalid edit leaves the world unchanged and sets [WorldEditing.error]. An edit of a
 * missing element does nothing.
 */
fun WorldEditing.after(edit: WorldEdit): WorldEditing {
    val calm = copy(error = null)
    return when (edit) {
        is WorldEdit.TapAt,
        is WorldEdit.Select,
        is WorldEdit.SelectWithin,
        WorldEdit.SelectAll,
        is WorldEdit.SelectNext,
        -> calm.chosen(edit)

        is WorldEdit.StartDrag -> calm.grabbed(edit)
        is WorldEdit.DragTo -> calm.dragged(edit)
        WorldEdit.Drop -> calm.dropped()
        WorldEdit.CancelDrag -> calm.letGo()

        is WorldEdit.SelectTool -> calm.copy(
            tool = edit.tool,
            selection = if (edit.tool == Tool.SELECT) selection else emptySet(),
        )

        is WorldEdit.SetMultiSelect -> calm.copy(isMultiSelect = edit.isMultiSelect)
        is WorldEdit.Snap -> calm.copy(snapping = edit.snapping)
        WorldEdit.FinishChange -> calm.copy(history = history.mergeEnded())
        is WorldEdit.Batch -> calm.together(edit.edits)
        WorldEdit.Undo -> calm.undone()
        WorldEdit.Redo -> calm.redone()
        WorldEdit.Copy -> if (selection.isEmpty()) calm else calm.copy(clipboard = selection.mapNotNull(world::piece))

        is WorldEdit.Draw,
        is WorldEdit.Nudge,
        is WorldEdit.TurnBy,
        is WorldEdit.ScaleBy,
        WorldEdit.Duplicate,
        WorldEdit.Delete,
        is WorldEdit.Paste,
        WorldEdit.Group,
        WorldEdit.Ungroup,
        is WorldEdit.Align,
        is WorldEdit.Restack,
        is WorldEdit.Put,
        is WorldEdit.Change,
        is WorldEdit.MoveCorner,
        is WorldEdit.AddCorner,
        is WorldEdit.RemoveCorner,
        is WorldEdit.MakeCorners,
        is WorldEdit.AddGoal,
        is WorldEdit.MoveGoal,
        is WorldEdit.WrapGoal,
        is WorldEdit.UnwrapGoal,
        is WorldEdit.ChangeSheet,
        is WorldEdit.NewWorld,
        -> calm.dropped().changed(edit)
    }
}

/** The result of a change. */
internal sealed interface Outcome {
    class Made(val snapshot: WorldSnapshot, val mergeKey: Any? = null) : Outcome

    class Not(val error: WorldEditError) : Outcome
}

private fun WorldEditing.changed(edit: WorldEdit): WorldEditing = when (val outcome = outcomeOf(edit)) {
    null -> this
    is Outcome.Not -> copy(error = outcome.error)
    is Outcome.Made -> made(snapshot, outcome.snapshot, outcome.mergeKey)
}

/** The state with [after] instead of [before], unless [after] is invalid. */
internal fun WorldEditing.made(before: WorldSnapshot, after: WorldSnapshot, mergeKey: Any? = null): WorldEditing {
    if (after == before) return this
    val error = if (after.world == before.world) null else errorOf(after.world)
    if (error != null) return copy(error = error)
    val isSameWorld = after.world == before.world && after.groups == before.groups
    return copy(
        world = after.world,
        selection = after.selection,
        groups = after.groups.filter { it.size > 1 },
        history = if (isSameWorld) history else history.recorded(before, mergeKey),
        errors = if (after.world == world) errors else validationErrorsOf(after.world),
    )
}

private fun WorldEditing.together(edits: List<WorldEdit>): WorldEditing {
    val begun = dropped()
    val done = edits.fold(begun) { now, edit -> if (now.error != null) now else now.after(edit) }
    if (done.error != null) return copy(error = done.error)
    val isSameWorld = done.world == begun.world && done.groups == begun.groups
    return done.copy(history = if (isSameWorld) begun.history else begun.history.recorded(begun.snapshot))
}

/**
 * The references to [things] after the goals' order has changed from [before] to [after]; goals keep their identity.
 */
internal fun renumbered(things: Set<ElementRef>, before: World, after: World): Set<ElementRef> {
    if (things.none { it.kind == ElementKind.GOAL }) return things
    val old = allGoals(before.goals)
    val new = allGoals(after.goals)
    return things.mapNotNull { thing ->
        if (thing.kind != ElementKind.GOAL) return@mapNotNull thing
        val goal = old.getOrNull(thing.number)?.goal
        new.indexOfFirst { it.goal === goal }.takeIf { it >= 0 }?.let { ElementRef(ElementKind.GOAL, it) }
    }.toSet()
}
