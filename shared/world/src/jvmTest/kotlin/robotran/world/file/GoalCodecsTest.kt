package robotran.world.file

import robotran.language.Language
import robotran.world.Goal
import robotran.world.GoalCondition
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class GoalCodecsTest {
    private val kinds = GoalCondition::class.java.declaredClasses.filter(
        GoalCondition::class.java::isAssignableFrom,
    ).toSet()

    @Test
    fun `there is a codec for each kind of goal, each with a word of its own`() {
        val world = assertIs<WorldFileResult.Success>(readWorld(FULL_WORLD, Language.ENGLISH)).world
        assertEquals(kinds, world.goals.flatMap(::withParts).map { it.condition.javaClass }.toSet())
        assertEquals(kinds.size, GOAL_CODECS.map { it.kind }.toSet().size)
        assertEquals(kinds.size, GOAL_CODECS.size)
    }

    private fun withParts(goal: Goal): List<Goal> = listOf(goal) + goal.parts.flatMap(::withParts)
}
