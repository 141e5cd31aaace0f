package robotran.worldediting

import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/** The result of [edit]; null if there is nothing to do. */
internal fun WorldEditing.outcomeOf(edit: WorldEdit): Outcome? = when (edit) {
    is WorldEdit.Draw -> drawn(edit.points)
    is WorldEdit.Nudge -> each { it.movedBy(edit.x, edit.y) }
    is WorldEdit.TurnBy -> middleOfSelection()?.let { middle -> each { it.rotatedBy(edit.degrees, middle) } }
    is WorldEdit.ScaleBy -> middleOfSelection()?.let { middle -> each { it.scaledBy(edit.factor, middle) } }
    WorldEdit.Duplicate -> added(selection.mapNotNull(world::piece), Point(STEP_ASIDE, -STEP_ASIDE))
    WorldEdit.Delete -> deleted()
    is WorldEdit.Paste -> pasted(edit.at)
    WorldEdit.Group -> grouped()
    WorldEdit.Ungroup -> Outcome.Made(snapshot.copy(groups = groups.filter { group -> group.none { it in selection } }))
    is WorldEdit.Align -> aligned(edit.side)
    is WorldEdit.Restack -> restacked(edit.order)
    is WorldEdit.Put -> put(edit.piece, edit.at, edit.inSight)
    is WorldEdit.Change -> changed(edit.thing, edit.piece)
    is WorldEdit.MoveCorner -> corners(edit.thing) { it.with(edit.number, edit.to) }
    is WorldEdit.AddCorner -> cornerAdded(edit)

    is WorldEdit.RemoveCorner -> corners(edit.thing) { corners ->
        corners.filterIndexed { number, _ ->
            number != edit.number
        }
    }

    is WorldEdit.MakeCorners -> cornersMade(edit.thing)
    is WorldEdit.AddGoal -> goalAdded(edit)
    is WorldEdit.MoveGoal -> goals(movedGoal(world.goals, edit.number, edit.move))
    is WorldEdit.WrapGoal -> goals(world.goals.wrapped(edit.number, edit.group))
    is WorldEdit.UnwrapGoal -> goals(world.goals.unwrapped(edit.number))
    is WorldEdit.ChangeSheet -> Outcome.Made(snapshot.copy(world = world.with(edit.parameters)), mergeKey = "sheet")
    is WorldEdit.NewWorld -> Outcome.Made(WorldSnapshot(newWorld(edit.title), emptySet(), emptyList()))
    else -> null
}

/** An empty sheet with only the pupil's robot. */
fun newWorld(title: String) = World(
    title,
    Paper(NEW_WIDTH, NEW_HEIGHT),
    listOf(
        RobotPlacement(
            Pose(
                NEW_WIDTH / 4,
                NEW_HEIGHT / 2,
                0.0,
            ),
        ),
    ),
)

/** Changes each selected element. */
private fun WorldEditing.each(change: (Form) -> Form): Outcome? {
    if (selection.isEmpty()) return null
    var now = world
    for (thing in selection) {
        val piece = world.piece(thing) ?: continue
        val changed = piece.form?.let { piece.withForm(change(it)) } ?: continue
        errorOf(changed)?.let { return Outcome.Not(it) }
        now = now.with(thing.number, changed)
    }
    return Outcome.Made(snapshot.copy(world = now))
}

private fun WorldEditing.middleOfSelection(): Point? =
    only?.let { world.piece(it)?.form?.middle } ?: world.frameOf(selection)?.centre

private fun WorldEditing.deleted(): Outcome? {
    if (selection.isEmpty()) return null
    val robots = selection.count { it.kind == ElementKind.ROBOT }
    if (robots == world.robots.size) return Outcome.Not(WorldEditError.LastRobot)
    val left = world.without(selection)
    val kept = groups.map { group -> renumbered((group - selection).map(::numberLeft).toSet(), world, left) }
    return Outcome.Made(WorldSnapshot(left, emptySet(), kept))
}

/** The new reference of an element when the selected ones are deleted; goals are handled elsewhere. */
private fun WorldEditing.numberLeft(ref: ElementRef): ElementRef = if (ref.kind == ElementKind.GOAL) {
    ref
} else {
    ref.copy(number = ref.number - selection.count { it.kind == ref.kind && it.number < ref.number })
}

private fun WorldEditing.grouped(): Outcome? {
    val placed = selection.filter { world.piece(it)?.form != null }.toSet()
    if (placed.size < 2) return null
    return Outcome.Made(snapshot.copy(groups = groups.map { it - placed }.filter { it.size > 1 } + listOf(placed)))
}

private fun WorldEditing.restacked(order: StackOrder): Outcome? {
    val chosen = selection.filter { it.kind == ElementKind.MARK }.map { it.number }.toSet()
    if (chosen.isEmpty()) return null
    val places = restackedOrder(world.marks.size, chosen, order)
    val marks = places.map { world.marks[it] }

    fun moved(things: Set<ElementRef>) =
        things.map { if (it.kind == ElementKind.MARK) it.copy(number = places.indexOf(it.number)) else it }.toSet()
    return Outcome.Made(WorldSnapshot(world.copy(marks = marks), moved(selection), groups.map(::moved)))
}

/** The old indices, from the bottom up. */
private fun restackedOrder(count: Int, chosen: Set<Int>, order: StackOrder): List<Int> {
    val all = (0..<count).toMutableList()
    return when (order) {
        StackOrder.TO_BACK -> all.filter { it in chosen } + all.filter { it !in chosen }
        StackOrder.TO_FRONT -> all.filter { it !in chosen } + all.filter { it in chosen }

        StackOrder.FORWARD -> {
            for (place in count - 2 downTo 0) if (all[place] in chosen && all[place + 1] !in chosen) all.swap(place)
            all
        }

        StackOrder.BACK -> {
            for (place in 0..<count - 1) if (all[place + 1] in chosen && all[place] !in chosen) all.swap(place)
            all
        }
    }
}

private fun MutableList<Int>.swap(index: Int) {
    val item = this[index]
    this[index] = this[index + 1]
    this[index + 1] = item
}

/** Offset of a copy from its original, in centimetres. */
internal const val STEP_ASIDE = 3.0

/** A sheet of wrapping paper on a classroom table. */
private const val NEW_WIDTH = 120.0
private const val NEW_HEIGHT = 90.0
