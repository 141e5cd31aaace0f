package robotran.simulation

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.orNull
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.brick.sound.SoundEvent
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.simulation.goal.GoalJudge
import robotran.simulation.goal.ProgramEvent
import robotran.simulation.ink.InkWriter
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
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
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.Template
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import robotran.world.roundToThousandths

class GoalProperties :
    StringSpec({
        val trigonometry = runBlocking { loadPhysicsEngine() }.trigonometry
        val brick = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH)).state
        val points = listOf(Point(10.0, 10.0), Point(70.0, 12.0), Point(30.0, 50.0))
        val sheet = World(
            "A sheet",
            Paper(80.0, 60.0),
            listOf(RobotPlacement(Pose(40.0, 30.0, 0.0)), RobotPlacement(Pose(20.0, 20.0, 90.0), name = "red")),
            blocks = listOf(MovableBlock(Shape.Circle(Point(60.0, 40.0), 3.0), name = "ball")),
            marks = listOf(
                Mark(MarkFigure.Line(points, 2.0, closed = true), name = "loop"),
                Mark(MarkFigure.Line(points, 2.0), name = "road"),
            ),
            template = Template(listOf(points)),
        )

        val coordinate = Arb.double(0.0, 80.0, includeNaNs = false)
        val shape: Arb<Shape> = arbitrary {
            val centre = Point(coordinate.bind(), coordinate.bind())
            val isRound = Arb.boolean().bind()
            if (isRound) {
                Shape.Circle(
                    centre,
                    Arb.double(1.0, 30.0).bind(),
                )
            } else {
                Shape.Rectangle(centre, 20.0, 30.0, coordinate.bind())
            }
        }
        val who = Arb.element("red", "ball", "nobody", "yellow").orNull(0.4)
        val seconds = Arb.int(0..4).orNull(0.5)
        val lines = Arb.element("loop", "road", "none")

        val single: Arb<Goal> = arbitrary {
            val region = shape.bind()
            val name = who.bind()
            when (Arb.int(0..9).bind()) {
                0, 1 -> Goal(Reach(region, name, Arb.boolean().bind(), seconds.bind(), Arb.boolean().bind()))
                2 -> Goal(StayOut(region, name, Arb.boolean().bind()))
                3 -> Goal(StayIn(region, name, Arb.boolean().bind()))
                4 -> Goal(NeverTouch(Arb.list(Arb.element(TouchKind.entries), 1..4).bind().toSet(), name))

                5 -> Goal(
                    DrawTemplate(Arb.double(0.1, 9.0).bind(), Arb.double(0.0, 1.0).bind(), Arb.double(0.0, 2.0).bind()),
                )

                6 -> Goal(InkLength(coordinate.orNull().bind(), coordinate.orNull().bind()))

                7 -> Goal(
                    FollowLine(
                        lines.bind(),
                        Arb.double(0.1, 3.0).bind(),
                        Arb.double(0.1, 9.0).bind(),
                        name,
                        seconds.bind(),
                    ),
                )

                8 -> Goal(EndWithin(Arb.int(1..4).bind(), name))

                else -> Goal(
                    PlaySound(Arb.int(1..5).orNull().bind(), Arb.element(300, 500).orNull().bind(), null, name),
                )
            }
        }

        fun nested(depth: Int): Arb<Goal> = arbitrary {
            if (depth == 1 || Arb.int(0..2).bind() > 0) {
                single.bind()
            } else {
                val goals = Arb.list(nested(depth - 1), 1..3).bind()
                when (Arb.int(0..2).bind()) {
                    0 -> Goal(InOrder(goals))
                    1 -> Goal(All(goals))
                    else -> Goal(AnyOf(goals))
                }
            }
        }

        data class Moment(val pose: Pose, val touches: TouchKind?, val tones: Int, val down: Boolean, val ends: Boolean)

        val moment: Arb<Moment> = arbitrary {
            val pose = Pose(coordinate.bind(), coordinate.bind(), Arb.double(-180.0, 180.0).bind())
            val touches = Arb.element(TouchKind.entries).orNull(0.9).bind()
            Moment(pose, touches, Arb.int(0..1).bind(), Arb.boolean().bind(), Arb.int(0..9).bind() == 0)
        }

        /** Passes the [moments] to a judge of [goals], one every 100 ms, with a callback after each. */
        fun judge(
            goals: List<Goal>,
            moments: List<Moment>,
            look: (List<GoalProgress>) -> Unit = {},
        ): List<GoalProgress> {
            val world = sheet.copy(goals = goals)
            val judge = GoalJudge(world, trigonometry, messages = SimulationMessages.of(Language.ENGLISH))
            val ink = InkWriter(world.paper, robots = 2)
            var touched = emptySet<TouchKind>()
            lateinit var last: SessionState
            moments.forEachIndexed { number, moment ->
                touched = touched + setOfNotNull(moment.touches)
                val pose = moment.pose
                ink.move(0, pose.x, pose.y, moment.down)
                val robot = RobotState(pose, 0.0, 0.0, moment.down, false, false, setOfNotNull(moment.touches), touched)
                val run = if (moment.ends) RunState.Ended(stopped = false) else RunState.Running(1)
                val snapshot = RobotSnapshot(brick.copy(run = run), robot, 0, emptyList(), 0)
                val block = Pose(pose.y / 4, pose.x / 4, pose.heading)
                last =
                    SessionState(
                        number * 100L,
                        List(2) {
                            snapshot
                        },
                        listOf(block),
                        emptyList(),
                        ink.ink,
                        judge.progress,
                    )
                val tone = SoundEvent.Tone(last.milliseconds, 440.0, 100)
                judge.observe(last, List(2 * moment.tones) { ProgramEvent(it % 2, tone) })
                look(judge.progress)
            }
            judge.finish(last)
            look(judge.progress)
            return judge.progress
        }

        fun all(goals: List<GoalProgress>): List<GoalProgress> = goals + goals.flatMap { all(it.parts) }

        val goals = Arb.list(nested(4), 1..5)
        val moments = Arb.list(moment, 1..50)

        "progress is from 0 to 1, in hundredths, and 1 only for what is met" {
            checkAll(goals, moments) { some, way ->
                judge(some, way) { described ->
                    for (goal in all(described)) {
                        goal.progress.shouldBeBetween(0.0, 1.0, 0.0)
                        (goal.progress == 1.0) shouldBe (goal.status == GoalStatus.MET)
                        roundToThousandths(goal.progress * 100) % 1.0 shouldBe 0.0
                    }
                }
            }
        }

        "nothing is pending when the run is over" {
            checkAll(goals, moments) { some, way ->
                all(judge(some, way)).none { it.status == GoalStatus.PENDING } shouldBe
                    true
            }
        }

        "what is decided stays as it is, in groups, too" {
            checkAll(goals, moments) { some, way ->
                var before: List<GoalProgress> = emptyList()
                judge(some, way) { now ->
                    val described = all(now)
                    all(before).forEachIndexed { number, goal ->
                        if (goal.status != GoalStatus.PENDING) described[number].status shouldBe goal.status
                    }
                    before = now
                }
            }
        }

        "a goal that holds is met if the run ends now" {
            checkAll(goals, moments, Arb.int(1..50)) { some, way, length ->
                val begun = way.take(length)
                var last: List<GoalProgress> = emptyList()
                var number = 0
                val ended = judge(some, begun) { if (number++ < begun.size) last = it }
                last.zip(ended) { before, after -> if (before.holds) after.status shouldBe GoalStatus.MET }
            }
        }

        "the order of goals that know nothing of each other does not matter" {
            checkAll(goals, moments) { some, way ->
                judge(some.reversed(), way).reversed() shouldBe judge(some, way)
                val forwards = judge(listOf(Goal(All(some)), Goal(AnyOf(some))), way)
                val backwards = judge(listOf(Goal(All(some.reversed())), Goal(AnyOf(some.reversed()))), way)
                backwards.map { it.status to it.progress } shouldBe forwards.map { it.status to it.progress }
                backwards.first().parts shouldContainExactlyInAnyOrder forwards.first().parts
            }
        }

        "the same run is judged alike" {
            checkAll(goals, moments) { some, way -> judge(some, way) shouldBe judge(some, way) }
        }
    })
