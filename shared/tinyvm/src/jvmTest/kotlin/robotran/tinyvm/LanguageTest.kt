package robotran.tinyvm

import robotran.tinyvm.config.TinyVmMode
import kotlin.test.Test
import kotlin.test.assertEquals

class LanguageTest {
    @Test
    fun `whole numbers are calculated with`() = assertEquals(
        listOf(7, -1, 12, 2, -3, 7, 1, -8, 40, 15, 6, -2),
        shownBy(
            "int a = 3, b = 4; show(a + b); show(a - b); show(a * b); show(9 / b); show(-a); show(a | b ^ 2 & 3 | 5);" +
                "show(9 % b); show(-32 >> 2); show(10 << 2); show((-1 >>> 28)); b += 2; show(b); b += 1000; b -= " +
                "1000; show((byte) 254);",
        ),
    )

    @Test
    fun `decimal numbers are calculated with`() = assertEquals(
        listOf(2, 7, 1, 0, 25, -3),
        shownBy(
            "float x = 2.5f; double y = 5.0; show((int) x); show((int) (x + y)); show(x < y); show(x >= y);" +
                "show((int) (x * 10)); show((int) -(y * 0.7));",
        ),
    )

    @Test
    fun `long and double are passed kept and returned`() = assertEquals(
        listOf(7, 11, 3, 1),
        shownBy(
            "show((int) second(1, 7L)); value = 11; show((int) value); long[] many = {1, 2, 3}; show((int) many[2]); " +
                "show((int) " +
                "half(2.5));",
            "static long value; static long second(int a, long b) { long c = b; return c; } static double " +
                "half(double x) { return x " +
                "/ 2; }",
        ),
    )

    @Test
    fun `methods call each other and themselves`() = assertEquals(
        listOf(55, 120),
        shownBy(
            "show(fib(10)); show(fac(5));",
            "static int fib(int n) { return n < 2 ? n : fib(n - 1) + fib(n - 2); } static int fac(int n) { " +
                "return n == 0 ? 1 : " +
                "n * fac(n - 1); }",
        ),
    )

    @Test
    fun `objects override methods and implement interfaces`() = assertEquals(
        listOf(1, 2, 3, 4, 6),
        shownBy(
            "Shape a = new Shape(); Shape b = new Square(); show(a.sides()); show(b.sides()); Named n = new " +
                "Square(); show(n.name());" +
                "show(((Square) b).twice()); show(new Named() { public int name() { return 6; } }.name());",
            "static class Shape { int sides() { return 1; } } interface Named { int name(); }" +
                "static class Square extends Shape implements Named { int sides() { return super.sides() + 1; } " +
                "public int name() { " +
                "return 3; }" +
                "int twice() { return sides() * 2; } }",
        ),
    )

    @Test
    fun `inner classes see what is around them`() = assertEquals(
        listOf(5, 12),
        shownBy(
            "Outer outer = new Outer(); outer.makeInner().add(); show(outer.count);" +
                "final int ten = 10; Adder adder = new Adder() { int add(int x) { return x + ten; } }; " +
                "show(adder.add(2));",
            "static class Outer { int count = 4; class Inner { void add() { count++; } } Inner makeInner() { return " +
                "new Inner(); } }" +
                " static abstract class Adder { abstract " +
                "int add(int x); }",
        ),
    )

    @Test
    fun `arrays hold numbers objects and arrays`() = assertEquals(
        listOf(3, 6, 12, -1, 65, 1, 4),
        shownBy(
            "int[] a = {1, 2, 3}; show(a.length); a[1] += 4; show(a[1]); int[][] grid = new int[3][4]; grid[2][3] = " +
                "12; " +
                "show(grid[2][3]);" +
                "byte[] bytes = new byte[2]; bytes[0] = (byte) 255; show(bytes[0]); char[] chars = {'A'}; " +
                "show(chars[0]);" +
                "Object[] objects = new Object[2]; objects[1] = a; show(objects[0] == null); show(grid[0].length);",
        ),
    )

    @Test
    fun `exceptions are caught and finally is done`() = assertEquals(
        listOf(1, 2, 10, 3, 4, 5),
        shownBy(
            "try { show(1); int x = 1 / zero; show(99); } catch (ArithmeticException e) { show(2); } finally { " +
                "show(10); }" +
                "try { Object o = null; o.toString(); } catch (NullPointerException e) { show(3); }" +
                "try { int[][] a = new int[2][2]; a[1][2] = 3; } catch (ArrayIndexOutOfBoundsException e) { " +
                "show(4); }" +
                "try { Object o = \"x\"; ((Thread) o).start(); } catch (ClassCastException e) { show(5); }",
            "static int zero;",
        ),
    )

    @Test
    fun `an own exception carries its message through calls`() = assertEquals(
        listOf(7, 4),
        shownBy(
            "try { fail(); } catch (Exception e) { show(7); show(e.getMessage().length()); }",
            "static class Own extends Exception { Own() { super(\"oops\"); } } static void fail() throws Own { throw " +
                "new Own(); }",
        ),
    )

    @Test
    fun `classes are made ready when they are first used`() {
        val body = "show(1); Late late = new Late(); show(2); show(Late.value);"
        val members = "static class Early { static { show(10); } } " +
            "static class Late extends Early { static int value = 5; static { show(20); } }"
        assertEquals(listOf(1, 20, 10, 2, 5), shownBy(body, members))
        assertEquals(listOf(1, 10, 20, 2, 5), shownBy(body, members, TinyVmMode.FORGIVING))
    }

    @Test
    fun `texts are joined`() = assertEquals(
        listOf(6, 'a'.code, '4'.code, 0),
        shownBy(
            "int n = -42; String text = \"a\" + n + \"bc\"; show(text.length()); show(text.charAt(0)); " +
                "show(text.charAt(2)); " +
                "show(hello() == hello());",
            "static String hello() { return \"hello\"; }",
        ),
    )

    @Test
    fun `a program in forgiving mode has its texts once`() = assertEquals(
        listOf(1),
        shownBy("show(hello() == hello());", "static String hello() { return \"hello\"; }", TinyVmMode.FORGIVING),
    )

    @Test
    fun `a program leaves loops by labels and conditions`() = assertEquals(
        listOf(12),
        shownBy(
            "int sum = 0; outer: for (int i = 0; ; i++) { for (int j = 0; j < 4; j++) { if (i == 3) break outer; if " +
                "(j == 2) " +
                "continue outer;" +
                "sum += i + j + (i > 1 && j > 0 || i == 0 ? 1 : 0); } } show(sum);",
        ),
    )
}
