package robotran.tinyvm

import robotran.rom.ProgramStatus
import robotran.tinyvm.programs.libraryClassFiles
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class MutatedClassFileTest {
    private val classes = JavaCompiler.compile(
        program(
            "int sum = 0; for (int i = 0; i < 20; i++) { sum += new Square(i).area() * (i % 3); Object o = new int[i]; all[i] = o; }\n" +
                "long time = System.currentTimeMillis(); float x = 2.5f * sum; double y = x / 3; show((int) y);\n" +
                "try { synchronized (all) { all[20] = null; } } catch (ArrayIndexOutOfBoundsException e) { show(-1); } finally { " +
                "show(2); }\n" +
                "String text = \"a\" + sum + (int) time; show(text.length()); int[][] grid = new int[2][3]; grid[1][2] = sum; Shape " +
                "s = new Square(3);\n" +
                "show(s instanceof Square ? ((Square) s).side : 0); Thread thread = new Worker(); thread.start(); Named named = new " +
                "Square(1);\n" +
                "show(named.name().length()); byte[] b = {1, 2}; char c = (char) b[1]; short h = (short) (c << 3); show(h); one = " +
                "5L; show((int) one);",
            "static Object[] all = new Object[20]; static long one; static abstract class Shape { int side; String name = " +
                "\"shape\"; abstract int area();" +
                "public String name() { return name; } } interface Named { String name(); }" +
                "static class Square extends Shape implements Named { Shape other = this; double half; Square(int side) { this.side " +
                "= side; half = side / 2.0; }" +
                "int area() { return side * side; } } static class Worker extends Thread { Object held = new Object[] { this };" +
                "public void run() { for (int i = 0; i < 5; i++) { show(i); try { sleep(3); } catch (InterruptedException e) { " +
                "return; } } } }",
        ),
    )

    /** One byte in a class file, or a few, is another; half of them in the latter part, where the code is. */
    @Test
    fun `mutated class files never crash hang or confuse the machine`() {
        val random = Random(5)
        var run = 0
        repeat(MUTANTS) {
            val name = classes.keys.random(random)
            val bytes = classes.getValue(name).copyOf()
            repeat(1 + random.nextInt(3)) {
                val first = if (random.nextBoolean()) bytes.size / 3 else 8
                bytes[random.nextInt(first, bytes.size)] =
                    if (random.nextInt(3) == 0) random.nextInt(12).toByte() else random.nextInt().toByte()
            }
            val mode = if (random.nextInt(8) == 0) TinyVmMode.FORGIVING else TinyVmMode.BRICK
            val result = linkTinyVm("mutant $it", classes + (name to bytes), libraryClassFiles, "Program", mode)
            if (result is TinyVmResult.Ready) {
                runMutant(result.program)
                run++
            }
        }
        assertTrue(run > MUTANTS / 20, "only $run mutants were sound enough to run")
    }

    private fun runMutant(program: TinyVmProgram) {
        val rom = ShowingRom()
        val run = program.start(rom)
        for (round in 1..ROUNDS) {
            rom.milliseconds += 2
            val status = run.resume(STEPS)
            if (status == ProgramStatus.Ended || status is ProgramStatus.Failed) break
        }
        run.callStack
        run.variables
        run.threads
        checkHeap(run)
    }

    private companion object {
        const val MUTANTS = 50_000
        const val ROUNDS = 20
        const val STEPS = 50
    }
}
