package robotran.worldediting

import robotran.language.history.History
import robotran.world.World

/**
 * The state after [edit]. An invalid edit leaves the world unchanged and sets [WorldEditing.error]. An edit of a
 * missing element does nothing.
 */
fun WorldEditing.after(edit: Edit): WorldEditing {
    val calm = copy(error = null)
    return when (edit) {
        is Edit.TapAt, is Edit.Select, is Edit.SelectWithin, Edit.SelectAll, is Edit.SelectNext -> calm.chosen(edit)
        is Edit.StartDrag -> calm.grabbed(edit)
        is Edit.DragTo -> calm.dragged(edit)
        Edit.Drop -> calm.dropped()
        Edit.CancelDrag -> calm.letGo()

        is Edit.SelectTool -> calm.copy(
            tool = edit.tool,
            selection = if (edit.tool == Tool.SELECT) selection else emptySet(),
        )

        is Edit.SelectSeveral -> calm.copy(several = edit.several)
        is Edit.Snap -> calm.copy(snapping = edit.snapping)
        Edit.FinishChange -> calm.copy(history = history.mergeEnded())
        is Edit.Batch -> calm.together(edit.edits)
        Edit.Undo -> calm.undone()
        Edit.Redo -> calm.redone()
        Edit.Copy -> if (selection.isEmpty()) calm else calm.copy(clipboard = selection.mapNotNull(world::piece))

        is Edit.Draw,
        is Edit.Nudge,
        is Edit.TurnBy,
        is Edit.ScaleBy,
        Edit.Duplicate,
        Edit.Delete,
        is Edit.Paste,
        Edit.Group,
        Edit.Ungroup,
        is Edit.Align,
        is Edit.Restack,
        is Edit.Put,
        is Edit.Change,
        is Edit.MoveCorner,
        is Edit.AddCorner,
        is Edit.RemoveCorner,
        is Edit.MakeCorners,
        is Edit.AddGoal,
        is Edit.MoveGoal,
        is Edit.WrapGoal,
        is Edit.UnwrapGoal,
        is Edit.ChangeSheet,
        is Edit.NewWorld,
        -> calm.dropped().changed(edit)
    }
}

/** The result of a change. */
internal sealed interface Outcome {
    class Made(val snapshot: WorldSnapshot, val mergeKey: Any? = null) : Outcome

    class Not(val error: EditError) : Outcome
}

private fun WorldEditing.changed(edit: Edit): WorldEditing = when (val outcome = outcomeOf(edit)) {
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

private fun WorldEditing.together(edits: List<Edit>): WorldEditing {
    val begun = dropped()
    val done = edits.fold(begun) { now, edit -> if (now.error != null) now else now.after(edit) }
    if (done.error != null) return copy(error = done.error)
    val isSameWorld = done.world == begun.world && done.groups == begun.groups
    return done.copy(history = if (isSameWorld) begun.history else begun.history.recorded(begun.snapshot))
}

private fun WorldEditing.undone(): WorldEditing {
    if (gesture != null) return letGo()
    val (before, rest) = history.undone { snapshot } ?: return this
    return back(before, rest)
}

private fun WorldEditing.redone(): WorldEditing {
    val (next, rest) = history.redone { snapshot } ?: return this
    return letGo().back(next, rest)
}

internal fun WorldEditing.back(to: WorldSnapshot, history: History<WorldSnapshot>): WorldEditing = copy(
    world = to.world,
    selection = to.selection,
    groups = to.groups,
    history = history,
    gesture = null,
    guides = emptyList(),
    errors = validationErrorsOf(to.world),
)

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
