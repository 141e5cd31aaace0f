package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.messages.JavaMessages
import robotran.javacompiler.messages.NewerJava
import robotran.javacompiler.messages.NxjRemedy
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** What an NXT lacks is told with what to use instead. */
class NxjGapsTest {
    private suspend fun assertTold(remedy: NxjRemedy, vararg statements: String) {
        for (text in statements) {
            assertAdvice(JavaMessages.of(Language.ENGLISH).insteadInNxj(remedy), nxtDiagnostic(text))
        }
    }

    @Test
    fun `classes of computers are told with what to use instead`() = runTest {
        assertTold(NxjRemedy.BUTTONS, "Scanner s = null;", "int c = System.in.read();")
        assertTold(NxjRemedy.SORT_ARRAY, "Collections.sort(null);")
        assertTold(NxjRemedy.HASH_MAP, "Map<String, Integer> m = new TreeMap<String, Integer>();", "LinkedHashMap m;")
        assertTold(NxjRemedy.NULL, "Optional<String> o = null;")
        assertTold(NxjRemedy.LINKED_LIST, "ArrayDeque<String> d = null;")
        assertTold(NxjRemedy.LONG_OR_DOUBLE, "BigInteger b = null;")
    }

    @Test
    fun `members of computers are told with what to use instead`() = runTest {
        assertTold(NxjRemedy.JOIN_TEXTS, "String s = String.format(\"%d\", 3);", "System.out.printf(\"x\");")
        assertTold(NxjRemedy.TOKENIZER, "String[] s = \"a b\".split(\" \");")
        assertTold(NxjRemedy.INDEX_OF, "boolean b = \"a\".contains(\"b\");")
        assertTold(NxjRemedy.ARRAY_LOOP, "int h = Arrays.hashCode(new int[3]);", "Arrays.setAll(new int[3], null);")
        assertTold(NxjRemedy.FILL_LIST, "List<String> l = Arrays.asList(\"a\");", "List<String> l = List.of(\"a\");")
        assertTold(NxjRemedy.LOOP, "List<String> l = null; l.stream();", "new ArrayList<String>().forEach(null);")
        assertTold(NxjRemedy.CALCULATE, "int i = Math.floorMod(3, 2);")
        assertTold(NxjRemedy.END_THREAD, "Thread.currentThread().stop();")
        assertTold(NxjRemedy.COMPARE_CHARACTERS, "boolean b = Character.isLetter('a');")
        assertTold(NxjRemedy.SUBSTRINGS, "new StringBuilder().insert(0, \"a\");")
        assertAdvice(
            "Write for (int i = text.length() - 1; i >= 0; i--) { back = back + text.charAt(i); }.",
            nxtDiagnostic("new StringBuilder().reverse();"),
        )
        assertTold(NxjRemedy.INSTANCEOF, "String n = \"\".getClass().getName();")
    }

