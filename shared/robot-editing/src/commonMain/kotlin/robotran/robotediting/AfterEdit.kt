package robotran.robotediting

import robotran.editing.Gesture
import robotran.editing.dropped
import robotran.editing.letGo
import robotran.editing.redone
import robotran.editing.undone
import robotran.language.history.History
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.geometry.Point
import robotran.world.robot.robotErrors
import robotran.world.robot.things

/** The state after [edit]. A refused edit leaves the robot unchanged and sets [RobotEditing.error]. */
fun RobotEditing.after(edit: RobotEdit): RobotEditing {
    val isMeasuring = edit is RobotEdit.Measure || edit == RobotEdit.FinishChange
    val calm = copy(error = null, measured = measured.takeIf { isMeasuring })
    return when (edit) {
        is RobotEdit.Choose -> calm.dropped().copy(chosen = edit.element?.takeIf { robot.has(it) })
        is RobotEdit.ChooseNext -> calm.dropped().nextChosen(edit.backwards)
        is RobotEdit.StartDrag -> calm.dropped().taken(edit)
        is RobotEdit.DragTo -> calm.draggedTo(edit.at)
        RobotEdit.Drop -> calm.dropped()
        RobotEdit.CancelDrag -> calm.letGo()
        RobotEdit.FinishChange -> calm.copy(history = history.mergeEnded())
        RobotEdit.Undo -> calm.undone()
        RobotEdit.Redo -> calm.redone()
        is RobotEdit.Nudge,
        is RobotEdit.TurnBy,
        RobotEdit.Remove,
        is RobotEdit.SetPort,
        RobotEdit.AddCorner,
        is RobotEdit.Add,
        is RobotEdit.Change,
        is RobotEdit.Replace,
        -> calm.dropped().changed(edit)

        is RobotEdit.Measure -> calm.dropped().changed(edit).copy(measured = edit.measured)
    }
}

/** The result of a change. */
internal sealed interface Outcome {
    /**
     * @property mergeKey the ongoing change that this one belongs to, see [History.mergeKey].
     * @property isRead whether the robot is from a file, whose figures are in their ranges.
     */
    class Made(
        val robot: RobotDescription,
        val chosen: RobotElement?,
        val mergeKey: Any? = null,
        val isRead: Boolean = false,
    ) : Outcome

    class Refused(val error: RobotEditError) : Outcome
}

private fun RobotEditing.changed(edit: RobotEdit): RobotEditing = when (val outcome = outcomeOf(edit)) {
    null -> this
    is Outcome.Refused -> copy(error = outcome.error)
    is Outcome.Made -> made(snapshot, outcome)
}

private fun RobotEditing.outcomeOf(edit: RobotEdit): Outcome? = when (edit) {
    is RobotEdit.Add -> robot.added(edit.item, edit.at)
    is RobotEdit.Change -> Outcome.Made(edit.robot, chosen, edit.what)
    is RobotEdit.Measure -> Outcome.Made(robot.copy(drive = edit.measured.drive), chosen, "measured")
    is RobotEdit.Replace -> Outcome.Made(edit.robot, null, isRead = true)
    is RobotEdit.Nudge -> chosen?.let { moved(robot.moved(it, edit.x, edit.y)) }
    is RobotEdit.TurnBy -> chosen?.let { moved(robot.turned(it, edit.degrees)) }
    is RobotEdit.SetPort -> (chosen as? RobotElement.Part)?.let { plugged(it.number, edit.port) }
    RobotEdit.AddCorner -> cornerAdded()
    RobotEdit.Remove -> chosen?.let { removed(it) }
    else -> null
}

private fun RobotEditing.moved(robot: RobotDescription?): Outcome? = robot?.let { Outcome.Made(it, chosen) }

/** Leaves one cable. */
private fun RobotEditing.plugged(number: Int, port: Int?): Outcome? {
    val thing = robot.things.getOrNull(number)?.on(null) ?: return null
    val first = robot.parts.indexOfFirst { it.on(null) == thing }
    val parts = robot.parts.mapIndexedNotNull { index, part ->
        when {
            index == first -> part.on(port)
            part.on(null) == thing -> null
            else -> part
        }
    }
    return Outcome.Made(robot.copy(parts = parts), chosen)
}

private fun RobotEditing.cornerAdded(): Outcome? {
    val outline = robot.chassis.outline
    val number = (chosen as? RobotElement.Corner)?.number ?: return null
    if (outline.size >= RobotLimits.CORNERS.last) return Outcome.Refused(RobotEditError.TOO_MANY_CORNERS)
    val corner = outline[number]
    val next = outline[(number + 1) % outline.size]
    val middle = Point((corner.x + next.x) / 2, (corner.y + next.y) / 2)
    val corners = outline.take(number + 1) + middle + outline.drop(number + 1)
    return Outcome.Made(robot.withOutline(corners), RobotElement.Corner(number + 1))
}

private fun RobotEditing.removed(element: RobotElement): Outcome = when (element) {
    is RobotElement.Part -> {
        val thing = robot.things[element.number].on(null)
        Outcome.Made(robot.copy(parts = robot.parts.filter { it.on(null) != thing }), null)
    }

    is RobotElement.Caster -> {
        Outcome.Made(robot.copy(casters = robot.casters.filterIndexed { number, _ -> number != element.number }), null)
    }

    is RobotElement.Corner -> {
        val left = robot.chassis.outline.filterIndexed { number, _ -> number != element.number }
        if (left.size < RobotLimits.CORNERS.first) {
            Outcome.Refused(RobotEditError.TOO_FEW_CORNERS)
        } else {
            Outcome.Made(robot.withOutline(left), RobotElement.Chassis)
        }
    }

    RobotElement.Pen -> Outcome.Made(robot.copy(pen = null), null)

    RobotElement.Wheels, RobotElement.Brick, RobotElement.Mass, RobotElement.Chassis -> {
        Outcome.Refused(RobotEditError.NEEDED)
    }
}

private fun RobotDescription.withOutline(corners: List<Point>) = copy(chassis = chassis.copy(outline = corners))

private fun RobotEditing.made(before: RobotSnapshot, made: Outcome.Made): RobotEditing {
    val kept = if (made.isRead) made.robot else made.robot.inRange(before.robot)
    val left = made.chosen?.takeIf { kept.has(it) }
    if (kept == before.robot) return copy(chosen = left)
    return copy(
        robot = kept,
        chosen = left,
        history = history.recorded(before, made.mergeKey),
        errors = robotErrors(kept),
    )
}

private fun RobotEditing.nextChosen(backwards: Boolean): RobotEditing {
    val all = robot.elements()
    val now = all.indexOf(if (chosen is RobotElement.Corner) RobotElement.Chassis else chosen)
    val next = when {
        now < 0 -> if (backwards) all.last() else all.first()
        else -> all[(now + if (backwards) all.size - 1 else 1) % all.size]
    }
    return copy(chosen = next)
}

private fun RobotEditing.taken(edit: RobotEdit.StartDrag) = copy(gesture = Gesture(edit.handle, edit.at, snapshot))

private fun RobotEditing.draggedTo(at: Point): RobotEditing {
    val gesture = gesture ?: return this
    val dragged = gesture.dragged(at)?.inRange(gesture.before.robot) ?: return this
    return if (dragged == robot) this else copy(robot = dragged, errors = robotErrors(dragged))
}
