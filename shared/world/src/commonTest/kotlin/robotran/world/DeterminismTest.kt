package robotran.world

import kotlinx.coroutines.test.runTest
import robotran.world.physics.loadPhysicsEngine
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** The hashes are recorded: the tests of every target, and those on other versions of the JVM, are held against them. */
class DeterminismTest {
    private val recorded = listOf(
        "807ca6a65c095854", "eed9e8752c65fa02", "9a1bbf67fbd430c0", "bfec833093dc1e54", "e2f0d7dc1818c069",
        "a0d4794e06817a1a", "c5aed09a5139aa4d", "459d9a126c0ae722", "f4dedbd17492665f", "06b1307a39127823",
    )

    @Test
    fun `ten worlds full of things make the same runs on every target`() = runTest(timeout = 10.minutes) {
        assertEquals(
            recorded,
            List(10) { number ->
                val session = HeavyWorlds.session(number)
                session.close()
                session.traceHash
            },
        )
    }

    @Test
    fun `these runs have in them what could go wrong`() = runTest(timeout = 2.minutes) {
        val state = HeavyWorlds.session(0).state
        assertTrue(state.robots.flatMap { it.robot.touched }.toSet() == TouchKind.entries.toSet(), state.robots.map { it.robot.touched }.toString())
        assertTrue(state.blocks.count { it.x != 0.0 } > 3, state.blocks.toString())
        assertTrue(state.ink.lengthCentimetres > 500)
        assertTrue(state.robots.all { it.bumps > 3 })
    }

    @Test
    fun `going back to an earlier time is the same as having been there`() = runTest(timeout = 5.minutes) {
        val session = HeavyWorlds.session(3)
        for (milliseconds in listOf(0L, 13_337L, 30_021L, 45_000L)) {
            val there = Session.replay(session.world, HeavyWorlds.loads(3), loadPhysicsEngine(), session.inputs, milliseconds)
            val straight = Session(session.world, HeavyWorlds.loads(3), loadPhysicsEngine())
            for (input in session.inputs) {
                if (input.milliseconds > milliseconds) break
                straight.advance((input.milliseconds - straight.state.milliseconds).toInt())
                straight.apply(input.input)
            }
            straight.advance((milliseconds - straight.state.milliseconds).toInt())
            assertEquals(straight.traceHash, there.traceHash)
            assertEquals(straight.state.copy(ink = Ink.NONE), there.state.copy(ink = Ink.NONE))
        }
        val again = Session.replay(session.world, HeavyWorlds.loads(3), loadPhysicsEngine(), session.inputs, 60_000)
        assertEquals(session.traceHash, again.traceHash)
    }
}
