package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.GoalStatus.FAILED
import robotran.simulation.state.GoalStatus.MET
import robotran.simulation.state.GoalStatus.PENDING
import robotran.world.Goal
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.AnyOf
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.TouchKind
import kotlin.test.Test
import kotlin.test.assertEquals

class GroupGoalTest {
    private val left = Goal(Reach(rectangle(0.0, 0.0, 10.0, 80.0)))
    private val right = Goal(Reach(rectangle(90.0, 0.0, 100.0, 80.0)))

    private fun Run.parts(): List<GoalStatus> = goal.parts.map { it.status }

    @Test
    fun `all of them are wanted in any order`() = runTest {
        val run = run(Goal(All(listOf(left, right))))
        run.robotAt(95.0, 40.0)
        assertEquals(PENDING, run.status)
        run.robotAt(5.0, 40.0)
        assertEquals(MET, run.status)
        assertEquals(1.0, run.goal.progress)
    }

    @Test
    fun `one that failed is enough for all to have failed`() = runTest {
        val run = run(Goal(All(listOf(left, Goal(NeverTouch())))))
        run.touching(TouchKind.WALLS)
        assertEquals(FAILED, run.status)
        run.robotAt(5.0, 40.0)
        assertEquals(listOf(MET, FAILED), run.parts())
        assertEquals(FAILED, run.status)
    }

    @Test
    fun `one is enough and all must fail`() = runTest {
        val run = run(Goal(AnyOf(listOf(left, Goal(NeverTouch())))))
        run.touching(TouchKind.WALLS)
        assertEquals(PENDING, run.status)
        run.robotAt(5.0, 40.0)
        assertEquals(MET, run.status)
        val neither = run(Goal(AnyOf(listOf(left, Goal(NeverTouch())))))
        neither.touching(TouchKind.WALLS)
        neither.finish()
        assertEquals(FAILED, neither.status)
    }

    @Test
    fun `in order the second counts only behind the first`() = runTest {
        val run = run(Goal(InOrder(listOf(left, right))))
        run.robotAt(95.0, 40.0)
        assertEquals(listOf(PENDING, PENDING), run.parts())
        run.robotAt(5.0, 40.0)
        assertEquals(listOf(MET, PENDING), run.parts())
        run.robotAt(50.0, 40.0)
        assertEquals(0.5, run.goal.progress)
        run.robotAt(95.0, 40.0)
        assertEquals(MET, run.status)
    }

    @Test
    fun `whose turn never came has failed`() = runTest {
        val run = run(Goal(InOrder(listOf(left, right, Goal(NeverTouch())))))
        run.robotAt(95.0, 40.0)
        run.finish()
        assertEquals(listOf(FAILED, FAILED, FAILED), run.parts())
    }

    @Test
    fun `what must never happen counts from its turn on and lets the next begin`() = runTest {
        val run = run(Goal(InOrder(listOf(left, Goal(NeverTouch()), right))))
        run.touching(TouchKind.WALLS)
        run.touching()
        run.robotAt(5.0, 40.0)
        run.robotAt(95.0, 40.0)
        assertEquals(listOf(MET, PENDING, MET), run.parts())
        run.finish()
        assertEquals(MET, run.status)
        val touched = run(Goal(InOrder(listOf(left, Goal(NeverTouch()), right))))
        touched.touching(TouchKind.WALLS)
        touched.touching()
        touched.robotAt(5.0, 40.0)
        touched.touching(TouchKind.WALLS)
        assertEquals(FAILED, touched.status)
    }

