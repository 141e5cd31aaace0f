package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition.AnyOf
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.EndWithin
import robotran.world.GoalCondition.FollowLine
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import kotlin.random.Random

/** Random edits of any world, sensible or not. */
internal class ArbitraryEdits(private val random: Random) {
    fun edit(): WorldEdit = when (random.nextInt(KINDS)) {
        0 -> WorldEdit.TapAt(place(), 2.0, random.nextBoolean())
        1 -> WorldEdit.Select(thing(), random.nextBoolean())
        2 -> WorldEdit.SelectWithin(area(), random.nextBoolean())
        3 -> WorldEdit.SelectAll
        4 -> WorldEdit.SelectNext(random.nextBoolean())
        5 -> WorldEdit.StartDrag(grip(), place())
        6, 7 -> WorldEdit.DragTo(place(), random.nextDouble(3.0))
        8 -> if (random.nextBoolean()) WorldEdit.Drop else WorldEdit.CancelDrag
        9 -> WorldEdit.Draw(List(random.nextInt(5)) { place() })
        10 -> WorldEdit.Nudge(number(), number())
        11 -> WorldEdit.TurnBy(random.nextDouble(-800.0, 800.0))
        12 -> WorldEdit.ScaleBy(random.nextDouble(0.2, 3.0))
        13 -> WorldEdit.Duplicate
        14 -> WorldEdit.Delete
        15 -> if (random.nextBoolean()) WorldEdit.Copy else WorldEdit.Paste(place().takeIf { random.nextBoolean() })
        16 -> if (random.nextBoolean()) WorldEdit.Group else WorldEdit.Ungroup
        17 -> WorldEdit.Align(AlignSide.entries.random(random))
        18 -> WorldEdit.Restack(StackOrder.entries.random(random))
        19, 20 -> WorldEdit.Put(PaletteItem.entries.random(random).piece(SHEET), place())

        21 -> PaletteItem.entries.random(random).piece(SHEET).named(name()).let {
            WorldEdit.Change(ElementRef(it.kind, random.nextInt(4)), it)
        }

        22 -> WorldEdit.MoveCorner(thing(), random.nextInt(-1, 6), place())
        23 -> WorldEdit.AddCorner(thing(), random.nextInt(-1, 6))
        24 -> WorldEdit.RemoveCorner(thing(), random.nextInt(-1, 6))
        25 -> WorldEdit.MakeCorners(thing())
        26 -> WorldEdit.AddGoal(goal(), random.nextInt(5).takeIf { random.nextBoolean() })
        27 -> WorldEdit.MoveGoal(random.nextInt(-1, 6), GoalMove.entries.random(random))
        28 -> WorldEdit.WrapGoal(random.nextInt(-1, 6), GoalGroup.entries.random(random))
        29 -> WorldEdit.UnwrapGoal(random.nextInt(-1, 6))

        30 -> WorldEdit.ChangeSheet(
            SHEET.parameters.copy(title = name().orEmpty(), width = number(), realism = random.nextDouble(1.2)),
        )

        31 -> WorldEdit.SelectTool(Tool.entries.random(random))
        32 -> WorldEdit.SetMultiSelect(random.nextBoolean())

        33 -> WorldEdit.Snap(
            Snapping(listOf(0.0, 0.5, 1.0).random(random), listOf(0.0, 15.0).random(random), random.nextBoolean()),
        )

        34 -> WorldEdit.FinishChange
        35 -> WorldEdit.Batch(List(random.nextInt(3)) { edit() })
        36 -> WorldEdit.Undo
        37 -> WorldEdit.Redo
        else -> if (random.nextInt(10) == 0) WorldEdit.NewWorld("New") else WorldEdit.FinishChange
    }

    private fun thing() = ElementRef(ElementKind.entries.random(random), random.nextInt(-1, 5))

    private fun grip(): DragHandle = when (random.nextInt(6)) {
        0 -> DragHandle.Size(SizeSide.entries.random(random))
        1 -> DragHandle.Turn
        2 -> DragHandle.Corner(random.nextInt(-1, 5))
        3 -> DragHandle.Edge(random.nextInt(-1, 5))
        else -> DragHandle.Body
    }

    private fun goal(): Goal = when (random.nextInt(6)) {
        0 -> Goal(PlaySound(random.nextInt(0, 3)))
        1 -> Goal(FollowLine("loop"))
        2 -> Goal(DrawTemplate())
        3 -> Goal(NeverTouch(who = name()))
        4 -> Goal(InkLength(number(), null))
        else -> Goal(AnyOf(List(random.nextInt(1, 3)) { Goal(EndWithin(random.nextInt(1, 50))) }))
    }

    private fun name() = listOf("a", "b", "loop", "yellow", "", "a\nb", "\uD800", null).random(random)

    private fun place() = Point(number(), number())

    private fun area(): Bounds = place().let {
        Bounds(
            it.x,
            it.y,
            it.x + random.nextDouble(100.0),
            it.y + random.nextDouble(100.0),
        )
    }

    private fun number(): Double = when (random.nextInt(10)) {
        0 -> random.nextDouble(-3000.0, 3000.0)
        1 -> 0.0
        else -> random.nextDouble(-20.0, 140.0)
    }

    private companion object {
        const val KINDS = 39
        val SHEET = newWorld("Sheet")
    }
}
