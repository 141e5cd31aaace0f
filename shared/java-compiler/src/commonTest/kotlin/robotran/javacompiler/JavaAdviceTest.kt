package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.Diagnostic
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

/** What pupils wrote, and what helps them. */
class JavaAdviceTest {
    private fun withNxtFix(statements: String, diagnostic: Diagnostic) =
        withFix(nxtProgram(statements), assertNotNull(diagnostic.fix, statements))
            .substringAfter("Exception {\n").removeSuffix("\n}\n}\n")

    private suspend fun fixedForNxt(statements: String) = withNxtFix(statements, nxtDiagnostic(statements))

    @Test
    fun `wait in main becomes a sleep, and notify needs an object`() = runTest {
        assertContains(diagnostic("wait(500);").message, "Thread.sleep(500)")
        assertEquals("Thread.sleep(500);", fixedStatements("wait(500);"))
        assertEquals("Thread.sleep(500);", fixedForNxt("wait(500);"))
        assertContains(diagnostic("notify();").message, "lock.notify()")
        assertContains(nxtDiagnostic("notifyAll();").message, "lock.notifyAll()")
    }

    @Test
    fun `a method that is inherited needs an object of the class`() = runTest {
        val text = "public class Robot extends Thread {\npublic void run() { }\n" +
            "public static void main(String[] args) {\nstart();\n}\n}"
        assertContains(diagnostics(text).single().message, "new Robot().start()")
        val own = "public class Robot {\nvoid go() { }\npublic static void main(String[] args) {\ngo();\n}\n}"
        assertContains(diagnostics(own).single().message, "Write \"static\"")
    }

    @Test
    fun `a method without its brackets gets them`() = runTest {
        assertEquals(
            "TouchSensor t = new TouchSensor(SensorPort.S1); if (t.isPressed()) Motor.A.stop();",
            fixedForNxt("TouchSensor t = new TouchSensor(SensorPort.S1); if (t.isPressed) Motor.A.stop();"),
        )
        assertEquals("if (!Motor.A.isMoving()) Motor.A.stop();", fixedForNxt("if (!Motor.A.isMoving) Motor.A.stop();"))
        assertEquals("if (Motor.A.isMoving() == true) { }", fixedForNxt("if (Motor.A.isMoving = true) { }"))
        assertEquals("Motor.A.setSpeed(300);", fixedForNxt("Motor.A.setSpeed = 300;"))
        assertContains(nxtDiagnostic("Motor.A.setSpeed = 300;").message, "is a method")
        assertEquals(
            "if (Sensor.S1.readBooleanValue()) Motor.A.stop();",
            fixedStatements("if (Sensor.S1.readBooleanValue) Motor.A.stop();"),
        )
    }

    @Test
    fun `constants of a brick are told with their class`() = runTest {
        assertEquals("new TouchSensor(SensorPort.S1);", fixedForNxt("new TouchSensor(S1);"))
        assertEquals("Motor.A.forward();", fixedForNxt("A.forward();"))
        assertEquals("if (Sensor.S1.readBooleanValue()) { }", fixedStatements("if (S1.readBooleanValue()) { }"))
        assertEquals("Button.VIEW.isPressed();", fixedStatements("VIEW.isPressed();"))
        val without = diagnostics("class Robot { void f() { S1.activate(); } }").first()
        assertContains(without.message, "Sensor.S1")
        assertNull(without.fix, "another import would be missing then")
    }

    @Test
    fun `what is made in another way is told how`() = runTest {
        assertContains(nxtDiagnostic("new TouchSensor();").message, "new TouchSensor(SensorPort.S1)")
        assertEquals("new UltrasonicSensor(SensorPort.S4);", fixedForNxt("new UltrasonicSensor(4);"))
        assertContains(nxtDiagnostic("Motor m = new Motor();").message, "Motor.A, Motor.B, Motor.C")
        assertContains(nxtDiagnostic("new NXTMotor();").message, "MotorPort.A")
        val text = "class Robot {\nRobot(int speed, String name) { }\nObject o = new Robot();\n}"
        assertContains(diagnostics(text).single().message, "new Robot(int, String)")
    }

