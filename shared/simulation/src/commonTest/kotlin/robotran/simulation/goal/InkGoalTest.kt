package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.simulation.config.SimulationLimits
import robotran.simulation.ink.InkWriter
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.world.Goal
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.Reach
import robotran.world.Paper
import robotran.world.Template
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class InkGoalTest {
    /** A corner of 20 cm and 10 cm. */
    private val corner = sheet.copy(
        template = Template(listOf(listOf(Point(20.0, 20.0), Point(40.0, 20.0), Point(40.0, 30.0)))),
    )

    @Test
    fun `enough is drawn when it is`() = runTest {
        val run =
            run(
                Goal(InkLength(atLeast = 10.0, atMost = null)),
                Goal(InkLength(null, 12.0)),
                Goal(InkLength(10.0, 12.0)),
            )
        run.draws(0.0 to 0.0, 5.0 to 0.0)
        assertEquals(listOf(0.5, 0.0, 0.5), run.goals.map { it.progress })
        run.draws(0.0 to 1.0, 6.0 to 1.0)
        assertEquals(listOf(GoalStatus.MET, GoalStatus.PENDING, GoalStatus.PENDING), run.goals.map { it.status })
        run.finish()
        assertEquals(listOf(GoalStatus.MET, GoalStatus.MET, GoalStatus.MET), run.goals.map { it.status })
    }

    @Test
    fun `too little and too much have failed`() = runTest {
        val little = run(Goal(InkLength(10.0, 12.0)))
        little.draws(0.0 to 0.0, 5.0 to 0.0)
        little.finish()
        assertEquals(GoalStatus.FAILED, little.status)
        val much = run(Goal(InkLength(10.0, 12.0)))
        much.draws(0.0 to 0.0, 13.0 to 0.0)
        assertEquals(GoalStatus.FAILED, much.status)
    }

    @Test
    fun `a drawing is judged by how much of the template has ink near it`() = runTest {
        val run = run(Goal(DrawTemplate()), world = corner)
        run.draws(20.0 to 20.5, 35.0 to 20.5)
        assertEquals(0.5, run.goal.progress, 0.03)
        run.draws(35.0 to 20.0, 40.0 to 20.0, 40.0 to 30.0)
        assertEquals(0.99, run.goal.progress)
        assertEquals(GoalStatus.PENDING, run.status)
        run.finish()
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `too little of a drawing has failed at the end`() = runTest {
        val run = run(Goal(DrawTemplate(coverage = 0.6)), world = corner)
        run.draws(20.0 to 20.5, 30.0 to 20.5)
        run.finish()
        assertEquals(GoalStatus.FAILED, run.status)
    }

    @Test
    fun `too much beside a drawing has failed at once`() = runTest {
        val run = run(Goal(DrawTemplate(excess = 0.1)), world = corner)
        run.draws(20.0 to 20.0, 40.0 to 20.0, 40.0 to 30.0)
        run.draws(60.0 to 60.0, 62.8 to 60.0)
        assertEquals(GoalStatus.PENDING, run.status)
        run.draws(60.0 to 61.0, 60.8 to 61.0)
        assertEquals(GoalStatus.FAILED, run.status)
    }

    @Test
    fun `what is enough for a drawing lets the next goal begin`() = runTest {
        val home = Goal(Reach(rectangle(0.0, 0.0, 10.0, 10.0)))
        val run = run(Goal(InOrder(listOf(Goal(DrawTemplate()), home))), world = corner)
        run.robotAt(5.0, 5.0)
        run.draws(20.0 to 20.0, 40.0 to 20.0, 40.0 to 30.0)
        run.robotAt(50.0, 40.0)
        assertEquals(GoalStatus.PENDING, run.goal.parts[1].status)
        run.robotAt(5.0, 5.0)
        assertEquals(GoalStatus.MET, run.goal.parts[1].status)
        run.finish()
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `ink that is looked at while it is drawn counts as much as all at once`() {
        val template =
            Template(listOf(listOf(Point(10.0, 10.0), Point(50.0, 10.0), Point(50.0, 50.0), Point(12.0, 31.0))))
        val writer = InkWriter(sheet.paper, robots = 2)
        val watching = Tracing(template, tolerance = 1.0)
        // Two pens draw at the same time, each with its own breaks: one along the template, one across it.
        for (step in 0..2_000) {
            val way = step * 0.05
            writer.move(0, 10.0 + minOf(way, 40.0), 10.0 + maxOf(0.0, minOf(way - 40.0, 40.0)), down = step % 700 < 650)
            writer.move(1, 30.0 + way / 50, 5.0 + way / 3, down = step % 90 < 60)
            if (step % 3 == 0) watching.follow(writer.ink)
        }
        watching.follow(writer.ink)
        val late = Tracing(template, tolerance = 1.0).apply { follow(writer.ink) }
        assertEquals(late.coverage, watching.coverage)
        assertEquals(late.excess, watching.excess)
        assertTrue(late.coverage in 0.5..0.75, "${late.coverage}")
        assertTrue(late.excess in 0.1..0.3, "${late.excess}")
    }

    @Test
    fun `the largest drawing over the largest template is judged while it grows`() {
        val paper = Paper(1000.0, 1000.0)
        val template = Template(
            List(200) { row ->
                List(100) {
                    Point(
                        it * 10.0,
                        row * 5.0 + if (it % 2 == 0) 0.0 else 4.0,
                    )
                }
            },
        )
        val tracing = Tracing(template, tolerance = 1.0)
        val writer = InkWriter(paper, robots = 1)
        val corners = SimulationLimits.MAXIMUM_INK_POINTS
        for (number in 0..<corners) {
            val row = number / 1000
            writer.move(
                0,
                if (row % 2 == 0) {
                    number % 1000.0
                } else {
                    999.0 - number % 1000
                },
                row * 5.0 + number % 2,
                down = true,
            )
            tracing.follow(writer.ink)
        }
        assertTrue(writer.ink.strokes.single().points.size > corners / 2)
        assertTrue(tracing.coverage in 0.1..0.9, "${tracing.coverage}")
        assertTrue(tracing.excess in 0.1..2.0, "${tracing.excess}")
    }

    @Test
    fun `dots cover the template but are no excess`() {
        val template = Template(listOf(listOf(Point(10.0, 10.0), Point(20.0, 10.0))))
        val tracing = Tracing(template, tolerance = 1.0)
        tracing.follow(Ink(listOf(InkStroke(listOf(Point(15.0, 10.0))), InkStroke(listOf(Point(50.0, 50.0)))), 0.0))
        assertEquals(0.2, tracing.coverage, 0.03)
        assertEquals(0.0, tracing.excess)
    }

    @Test
    fun `a template of no length and a tiny tolerance are no trouble`() {
        val dot = Tracing(Template(listOf(listOf(Point(10.0, 10.0), Point(10.0, 10.0)))), tolerance = 0.1)
        dot.follow(Ink(listOf(InkStroke(listOf(Point(9.0, 10.0), Point(11.0, 10.0)))), 2.0))
        assertEquals(1.0, dot.coverage)
        assertEquals(0.0, dot.excess)
    }
}
