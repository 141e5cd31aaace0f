package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.simulation.state.TemplateStretch
import robotran.world.Barrier
import robotran.world.Goal
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
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Template
import robotran.world.TouchKind
import robotran.world.Wall
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

class GoalShortfallTest {
    private val garage = rectangle(80.0, 30.0, 100.0, 50.0)
    private val road = Mark(MarkFigure.Line(listOf(Point(10.0, 40.0), Point(90.0, 40.0)), 2.0), name = "road")
    private val template = Template(listOf(listOf(Point(10.0, 10.0), Point(50.0, 10.0), Point(50.0, 40.0))))

    private inline fun <reified T : GoalShortfall> Run.lacks(): T = assertIs<T>(goal.shortfall)

    @Test
    fun `nothing is missing while a goal may still be met or when it is met`() = runTest {
        val run = run(Goal(Reach(garage)))
        run.robotAt(60.0, 40.0)
        assertNull(run.goal.shortfall)
        run.robotAt(85.0, 40.0)
        run.finish()
        assertNull(run.goal.shortfall)
    }

    @Test
    fun `a region that was not reached was nearest at some moment and place`() = runTest {
        val run =
            run(Goal(Reach(garage)), world = sheet.copy(marks = listOf(Mark(MarkFigure.Area(garage), name = "P"))))
        run.programIs(RunState.Running(7))
        run.robotAt(60.0, 40.0)
        run.robotAt(70.0, 20.0)
        run.robotAt(75.0, 40.0)
        run.programIs(RunState.Running(8))
        run.robotAt(20.0, 10.0)
        run.finish()
        val missing = run.lacks<PlaceShortfall.NotReached>()
        assertEquals(5.0, missing.centimetres)
        assertEquals(Point(75.0, 40.0), missing.place)
        assertEquals(Point(80.0, 40.0), missing.target)
        assertEquals(Point(20.0, 10.0), missing.end)
        assertEquals("P", missing.area)
        assertEquals(40L, missing.moment.milliseconds)
        assertEquals(7, missing.moment.sourceLine)
    }

    @Test
    fun `a robot that had to be inside with all parts stuck out with one`() = runTest {
        val run = run(Goal(Reach(garage, whole = true)))
        run.robotAt(83.0, 40.0)
        run.robotAt(70.0, 40.0)
        run.finish()
        val missing = run.lacks<PlaceShortfall.PartlyOutside>()
        assertTrue(missing.wasPartlyInside)
        assertEquals(10L, missing.moment.milliseconds)
        val corner = checkNotNull(missing.place)
        assertEquals(80.0 - corner.x, missing.centimetres)
    }

    @Test
    fun `who comes too late is told by how much`() = runTest {
        val run = run(Goal(Reach(garage, within = 2)))
        run.robotAt(70.0, 40.0)
        run.until(2.5)
        assertEquals(GoalStatus.FAILED, run.status)
        assertEquals(10.0, run.lacks<PlaceShortfall.NotReached>().centimetres)
        run.until(3.5)
        run.robotAt(85.0, 40.0)
        run.robotAt(20.0, 40.0)
        run.finish()
        val missing = run.lacks<PlaceShortfall.ReachedTooLate>()
        assertEquals(1510L, missing.milliseconds)
        assertEquals(Point(85.0, 40.0), missing.place)
        assertEquals(GoalStatus.FAILED, run.status)
    }

    @Test
    fun `who had to stay and left again is told where and when`() = runTest {
        val run = run(Goal(Reach(garage, stays = true)))
        run.robotAt(85.0, 40.0)
        run.robotAt(70.0, 40.0)
        run.robotAt(90.0, 40.0)
        run.robotAt(79.0, 40.0)
        run.robotAt(60.0, 40.0)
        run.finish()
        val missing = run.lacks<PlaceShortfall.LeftAgain>()
        assertEquals(40L, missing.moment.milliseconds)
        assertEquals(Point(79.0, 40.0), missing.place)
        assertEquals(20.0, missing.centimetres)
    }

    @Test
    fun `the line is that of the robot that a goal is about, which is named beside others`() = runTest {
        val red = sheet.robots.single().copy(name = "red")
        val run = run(Goal(Reach(garage, who = "red")), world = sheet.copy(robots = sheet.robots + red))
        run.programIs(RunState.Running(5))
        run.programIs(RunState.Running(2), number = 1)
        run.robotAt(70.0, 40.0, number = 1)
        run.finish()
        val missing = run.lacks<PlaceShortfall.NotReached>()
        assertEquals("red" to 2, missing.moment.robot to missing.moment.sourceLine)
    }

