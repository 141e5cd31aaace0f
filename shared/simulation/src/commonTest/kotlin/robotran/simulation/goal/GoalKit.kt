package robotran.simulation.goal

import robotran.brick.sound.SoundEvent
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.TextLcd
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.state.RcxState
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.RobotState
import robotran.simulation.state.SessionState
import robotran.world.Goal
import robotran.world.Paper
import robotran.world.Penbot
import robotran.world.RobotPlacement
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.length

/** A sheet with one robot in its centre. */
internal val sheet = World("A sheet", Paper(100.0, 80.0), listOf(RobotPlacement(Pose(50.0, 40.0, 0.0))))

internal fun rectangle(left: Double, bottom: Double, right: Double, top: Double) =
    Shape.Rectangle(Point((left + right) / 2, (bottom + top) / 2), right - left, top - bottom)

/** A fake run with only the data that goals use; each call is the next moment. */
internal class Run(world: World, trigonometry: Trigonometry) {
    val judge = GoalJudge(world, trigonometry, messages = SimulationMessages.of(Language.ENGLISH))
    private val brick = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH)).state
    private var milliseconds = 0L
    private var robots = world.robots.map {
        RobotSnapshot(brick, RobotState(it.start, 0.0, 0.0, false, false, false), 0, emptyList(), 0)
    }
    private var blocks = world.blocks.map { Pose(0.0, 0.0, 0.0) }
    private var ink = Ink.NONE
    private var strokes: List<InkStroke> = emptyList()

    val goals: List<GoalProgress> get() = judge.progress
    val goal: GoalProgress get() = goals.first()
    val status: GoalStatus get() = goal.status

    private val state get() = SessionState(milliseconds, robots, blocks, emptyList(), ink, judge.progress)

    fun robotAt(x: Double, y: Double, heading: Double = 0.0, number: Int = 0) =
        look { change(number) { copy(robot = robot.copy(pose = Pose(x, y, heading))) } }

    /** Puts the light sensor of the first robot there, facing along x. */
    fun sensorAt(x: Double, y: Double) = robotAt(x - Penbot.LIGHT_SENSOR_POSITION, y)

    fun blockAt(x: Double, y: Double, heading: Double = 0.0, number: Int = 0) =
        look { blocks = blocks.mapIndexed { index, pose -> if (index == number) Pose(x, y, heading) else pose } }

    fun touching(vararg kinds: TouchKind, number: Int = 0) = look {
        change(number) { copy(robot = robot.copy(touching = kinds.toSet(), touched = robot.touched + kinds)) }
    }

    fun programIs(run: RunState, number: Int = 0) = look {
        change(number) { copy(brick = brick.withRun(brick.motors.map { it.mode }, run)) }
    }

    fun shows(text: String, number: Int = 0) = look {
        val memory = RcxMemory().also { TextLcd.print(text, it) }
        change(number) { copy(brick = (brick as RcxState).copy(glass = LcdGlass.of(memory))) }
    }

    fun draws(vararg places: Pair<Double, Double>, robot: Int = 0) = look {
        strokes = strokes + InkStroke(places.map { Point(it.first, it.second) }, robot)
        ink = Ink(strokes, strokes.sumOf(::lengthOf))
    }

    fun inkIs(ink: Ink) = look { this.ink = ink }

    fun plays(vararg hertz: Double, isFirmware: Boolean = false, number: Int = 0) {
        milliseconds += 10
        judge.observe(
            state,
            hertz.map { ProgramEvent(number, SoundEvent.Tone(milliseconds, it, 100, isFirmware)) },
        )
    }

    /** Advances time to this second. */
    fun until(seconds: Double) {
        milliseconds = (seconds * 1000).toLong() - 10
        look { }
    }

    fun finish() = judge.finish(state)

    private fun lengthOf(stroke: InkStroke) = stroke.points.zipWithNext { from, to ->
        length(
            to.x - from.x,
            to.y - from.y,
        )
    }.sum()

    private fun look(change: () -> Unit) {
        change()
        milliseconds += 10
        judge.observe(state, emptyList())
    }

    private fun change(number: Int, change: RobotSnapshot.() -> RobotSnapshot) {
        robots = robots.mapIndexed { index, robot -> if (index == number) robot.change() else robot }
    }
}

internal suspend fun run(vararg goals: Goal, world: World = sheet): Run =
    Run(world.copy(goals = goals.toList()), loadPhysicsEngine().trigonometry)
