package robotran.benchmarks

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.nxt.FakeNxt
import robotran.nxt.program.NxtProgram
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.ReadyRobots
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/** The bytecodes per second of the machine of an NXT, in the same loop as [bytecodeSpeed]. */
internal suspend fun nxjBytecodeSpeed(): Measurement = nxjSpeed("Mixed", MIXED)

/** The same in a loop with numbers of 64 bits. Some operations take the time of several bytecodes. */
internal suspend fun nxjDoubleSpeed(): Measurement = nxjSpeed("Doubles", DOUBLES)

/** The same in a loop that makes objects, which the collector takes back. */
internal suspend fun nxjObjectSpeed(): Measurement = nxjSpeed("Objects", OBJECTS)

/** The speed relative to real time of a session in which a Java program on an NXT follows a line. */
internal suspend fun nxjLineFollowerSpeed(): Measurement {
    val world = (
        readWorld(
            BuiltInWorlds.texts.getValue("line-loop.world.json"),
            Language.ENGLISH,
        ) as WorldFileResult.Success
    ).world
    val robots = world.robots.map { it.copy(description = ReadyRobots.NXT_PENBOT) }
    val program = nxjProgramOf("LineFollower", LINE_FOLLOWER_NXJ)
    return realTime(running(program, world.copy(robots = robots), loadPhysicsEngine()))
}

private suspend fun nxjSpeed(name: String, source: String): Measurement {
    val program = nxjProgramOf(name, source, JavaSettings(speed = TinyVmSpeed.UNLIMITED))
    val bytecodesPerStep = NxtCosts.UNLIMITED_BYTECODES_PER_MILLISECOND / NxtCosts.STEPS_PER_MILLISECOND
    val seconds = seconds {
        val nxt = FakeNxt()
        val run = program.start(nxt)
        repeat(RESUMES) {
            check(run.resume(STEPS) == ProgramStatus.Running) { "The loop came to an end." }
            nxt.advance(1)
        }
    }
    val bytecodes = RESUMES.toLong() * STEPS * bytecodesPerStep
    return Measurement(
        bytecodes / seconds / 1e6,
        "million bytecodes/s",
        "${bytecodes / 1_000_000} million in ${rounded(seconds)} s",
    )
}

/** The valid Java program [source] for an NXT, compiled and linked. */
private suspend fun nxjProgramOf(name: String, source: String, settings: JavaSettings = JavaSettings()): NxtProgram {
    val target = RobotTarget.Nxt(wheelDiameter = 5.6, track = 11.4)
    val program = Program.of("$name.java", source)
    return when (val result = ProgramCompiler(target, settings, Language.ENGLISH).compileOrThrow(program)) {
        is ProgramResult.Success -> result.program as NxtProgram
        is ProgramResult.Failure -> error(result.diagnostics.first().message)
    }
}

private val DOUBLES =
    """
    import lejos.nxt.*;

    public class Doubles {
        private static double[] past = new double[16];
        private static long rounds;

        public static void main(String[] args) {
            double x = 0;
            while (!Button.ESCAPE.isPressed()) {
                for (int index = 0; index < 16; index++) {
                    x = x * 0.75 + index;
                    past[index] = (past[index] + x) / 2;
                    if (past[index] > 10.5) rounds += index;
                    else rounds ^= index * 31L;
                }
                x = x - half(x);
            }
        }

        private static double half(double value) {
            return value * 0.5;
        }
    }
    """.trimIndent()

private val OBJECTS =
    """
    import java.util.ArrayList;
    import lejos.nxt.*;

    public class Objects {
        private final int x;
        private final int y;

        Objects(int x, int y) {
            this.x = x;
            this.y = y;
        }

        Objects plus(Objects other) {
            return new Objects(x + other.x, y + other.y);
        }

        public static void main(String[] args) {
            ArrayList<Objects> steps = new ArrayList<Objects>();
            for (int index = 0; index < 8; index++) steps.add(new Objects(index, 2 * index));
            Objects place = new Objects(0, 0);
            while (!Button.ESCAPE.isPressed()) {
                for (Objects step : steps) place = place.plus(step);
            }
        }
    }
    """.trimIndent()

/** Steers by how bright the floor is, and looks again as often as it can. */
private val LINE_FOLLOWER_NXJ =
    """
    import lejos.nxt.*;

    public class LineFollower {
        public static void main(String[] args) {
            LightSensor light = new LightSensor(SensorPort.S3);
            Motor.A.forward();
            Motor.C.forward();
            int rounds = 0;
            while (!Button.ESCAPE.isPressed()) {
                int error = light.getLightValue() - 45;
                Motor.A.setSpeed(Math.max(20, 200 + 15 * error));
                Motor.C.setSpeed(Math.max(20, 200 - 15 * error));
                if (++rounds % 20 == 0) LCD.drawInt(error, 4, 0, 0);
            }
        }
    }
    """.trimIndent()

private const val RESUMES = 2_000

/** All of a millisecond. */
private const val STEPS = NxtCosts.STEPS_PER_MILLISECOND