    @Test
    fun `the first breach of a region is told, not later ones`() = runTest {
        val out = run(Goal(StayOut(garage)))
        for (x in listOf(70.0, 81.0, 70.0, 90.0)) out.robotAt(x, 40.0)
        out.finish()
        val entered = out.lacks<PlaceShortfall.Entered>()
        assertEquals(20L to Point(81.0, 40.0), entered.moment.milliseconds to entered.place)

        val inside = run(Goal(StayIn(garage)))
        for (x in listOf(85.0, 77.0, 60.0)) inside.robotAt(x, 40.0)
        val left = inside.lacks<PlaceShortfall.Left>()
        assertEquals(3.0, left.centimetres)
        assertEquals(20L to Point(77.0, 40.0), left.moment.milliseconds to left.place)
    }

    @Test
    fun `a thin region under the middle of the robot is entered where both overlap`() = runTest {
        val strip = rectangle(49.0, 0.0, 51.0, 80.0)
        val run = run(Goal(StayOut(strip, whole = true)))
        run.robotAt(50.0, 40.0)
        val place = checkNotNull(run.lacks<PlaceShortfall.Entered>().place)
        assertTrue(place.x in 49.0..51.0, "$place")
    }

    @Test
    fun `a touch is told with the thing and the place where it is`() = runTest {
        val post = Barrier(rectangle(70.0, 38.0, 74.0, 42.0), name = "post")
        val wall = Wall(Point(0.0, 79.0), Point(100.0, 79.0), 1.0)
        val run = run(Goal(NeverTouch()), world = sheet.copy(barriers = listOf(post), walls = listOf(wall)))
        run.robotAt(60.0, 40.0)
        run.touching(TouchKind.BARRIERS)
        val touch = run.lacks<ForbiddenTouch>()
        assertEquals(setOf(TouchKind.BARRIERS), touch.what)
        assertEquals("post", touch.name)
        assertEquals(20L, touch.moment.milliseconds)
        assertEquals(70.0, touch.place?.x)
    }

    @Test
    fun `what is missing of a template is told as stretches`() = runTest {
        val run = run(Goal(DrawTemplate(tolerance = 1.0)), world = sheet.copy(template = template))
        run.draws(20.0 to 10.0, 50.0 to 10.0)
        run.finish()
        val missing = run.lacks<InkShortfall.TemplateMissing>()
        assertEquals(0.9, missing.wanted)
        assertEquals(0.45, missing.share, 0.05)
        assertEquals(listOf(29.0, 9.0), missing.missing.map { it.centimetres }.map { (it + 0.5).toInt().toDouble() })
        assertTrue(missing.missing.first().points.all { it.x == 50.0 && it.y > 10.9 })
    }

    @Test
    fun `ink beside the template is told from the moment at which it was too much`() = runTest {
        val run = run(Goal(DrawTemplate(tolerance = 1.0, excess = 0.1)), world = sheet.copy(template = template))
        run.draws(10.0 to 10.0, 20.0 to 10.0)
        run.draws(20.0 to 10.0, 20.0 to 30.0)
        run.draws(60.0 to 10.0, 60.0 to 60.0)
        run.finish()
        val beside = run.lacks<InkShortfall.InkBesideTemplate>()
        assertEquals(20L, beside.moment.milliseconds)
        assertEquals(69.0, beside.centimetres, 0.5)
        assertEquals(listOf(60.0, 20.0), beside.beside.map { it.middle.x })
    }

    @Test
    fun `a scribble beside the template is told with few points`() = runTest {
        val run = run(Goal(DrawTemplate(tolerance = 1.0)), world = sheet.copy(template = template))
        for (stroke in 0..20) {
            run.draws(*Array(500) { (it % 2 * 30.0 + 60.0) to 20.0 + stroke + it / 500.0 })
        }
        run.finish()
        val beside = run.lacks<InkShortfall.InkBesideTemplate>().beside
        assertEquals(TemplateStretch.MAX_STRETCHES, beside.size)
        assertTrue(beside.all { it.points.size <= TemplateStretch.MAX_POINTS })
    }

