package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.Diagnostic
import kotlin.test.Test
import kotlin.test.assertTrue

/** A fix that is offered leaves a program with fewer mistakes and none that is new. */
class JavaFixesTest {
    private val statements = listOf(
        "wait(500);",
        "int x = 09;",
        "float f = 1,5;",
        "double d = 3,14;",
        "int i = 1,5;",
        "Thread.sleep(0.5);",
        "Thread.sleep(1,5);",
        "int x = 5.5;",
        "int x = 5.0;",
        "int way1 = 1; way2 = 3;",
        "int wall = 1; int walk = 2; int x = walt;",
        "for (int i = 0; i < 5; i++); { int k = i; }",
        "int i = 0; while (i < 3); { i++; }",
        "int i = 0; if i > 2 { }",
        "while true { }",
        "int class = 5;",
        "int x = 1; if (x =< 2) { }",
        "boolean b = 1 \u2264 2 && 2 \u2260 3;",
        "String s = \u201Ehi\u201C;",
        "int x = 1\nint y = 2;",
        "int x = (3;",
        "String s = 'hello';",
        "boolean b = True;",
        "boolean b = true and false;",
        "int speed = 1; sped = 2;",
        "drive(20);",
        "/* open\nint x = 1;",
        "int x = 1; x == 3;",
        "if (2 > 1) then { }",
    )
    private val ofRcx = listOf(
        "Motor.A.foward();",
        "Motor.A.run();",
        "Motor.A.setPower(5.0);",
        "S1.activate();",
        "Sensor.S4.activate();",
        "if (Sensor.S1.readBooleanValue) { }",
        "LCD.clear;",
    )
    private val ofNxt = listOf(
        "Motor.A.setSpeed = 300;",
        "if (!Motor.A.isMoving) { }",
        "if (Motor.A.isMoving = true) { }",
        "new TouchSensor(S1);",
        "new TouchSensor(SensorPort.S5);",
        "new TouchSensor(SensorPort.5);",
        "Motor.A.on();",
        "new TouchSensor();",
        "new UltrasonicSensor(4);",
        "new Motor();",
        "new UltrasonicSensor(SensorPort.S1).distance();",
        "Motor.A.setSpeed(2,5);",
        "Motor.A.rotate(\u221290);",
    )
    private val sources = listOf(
        "Public Class Robot {\n}\n",
        "Public Class Robot {\npublic static void main(String[] args) {\nint x = 1;\n}\n}\n",
        "public class My Robot {\n}\n",
        "void drive() { }\npublic class Robot { }\n",
        "public class Robot {\nint x = 1;\nx = 2;\n}\n",
        "public class Robot {\nvoid a() {\nvoid b() { }\n}\n}\n",
        "public class Robot extends Thread {\npublic void run() throws InterruptedException { }\n}\n",
    )

    @Test
    fun `each fix for an RCX leaves fewer mistakes`() = runTest {
        for (text in (statements + ofRcx).map(::program) + sources) check(text) { errorsOf(compile(it)) }
    }

    @Test
    fun `each fix for an NXT leaves fewer mistakes`() = runTest {
        for (text in (statements + ofNxt).map(::nxtProgram) + sources) check(text) { errorsOf(compileForNxt(it)) }
    }

    /** The errors or warnings: a semicolon behind `while (...)` is Java, but hardly ever what was meant. */
    private fun errorsOf(result: CompilationResult): List<Diagnostic> = when (result) {
        is CompilationResult.Success -> result.warnings
        is CompilationResult.Failure -> result.diagnostics
    }

    private suspend fun check(text: String, errors: suspend (String) -> List<Diagnostic>) {
        val before = errors(text)
        assertTrue(before.isNotEmpty(), text)
        for (fix in before.mapNotNull { it.fix }) {
            val fixed = withFix(text, fix)
            val after = errors(fixed)
            assertTrue(after.size < before.size, "$fixed\n${after.joinToString("\n") { it.message }}")
        }
    }
}
