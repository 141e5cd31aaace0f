package robotran.worldediting

import robotran.editing.Field
import robotran.editing.ungrouped
import robotran.json.nearestDecimal
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.PlaySound
import robotran.world.HasTimeLimit
import robotran.world.World
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertNull

class GoalFieldsTest {
    private val kinds = GoalCondition::class.java.declaredClasses.filter(
        GoalCondition::class.java::isAssignableFrom,
    ).toSet()
    private val conditions = newGoals(emptySheet().world).map { it.condition }

    @Test
    fun `there is a new goal of each kind, and a world can have it`() {
        assertEquals(kinds, conditions.map { it.javaClass }.toSet())
        assertEquals(kinds.size, conditions.size)
        for (condition in conditions) assertNull(errorOf(Goal(condition)), "$condition")
    }

    @Test
    fun `each figure of each kind has a tag of its own`() {
        for (condition in conditions) {
            val tags = fieldsOf(condition).ungrouped().map { it.tag }
            assertEquals(tags.distinct(), tags, "$condition")
        }
    }

    @Test
    fun `a number beyond its limits is refused, and one at its limits is not`() {
        for (condition in conditions) {
            for (field in fieldsOf(condition).filterIsInstance<Field.Number<GoalCondition>>()) {
                val (lowest, highest) = field.spec.range.run { start to endInclusive }
                assertEquals(
                    listOf(null, null),
                    listOf(lowest, highest).map {
                        errorOf(Goal(checkNotNull(field.with(it))))
                    },
                    "$condition",
                )
                val beyond = listOf(lowest - 1, highest + 1).map { errorOf(Goal(checkNotNull(field.with(it)))) }
                assertEquals(
                    listOf<WorldEditError?>(WorldEditError.OutOfRange, WorldEditError.OutOfRange),
                    beyond,
                    "$condition",
                )
            }
        }
    }

    @Test
    fun `a number that is turned on begins as one that a world can have`() {
        val bounds =
            listOf(InkLength(5.0, null), InkLength(null, 5.0), PlaySound(lowest = 9000), PlaySound(highest = 50))
        for (condition in conditions + bounds) {
            for (field in fieldsOf(condition).filterIsInstance<Field.OptionalNumber<GoalCondition>>()) {
                assertNull(errorOf(Goal(checkNotNull(field.switch.with(true)))), "${field.tag} of $condition")
            }
        }
    }

    @Test
    fun `bounds must be in order, and a length needs one`() {
        val wrong = listOf(InkLength(9.0, 8.0), InkLength(null, null), PlaySound(lowest = 500, highest = 400))
        for (condition in wrong) assertEquals(WorldEditError.OutOfRange, errorOf(Goal(condition)), "$condition")
    }

    @Test
    fun `the time limit of the world is what a goal begins with`() {
        val world = emptySheet().world.copy(timeLimit = World.DEFAULT_TIME_LIMIT + 7)
        for (condition in conditions) {
            val within = fieldsOf(condition, world.timeLimit).find { it.tag == "field-within" } as? Field.OptionalNumber
            val begun = within?.switch?.with(true) as? HasTimeLimit
            if (within != null) assertEquals(world.timeLimit, begun?.within)
        }
    }

    @Test
    fun `all decimals are rounded to what a file keeps`() {
        val fine = 1.0 / 3
        val tidied = Goal(DrawTemplate(fine, fine, fine), says = "Trace it.").tidied()
        val draw = tidied.condition as DrawTemplate
        assertEquals(List(3) { nearestDecimal(fine) }, listOf(draw.tolerance, draw.coverage, draw.excess))
        assertNotEquals(fine, draw.coverage)
        assertEquals(tidied, tidied.tidied())
        assertEquals("Trace it.", tidied.says)
    }
}