    @Test
    fun `too little and too much ink are told in centimetres`() = runTest {
        val short = run(Goal(InkLength(30.0, null)))
        short.draws(10.0 to 10.0, 30.0 to 10.0)
        short.finish()
        assertEquals(InkShortfall.TooShort(10.0, Point(30.0, 10.0)), short.goal.shortfall)

        val long = run(Goal(InkLength(null, 30.0)))
        long.draws(10.0 to 10.0, 30.0 to 10.0)
        long.draws(10.0 to 10.0, 30.0 to 10.0)
        assertEquals(10.0, long.lacks<InkShortfall.TooLong>().centimetres)
        long.draws(10.0 to 10.0, 30.0 to 10.0)
        long.finish()
        assertEquals(30.0, long.lacks<InkShortfall.TooLong>().centimetres)
        assertEquals(20L, long.lacks<InkShortfall.TooLong>().moment.milliseconds)
    }

    @Test
    fun `a line is told where it was left for good`() = runTest {
        val run = run(Goal(FollowLine("road", tolerance = 2.0)), world = sheet.copy(marks = listOf(road)))
        for (x in 10..50) run.sensorAt(x.toDouble(), 40.0)
        run.sensorAt(51.0, 47.0)
        run.sensorAt(60.0, 60.0)
        run.finish()
        val left = run.lacks<LineShortfall.Left>()
        assertEquals(Point(51.0, 47.0), left.place)
        assertEquals(420L, left.moment.milliseconds)
        assertEquals(false, left.cameBack)
        assertEquals(run.goal.progress, left.share, 0.02)
    }

    @Test
    fun `a line that is left and found elsewhere began again there`() = runTest {
        val run = run(Goal(FollowLine("road", tolerance = 2.0)), world = sheet.copy(marks = listOf(road)))
        for (x in 10..40) run.sensorAt(x.toDouble(), 40.0)
        for (x in 41..60) run.sensorAt(x.toDouble(), 50.0)
        for (x in 61..70) run.sensorAt(x.toDouble(), 40.0)
        run.finish()
        val left = run.lacks<LineShortfall.Left>()
        assertEquals(Point(41.0, 50.0), left.place)
        assertEquals(true, left.cameBack)
    }

    @Test
    fun `a line that was not reached was nearest somewhere`() = runTest {
        val run = run(Goal(FollowLine("road", tolerance = 2.0)), world = sheet.copy(marks = listOf(road)))
        for (y in listOf(10.0, 35.0, 20.0)) run.sensorAt(30.0, y)
        run.finish()
        val missing = run.lacks<LineShortfall.NotReached>()
        assertEquals(5.0, missing.centimetres)
        assertEquals(Point(30.0, 40.0), missing.target)
        assertEquals(20L, missing.moment.milliseconds)
    }

    @Test
    fun `a line is unfinished if the run ends on it`() = runTest {
        val run = run(Goal(FollowLine("road", tolerance = 2.0)), world = sheet.copy(marks = listOf(road)))
        for (x in 10..50) run.sensorAt(x.toDouble(), 40.0)
        run.finish()
        val missing = run.lacks<LineShortfall.Unfinished>()
        assertEquals(Point(50.0, 40.0), missing.place)
        assertTrue(missing.centimetres in 10.0..40.0, "${missing.centimetres}")
    }

    @Test
    fun `a line that was followed too slowly is told by how much`() = runTest {
        val run = run(Goal(FollowLine("road", tolerance = 2.0, within = 1)), world = sheet.copy(marks = listOf(road)))
        for (x in 10..50) run.sensorAt(x.toDouble(), 40.0)
        run.until(1.5)
        assertIs<LineShortfall.Unfinished>(run.goal.shortfall)
        for (x in 51..90) run.sensorAt(x.toDouble(), 40.0)
        run.finish()
        assertTrue(run.lacks<LineShortfall.TooLate>().milliseconds > 500)
    }

    @Test
    fun `a program that has not ended says where it was`() = runTest {
        val running = run(Goal(EndWithin(1)))
        running.programIs(RunState.Running(5))
        running.until(1.5)
        assertEquals(5, running.lacks<ProgramShortfall.StillRunning>().moment.sourceLine)
        running.programIs(RunState.Ended(stopped = false))
        running.finish()
        assertEquals(510L, running.lacks<ProgramShortfall.EndedTooLate>().milliseconds)

        val stopped = run(Goal(EndWithin(1)))
        stopped.programIs(RunState.Ended(stopped = true))
        stopped.finish()
        assertEquals(false, stopped.lacks<ProgramShortfall.Interrupted>().hasFailed)

        val failed = run(Goal(EndWithin(1)))
        failed.programIs(RunState.Failed(ProgramFailure("It divides by 0.", 9)))
        failed.finish()
        assertEquals(9, failed.lacks<ProgramShortfall.Interrupted>().moment.sourceLine)

        val idle = run(Goal(EndWithin(1)))
        idle.finish()
        assertEquals(ProgramShortfall.NotStarted, idle.goal.shortfall)
    }

