package robotran.simulation

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.rcxrom.program.RcxProgram
import robotran.simulation.noise.NoiseStream
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Barrier
import robotran.world.Lamp
import robotran.world.LightFacing
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.Shade
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.length

/** Generated worlds with many objects: 40 barriers of all shapes, 10 blocks, marks, lamps, three robots, noise on. */
internal object HeavyWorlds {
    fun world(number: Int): World {
        val random = NoiseStream(number, "heavy world")

        fun from(low: Double, high: Double) = low + (high - low) * random.share()

        /** Far from the robots' starts. */
        fun place(): Point {
            while (true) {
                val place = Point(from(5.0, 195.0), from(5.0, 145.0))
                if (STARTS.all { length(place.x - it.x, place.y - it.y) > 22 }) return place
            }
        }

        fun shape(kind: Int, size: Double, at: Point): Shape = when (kind % 4) {
            0 -> Shape.Rectangle(at, size, size * 0.7, from(-180.0, 180.0))
            1 -> Shape.Circle(at, size / 2)
            2 -> Shape.Polygon(listOf(at, Point(at.x + size, at.y), Point(at.x + size * 0.4, at.y + size * 0.8)))

            // Concave and clockwise.
            else -> Shape.Polygon(
                listOf(
                    at,
                    Point(at.x, at.y + size),
                    Point(at.x + size * 0.4, at.y + size * 0.3),
                    Point(at.x + size, at.y),
                ),
            )
        }
        return BuiltInWorlds.plain.copy(
            title = "Heavy $number",
            paper = Paper(200.0, 150.0),
            walls = listOf(
                Wall(Point(0.0, 0.0), Point(200.0, 0.0), 1.0),
                Wall(Point(200.0, 0.0), Point(200.0, 150.0), 1.0),
                Wall(Point(200.0, 150.0), Point(0.0, 150.0), 1.0),
                Wall(Point(0.0, 150.0), Point(0.0, 0.0), 1.0),
            ),
            robots = STARTS.mapIndexed { robot, start ->
                RobotPlacement(
                    start.copy(heading = from(-180.0, 180.0)),
                    name = "robot $robot",
                    description = ReadyRobots.penbotWith(
                        listOf(
                            listOf(PortSensor.LEFT_BUMPER, PortSensor.TEMPERATURE),
                            listOf(PortSensor.LIGHT),
                            listOf(PortSensor.RIGHT_ROTATION),
                        ),
                    ),
                    lightFacing = LightFacing.entries[robot % 2],
                    beacon = from(0.0, 1.0),
                )
            },
            barriers = List(40) { Barrier(shape(it, from(3.0, 9.0), place())) },
            blocks = List(10) {
                MovableBlock(shape(it, from(3.0, 6.0), place()), mass = from(0.05, 0.4), friction = from(0.2, 0.8))
            },
            marks =
                List(12) { Mark(MarkFigure.Area(shape(it, from(10.0, 40.0), place())), Shade.Grey(from(0.0, 1.0))) } +
                    Mark(MarkFigure.Line(List(8) { place() }, width = 2.0, closed = true), Shade.Colour(20, 40, 160)),
            lamps = List(3) {
                Lamp(place(), brightness = from(0.5, 3.0), direction = from(-180.0, 180.0), cone = from(40.0, 360.0))
            },
            realism = 0.2 + number * 0.08,
            seed = number,
        )
    }

    /** A robot that drives about, draws, reads its sensors and floats, differently in each world. */
    private fun program(number: Int, robot: Int): RcxProgram {
        val random = NoiseStream(number, "program of robot $robot")
        return ScriptedProgram {
            penDown()
            repeat(60) {
                activate(port = 1)
                motors(FORWARD_OR_BACKWARD[(random.share() * 3).toInt()], (random.share() * 8).toInt())
                pause(300 + (random.share() * 900).toLong())
                if (random.share() < 0.3) motors(ScriptedProgram.FLOAT, 7)
                turnRight(10 + 150 * random.share())
            }
        }
    }

    private val sessions = mutableMapOf<Int, Session>()

    /** A session of sixty virtual seconds in the world [number], with user input; it is run once for all tests. */
    suspend fun session(number: Int): Session = sessions[number] ?: run(number).also { sessions[number] = it }

    private suspend fun run(number: Int): Session {
        val session = Session(world(number), loads(number), loadPhysicsEngine(), Language.ENGLISH)
        for (robot in 0..2) {
            session.apply(SessionInput.Press(BrickButton.RUN, robot))
            session.advance(7)
            session.apply(SessionInput.Release(BrickButton.RUN, robot))
        }
        session.advance(20_000)
        session.apply(SessionInput.MoveLamp(0, Point(100.0, 75.0)))
        session.apply(SessionInput.SwitchLamp(1, on = false))
        session.advance(10_001)
        session.apply(SessionInput.PlaceRobot(1, Pose(STARTS[1].x, STARTS[1].y, 77.0)))
        session.advance(60_000 - session.state.milliseconds.toInt())
        return session
    }

    fun loads(number: Int) = List(3) { RobotProgramSet(listOf(program(number, it))) }

    private val STARTS = listOf(Pose(30.0, 30.0, 0.0), Pose(150.0, 100.0, 0.0), Pose(60.0, 110.0, 0.0))
    private val FORWARD_OR_BACKWARD = listOf(ScriptedProgram.FORWARD, ScriptedProgram.FORWARD, ScriptedProgram.BACKWARD)
}