    @Test
    fun `a method of the class is never named by its class`() = runTest {
        val text = "public class Drive {\npublic static void main(String[] args) {\ndrive(20, \"x\");\n}\n}"
        val diagnostic = diagnostics(text).last()
        assertContains(diagnostic.message, "static void drive(int a, String b) { }")
        assertNull(diagnostic.fix)
    }

    @Test
    fun `a method whose first word is missing is found`() = runTest {
        val sonar = "UltrasonicSensor u = new UltrasonicSensor(SensorPort.S4);"
        assertEquals("$sonar int d = u.getDistance();", fixedForNxt("$sonar int d = u.distance();"))
        assertEquals(
            "TouchSensor t = new TouchSensor(SensorPort.S1); if (t.isPressed()) { }",
            fixedForNxt("TouchSensor t = new TouchSensor(SensorPort.S1); if (t.pressed()) { }"),
        )
    }

    @Test
    fun `a number that begins with 0 loses it`() = runTest {
        assertEquals("int x = 9;", fixedStatements("int x = 09;"))
        assertContains(diagnostic("int x = 3000000000;").message, "too large")
        assertContains(diagnostic("int x = 0999999999999;").message, "too large")
    }

    @Test
    fun `a decimal comma becomes a point`() = runTest {
        assertEquals("float f = 1.5f;", fixedStatements("float f = 1,5;"))
        assertEquals("double d = 3.14;", fixedStatements("double d = 3,14;"))
        assertContains(diagnostic("Thread.sleep(1,5);").message, "a point, not a comma: 1.5")
        assertNull(diagnostic("Thread.sleep(1,5);").fix, "milliseconds are whole")
        assertContains(nxtDiagnostic("Motor.A.setSpeed(2,5);").message, "2.5")
        assertContains(diagnostic("int x = 1,5;").message, "1.5")
        compiled(program("int[] x = {1,5};"))
    }

    @Test
    fun `seconds become milliseconds`() = runTest {
        assertContains(diagnostic("Thread.sleep(0.5);").message, "milliseconds")
        assertEquals("Thread.sleep(500);", fixedStatements("Thread.sleep(0.5);"))
        assertEquals("Thread.sleep(1250);", fixedStatements("Thread.sleep(1.25);"))
        assertEquals("Delay.msDelay(200);", fixedForNxt("Delay.msDelay(.2);"))
    }

    @Test
    fun `a number with a point is not cut where a whole one is needed`() = runTest {
        val declared = diagnostic("int x = 5.5;")
        assertContains(declared.message, "5.5 has a point, and \"int\" holds whole numbers only. ")
        assertContains(declared.message, "such as 5. For numbers with a point")
        assertContains(declared.message, "float x = 5.5f;")
        assertNull(declared.fix, "5 is another number")
        compiled(program("float x = 5.5f;"))
        assertContains(nxtDiagnostic("int x = 1; x = -.5;").message, "such as 0.")
        assertContains(nxtDiagnostic("int x; x = 2.5;").message, "double x = 2.5;")
        assertEquals("long x = 5;", fixedForNxt("long x = 5.0;"))
        assertEquals("Motor.A.setPower(3);", fixedStatements("Motor.A.setPower(3.0);"))
        assertContains(diagnostic("Motor.A.setPower(3.5);").message, "such as 3.")
        assertNull(diagnostic("Motor.A.setPower(3.5);").fix)
        assertEquals("int x = 1; int y = (int) (x * 0.5);", fixedStatements("int x = 1; int y = x * 0.5;"))
    }

    @Test
    fun `another one of a series is told, not taken for the one that is meant`() = runTest {
        val ports = nxtDiagnostic("new TouchSensor(SensorPort.S5);")
        assertContains(ports.message, "SensorPort.S1, SensorPort.S2, SensorPort.S3, SensorPort.S4")
        assertContains(nxtDiagnostic("new TouchSensor(S5);").message, "SensorPort.S4")
        assertContains(diagnostic("Sensor.S4.activate();").message, "Sensor.S1, Sensor.S2, Sensor.S3")
        assertContains(diagnostic("Motor.D.forward();").message, "Motor.A, Motor.B, Motor.C")
        val others = listOf("new TouchSensor(SensorPort.S5);", "new TouchSensor(S0);", "Motor.D.forward();")
        for (statement in others) assertNull(nxtDiagnostic(statement).fix, statement)
        assertContains(diagnostic("int way1 = 1; way2 = 3;").message, "int way2 = 0;")
        assertNull(diagnostic("int pointA = 1; int x = pointB;").fix)
    }

