package robotran.world.file

import io.kotest.property.Arb
import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.arbitrary
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.nearestDecimal
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
import robotran.world.Lamp
import robotran.world.LightFacing
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.Shade
import robotran.world.Template
import robotran.world.TouchKind
import robotran.world.UnknownFields
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.robot.footprint
import robotran.world.robot.robotErrors
import kotlin.math.abs
import kotlin.random.Random

/** Worlds of all kinds that a file can contain. */
internal fun arbitraryWorlds(): Arb<World> = arbitrary { ArbitraryWorld(it.random).world() }

/** Robots are in a lower strip of the paper, everything else above it, so that no robot starts in an obstacle. */
private class ArbitraryWorld(private val random: Random) {
    private var names = 0

    fun world(): World {
        val robots = List(random.nextInt(1, 9), ::robot)
        val blocks =
            some(4) { MovableBlock(shape(), number(0.001, 100.0), number(0.0, 10.0), maybe(::name), unknown()) }
        val marks = some(4, ::mark)
        val template = maybe { Template(List(random.nextInt(1, 4)) { way(2) }, unknown()) }
        val goals = Goals(robots.map { it.name }, blocks.mapNotNull { it.name }, marks, template)
        return World(
            title = text(),
            task = maybe(::text).orEmpty(),
            paper = Paper(1000.0, number(700.0, 1000.0), unknown()),
            robots = robots,
            walls = some(4) { Wall(point(), point(), number(0.1, 100.0), unknown()) },
            barriers = some(4) { Barrier(shape(), maybe(::name), unknown()) },
            blocks = blocks,
            marks = marks,
            lamps = some(3, ::lamp),
            ambientLight = number(0.0, 100.0),
            temperature = number(-20.0, 50.0),
            template = template,
            goals = some(4) { goals.goal(depth = 1) },
            timeLimit = random.nextInt(1, 3601),
            realism = number(0.0, 1.0),
            seed = random.nextInt(0, Int.MAX_VALUE),
            unknown = unknown(),
        )
    }

    private fun robot(number: Int) = RobotPlacement(
        start = Pose(number(30.0 + 40 * number, 32.0 + 40 * number), number(20.0, 30.0), number(-179.9, 180.0)),
        name = if (number == 0 && random.nextBoolean()) FIRST_ROBOT else name(),
        colour = RobotColour.entries.random(random),
        description = description(),
        lightFacing = maybe { LightFacing.entries.random(random) },
        beacon = number(0.0, 100.0),
        program = maybe {
            List(random.nextInt(1, 5)) { if (random.nextBoolean()) "\t" + text() else "" }.joinToString("\n")
        },
        unknown = unknown(),
    )

    /** No larger than there is room for. */
    private fun description(): RobotDescription {
        if (random.nextInt(4) > 0) {
            return ReadyRobots.penbotWith(List(3) { PortSensor.entries.shuffled(random).take(random.nextInt(3)) })
        }
        val robot = arbitraryRobots().sample(RandomSource(random, 0L)).value.copy(unknown = unknown())
        val isSmall = robotErrors(robot).isEmpty() && robot.footprint.all { abs(it.x) < 14 && abs(it.y) < 14 }
        return if (isSmall) robot else ReadyRobots.all.values.random(random)
    }

    private fun mark(): Mark {
        val figure = when (random.nextInt(3)) {
            0 -> MarkFigure.Area(shape())

            1 -> random.nextBoolean().let { closed ->
                MarkFigure.Line(way(if (closed) 3 else 2), number(0.1, 100.0), closed)
            }

            else -> random.nextInt(1, 9).let { width ->
                MarkFigure.GreyMap(point(), number(0.01, 100.0), List(random.nextInt(1, 5)) { greys(width) })
            }
        }
        val shade = if (random.nextBoolean()) Shade.Grey(number(0.0, 1.0)) else Shade.Colour(part(), part(), part())
        return Mark(figure, shade, maybe(::name), unknown())
    }

    private fun lamp() = Lamp(
        point(),
        number(0.0, 100.0),
        number(-360.0, 360.0),
        number(1.0, 360.0),
        random.nextBoolean(),
        maybe(::name),
        unknown(),
        random.nextBoolean(),
    )