    @Test
    fun `tones and ink count from their turn on`() = runTest {
        val sound = Goal(PlaySound(2))
        val run = run(Goal(InOrder(listOf(sound, sound))), Goal(InOrder(listOf(left, Goal(InkLength(10.0, null))))))
        run.plays(440.0, 440.0, 440.0)
        assertEquals(listOf(true, false), run.goal.parts.map { it.holds })
        assertEquals(0.5, run.goal.parts[1].progress)
        run.plays(440.0)
        assertEquals(true, run.goal.holds)
        run.draws(0.0 to 0.0, 20.0 to 0.0)
        run.robotAt(5.0, 40.0)
        run.draws(0.0 to 5.0, 9.0 to 5.0)
        assertEquals(PENDING, run.goals[1].status)
        run.draws(0.0 to 6.0, 2.0 to 6.0)
        assertEquals(MET, run.goals[1].status)
    }

    @Test
    fun `a number of tones counts until the next tones have their turn`() = runTest {
        fun order() = arrayOf(Goal(InOrder(listOf(Goal(PlaySound(2)), left, Goal(PlaySound(1))))))
        val run = run(*order())
        run.plays(440.0, 440.0)
        run.robotAt(5.0, 40.0)
        run.plays(440.0)
        run.finish()
        assertEquals(MET, run.status)
        val tooMany = run(*order())
        tooMany.plays(440.0, 440.0)
        tooMany.plays(440.0)
        tooMany.robotAt(5.0, 40.0)
        tooMany.plays(440.0)
        tooMany.finish()
        assertEquals(listOf(FAILED, MET, MET), tooMany.parts())
        val high = Goal(InOrder(listOf(Goal(PlaySound(1, highest = 400)), Goal(PlaySound(1, lowest = 500)))))
        val lowAgain = run(high)
        lowAgain.plays(300.0, 600.0, 300.0)
        assertEquals(FAILED, lowAgain.status, "the low tones are still counted while the high ones are")
    }

    @Test
    fun `what lies in a group is decided at the end if any part is that the group needs`() = runTest {
        val stays = Goal(Reach(rectangle(0.0, 0.0, 10.0, 80.0), stays = true))
        val run =
            run(Goal(All(listOf(stays, right))), Goal(AnyOf(listOf(stays, right))), Goal(InOrder(listOf(stays, right))))
        run.robotAt(5.0, 40.0)
        assertEquals(List(3) { PENDING }, run.goals.map { it.status })
        run.robotAt(95.0, 40.0)
        assertEquals(listOf(PENDING, MET, PENDING), run.goals.map { it.status })
        run.finish()
        assertEquals(listOf(FAILED, MET, FAILED), run.goals.map { it.status })
    }

    @Test
    fun `an ordered group of what must never happen does not make the next goal wait`() = runTest {
        val never = Goal(InOrder(listOf(Goal(NeverTouch()), Goal(NeverTouch()))))
        val run = run(Goal(InOrder(listOf(never, left))))
        run.robotAt(50.0, 40.0)
        run.robotAt(5.0, 40.0)
        run.robotAt(50.0, 40.0)
        assertEquals(listOf(PENDING, MET), run.parts())
        run.finish()
        assertEquals(MET, run.status)
    }

    @Test
    fun `groups lie in groups four deep`() = runTest {
        val somewhere = Goal(AnyOf(listOf(Goal(All(listOf(left))), right)))
        val run = run(Goal(InOrder(listOf(somewhere, Goal(All(listOf(Goal(AnyOf(listOf(Goal(PlaySound())))))))))))
        run.plays(440.0)
        assertEquals(PENDING, run.goal.parts[1].status)
        run.robotAt(95.0, 40.0)
        assertEquals(MET, run.goal.parts[0].status)
        run.plays(440.0)
        assertEquals(MET, run.status)
    }

    @Test
    fun `fifty goals are judged in one go`() = runTest {
        val run = run(*Array(50) { Goal(Reach(rectangle(50.0, 0.0, 50.0 + it, 80.0))) })
        run.robotAt(75.0, 40.0)
        assertEquals(25, run.goals.count { it.status == MET })
    }

    @Test
    fun `once finished nothing changes any more`() = runTest {
        val run = run(left)
        run.finish()
        run.robotAt(5.0, 40.0)
        run.finish()
        assertEquals(FAILED, run.status)
    }
}
