package robotran.worldediting

import robotran.editing.rounded
import robotran.json.nearestDecimal
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Shape

/** Replaces [ref] by [wanted], if that is valid; goals follow a changed name. */
internal fun WorldEditing.changed(ref: ElementRef, wanted: Element): Outcome? {
    val before = world.piece(ref) ?: return null
    if (before.kind != wanted.kind) return null
    val piece = wanted.tidied()
    errorOf(piece)?.let { return Outcome.Not(it) }
    val name = piece.name
    if (name != null && world.names().any { (other, taken) -> taken == name && other != ref }) {
        return Outcome.Not(WorldEditError.NameTaken(name))
    }
    val changed = world.with(ref.number, piece)
    val oldName = before.name
    val renamed = if (oldName != null && name != null && name != oldName) {
        changed.withGoalsRenamed(oldName, name)
    } else {
        changed
    }
    return Outcome.Made(snapshot.copy(world = renamed), mergeKey = ref)
}

internal fun WorldEditing.corners(ref: ElementRef, change: (List<Point>) -> List<Point>): Outcome? {
    val piece = world.piece(ref) ?: return null
    val form = piece.form?.takeIf { it.corners.isNotEmpty() } ?: return null
    val corners = change(form.corners)
    val isBent = form is Form.Area || (form is Form.Way && form.isBent)
    if (corners.size < (if (form.isRound) MIN_CORNERS else 2) || (!isBent && corners.size != 2)) {
        return Outcome.Not(WorldEditError.TooFewCorners)
    }
    val changed = piece.withForm(form.withCorners(corners))
    errorOf(changed)?.let { return Outcome.Not(it) }
    return Outcome.Made(snapshot.copy(world = world.with(ref.number, changed)))
}

internal fun WorldEditing.cornerAdded(edit: WorldEdit.AddCorner): Outcome? {
    val form = world.piece(edit.thing)?.form ?: return null
    if (form is Form.Way && !form.isBent) return null
    val (from, to) = form.takeIf { it.corners.isNotEmpty() }?.edges()?.getOrNull(edit.after) ?: return null
    return corners(edit.thing) { it.take(edit.after + 1) + middleOf(from, to) + it.drop(edit.after + 1) }
}

internal fun WorldEditing.cornersMade(ref: ElementRef): Outcome? {
    val piece = world.piece(ref) ?: return null
    val corners = when (val shape = (piece.form as? Form.Area)?.shape) {
        is Shape.Rectangle -> SelectionFrame(shape.centre, shape.width, shape.height, shape.angle).let { frame ->
            listOf(frame.at(-1, -1), frame.at(1, -1), frame.at(1, 1), frame.at(-1, 1))
        }

        is Shape.Circle -> List(CORNERS_OF_CIRCLE) {
            Direction(it * FULL_TURN / CORNERS_OF_CIRCLE).from(shape.centre, shape.radius, 0.0)
        }

        is Shape.Polygon, null -> return null
    }
    val changed = piece.withForm(Form.Area(Shape.Polygon(corners)))
    errorOf(changed)?.let { return Outcome.Not(it) }
    return Outcome.Made(snapshot.copy(world = world.with(ref.number, changed)))
}

/** The element with its numbers rounded as in a file. */
internal fun Element.tidied(): Element {
    val placed = form?.let { withForm(it) } ?: this
    return when (placed) {
        is Element.OfRobot -> with(placed.robot) {
            placed.copy(
                copy(beacon = nearestDecimal(beacon), program = program?.replace("\r\n", "\n")?.replace('\r', '\n')),
            )
        }

        is Element.OfWall -> placed.copy(placed.wall.copy(thickness = rounded(placed.wall.thickness)))

        is Element.OfBlock -> with(placed.block) {
            placed.copy(copy(mass = nearestDecimal(mass), friction = nearestDecimal(friction)))
        }

        is Element.OfLamp -> with(placed.lamp) {
            placed.copy(copy(brightness = nearestDecimal(brightness), cone = nearestDecimal(cone)))
        }

        is Element.OfMark -> placed.copy(placed.mark.tidied())
        is Element.OfGoal -> placed.copy(placed.goal.tidied())
        is Element.OfBarrier, is Element.OfStroke -> placed
    }
}

private const val CORNERS_OF_CIRCLE = 12
private const val FULL_TURN = 360.0
