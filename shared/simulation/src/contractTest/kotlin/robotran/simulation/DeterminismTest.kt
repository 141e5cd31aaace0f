package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.Ink
import robotran.world.TouchKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** Compares hashes with recorded ones on every target, and on other versions of the JVM. */
class DeterminismTest {
    private val recorded = listOf(
        "4f28f72b2a69b7d1",
        "da5034055078e126",
        "3629ef8444b03da2",
        "1775da185aa63064",
        "6e09b2ebd6dd0713",
        "6071fb56dcaeb42e",
        "379f44025a434e55",
        "ac3c9b0b26a9989f",
        "0c1570917c702356",
        "8945ae6c0da8fe7d",
    )

    @Test
    fun `ten worlds full of things make the same runs on every target`() = runTest(timeout = 10.minutes) {
        assertEquals(
            recorded,
            List(10) { HeavyWorlds.session(it).traceHash },
        )
    }

    @Test
    fun `these runs have in them what could go wrong`() = runTest(timeout = 2.minutes) {
        val states = List(4) { HeavyWorlds.session(it).state }
        val robots = states.flatMap { it.robots }
        assertEquals(TouchKind.entries.toSet(), robots.flatMap { it.robot.touched }.toSet())
        assertTrue(
            states.sumOf { state ->
                state.blocks.count { it.x != 0.0 }
            } > 8,
            states.map { it.blocks }.toString(),
        )
        assertTrue(states.all { it.ink.lengthCentimetres > 500 })
        assertTrue(robots.all { it.bumps > 3 })
    }

    @Test
    fun `going back to an earlier time is the same as having been there`() = runTest(timeout = 5.minutes) {
        val session = HeavyWorlds.session(3)
        for (milliseconds in listOf(0L, 13_337L, 30_021L, 45_000L)) {
            val there = Session.replay(
                session.world,
                HeavyWorlds.loads(3),
                loadPhysicsEngine(),
                session.inputs,
                milliseconds,
                language = Language.ENGLISH,
            )
            val straight = Session(session.world, HeavyWorlds.loads(3), loadPhysicsEngine(), Language.ENGLISH)
            for (input in session.inputs) {
                if (input.milliseconds > milliseconds) break
                straight.advance((input.milliseconds - straight.state.milliseconds).toInt())
                straight.apply(input.input)
            }
            straight.advance((milliseconds - straight.state.milliseconds).toInt())
            assertEquals(straight.traceHash, there.traceHash)
            assertEquals(straight.state.copy(ink = Ink.NONE), there.state.copy(ink = Ink.NONE))
        }
        val again = Session.replay(
            session.world,
            HeavyWorlds.loads(3),
            loadPhysicsEngine(),
            session.inputs,
            60_000,
            Language.ENGLISH,
        )
        assertEquals(session.traceHash, again.traceHash)
    }
}