    private inner class Goals(
        private val robots: List<String>,
        blocks: List<String>,
        marks: List<Mark>,
        private val template: Template?,
    ) {
        private val movable = robots + blocks
        private val lines = marks.filter { it.figure is MarkFigure.Line }.mapNotNull { it.name }

        fun goal(depth: Int): Goal = when (random.nextInt(if (depth == 3) SIMPLE_KINDS else KINDS)) {
            0 -> Goal(Reach(shape(), any(movable), flag(), maybe(::seconds), flag()), maybe(::text), unknown())
            1 -> Goal(StayOut(shape(), any(movable), flag()), maybe(::text), unknown())
            2 -> Goal(StayIn(shape(), any(movable), flag()), maybe(::text), unknown())
            3 -> Goal(NeverTouch(touchKinds(), any(robots)), maybe(::text), unknown())
            4 -> if (template == null) goal(depth) else drawTemplate()
            5 -> Goal(InkLength(number(0.0, 50.0), maybe { number(50.0, 1e5) }), maybe(::text), unknown())
            6 -> if (lines.isEmpty()) goal(depth) else followLine()
            7 -> Goal(EndWithin(seconds(), any(robots)), maybe(::text), unknown())
            8 -> showOnDisplay()
            9 -> playSound()
            10 -> Goal(InOrder(goals(depth)), maybe(::text), unknown())
            11 -> Goal(All(goals(depth)), maybe(::text), unknown())
            else -> Goal(AnyOf(goals(depth)), maybe(::text), unknown())
        }

        private fun touchKinds() = TouchKind.entries.shuffled(random).take(random.nextInt(1, 5)).toSet()

        private fun showOnDisplay(): Goal {
            val text = "HELLO".take(random.nextInt(1, 6))
            return Goal(ShowOnDisplay(text, any(robots), random.nextBoolean()), maybe(::text), unknown())
        }

        private fun playSound(): Goal {
            val lowest = maybe { random.nextInt(31, 440) }
            return Goal(
                PlaySound(
                    maybe { random.nextInt(1, 1001) },
                    lowest,
                    maybe {
                        440
                    },
                    any(robots),
                ),
                maybe(::text),
                unknown(),
            )
        }

        private fun drawTemplate() =
            Goal(DrawTemplate(number(0.1, 100.0), number(0.0, 1.0), number(0.0, 100.0)), maybe(::text), unknown())

        private fun goals(depth: Int) = List(random.nextInt(1, 3)) { goal(depth + 1) }

        private fun followLine() = Goal(
            FollowLine(lines.random(random), number(0.1, 100.0), number(0.1, 100.0), any(robots), maybe(::seconds)),
            maybe(::text),
            unknown(),
        )

        private fun any(names: List<String>) = maybe { names.random(random) }
    }

    private fun shape(): Shape = when (random.nextInt(3)) {
        0 -> Shape.Rectangle(farPoint(), number(0.1, 100.0), number(0.1, 100.0), number(-360.0, 360.0))
        1 -> Shape.Circle(farPoint(), number(0.1, 100.0))
        else -> polygon()
    }

    /** Its corners go up once on the left and down once on the right. */
    private fun polygon(): Shape.Polygon {
        val height = random.nextInt(1, 4)
        val left = List(height + 1) { Point(number(100.0, 150.0), 400.0 + 20 * it) }
        val right = List(height + 1) { Point(number(160.0, 200.0), 400.0 + 20 * (height - it)) }
        return Shape.Polygon(if (random.nextBoolean()) left + right else (left + right).reversed())
    }

    private fun way(min: Int): List<Point> = List(random.nextInt(min, min + 4)) {
        Point(
            number(-1000.0, 2000.0),
            it * 20.0,
        )
    }

    private fun point() = Point(number(0.0, 1000.0), number(500.0, 1000.0))

    private fun farPoint() = Point(number(0.0, 1000.0), number(300.0, 1000.0))

    /** Some round, some with the max number of digits of a file. */
    private fun number(from: Double, to: Double): Double {
        val any = random.nextDouble(from, to)
        return nearestDecimal(if (random.nextBoolean()) any else (any * 10).toInt() / 10.0).coerceIn(from, to)
    }

    private fun greys(width: Int) = List(width) { "0123456789abcdef.".random(random) }.joinToString("")

    private fun part() = random.nextInt(256)

    private fun seconds() = random.nextInt(1, 3601)

    private fun flag() = random.nextBoolean()

    private fun name(): String = "n${names++}" + text()

    private fun text(): String = List(random.nextInt(1, 12)) { CHARACTERS.random(random) }.joinToString("")

    private fun unknown(): UnknownFields = if (random.nextInt(4) > 0) {
        UnknownFields.NONE
    } else {
        UnknownFields(List(random.nextInt(1, 3)) { "_${text()}" to value(2) }.toMap())
    }

    private fun value(depth: Int): JsonElement = when (random.nextInt(if (depth == 0) 4 else 6)) {
        0 -> JsonPrimitive(random.nextInt())
        1 -> JsonPrimitive(text() + "\n\u0007\ud800")
        2 -> JsonPrimitive(random.nextBoolean())
        3 -> JsonNull
        4 -> JsonArray(List(random.nextInt(3)) { value(depth - 1) })
        else -> JsonObject(List(random.nextInt(3)) { text() to value(depth - 1) }.toMap())
    }

    private fun <T : Any> maybe(make: () -> T): T? = if (random.nextBoolean()) make() else null

    private fun <T> some(max: Int, make: () -> T): List<T> = List(random.nextInt(max + 1)) { make() }

    private companion object {
        const val KINDS = 13

        /** Those that are no groups. */
        const val SIMPLE_KINDS = 10
        val CHARACTERS = listOf("a", "B", "ñ", "\"", "\\", "/", "语", "\uD83E\uDD16", "x", "{", "]", ",", "7")
    }
}
