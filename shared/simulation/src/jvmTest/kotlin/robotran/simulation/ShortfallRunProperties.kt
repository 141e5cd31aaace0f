package robotran.simulation

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.simulation.goal.distanceTo
import robotran.simulation.goal.sheet
import robotran.simulation.grade.runForGoals
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.StayIn
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.length
import robotran.world.geometry.outline

/** What is told of a goal that was not met is true in real runs, with their physics and programs. */
class ShortfallRunProperties :
    StringSpec({
        val physics = runBlocking { loadPhysicsEngine() }

        /** Drives and turns at random, with the pen down. */
        val program: Arb<ScriptedProgram> = arbitrary {
            val moves = List(Arb.int(1..4).bind()) {
                numbers(1.0, 25.0).bind() to numbers(-120.0, 120.0).bind()
            }
            ScriptedProgram {
                penDown()
                for ((way, angle) in moves) {
                    forward(way)
                    if (angle < 0) turnRight(-angle) else turnLeft(angle)
                }
            }
        }
        val place = arbitrary { Point(numbers(5.0, 95.0).bind(), numbers(5.0, 75.0).bind()) }

        fun worldWith(goal: GoalCondition, seed: Int = 1) =
            sheet.copy(goals = listOf(Goal(goal)), realism = 0.5, seed = seed, timeLimit = 20)

        fun <T> inSession(world: World, program: ScriptedProgram, use: (Session) -> T): T {
            val session = Session(world, listOf(program), physics, Language.ENGLISH)
            try {
                return use(session)
            } finally {
                session.close()
            }
        }

        fun shortfallOf(world: World, program: ScriptedProgram): GoalShortfall? =
            inSession(world, program) { it.runForGoals().goals.single().shortfall }

        /** The session at the moment that is told, made anew. */
        fun <T> atMoment(world: World, program: ScriptedProgram, described: GoalShortfall, use: (Session) -> T): T =
            inSession(world, program) {
                it.pressRun()
                it.advance((checkNotNull(described.moment).milliseconds - it.milliseconds).toInt())
                use(it)
            }

        "a robot that is put where it is told to have been short of, is there" {
            var checked = 0
            checkAll(60, program, place, Arb.int(1..1000)) { driving, centre, seed ->
                val world = worldWith(Reach(Shape.Circle(centre, 4.0)), seed)
                val described = shortfallOf(world, driving) as? PlaceShortfall.NotReached ?: return@checkAll
                checked++
                atMoment(world, driving, described) { session ->
                    val pose = session.state.robot.pose
                    Point(pose.x, pose.y) shouldBe described.place
                    length(described.target.x - pose.x, described.target.y - pose.y) shouldBe
                        (described.centimetres plusOrMinus EXACT)
                    // Inputs are rounded to thousandths, so a little farther than the edge.
                    val share = 1 + INPUT_STEP / described.centimetres
                    session.apply(
                        SessionInput.PlaceRobot(
                            0,
                            Pose(
                                pose.x + share * (described.target.x - pose.x),
                                pose.y + share * (described.target.y - pose.y),
                                pose.heading,
                            ),
                        ),
                    )
                    session.finish()
                    session.state.goals.single().status shouldBe GoalStatus.MET
                }
            }
            checked shouldBeGreaterThan 20
        }

        "a line is told that the program was at, or was at last" {
            checkAll(40, program, place) { driving, centre ->
                val world = worldWith(Reach(Shape.Circle(centre, 4.0)))
                val described = shortfallOf(world, driving) as? PlaceShortfall.NotReached ?: return@checkAll
                val until = described.moment.milliseconds
                inSession(world, driving) { session ->
                    session.pressRun()
                    // It was nearest before the program began.
                    if (until < session.milliseconds) return@inSession
                    session.advance((until - session.milliseconds).toInt())
                    val calls = session.callLog.entries.filter { it.sourceLine > 0 }
                    val last = calls.lastOrNull()?.sourceLine ?: 0
                    // Between two looks, a program may go on by a line, or make its last call and end.
                    withClue("${described.moment}, last call in line $last") {
                        (described.moment.sourceLine - last in -1..1) shouldBe true
                    }
                }
            }
        }

        "a region is left at the first moment at which the robot is outside" {
            checkAll(40, program, numbers(3.0, 12.0)) { driving, radius ->
                val shape = Shape.Circle(Point(50.0, 40.0), radius)
                val world = worldWith(StayIn(shape))
                val described = shortfallOf(world, driving) as? PlaceShortfall.Left ?: return@checkAll
                inSession(world, driving) { session ->
                    session.pressRun()
                    while (session.milliseconds % LOOK != 0L) session.advance(1)
                    var first: Long? = null
                    while (first == null) {
                        val pose = session.state.robot.pose
                        if (shape.outline(physics.trigonometry).distanceTo(Point(pose.x, pose.y)) > 0) {
                            first = session.milliseconds
                        } else {
                            session.advance(LOOK.toInt())
                        }
                    }
                    described.moment.milliseconds shouldBe first
                    val pose = session.state.robot.pose
                    described.place shouldBe Point(pose.x, pose.y)
                }
            }
        }

        "a forbidden touch is told at its moment, at the thing and at the robot" {
            var checked = 0
            checkAll(60, program, place, numbers(0.0, 90.0)) { driving, centre, angle ->
                if (length(centre.x - 50.0, centre.y - 40.0) < 22.0) return@checkAll
                val post = Shape.Rectangle(centre, 10.0, 6.0, angle)
                val world = worldWith(NeverTouch(setOf(TouchKind.BARRIERS)))
                    .copy(barriers = listOf(Barrier(post, name = "post")))
                val described = shortfallOf(world, driving) as? ForbiddenTouch ?: return@checkAll
                checked++
                described.name shouldBe "post"
                post.outline(physics.trigonometry).distanceTo(described.place!!) shouldBeLessThan EXACT
                atMoment(world, driving, described) { session ->
                    session.state.robot.touched shouldBe setOf(TouchKind.BARRIERS)
                    session.state.robot.pose.let {
                        length(it.x - described.place!!.x, it.y - described.place!!.y) shouldBeLessThan ROBOT_REACH
                    }
                }
                inSession(world, driving) { session ->
                    session.pressRun()
                    session.advance((described.moment.milliseconds - LOOK - session.milliseconds).toInt())
                    session.state.robot.touched shouldBe emptySet()
                }
            }
            checked shouldBeGreaterThan 3
        }

        "with as much less asked for as is told, the drawing is long enough" {
            checkAll(30, program, numbers(20.0, 120.0)) { driving, wanted ->
                val described = shortfallOf(worldWith(InkLength(wanted, null)), driving) as? InkShortfall.TooShort
                    ?: return@checkAll
                shortfallOf(worldWith(InkLength(wanted - described.centimetres - EXACT, null)), driving) shouldBe null
                (
                    shortfallOf(
                        worldWith(InkLength(wanted - described.centimetres + EXACT, null)),
                        driving,
                    ) != null
                ) shouldBe
                    true
            }
        }
    })

private const val LOOK = 10L
private const val EXACT = 1e-6
private const val INPUT_STEP = 0.01

/** More than from the pen of a robot to its farthest corner, in centimetres. */
private const val ROBOT_REACH = 15.0
