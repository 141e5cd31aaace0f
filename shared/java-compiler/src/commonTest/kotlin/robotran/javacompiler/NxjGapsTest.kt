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
    private suspend fun assertDiagnostics(remedy: NxjRemedy, vararg statements: String) {
        for (text in statements) {
            assertAdvice(JavaMessages.of(Language.ENGLISH).insteadInNxj(remedy), nxtDiagnostic(text))
        }
    }

    @Test
    fun `classes of computers are told with what to use instead`() = runTest {
        assertDiagnostics(NxjRemedy.BUTTONS, "Scanner s = null;", "int c = System.in.read();")
        assertDiagnostics(NxjRemedy.SORT_ARRAY, "Collections.sort(null);")
        assertDiagnostics(
            NxjRemedy.HASH_MAP,
            "Map<String, Integer> m = new TreeMap<String, Integer>();",
            "LinkedHashMap m;",
        )
        assertDiagnostics(NxjRemedy.NULL, "Optional<String> o = null;")
        assertDiagnostics(NxjRemedy.LINKED_LIST, "ArrayDeque<String> d = null;")
        assertDiagnostics(NxjRemedy.LONG_OR_DOUBLE, "BigInteger b = null;")
    }

    @Test
    fun `members of computers are told with what to use instead`() = runTest {
        assertDiagnostics(NxjRemedy.JOIN_TEXTS, "String s = String.format(\"%d\", 3);", "System.out.printf(\"x\");")
        assertDiagnostics(NxjRemedy.TOKENIZER, "String[] s = \"a b\".split(\" \");")
        assertDiagnostics(NxjRemedy.INDEX_OF, "boolean b = \"a\".contains(\"b\");")
        assertDiagnostics(
            NxjRemedy.ARRAY_LOOP,
            "int h = Arrays.hashCode(new int[3]);",
            "Arrays.setAll(new int[3], null);",
        )
        assertDiagnostics(
            NxjRemedy.FILL_LIST,
            "List<String> l = Arrays.asList(\"a\");",
            "List<String> l = List.of(\"a\");",
        )
        assertDiagnostics(
            NxjRemedy.LOOP,
            "List<String> l = null; l.stream();",
            "new ArrayList<String>().forEach(null);",
        )
        assertDiagnostics(NxjRemedy.CALCULATE, "int i = Math.floorMod(3, 2);")
        assertDiagnostics(NxjRemedy.END_THREAD, "Thread.currentThread().stop();")
        assertDiagnostics(NxjRemedy.COMPARE_CHARACTERS, "boolean b = Character.isLetter('a');")
        assertDiagnostics(NxjRemedy.SUBSTRINGS, "new StringBuilder().insert(0, \"a\");")
        assertAdvice(
            "Write for (int i = text.length() - 1; i >= 0; i--) { back = back + text.charAt(i); }.",
            nxtDiagnostic("new StringBuilder().reverse();"),
        )
        assertDiagnostics(NxjRemedy.INSTANCEOF, "String n = \"\".getClass().getName();")
    }

    @Test
    fun `old leJOS NXJ is told with what to use now`() = runTest {
        assertDiagnostics(NxjRemedy.NXT_MOTOR, "Motor.A.setPower(50);")
        assertDiagnostics(
            NxjRemedy.ALWAYS_REGULATED,
            "Motor.A.regulateSpeed(true);",
            "Motor.B.smoothAcceleration(true);",
        )
        assertDiagnostics(NxjRemedy.ROTATION_SPEED, "int s = Motor.A.getActualSpeed();")
        assertDiagnostics(NxjRemedy.IS_MOVING, "boolean b = Motor.A.isRotating();")
        assertDiagnostics(NxjRemedy.DIFFERENTIAL_PILOT, "TachoPilot p = null;")
        assertDiagnostics(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot p = null; p.setMoveSpeed(3);")
        assertDiagnostics(NxjRemedy.NAVIGATOR, "SimpleNavigator n = null;")
    }

    @Test
    fun `what leJOS NXJ has and no world can mean is told with what to use instead`() = runTest {
        assertDiagnostics(NxjRemedy.BALANCE, "SegowayPilot p = null;", "Ballbot b = null;")
        assertDiagnostics(NxjRemedy.LINE_MAP, "SVGMapLoader l = null;")
        assertDiagnostics(NxjRemedy.NO_COMPUTER, "NXTNavigationModel m = null;", "PIDTuner t = null;")
        assertDiagnostics(NxjRemedy.ODOMETRY, "GPSPoseProvider p = null;")
        assertDiagnostics(NxjRemedy.PIXELS, "LCD.drawLine(0, 0, 9, 9);", "TiledLayer l = null;")
        val imports = mapOf(
            "lejos.robotics.mapping.NavigationModel" to NxjRemedy.NO_COMPUTER,
            "lejos.robotics.mapping.SVGMapLoader" to NxjRemedy.LINE_MAP,
            "javax.microedition.sensor.SensorManager" to NxjRemedy.SENSORS,
            "javax.microedition.location.Coordinates" to NxjRemedy.ODOMETRY,
            "javax.microedition.lcdui.game.GameCanvas" to NxjRemedy.PIXELS,
            "lejos.robotics.kinematics.RobotArm" to NxjRemedy.DIFFERENTIAL_PILOT,
        )
        for ((name, remedy) in imports) {
            val described = nxtDiagnosticOf("import $name;\nclass Robot { }")
            assertAdvice(JavaMessages.of(Language.ENGLISH).insteadInNxj(remedy), described)
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
            val described = nxtDiagnosticOf("import $name;\nclass Robot { }")
            assertAdvice(JavaMessages.of(Language.ENGLISH).insteadInNxj(remedy), described)
        }
        assertDiagnostics(NxjRemedy.DRAW, "LCD.showNumber(3);")
        assertDiagnostics(NxjRemedy.SENSOR_PORT, "Sensor.S1.activate();")
        assertDiagnostics(NxjRemedy.NXT_BUTTONS, "Button.RUN.waitForPress();")
        assertDiagnostics(NxjRemedy.MOTOR_OF_PORT, "EV3LargeRegulatedMotor m = null;")
    }

    @Test
    fun `add-ons and chips without a place in a world are told with what to use instead`() = runTest {
        assertDiagnostics(NxjRemedy.SENSORS, "NXTCam c = null;", "DGPSSensor g = null;")
        assertDiagnostics(NxjRemedy.COMPASS, "CompassSensor c = null;")
        assertDiagnostics(NxjRemedy.GYRO, "CruizcoreGyro g = null;")
        assertDiagnostics(NxjRemedy.ACCELERATION, "TiltSensor t = null;")
        assertDiagnostics(NxjRemedy.DISTANCE, "EOPD e = null;")
        assertDiagnostics(NxjRemedy.COUNT_TURNS, "AngleSensor a = null;")
        assertDiagnostics(NxjRemedy.THERMOMETER, "RCXTemperatureSensor t = null;")
        assertDiagnostics(NxjRemedy.RCX_LINK, "IRLink i = null;")
        assertDiagnostics(NxjRemedy.ONE_PORT_EACH, "TouchMUX m = null;", "SensorMux m = null;")
        assertDiagnostics(
            NxjRemedy.THREE_MOTORS,
            "PFLink p = null;",
            "MServo s = null;",
            "RCXMotorMultiplexer m = null;",
        )
        assertDiagnostics(NxjRemedy.MENU_SETTINGS, "Button.loadSettings();", "Sound.loadSettings();")
        assertDiagnostics(NxjRemedy.BREAKPOINTS, "VM.getVM();", "NXT.boot();", "int checks = VM.VM_TYPECHECKS;")
        assertDiagnostics(NxjRemedy.NXT_LISTENERS, "int bit = NXTEvent.USER1;", "int type = NXTEvent.RS485;")
        assertDiagnostics(NxjRemedy.PRINT, "Assertion.test(\"x\", true);")
        val comm = "lejos.nxt.comm"
        assertDiagnostics(
            NxjRemedy.BLUETOOTH_BY_NAME,
            "$comm.Bluetooth.btRead(null, 0, 0);",
            "$comm.Bluetooth.getPin();",
        )
        assertDiagnostics(NxjRemedy.BLUETOOTH, "$comm.USB.usbReset();", "$comm.RS485.hsEnable(0, 0);")
    }

    @Test
    fun `calls without a class are told`() = runTest {
        assertDiagnostics(NxjRemedy.PRINT, "println(\"x\");")
        assertDiagnostics(NxjRemedy.WAIT, "sleep(100);", "delay(100);")
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
            val described = nxtDiagnostic(statements)
            val sentences = "${JavaMessages.of(
                Language.ENGLISH,
            ).newerJava(feature)} ${JavaMessages.of(Language.ENGLISH).insteadOf(feature)}"
            assertEquals(sentences, described.message, statements)
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
        val (semicolon, described) = toldOf(before)
        assertEquals(8, semicolon.first)
        assertContains(semicolon.second, "\";\"")
        assertEquals(9 to diamond, described)
        val after = toldOf("List<String> list = new ArrayList<>();\nlist.add(null)\nint x = 3;")
        assertEquals(listOf(8 to diamond, 9 to semicolon.second), after)
        // One sentence a line: the other one follows when this one is mended.
        assertEquals(listOf(8 to diamond), toldOf("List<String> list = new ArrayList < > ()\nlist.add(null);"))
    }

    @Test
    fun `an unequal of another language is told beside a missing semicolon`() = runTest {
        val described = toldOf("int x = 3\nif (x <> 4) x = 2;\nList<String> list = new ArrayList<>();")
        assertEquals(listOf(8, 9, 10), described.map { it.first })
        assertEquals(JavaMessages.of(Language.ENGLISH).foreignWord("<>", "!="), described[1].second)
    }

    @Test
    fun `a diamond in a text or comment is none`() = runTest {
        val described = toldOf("// new ArrayList<>()\nLCD.drawString(\"new ArrayList<>\", 0, 0)\nint x = 3;")
        assertEquals(listOf(9), described.map { it.first })
    }

    @Test
    fun `boxes of the wrong kind get no advice for an RCX`() = runTest {
        val sentence = "This is of type \"long\", and \"Integer\" is needed here."
        assertEquals(sentence, nxtDiagnostic("Integer i = 5L;").message)
        assertFalse("Vector" in nxtDiagnostic("Integer i = null; boolean b = i && true;").message)
    }

    @Test
    fun `missing imports and typing errors are mended`() = runTest {
        val described =
            nxtDiagnosticOf("public class Robot { public static void main(String[] a) { Motor.A.forward(); } }")
        assertContains(described.message, "import lejos.nxt.*;")
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
            val described = all.map { messages: JavaMessages -> messages.insteadInNxj(remedy) }
            assertTrue(described.all { it.length in 8..LONGEST && it.last() in ".;0" }, described.toString())
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
        suspend fun described(statement: String) =
            nxtDiagnosticOf("import javax.microedition.lcdui.*;\n" + nxtProgram(statement))
        assertAdvice(
            JavaMessages.of(Language.ENGLISH).importIt("import java.util.List;"),
            described("List<String> names = null;"),
        )
        assertAdvice(
            JavaMessages.of(Language.ENGLISH).importIt("import javax.microedition.lcdui.List;"),
            described("List menu = null;"),
        )
    }
}
