package robotran.tinyvm

import robotran.language.fuzz.Fuzzing
import kotlin.test.Test
import kotlin.test.assertTrue

class ClassFileFuzzTest {
    private val classes = JavaCompiler.compile(
        program(
            "int sum = 0; for (int i = 0; i < 20; i++) { sum += new Square(i).area() * (i % 3); Object o = new " +
                "int[i]; all[i] = o; }\n" +
                "long time = System.currentTimeMillis(); float x = 2.5f * sum; double y = x / 3; show((int) y);\n" +
                "try { synchronized (all) { all[20] = null; } } catch (ArrayIndexOutOfBoundsException e) { show(-1); " +
                "} finally { " +
                "show(2); }\n" +
                "String text = \"a\" + sum + (int) time; show(text.length()); int[][] grid = new int[2][3]; " +
                "grid[1][2] = sum; Shape " +
                "s = new Square(3);\n" +
                "show(s instanceof Square ? ((Square) s).side : 0); Thread thread = new Worker(); thread.start(); " +
                "Named named = new " +
                "Square(1);\n" +
                "show(named.name().length()); byte[] b = {1, 2}; char c = (char) b[1]; short h = (short) (c << 3); " +
                "show(h); one = " +
                "5L; show((int) one);",
            "static Object[] all = new Object[20]; static long one; static abstract class Shape { int side; String " +
                "name = " +
                "\"shape\"; abstract int area();" +
                "public String name() { return name; } } interface Named { String name(); }" +
                "static class Square extends Shape implements Named { Shape other = this; double half; Square(int " +
                "side) { this.side " +
                "= side; half = side / 2.0; }" +
                "int area() { return side * side; } } static class Worker extends Thread { Object held = new " +
                "Object[] { this };" +
                "public void run() { for (int i = 0; i < 5; i++) { show(i); try { sleep(3); } catch " +
                "(InterruptedException e) { " +
                "return; } } } }",
        ),
    )

    @Test
    fun `mutated class files never crash hang or confuse the machine`() {
        val run = Fuzzing.count(MUTANTS) { runMutant(classes, "Program", it) }
        assertTrue(run > Fuzzing.share(MUTANTS) / 20, "only $run mutants were sound enough to run")
    }

    private companion object {
        const val MUTANTS = 50_000
    }
}
