package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.simulation.goal.Run
import robotran.simulation.goal.distanceTo
import robotran.simulation.goal.sheet
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.FollowLine
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Template
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.distance
import robotran.world.geometry.length
import robotran.world.geometry.outline

/**
 * What is told of a goal that was not met is true: at that time the robot was at that place, and the run would have met
 * the goal if the robot had been moved, or the goal changed, by the amount.
 */
class ShortfallProperties :
    StringSpec({
        val trigonometry = runBlocking { loadPhysicsEngine() }.trigonometry
        val coordinate = numbers(0.0, 80.0)

        val region: Arb<Shape> = arbitrary {
            val centre = Point(coordinate.bind(), coordinate.bind())
            if (Arb.boolean().bind()) {
                Shape.Circle(centre, numbers(1.0, 25.0).bind())
            } else {
                Shape.Rectangle(centre, numbers(2.0, 40.0).bind(), 30.0, coordinate.bind())
            }
        }

        /** Poses 10 ms apart, one to five centimetres between two of them. */
        val drive: Arb<List<Pose>> = arbitrary {
            var pose = Pose(coordinate.bind(), coordinate.bind(), 0.0)
            List(Arb.int(2..40).bind()) {
                val heading = numbers(-180.0, 180.0).bind()
                pose = Pose(
                    (pose.x + numbers(-5.0, 5.0).bind()).coerceIn(0.0, 100.0),
                    (pose.y + numbers(-5.0, 5.0).bind()).coerceIn(0.0, 80.0),
                    heading,
                )
                pose
            }
        }

        fun runOf(goal: GoalCondition, poses: List<Pose>, world: World = sheet): Run =
            Run(world.copy(goals = listOf(Goal(goal))), trigonometry).also { run ->
                poses.forEach { run.robotAt(it.x, it.y, it.heading) }
            }

        fun finished(goal: GoalCondition, poses: List<Pose>) = runOf(goal, poses).also { it.finish() }

        fun Shape.grownBy(amount: Double): Shape = when (this) {
            is Shape.Circle -> copy(radius = maxOf(radius + amount, 0.0))
            is Shape.Rectangle -> copy(width = width + 2 * amount, height = height + 2 * amount)
            is Shape.Polygon -> error("No polygon is needed here.")
        }

        /** The pose at the time that is told. */
        fun List<Pose>.at(shortfall: GoalShortfall): Pose =
            this[(checkNotNull(shortfall.moment).milliseconds / MILLISECONDS_PER_LOOK).toInt() - 1]

        fun Pose.place() = Point(x, y)

        "a robot that had been moved from the place that is told by the amount that is told would have been there" {
            var checked = 0
            checkAll(drive, region) { poses, shape ->
                val run = finished(Reach(shape), poses)
                if (run.status == GoalStatus.MET) {
                    run.goal.shortfall shouldBe null
                    return@checkAll
                }
                checked++
                val described = run.goal.shortfall.shouldBeInstanceOf<PlaceShortfall.NotReached>()
                poses.at(described).place() shouldBe described.place
                val outline = shape.outline(trigonometry)
                described.centimetres shouldBe (poses.minOf { outline.distanceTo(it.place()) } plusOrMinus EXACT)
                described.end shouldBe poses.last().place()
                val from = checkNotNull(described.place)
                val way = length(described.target.x - from.x, described.target.y - from.y)
                way shouldBe (described.centimetres plusOrMinus EXACT)

                fun moved(by: Double) = Pose(
                    from.x + (described.target.x - from.x) * by / way,
                    from.y + (described.target.y - from.y) * by / way,
                    0.0,
                )
                finished(Reach(shape), poses + moved(described.centimetres + NEARLY)).status shouldBe GoalStatus.MET
                if (way > 2 * NEARLY) {
                    finished(Reach(shape), poses + moved(described.centimetres - NEARLY)).status shouldBe
                        GoalStatus.FAILED
                }
            }
            checked shouldBeGreaterThan 10
        }

        "a region that had been larger by what stuck out would have held all of the robot, and not a smaller one" {
            checkAll(drive, region) { poses, shape ->
                val run = finished(Reach(shape, whole = true), poses)
                val described = run.goal.shortfall as? PlaceShortfall.PartlyOutside ?: return@checkAll
                val last = poses.at(described)
                val grown = shape.grownBy(described.centimetres + EXACT)
                finished(Reach(grown, whole = true), listOf(last)).status shouldBe GoalStatus.MET
                val smaller = shape.grownBy(described.centimetres - TOLERANCE)
                // The corners of a grown rectangle are farther away than its sides.
                if (shape is Shape.Circle) {
                    finished(Reach(smaller, whole = true), poses).status shouldBe GoalStatus.FAILED
                }
                shape.outline(trigonometry).distanceTo(checkNotNull(described.place)) shouldBe
                    (described.centimetres plusOrMinus EXACT)
            }
        }

        "with more time, who came too late would have been in time" {
            checkAll(drive, drive, region) { early, late, shape ->
                val run = runOf(Reach(shape, within = 1), early)
                run.until(1.5)
                late.forEach { run.robotAt(it.x, it.y, it.heading) }
                run.finish()
                val described = run.goal.shortfall as? PlaceShortfall.ReachedTooLate ?: return@checkAll
                val seconds = 1 + ((described.milliseconds + 999) / 1000).toInt()
                val again = runOf(Reach(shape, within = seconds), early)
                again.until(1.5)
                late.forEach { again.robotAt(it.x, it.y, it.heading) }
                again.status shouldBe GoalStatus.MET
                described.moment.milliseconds shouldBe 1000 + described.milliseconds
            }
        }

        "a region was entered or left at the moment that is told, and not before" {
            checkAll(drive, region, Arb.boolean(), Arb.boolean()) { poses, shape, whole, out ->
                val goal = if (out) StayOut(shape, whole = whole) else StayIn(shape, whole = whole)
                val described = finished(goal, poses).goal.shortfall ?: return@checkAll
                val until = (checkNotNull(described.moment).milliseconds / MILLISECONDS_PER_LOOK).toInt()
                finished(goal, poses.take(until)).status shouldBe GoalStatus.FAILED
                if (until > 1) finished(goal, poses.take(until - 1)).status shouldBe GoalStatus.MET
                val outside = shape.outline(trigonometry).distanceTo(checkNotNull(described.place))
                if (described is PlaceShortfall.Left) {
                    outside shouldBe (described.centimetres plusOrMinus EXACT)
                    val grown = StayIn(shape.grownBy(described.centimetres + EXACT), whole = whole)
                    finished(grown, poses.take(until)).status shouldBe GoalStatus.MET
                } else {
                    outside shouldBe (0.0 plusOrMinus EXACT)
                }
            }
        }

        "a goal that had asked for as much less or more ink as is told would have been met" {
            val lines = Arb.list(coordinate, 1..8)
            checkAll(lines, numbers(0.5, 200.0), Arb.boolean()) { ends, wanted, isMost ->
                fun drawn(goal: GoalCondition, strokes: Int = ends.size) =
                    Run(sheet.copy(goals = listOf(Goal(goal))), trigonometry).also { run ->
                        ends.take(strokes).forEach { run.draws(0.0 to it, it to 0.0) }
                        run.finish()
                    }
                val goal = if (isMost) InkLength(null, wanted) else InkLength(wanted, null)
                when (val described = drawn(goal).goal.shortfall) {
                    is InkShortfall.TooShort -> {
                        drawn(InkLength(wanted - described.centimetres - EXACT, null)).status shouldBe GoalStatus.MET
                        drawn(InkLength(wanted - described.centimetres + EXACT, null)).status shouldBe GoalStatus.FAILED
                        described.place shouldBe Point(ends.last(), 0.0)
                    }

                    is InkShortfall.TooLong -> {
                        drawn(InkLength(null, wanted + described.centimetres + EXACT)).status shouldBe GoalStatus.MET
                        drawn(InkLength(null, wanted + described.centimetres - EXACT)).status shouldBe GoalStatus.FAILED
                        val before = (described.moment.milliseconds / MILLISECONDS_PER_LOOK).toInt() - 1
                        drawn(goal, before).status shouldBe GoalStatus.MET
                    }

                    else -> described shouldBe null
                }
            }
        }

        "drawing what is told to be missing of a template completes it" {
            checkAll(500, Arb.list(coordinate, 2..5), Arb.list(coordinate, 2..6), numbers(1.0, 3.0)) {
                xs,
                at,
                tolerance,
                ->
                val corners = xs.mapIndexed { number, x -> Point(x, 12.0 * number) }
                val world = sheet.copy(template = Template(listOf(corners)))
                val goal = DrawTemplate(tolerance, coverage = 1.0, excess = 100.0)

                fun Run.drawsBits() = at.forEach { part ->
                    val number = (part / 80.0 * (corners.size - 1)).toInt().coerceAtMost(corners.size - 2)
                    val (from, to) = corners[number] to corners[number + 1]
                    draws(from.x to from.y, (from.x + to.x) / 2 to (from.y + to.y) / 2)
                }
                val run = Run(world.copy(goals = listOf(Goal(goal))), trigonometry).apply { drawsBits() }
                run.finish()
                val described = run.goal.shortfall as? InkShortfall.TemplateMissing ?: return@checkAll
                val total = corners.zipWithNext { one, two -> length(two.x - one.x, two.y - one.y) }.sum()
                // Each stroke has one sample more than it has distances between samples.
                described.missing.sumOf { it.centimetres } / total shouldBe ((1 - described.share) plusOrMinus 0.05)
                val again = Run(world.copy(goals = listOf(Goal(goal))), trigonometry).apply { drawsBits() }
                described.missing.forEach { stretch ->
                    again.draws(*stretch.points.map { it.x to it.y }.toTypedArray())
                }
                again.finish()
                again.status shouldBe GoalStatus.MET
            }
        }

        "ink that is told to be beside the template is beside it, and would be allowed with as much more excess" {
            checkAll(500, Arb.list(coordinate, 2..8), numbers(0.3, 3.0)) { ys, tolerance ->
                val corners = listOf(Point(10.0, 10.0), Point(60.0, 10.0), Point(60.0, 50.0))
                val world = sheet.copy(template = Template(listOf(corners)))
                val total = 90.0

                fun drawn(excess: Double, strokes: Int = ys.size) = Run(
                    world.copy(goals = listOf(Goal(DrawTemplate(tolerance, coverage = 0.0, excess = excess)))),
                    trigonometry,
                ).also { run ->
                    ys.take(strokes).forEach { run.draws(10.0 to 10.0, it to it) }
                    run.finish()
                }
                val described = drawn(0.1).goal.shortfall as? InkShortfall.InkBesideTemplate ?: return@checkAll
                drawn((described.centimetres + EXACT) / total).status shouldBe GoalStatus.MET
                drawn((described.centimetres - EXACT) / total).status shouldBe GoalStatus.FAILED
                drawn(0.1, (described.moment.milliseconds / MILLISECONDS_PER_LOOK).toInt() - 1).status shouldBe
                    GoalStatus.MET
                for (place in described.beside.flatMap { it.points }) {
                    val away = corners.zipWithNext { from, to -> distance(place, from, to) }.min()
                    away shouldBeGreaterThan tolerance * 0.99
                }
            }
        }

        "driving on along the line from where it was left, as far as is told, meets the goal" {
            val line = Mark(MarkFigure.Line(listOf(Point(5.0, 40.0), Point(95.0, 40.0)), 2.0), name = "road")
            val world = sheet.copy(marks = listOf(line))
            checkAll(numbers(0.5, 6.0), numbers(10.0, 80.0), Arb.int(0..30)) { tolerance, until, astray ->
                val goal = FollowLine("road", tolerance = tolerance)

                fun way(to: Double) = generateSequence(5.0) { it + 0.4 }.takeWhile { it <= to }
                val run = Run(world.copy(goals = listOf(Goal(goal))), trigonometry)
                way(until).forEach { run.sensorAt(it, 40.0) }
                repeat(astray) { run.sensorAt(way(until).last(), 40.4 + 0.4 * it) }
                run.finish()
                if (run.status == GoalStatus.MET) return@checkAll
                val (missing, moment) = when (val described = run.goal.shortfall) {
                    is LineShortfall.Left -> {
                        distance(described.place!!, Point(5.0, 40.0), Point(95.0, 40.0)) shouldBeGreaterThan tolerance
                        described.centimetres to described.moment
                    }

                    else -> described.shouldBeInstanceOf<LineShortfall.Unfinished>().let { it.centimetres to it.moment }
                }
                val last = way(until).last()
                moment.place!!.x shouldBe (last plusOrMinus EXACT)

                fun goneOn(by: Double) = Run(world.copy(goals = listOf(Goal(goal))), trigonometry).also { again ->
                    way(until).forEach { again.sensorAt(it, 40.0) }
                    way(last + by).dropWhile { it <= last }.forEach { again.sensorAt(it, 40.0) }
                    again.sensorAt(last + by, 40.0)
                }
                goneOn(missing + EXACT).status shouldBe GoalStatus.MET
                goneOn(missing - NEARLY).status shouldBe GoalStatus.PENDING
            }
        }

        "playing the tones that are told to be missing meets the goal" {
            checkAll(Arb.list(numbers(100.0, 900.0), 0..6), Arb.int(1..5)) { tones, times ->
                val goal = PlaySound(times, lowest = 400, highest = 600)

                fun played(more: Int) = Run(sheet.copy(goals = listOf(Goal(goal))), trigonometry).also { run ->
                    tones.forEach { run.plays(it) }
                    repeat(more) { run.plays(500.0) }
                    run.finish()
                }
                val described = played(0).goal.shortfall as? ProgramShortfall.TonesMissing ?: return@checkAll
                played(described.wanted - described.played).status shouldBe GoalStatus.MET
                played(described.wanted - described.played - 1).status shouldBe GoalStatus.FAILED
                described.others shouldBe tones.size - described.played
                described.moment?.let {
                    tones[(it.milliseconds / MILLISECONDS_PER_LOOK).toInt() - 1] shouldBe described.otherHertz
                }
            }
        }
    })

private const val MILLISECONDS_PER_LOOK = 10L

/** In centimetres: far below what is told, but above the errors of some floating-point operations. */
private const val EXACT = 1e-6
private const val NEARLY = 1e-3

/** What may stick out of a region unseen: a tenth of a millimetre, and as much again. */
private const val TOLERANCE = 0.02

internal fun numbers(min: Double, max: Double): Arb<Double> = Arb.double(min, max, includeNaNs = false)