    @Test
    fun `old leJOS NXJ is told with what to use now`() = runTest {
        assertTold(NxjRemedy.NXT_MOTOR, "Motor.A.setPower(50);")
        assertTold(NxjRemedy.ALWAYS_REGULATED, "Motor.A.regulateSpeed(true);", "Motor.B.smoothAcceleration(true);")
        assertTold(NxjRemedy.ROTATION_SPEED, "int s = Motor.A.getActualSpeed();")
        assertTold(NxjRemedy.IS_MOVING, "boolean b = Motor.A.isRotating();")
        assertTold(NxjRemedy.DIFFERENTIAL_PILOT, "TachoPilot p = null;")
        assertTold(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot p = null; p.setMoveSpeed(3);")
        assertTold(NxjRemedy.NAVIGATOR, "SimpleNavigator n = null;")
    }

    @Test
    fun `what leJOS NXJ has and no world can mean is told with what to use instead`() = runTest {
        assertTold(NxjRemedy.BALANCE, "SegowayPilot p = null;", "Ballbot b = null;")
        assertTold(NxjRemedy.LINE_MAP, "SVGMapLoader l = null;")
        assertTold(NxjRemedy.NO_COMPUTER, "NXTNavigationModel m = null;", "PIDTuner t = null;")
        assertTold(NxjRemedy.ODOMETRY, "GPSPoseProvider p = null;")
        assertTold(NxjRemedy.PIXELS, "LCD.drawLine(0, 0, 9, 9);", "TiledLayer l = null;")
        val imports = mapOf(
            "lejos.robotics.mapping.NavigationModel" to NxjRemedy.NO_COMPUTER,
            "lejos.robotics.mapping.SVGMapLoader" to NxjRemedy.LINE_MAP,
            "javax.microedition.sensor.SensorManager" to NxjRemedy.SENSORS,
            "javax.microedition.location.Coordinates" to NxjRemedy.ODOMETRY,
            "javax.microedition.lcdui.game.GameCanvas" to NxjRemedy.PIXELS,
            "lejos.robotics.kinematics.RobotArm" to NxjRemedy.DIFFERENTIAL_PILOT,
        )
        for ((name, remedy) in imports) {
            val told = nxtDiagnosticOf("import $name;\nclass Robot { }")
            assertAdvice(JavaMessages.of(Language.ENGLISH).insteadInNxj(remedy), told)
        }
    }

    @Test
    fun `programs for other robots are told so`() = runTest {
        val imports = mapOf(
            "lejos.hardware.motor.Motor" to NxjRemedy.NOT_EV3,
            "lejos.hardware.*" to NxjRemedy.NOT_EV3,
            "josx.platform.rcx.*" to NxjRemedy.NOT_RCX,
            "josx.platform.rcx.Motor" to NxjRemedy.NOT_RCX,
            "javax.swing.*" to NxjRemedy.LCD,
            "java.util.stream.Collectors" to NxjRemedy.LOOP,
            "java.text.DecimalFormat" to NxjRemedy.JOIN_TEXTS,
            "lejos.nxt.Settings" to NxjRemedy.MENU_SETTINGS,
            "lejos.nxt.addon.RFIDSensor" to NxjRemedy.SENSORS,
            "lejos.nxt.addon.PFMate" to NxjRemedy.THREE_MOTORS,
            "lejos.nxt.addon.tetrix.TetrixMotor" to NxjRemedy.THREE_MOTORS,
            "lejos.nxt.addon.NothingKnown" to NxjRemedy.SENSORS,
            "lejos.nxt.comm.LCPBTResponder" to NxjRemedy.BLUETOOTH,
        )
        for ((name, remedy) in imports) {
            val told = nxtDiagnosticOf("import $name;\nclass Robot { }")
            assertAdvice(JavaMessages.of(Language.ENGLISH).insteadInNxj(remedy), told)
        }
        assertTold(NxjRemedy.DRAW, "LCD.showNumber(3);")
        assertTold(NxjRemedy.SENSOR_PORT, "Sensor.S1.activate();")
        assertTold(NxjRemedy.NXT_BUTTONS, "Button.RUN.waitForPress();")
        assertTold(NxjRemedy.MOTOR_OF_PORT, "EV3LargeRegulatedMotor m = null;")
    }

    @Test
    fun `add-ons and chips without a place in a world are told with what to use instead`() = runTest {
        assertTold(NxjRemedy.SENSORS, "NXTCam c = null;", "DGPSSensor g = null;")
        assertTold(NxjRemedy.COMPASS, "CompassSensor c = null;")
        assertTold(NxjRemedy.GYRO, "CruizcoreGyro g = null;")
        assertTold(NxjRemedy.ACCELERATION, "TiltSensor t = null;")
        assertTold(NxjRemedy.DISTANCE, "EOPD e = null;")
        assertTold(NxjRemedy.COUNT_TURNS, "AngleSensor a = null;")
        assertTold(NxjRemedy.THERMOMETER, "RCXTemperatureSensor t = null;")
        assertTold(NxjRemedy.RCX_LINK, "IRLink i = null;")
        assertTold(NxjRemedy.ONE_PORT_EACH, "TouchMUX m = null;", "SensorMux m = null;")
        assertTold(NxjRemedy.THREE_MOTORS, "PFLink p = null;", "MServo s = null;", "RCXMotorMultiplexer m = null;")
        assertTold(NxjRemedy.MENU_SETTINGS, "Button.loadSettings();", "Sound.loadSettings();")
        assertTold(NxjRemedy.BREAKPOINTS, "VM.getVM();", "NXT.boot();", "int checks = VM.VM_TYPECHECKS;")
        assertTold(NxjRemedy.NXT_LISTENERS, "int bit = NXTEvent.USER1;", "int type = NXTEvent.RS485;")
        assertTold(NxjRemedy.PRINT, "Assertion.test(\"x\", true);")
        val comm = "lejos.nxt.comm"
        assertTold(NxjRemedy.BLUETOOTH_BY_NAME, "$comm.Bluetooth.btRead(null, 0, 0);", "$comm.Bluetooth.getPin();")
        assertTold(NxjRemedy.BLUETOOTH, "$comm.USB.usbReset();", "$comm.RS485.hsEnable(0, 0);")
    }

    @Test
    fun `calls without a class are told`() = runTest {
        assertTold(NxjRemedy.PRINT, "println(\"x\");")
        assertTold(NxjRemedy.WAIT, "sleep(100);", "delay(100);")
    }

    @Test
    fun `newer Java is told by name`() = runTest {
        val programs = mapOf(
            NewerJava.DIAMOND to "List<String> l = new ArrayList<>();",
            NewerJava.LAMBDA to "Runnable r = () -> Sound.beep();",
            NewerJava.TEXT_IN_SWITCH to "String s = \"a\"; switch (s) { case \"a\": break; }",
            NewerJava.MULTI_CATCH to "try { Sound.beep(); } catch (IllegalStateException | NullPointerException e) { }",
            NewerJava.TRY_WITH_RESOURCES to "try (java.io.InputStream s = null) { }",
            NewerJava.VAR to "var x = 3;",
            NewerJava.NUMBER_STYLE to "int x = 1_000;",
        )
        for ((feature, statements) in programs) {
            val told = nxtDiagnostic(statements)
            val sentences = "${JavaMessages.of(
                Language.ENGLISH,
            ).newerJava(feature)} ${JavaMessages.of(Language.ENGLISH).insteadOf(feature)}"
            assertEquals(sentences, told.message, statements)
        }
    }

    private suspend fun toldOf(statements: String): List<Pair<Int?, String>> =
        assertIs<CompilationResult.Failure>(compileForNxt(nxtProgram(statements))).diagnostics
            .map { it.range?.line to it.message }

    @Test
    fun `a missing semicolon is told beside an empty diamond`() = runTest {
        val diamond = NewerJava.DIAMOND.let {
            JavaMessages.of(Language.ENGLISH).newerJava(it) + " " +
                JavaMessages.of(Language.ENGLISH).insteadOf(it)
        }
        val before = "LCD.drawInt(1, 0, 0)\nMap<String, Integer> map = new HashMap<>();\nmap.put(null, null);"
        val (semicolon, told) = toldOf(before)
        assertEquals(8, semicolon.first)
        assertContains(semicolon.second, "\";\"")
        assertEquals(9 to diamond, told)
        val after = toldOf("List<String> list = new ArrayList<>();\nlist.add(null)\nint x = 3;")
        assertEquals(listOf(8 to diamond, 9 to semicolon.second), after)
        // One sentence a line: the other one follows when this one is mended.
        assertEquals(listOf(8 to diamond), toldOf("List<String> list = new ArrayList < > ()\nlist.add(null);"))
    }

    @Test
    fun `an unequal of another language is told beside a missing semicolon`() = runTest {
        val told = toldOf("int x = 3\nif (x <> 4) x = 2;\nList<String> list = new ArrayList<>();")
        assertEquals(listOf(8, 9, 10), told.map { it.first })
        assertEquals(JavaMessages.of(Language.ENGLISH).foreignWord("<>", "!="), told[1].second)
    }

    @Test
    fun `a diamond in a text or comment is none`() = runTest {
        val told = toldOf("// new ArrayList<>()\nLCD.drawString(\"new ArrayList<>\", 0, 0)\nint x = 3;")
        assertEquals(listOf(9), told.map { it.first })
    }

    @Test
    fun `boxes of the wrong kind get no advice for an RCX`() = runTest {
        val sentence = "This is of type \"long\", and \"Integer\" is needed here."
        assertEquals(sentence, nxtDiagnostic("Integer i = 5L;").message)
        assertFalse("Vector" in nxtDiagnostic("Integer i = null; boolean b = i && true;").message)
    }

    @Test
    fun `missing imports and typing errors are mended`() = runTest {
        val told = nxtDiagnosticOf("public class Robot { public static void main(String[] a) { Motor.A.forward(); } }")
        assertContains(told.message, "import lejos.nxt.*;")
        assertContains(nxtDiagnostic("Motor.A.foward();").message, "forward")
        assertContains(nxtDiagnostic("new ArrayList<String>().contans(null);").message, "contains")
        assertContains(nxtDiagnostic("UltrasonicSenor s = null;").message, "UltrasonicSensor")
    }

    @Test
    fun `all remedies are told in three languages and one sentence or two`() {
        val all =
            listOf(
                JavaMessages.of(Language.ENGLISH),
                JavaMessages.of(Language.GERMAN),
                JavaMessages.of(Language.SPANISH),
            )
        for (remedy in NxjRemedy.entries) {
            val told = all.map { messages: JavaMessages -> messages.insteadInNxj(remedy) }
            assertTrue(told.all { it.length in 8..LONGEST && it.last() in ".;0" }, told.toString())
        }
        for (feature in listOf(NewerJava.DIAMOND, NewerJava.TEXT_IN_SWITCH)) {
            assertEquals(all.size, all.map { it.newerJava(feature) }.toSet().size)
            assertEquals(all.size, all.map { it.insteadOf(feature) }.toSet().size)
        }
    }

    private companion object {
        const val LONGEST = 120
    }

    @Test
    fun `a class of two packages is told with the import of the brick's`() = runTest {
        val diagnostic = nxtDiagnostic("Timer timer = null;")
        val advice = JavaMessages.of(Language.ENGLISH).importIt("import lejos.util.Timer;")
        assertEquals("${JavaMessages.of(Language.ENGLISH).severalClasses("Timer")} $advice", diagnostic.message)
    }

    @Test
    fun `of two classes the one with types in angle brackets is Java's`() = runTest {
        suspend fun told(statement: String) =
            nxtDiagnosticOf("import javax.microedition.lcdui.*;\n" + nxtProgram(statement))
        assertAdvice(
            JavaMessages.of(Language.ENGLISH).importIt("import java.util.List;"),
            told("List<String> names = null;"),
        )
        assertAdvice(
            JavaMessages.of(Language.ENGLISH).importIt("import javax.microedition.lcdui.List;"),
            told("List menu = null;"),
        )
    }
}
