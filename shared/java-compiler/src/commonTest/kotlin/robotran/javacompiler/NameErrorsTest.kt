package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull

class NameErrorsTest {
    @Test
    fun `a misspelt name is told with the one that is near`() = runTest {
        assertEquals("Motor.A.forward();", fixedStatements("Motor.A.foward();"))
        assertEquals("Motor.A.forward();", fixedStatements("Moter.A.forward();"))
        assertEquals(
            "int speed = 3; Motor.A.setPower(speed);",
            fixedStatements("int speed = 3; Motor.A.setPower(sped);"),
        )
        assertNull(diagnostic("int x = qqq;").fix)
    }

    @Test
    fun `small and capital letters are told from each other`() = runTest {
        assertEquals("Motor.A.forward();", fixedStatements("motor.A.forward();"))
        assertEquals("Motor.A.forward();", fixedStatements("Motor.a.forward();"))
        assertEquals("Motor.A.forward();", fixedStatements("Motor.A.Forward();"))
        assertEquals("LCD.showNumber(3);", fixedStatements("lcd.showNumber(3);"))
        assertEquals("String s;", fixedStatements("string s;"))
        assertEquals("int y;", fixedStatements("Int y;"))
        assertContains(diagnostic("motor.A.forward();").message, "capital")
    }

    @Test
    fun `a missing import is told with its line`() = runTest {
        val diagnostic = diagnostics("class Robot { void go() { Motor.A.forward(); } }").single()
        assertContains(diagnostic.message, "import josx.platform.rcx.*;")
        assertEquals(SourceFix(SourceRange(1, 1, 1), "import josx.platform.rcx.*;\n"), diagnostic.fix)
        val inPackage = "// package none;\npackage robots;\nclass Robot { Vector all; }"
        assertEquals(SourceFix(SourceRange(2, 16, 16), "\nimport java.util.*;"), diagnostics(inPackage).single().fix)
    }

    @Test
    fun `an import of what is not there is told with what was meant`() = runTest {
        suspend fun fixedImport(name: String) = diagnostics("import $name;\nclass Robot { }").single().fix?.replacement
        assertEquals("josx.platform.rcx.Motor", fixedImport("josx.platform.rcx.Moto"))
        assertEquals("josx.platform.rcx.Motor", fixedImport("josx.platform.rcx.motor"))
        assertEquals("josx.platform.rcx.Motor", fixedImport("Motor"))
        assertEquals("josx.platform.rcx", fixedImport("josx.platform.rxc.*"))
        assertNull(fixedImport("org.example.Robots"))
    }

    @Test
    fun `an unknown variable can be declared`() = runTest {
        assertContains(diagnostic("number = 1;").message, "int number = 0;")
    }

    @Test
    fun `an unknown method can be written`() = runTest {
        assertContains(diagnostic("turnAround();").message, "static void turnAround() { }")
    }

    @Test
    fun `what is private is told to be so`() = runTest {
        val other = SourceFile("Other.java", "class Other { private int count; private void go() { } }")
        for (use in listOf("new Other().count = 3;", "new Other().go();")) {
            val diagnostic = diagnostics(program(use), other).single()
            assertContains(diagnostic.message, "only \"Other\" itself")
            assertContains(diagnostic.message, "Take \"private\" away")
        }
    }

    @Test
    fun `what the library keeps to itself is not there`() = runTest {
        assertFalse("private" in diagnostic("Motor.A.power = 3;").message)
        assertContains(diagnostic("Motor.A.power = 3;").message, "has no \"power\"")
    }

    @Test
    fun `the length of a text has brackets and that of an array has none`() = runTest {
        assertContains(diagnostic("String s = null; int n = s.length;").message, "word.length()")
        assertEquals("int n = args.length;", fixedStatements("int n = args.length();"))
    }

    @Test
    fun `single values have no methods and texts no places`() = runTest {
        assertContains(diagnostic("int q = 1; q.go();").message, "no methods")
        assertContains(diagnostic("String s = \"a\"; char c = s[0];").message, "charAt(0)")
    }

    @Test
    fun `one mistake is told once where it is imported and once where it is used`() = runTest {
        assertEquals(
            listOf(1, 3),
            diagnostics("import java.util.ArrayList;\nclass Robot {\nArrayList a;\nArrayList b;\n}").map {
                it.range?.line
            },
        )
        assertEquals(1, diagnostics(program("int x = 1\nMotor.A.foo();")).size)
    }
}