    @Test
    fun `a display that differs says what it showed at last and what was nearest`() = runTest {
        val run = run(Goal(ShowOnDisplay("HELLO")))
        run.programIs(RunState.Running(1))
        run.programIs(RunState.Running(2))
        run.shows("HELL")
        run.shows("FACE")
        run.finish()
        val missing = run.lacks<ProgramShortfall.DisplayDiffered>()
        assertEquals("FACE", missing.last?.uppercase())
        assertEquals("HELL", missing.nearest?.uppercase())
        assertEquals(30L, missing.moment?.milliseconds)

        val blank = run(Goal(ShowOnDisplay("HELLO")))
        blank.finish()
        assertEquals(ProgramShortfall.DisplayDiffered("HELLO", null, null, null), blank.goal.shortfall)
    }

    @Test
    fun `missing tones are counted, and others by their pitch`() = runTest {
        val run = run(Goal(PlaySound(3, lowest = 400, highest = 500)))
        run.plays(440.0)
        run.plays(880.0, 220.0)
        run.plays(1000.0, isFirmware = true)
        run.finish()
        val missing = run.lacks<ProgramShortfall.TonesMissing>()
        assertEquals(Triple(1, 3, 2), Triple(missing.played, missing.wanted, missing.others))
        assertEquals(880.0, missing.otherHertz)
        assertEquals(20L, missing.moment?.milliseconds)
    }

    @Test
    fun `tones too many are counted to the end and told from the first`() = runTest {
        val run = run(Goal(PlaySound(2)))
        run.plays(440.0, 440.0)
        run.plays(440.0)
        run.plays(440.0)
        run.finish()
        val tooMany = run.lacks<ProgramShortfall.TooManyTones>()
        assertEquals(Pair(4, 2), Pair(tooMany.played, tooMany.wanted))
        assertEquals(20L, tooMany.moment.milliseconds)
    }

    @Test
    fun `a text that was replaced is told with what came last and when`() = runTest {
        val run = run(Goal(ShowOnDisplay("4", stays = true)))
        run.programIs(RunState.Running(1))
        listOf("4", "5", "6").forEach { run.shows(it) }
        run.finish()
        val changed = run.lacks<ProgramShortfall.DisplayChanged>()
        assertEquals("4" to "6", changed.wanted to changed.last)
        assertEquals(30L, changed.moment.milliseconds)
    }

    @Test
    fun `a group names its first part that was not met, and later ones were not begun`() = runTest {
        val goals = listOf(Goal(Reach(rectangle(0.0, 0.0, 100.0, 80.0))), Goal(Reach(garage)), Goal(PlaySound()))
        val run = run(Goal(InOrder(goals)))
        run.robotAt(70.0, 40.0)
        run.finish()
        val group = run.lacks<GoalShortfall.PartNotMet>()
        assertEquals(1, group.part)
        assertEquals(Point(70.0, 40.0), group.place)
        assertIs<PlaceShortfall.NotReached>(group.shortfall)
        assertEquals(GoalShortfall.NotBegun, run.goal.parts[2].shortfall)
        assertNull(run.goal.parts[0].shortfall)
    }

    @Test
    fun `all of a group is told by its first failure, one of a group by its nearest part`() = runTest {
        val far = Goal(Reach(rectangle(0.0, 0.0, 1.0, 1.0)))
        val all = run(Goal(All(listOf(Goal(StayIn(rectangle(0.0, 0.0, 100.0, 80.0))), far, Goal(Reach(garage))))))
        all.robotAt(70.0, 40.0)
        all.finish()
        assertEquals(1, all.lacks<GoalShortfall.PartNotMet>().part)

        val any = run(Goal(AnyOf(listOf(far, Goal(Reach(garage))))))
        any.robotAt(50.0, 40.0)
        any.robotAt(70.0, 40.0)
        any.finish()
        assertEquals(1, any.lacks<GoalShortfall.PartNotMet>().part)
    }

    @Test
    fun `a goal about something that is not there can not be met`() = runTest {
        assertEquals(GoalShortfall.ImpossibleGoal, run(Goal(Reach(garage, who = "nobody"))).goal.shortfall)
        assertEquals(GoalShortfall.ImpossibleGoal, run(Goal(AnyOf(emptyList()))).goal.shortfall)
    }
}
