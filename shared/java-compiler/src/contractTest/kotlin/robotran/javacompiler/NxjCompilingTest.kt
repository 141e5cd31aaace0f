package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.ecj.BrickTarget
import robotran.languagesupport.SourceFile
import robotran.nxjlibrary.NxjLibrary
import robotran.nxjlibrary.NxjSources
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Java for leJOS NXJ, on every platform that compiles it. */
class NxjCompilingTest {
    private suspend fun assertCompiles(vararg texts: String) {
        for (text in texts) {
            val result = compiledForNxt(text)
            assertEquals(emptyList(), result.warnings, text)
            for ((name, file) in result.classes) assertEquals(CLASS_FILE_VERSION, file[VERSION_PLACE].toInt(), name)
        }
    }

    @Test
    fun `generics, boxes and for-each compile`() = runTest {
        assertCompiles(
            nxtProgram(
                "List<Integer> list = new ArrayList<Integer>(); list.add(3); int sum = 0; for (int x : list) sum += x;",
            ),
            nxtProgram(
                "Map<String, List<Long>> m = new HashMap<String, List<Long>>(); for (String k : m.keySet()) m.get(k);",
            ),
            nxtProgram("Integer boxed = 3; boxed++; Object o = 'x'; long l = boxed; boolean same = boxed == 3;"),
            "class Pair<A extends Comparable<A>, B> { A a; B b; <C> C cast(C c) { return c; } }",
            "abstract class Base<T> { abstract T make(T t); } class Sub extends Base<String> { @Override String " +
                "make(String s) " +
                "{ return s; } }",
            "class Max { static <T extends Comparable<? super T>> T max(Iterable<? extends T> all) { T best = null; " +
                "for (T t : all) if (best == null || t.compareTo(best) > 0) best = t; return best; } }",
        )
    }

    @Test
    fun `enums and switch compile`() = runTest {
        assertCompiles(
            "enum Colour { RED, GREEN { @Override int weight() { return 5; } }; int weight() { return ordinal(); } } " +
                "class Robot { int of(Colour c) { switch (c) { case RED: return 1; default: return c.weight(); } } }",
            nxtProgram("int x = 3; switch (x) { case 1: case 3: x = 4; break; case 100000: break; default: x = 5; }"),
            "enum Side { LEFT, RIGHT; static Side of(String s) { return valueOf(s); } int count() { return " +
                "values().length; } }",
        )
    }

    @Test
    fun `varargs, static imports, annotations and assert compile`() = runTest {
        assertCompiles(
            "class Robot { static int add(int... all) { int s = 0; for (int a : all) s += a; return s; } int x " +
                "= add() + add(1, 2); }",
            "import static java.lang.Math.*; class Robot { double x = max(1, 2) * PI; }",
            "@interface Mark { String value() default \"x\"; } @Mark(\"y\") class Robot { " +
                "@SuppressWarnings(\"unused\") int x; }",
            nxtProgram("assert args.length == 0 : \"arguments\";"),
        )
    }

    @Test
    fun `override on methods of interfaces compiles`() = runTest {
        assertCompiles(
            "import lejos.nxt.*; class Robot implements ButtonListener { @Override public void " +
                "buttonPressed(Button b) {} " +
                "@Override public void buttonReleased(Button b) {} }",
            nxtProgram("new Thread(new Runnable() { @Override public void run() { Sound.beep(); } }).start();"),
        )
    }

    @Test
    fun `what an RCX cannot do compiles`() = runTest {
        assertCompiles(
            nxtProgram(
                "long l = System.currentTimeMillis(); l = l * 3 % 7; double d = 5.5 % 2; String t = \"\";" +
                    " while (t.length() < 5) t = t + d;",
            ),
            nxtProgram(
                "Object o = new int[3]; if (o instanceof int[]) { int[] a = ((int[]) o).clone(); } Class<?> k = " +
                    "String.class;",
            ),
            "class Robot { private synchronized void a() {} static synchronized void b() {} }",
            nxtProgram("label: for (int i = 0; ; i++) { try { if (i > 3) break label; } finally { i++; } }"),
        )
    }

    @Test
    fun `robots compile`() = runTest {
        assertCompiles(
            nxtProgram(
                "DifferentialPilot pilot = new DifferentialPilot(5.6, 11.2, Motor.A, Motor.C); " +
                    "UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S1); while (sonar.getDistance() > " +
                    "20 && " +
                    "!Button.ESCAPE.isDown()) { LCD.drawInt(sonar.getDistance(), 4, 0, 1); Delay.msDelay(20); " +
                    "pilot.travel(10); pilot.rotate(90); }",
            ),
        )
    }

    @Test
    fun `the class library is compiled to the bytes that the build makes of it`() = runTest {
        val library = NxjLibrary.load()
        val sources = NxjSources.load()
        for (name in library.classNames.filter { '$' !in it }) {
            val text = sources.source(name) ?: continue
            val source = listOf(SourceFile(name.substringAfterLast('/') + ".java", text))
            val result = compiler().compile(source, library.classFiles, target = BrickTarget.LEJOS_NXJ)
            for ((made, bytes) in assertIs<CompilationResult.Success>(result, name).classes) {
                assertTrue(bytes.contentEquals(library.classFile(made)), made)
            }
        }
    }

    @Test
    fun `the targets do not disturb each other`() = runTest {
        val forNxt = nxtProgram("List<String> l = new ArrayList<String>(); LCD.drawString(\"x\", 0, 0);")
        val forRcx = program("LCD.showNumber(3);")
        repeat(3) {
            assertIs<CompilationResult.Success>(compileForNxt(forNxt))
            assertIs<CompilationResult.Success>(compile(forRcx))
            assertIs<CompilationResult.Failure>(compile(forNxt))
            assertIs<CompilationResult.Failure>(compileForNxt(forRcx))
        }
    }

    @Test
    fun `the test programs of the library compile and can be run`() = runTest {
        val library = NxjLibrary.load()
        for ((path, text) in nxjPrograms) {
            val source = listOf(SourceFile(path.substringAfterLast('/'), text))
            val classes = if (path.startsWith(FORGIVING)) library.classFiles else library.classFilesOfBrick
            val result = compiler().compile(source, classes, target = BrickTarget.LEJOS_NXJ)
            val compiled = assertIs<CompilationResult.Success>(result, "$path: $result")
            assertEquals(null, compiled.missingMain, path)
        }
    }

    private companion object {
        /** The programs that use what leJOS NXJ lacks. */
        const val FORGIVING = "forgiving/"
        const val VERSION_PLACE = 7
        const val CLASS_FILE_VERSION = 50
    }
}