    @Test
    fun `of several names that are as near none is put in`() = runTest {
        assertContains(diagnostic("int wall = 1; int walk = 2; int x = walt;").message, "Did you mean")
        assertNull(diagnostic("int wall = 1; int walk = 2; int x = walt;").fix)
    }

    @Test
    fun `what turns a motor on is told for the words of other robots`() = runTest {
        for (command in listOf("run()", "on()", "start()")) {
            assertContains(diagnostic("Motor.A.$command;").message, "\"Motor\" has no method", message = command)
            assertContains(diagnostic("Motor.A.$command;").message, "Motor.A.forward();")
            assertContains(nxtDiagnostic("Motor.A.$command;").message, "Motor.A.forward();")
        }
        assertContains(diagnostic("Motor.A.rotate(90);").message, "counts no degrees")
        assertContains(diagnostic("Motor.A.setSpeed(300);").message, "setPower()")
        assertContains(nxtDiagnostic("Motor.A.turn(90);").message, "rotate(90)")
    }

    @Test
    fun `a class that is used like a value is told as such, not as missing`() = runTest {
        val diagnostic = nxtDiagnostic("new TouchSensor(SensorPort.5);")
        assertContains(diagnostic.message, "is a class")
        assertContains(diagnostic.message, "SensorPort.S1")
        assertNull(diagnostic.fix, "it is imported already")
    }

    @Test
    fun `a whole number that does not fit is not cut`() = runTest {
        assertContains(diagnostic("byte b = 300;").message, "300 does not fit into \"byte\".")
        assertNull(diagnostic("byte b = 300;").fix, "it would be 44")
        assertNull(nxtDiagnostic("short s = -40000;").fix)
    }

    @Test
    fun `parts of a brick that it does not have are told with those it has`() = runTest {
        assertContains(diagnostic("Button.ENTER.isPressed();").message, "Button.RUN, Button.VIEW")
        assertContains(nxtDiagnostic("Button.A.isDown();").message, "Button.ENTER, Button.LEFT")
        val light = nxtDiagnostic("new LightSensor(SensorPort.S1).getValue();")
        assertContains(light.message, "\"getLightValue\"")
        assertNull(light.fix)
    }

    @Test
    fun `brackets with too little or too much are told with the method`() = runTest {
        assertContains(diagnostic("Motor.A.setPower();").message, "in its brackets, as in: setPower(int)")
        assertContains(diagnostic("Motor.A.forward(5);").message, "has nothing in its brackets: forward()")
    }

    @Test
    fun `a loop that a semicolon cuts short is told at the semicolon`() = runTest {
        val statements = "for (int i = 0; i < 5; i++); { LCD.showNumber(i); }"
        assertContains(diagnostic(statements).message, "is all that is done here")
        assertEquals("for (int i = 0; i < 5; i++) { LCD.showNumber(i); }", fixedStatements(statements))
        assertContains(diagnostic("for (int i = 0; i < 5; i++) { }\nLCD.showNumber(i);").message, "no variable \"i\"")
    }

    @Test
    fun `a comment that does not end is told where it begins`() = runTest {
        val diagnostic = diagnostics(program("/* open comment\nMotor.A.stop();")).single()
        assertEquals(4, diagnostic.range?.line)
        assertContains(diagnostic.message, "does not end")
    }

    @Test
    fun `a method announces no more than the one that it replaces`() = runTest {
        val text = "public class Robot extends Thread {\n" +
            "public void run() throws InterruptedException {\nThread.sleep(100);\n}\n}"
        for (diagnostic in listOf(diagnostics(text).single(), nxtDiagnosticOf(text))) {
            assertContains(diagnostic.message, "Thread.run()")
            assertContains(diagnostic.message, "catch (InterruptedException e)")
        }
    }
}
