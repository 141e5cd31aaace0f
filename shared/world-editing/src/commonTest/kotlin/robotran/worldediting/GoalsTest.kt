package robotran.worldediting

import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.AnyOf
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.EndWithin
import robotran.world.GoalCondition.FollowLine
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.ShowOnDisplay
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class GoalsTest {
    private val beep = Goal(PlaySound())
    private val end = Goal(EndWithin(20))
    private val two = emptySheet().after(WorldEdit.AddGoal(beep), WorldEdit.AddGoal(end))

    @Test
    fun `goals are added at the end and chosen`() {
        assertEquals(listOf(beep, end), two.world.goals)
        assertEquals(ElementRef(ElementKind.GOAL, 1), two.only)
        two.assertSound()
    }

    @Test
    fun `all thirteen kinds of goal can be in a world`() {
        val sheet = emptySheet().with(PaletteItem.LINE, 80.0, 45.0).with(PaletteItem.TEMPLATE_LINE, 80.0, 20.0)
        val line = ElementRef(ElementKind.MARK, 0)
        val named = sheet.after(WorldEdit.Change(line, checkNotNull(sheet.world.piece(line)).named("loop")))
        val simple = listOf(
            NeverTouch(),
            DrawTemplate(),
            InkLength(10.0, null),
            FollowLine("loop"),
            EndWithin(9),
            ShowOnDisplay("HI"),
            PlaySound(),
            InOrder(listOf(beep, end)),
            All(listOf(beep)),
            AnyOf(listOf(beep)),
        ).map { Goal(it) }
        val all = simple.fold(named) { now, goal -> now.after(WorldEdit.AddGoal(goal)) }
            .with(PaletteItem.GOAL_AREA, 20.0, 20.0).with(PaletteItem.FORBIDDEN_AREA, 60.0, 20.0)
            .with(PaletteItem.PERMITTED_AREA, 60.0, 45.0)
        assertEquals(13, all.world.goals.map { it.condition::class }.toSet().size)
        all.assertSound()
    }

    @Test
    fun `a goal can go up and down, into a group and out of it`() {
        assertEquals(listOf(end, beep), two.after(WorldEdit.MoveGoal(1, GoalMove.UP)).world.goals)
        assertEquals(listOf(end, beep), two.after(WorldEdit.MoveGoal(0, GoalMove.DOWN)).world.goals)
        val wrapped = two.after(WorldEdit.WrapGoal(0, GoalGroup.IN_ORDER))
        assertEquals(listOf(Goal(InOrder(listOf(beep))), end), wrapped.world.goals)
        assertEquals(ElementRef(ElementKind.GOAL, 2), wrapped.only)
        val inside = wrapped.after(WorldEdit.MoveGoal(2, GoalMove.IN))
        assertEquals(listOf<Goal>(Goal(InOrder(listOf(beep, end)))), inside.world.goals)
        val out = inside.after(WorldEdit.MoveGoal(1, GoalMove.OUT))
        assertEquals(listOf(Goal(InOrder(listOf(end))), beep), out.world.goals)
        assertEquals(listOf(end, beep), out.after(WorldEdit.UnwrapGoal(0)).world.goals)
        assertEquals(two.world, two.after(WorldEdit.MoveGoal(0, GoalMove.OUT)).world)
    }

    @Test
    fun `a group goes with its last goal`() {
        val wrapped = two.after(
            WorldEdit.WrapGoal(0, GoalGroup.ANY_OF),
            WorldEdit.Select(ElementRef(ElementKind.GOAL, 1)),
            WorldEdit.Delete,
        )
        assertEquals(listOf<Goal>(end), wrapped.world.goals)
    }

    @Test
    fun `goals lie at most four deep`() {
        val deep = (1..3).fold(emptySheet().after(WorldEdit.AddGoal(beep))) { now, _ ->
            now.after(WorldEdit.WrapGoal(0, GoalGroup.ALL))
        }
        deep.assertSound()
        assertEquals(WorldEditError.TooDeep, deep.after(WorldEdit.WrapGoal(0, GoalGroup.ALL)).error)
    }

    @Test
    fun `goals that are the same are still two`() {
        val twice = emptySheet().after(
            WorldEdit.AddGoal(beep),
            WorldEdit.AddGoal(beep),
            WorldEdit.MoveGoal(0, GoalMove.DOWN),
        )
        assertEquals(listOf(beep, beep), twice.world.goals)
        assertEquals(
            1,
            twice.after(WorldEdit.Select(ElementRef(ElementKind.GOAL, 1)), WorldEdit.Delete).world.goals.size,
        )
    }

    @Test
    fun `a goal that needs a line or a drawing is not added without one`() {
        assertEquals(WorldEditError.NeedsLine, emptySheet().after(WorldEdit.AddGoal(Goal(FollowLine("loop")))).error)
        assertEquals(WorldEditError.NeedsTemplate, emptySheet().after(WorldEdit.AddGoal(Goal(DrawTemplate()))).error)
    }

    @Test
    fun `a goal follows the name of its block and says so when the block is gone`() {
        val block = emptySheet().with(PaletteItem.BLOCK, 80.0, 45.0)
        val thing = ElementRef(ElementKind.BLOCK, 0)
        val box = block.after(WorldEdit.Change(thing, block.chosenPiece.named("box")))
        val reach = (PaletteItem.GOAL_AREA.piece(box.world) as Element.OfGoal).goal.withWho("box")
        val goal = box.after(
            WorldEdit.AddGoal(reach),
            WorldEdit.Change(thing, checkNotNull(box.world.piece(thing)).named("crate")),
        )
        assertEquals("crate", goal.world.goals.single().who)
        goal.assertSound()
        val gone = goal.after(WorldEdit.Select(thing), WorldEdit.Delete)
        assertEquals(
            listOf<ValidationError>(ValidationError.MissingActor(ElementRef(ElementKind.GOAL, 0), "crate")),
            gone.errors,
        )
        gone.after(WorldEdit.Undo).assertSound()
    }

    @Test
    fun `figures of goals keep to what a world can have`() {
        val thing = ElementRef(ElementKind.GOAL, 1)
        assertEquals(
            WorldEditError.OutOfRange,
            two.after(WorldEdit.Change(thing, Element.OfGoal(Goal(EndWithin(0))))).error,
        )
        assertEquals(
            WorldEditError.InvalidText,
            two.after(WorldEdit.Change(thing, Element.OfGoal(end.copy(says = " ")))).error,
        )
        val soon = Goal(EndWithin(7))
        assertTrue(two.after(WorldEdit.Change(thing, Element.OfGoal(soon))).world.goals[1] == soon)
    }

    @Test
    fun `a goal where the robot starts is met at the start unless it is to be there at the end or after others`() {
        val over = Reach(Shape.Rectangle(Point(30.0, 45.0), 20.0, 20.0))
        val goal = { condition: GoalCondition -> emptySheet().after(WorldEdit.AddGoal(Goal(condition))).world }
        assertEquals(listOf(ElementRef(ElementKind.GOAL, 0)), goalsMetAtStart(goal(over)))
        val small = Reach(Shape.Circle(Point(30.0, 45.0), 3.0), whole = true)
        assertEquals(emptyList(), goalsMetAtStart(goal(small)), "A part of the robot is outside.")
        assertEquals(emptyList(), goalsMetAtStart(goal(over.copy(stays = true))))
        assertEquals(emptyList(), goalsMetAtStart(goal(InOrder(listOf(Goal(over))))))
        assertEquals(emptyList(), goalsMetAtStart(goal(Reach(Shape.Rectangle(Point(80.0, 45.0), 20.0, 20.0)))))
    }
}
