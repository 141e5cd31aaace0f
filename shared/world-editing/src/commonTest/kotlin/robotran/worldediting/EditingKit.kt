package robotran.worldediting

import robotran.language.Language
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.file.writeWorld
import robotran.world.geometry.Point
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A new sheet of 120 by 90 cm with the robot at 30, 45. */
internal fun emptySheet() = WorldEditing.of(newWorld("Test"))

internal fun WorldEditing.after(vararg edits: WorldEdit): WorldEditing = edits.fold(this) { now, edit ->
    now.after(edit)
}

/** Adds and selects a new [item] with its centre at [x], [y]. */
internal fun WorldEditing.with(item: PaletteItem, x: Double, y: Double): WorldEditing {
    val put = after(WorldEdit.Snap(Snapping(0.0, 0.0, toOthers = false)), WorldEdit.Put(item.piece(world), Point(x, y)))
    return put.after(WorldEdit.Snap(Snapping()))
}

/** Drags the selection by [grip] from [from] to [to]. */
internal fun WorldEditing.drag(grip: DragHandle, from: Point, to: Point): WorldEditing =
    after(WorldEdit.StartDrag(grip, from), WorldEdit.DragTo(to, REACH), WorldEdit.Drop)

internal fun WorldEditing.handle(grip: DragHandle): Point = world.handlesOf(selection).first { it.grip == grip }.place

internal val WorldEditing.chosenPiece: Element get() = checkNotNull(world.piece(checkNotNull(only)))

internal val WorldEditing.chosenForm: Form get() = checkNotNull(chosenPiece.form)

/** Checks that the world can be saved. */
internal fun WorldEditing.assertSound() {
    assertEquals(emptyList(), errors)
    assertEquals(WorldFileResult.Success(world), readWorld(writeWorld(world), Language.ENGLISH))
}

internal fun assertNear(expected: Point, actual: Point) = assertTrue(
    robotran.world.geometry.length(expected.x - actual.x, expected.y - actual.y) < 0.01,
    "$actual is not $expected",
)

internal const val REACH = 1.5
