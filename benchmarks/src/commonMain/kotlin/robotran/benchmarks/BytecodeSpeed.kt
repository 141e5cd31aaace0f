package robotran.benchmarks

import robotran.brick.program.ProgramStatus
import robotran.programs.JavaSettings
import robotran.tinyvm.config.TinyVmSpeed

/** The bytecodes per second of the virtual machine, in a loop of arithmetic, field access, array elements and calls. */
internal suspend fun bytecodeSpeed(): Measurement {
    val speed = TinyVmSpeed.UNLIMITED
    val program = javaProgramOf("Mixed.java", MIXED, JavaSettings(speed = speed))
    val seconds =
        seconds {
            val run = program.start(SilentRom())
            repeat(RESUMES) { check(run.resume(STEPS) == ProgramStatus.Running) { "The loop came to an end." } }
        }
    val bytecodes = RESUMES.toLong() * STEPS * speed.bytecodesPerStep
    return Measurement(
        bytecodes / seconds / 1e6,
        "million bytecodes/s",
        "${bytecodes / 1_000_000} million in ${rounded(seconds)} s",
    )
}

/** An endless loop without allocations, since the brick has no garbage collection. */
internal val MIXED =
    """
    public class Mixed {
        private int[] past = new int[16];
        private int sum;
        private static int rounds;

        public static void main(String[] args) {
            Mixed mixed = new Mixed();
            for (;;) {
                for (int index = 0; index < 16; index++) mixed.step(index);
                rounds++;
            }
        }

        private void step(int index) {
            past[index] = past[index] * 31 + index;
            if ((past[index] & 1) == 0) sum = sum + past[index];
            else sum = mixed(sum, index);
        }

        private static int mixed(int value, int index) {
            return (value << 3) - (value >> 2) + index % 7;
        }
    }
    """.trimIndent()

private const val RESUMES = 2_000

/** As many steps as one frame at 60 frames per second needs. */
private const val STEPS = 32
