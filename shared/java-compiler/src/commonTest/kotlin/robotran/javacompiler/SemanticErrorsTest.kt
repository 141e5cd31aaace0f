package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class SemanticErrorsTest {
    private suspend fun hint(statements: String) = diagnostic(statements).message

    @Test
    fun `a single equals sign in a condition becomes two`() = runTest {
        assertEquals("int x = 1; if (x == 1) { }", fixedStatements("int x = 1; if (x = 1) { }"))
    }

    @Test
    fun `numbers that do not fit are cast`() = runTest {
        assertEquals("float x = 1.5f;", fixedStatements("float x = 1.5;"))
        assertEquals("int x = (int) (Math.random() * 3);", fixedStatements("int x = Math.random() * 3;"))
        assertEquals("int x = (int) Math.sqrt(2);", fixedStatements("int x = Math.sqrt(2);"))
        assertContains(hint("int n = Math.round(3.4);"), "(float)")
        assertContains(diagnostic("int n = 99999999999;").message, "2147483647")
    }

    @Test
    fun `an object of a Vector is cast to what it is`() = runTest {
        val vector = "java.util.Vector v = new java.util.Vector();"
        assertEquals(
            "$vector String s = (String) v.elementAt(0);",
            fixedStatements("$vector String s = v.elementAt(0);"),
        )
    }

    @Test
    fun `other types that do not fit come with advice`() = runTest {
        assertContains(hint("int x = 1; if (x) { }"), "count > 0")
        assertContains(hint("String s = 3;"), "Integer.toString(")
        assertContains(hint("TextLCD.print(3);"), "Integer.toString(")
        assertContains(diagnostic("int x = nothing(); } static void nothing() {").message, "void")
        assertContains(diagnostic("boolean b = 3 & true;").message, "\"int, boolean\"")
        assertContains(diagnostic("Motor.A.setPower();").message, "setPower(int)")
    }

    @Test
    fun `an exception that nothing takes care of is passed on or caught`() = runTest {
        val text = "class Robot {\nvoid go() {\n  Thread.sleep(10);\n}\n}"
        val diagnostic = diagnostics(text).single()
        assertContains(diagnostic.message, "throws InterruptedException")
        assertContains(diagnostic.message, "catch (InterruptedException e)")
        compiled(withFix(text, assertNotNull(diagnostic.fix)))
        assertNull(diagnostics("class Robot { void go() { if (true) Thread.sleep(10); } }").single().fix)
    }

    @Test
    fun `a catch of what cannot happen is told`() = runTest {
        assertContains(hint("try { } catch (InterruptedException e) { }"), "Take this \"catch\" away")
        assertContains(
            hint("try { Thread.sleep(3); } catch (Exception e) { } catch (InterruptedException e) { }"),
            "Take this",
        )
    }

    @Test
    fun `a method gives back what it says`() = runTest {
        assertContains(memberDiagnostic("int f(int x) { if (x > 3) return 1; }").message, "return")
        assertContains(memberDiagnostic("void f() { return 3; }").message, "void")
        val text = "class Robot {\npublic static main(String[] args) { }\n}"
        compiled(withFix(text, assertNotNull(diagnostics(text).single().fix)))
    }

    @Test
    fun `what is never reached is told`() = runTest {
        assertContains(diagnostic("while (true) { }\nint y = 3;").message, "never gets here")
        assertContains(diagnostic("return;\nint y = 3;").message, "never gets here")
    }

    @Test
    fun `variables have a value before they are read and one declaration`() = runTest {
        assertContains(diagnostic("int x; x++;").message, "no value yet")
        assertContains(diagnostic("int x = 1; int x = 2;").message, "declared already")
        assertContains(diagnostic("final int x = 1; x = 2;").message, "only once")
        assertContains(memberDiagnostic("static final int X = 1; void f() { X = 2; }").message, "only once")
        assertContains(memberDiagnostic("int q;\nint q;").message, "declared already")
        assertContains(memberDiagnostic("void f() { }\nvoid f() { }").message, "declared already")
        assertContains(diagnostics("class A { }\nclass A { }").single().message, "declared already")
    }

    @Test
    fun `what belongs to an object is not reached from a static method`() = runTest {
        assertContains(memberDiagnostic("int n; static void f() { n = 3; }").message, "\"static\"")
        assertContains(memberDiagnostic("void g() { } static void f() { g(); }").message, "\"static\"")
        assertContains(memberDiagnostic("static void f() { this.toString(); }").message, "\"this\"")
        assertContains(diagnostic("Motor.setPower(3);").message, "object of \"Motor\"")
    }

    @Test
    fun `classes have the methods that they must have`() = runTest {
        assertContains(diagnostics("class Robot extends Thread { }").single().message, "public void run()")
        assertContains(diagnostics("class Robot extends Thread { void run() { } }").single().message, "\"public\"")
        assertContains(
            diagnostics("interface X { } class Robot { X x = new X(); }").single().message,
            "is a X",
        )
    }

    @Test
    fun `a public class is called like its file`() = runTest {
        assertContains(diagnostics("public class Other { }").single().message, "\"Other.java\"")
    }
}
