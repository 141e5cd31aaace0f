package robotran.cli.run

import robotran.cli.CommandTest
import kotlin.io.path.readText
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests `robotran run` with Java sources. */
class JavaRunTest : CommandTest() {
    private fun run(vararg arguments: String) = commandLine.execute(listOf("run") + arguments)

    private fun romLogOf(vararg arguments: String): List<String> {
        val log = folder.resolve("log.txt")
        assertEquals(0, run(*arguments, "--rom-log", "$log"), console.complaints.joinToString())
        return log.readText().trimEnd().lines()
    }

    private fun reportOf(vararg arguments: String): String {
        console.said.clear()
        assertEquals(0, run(*arguments, "--report", "-"), console.complaints.joinToString())
        return console.said.single()
    }

    @Test
    fun `every Java example leaves its recorded report and ROM log`() {
        val examples = tree.resolve("examples/lejos").listFiles { file -> file.extension == "java" }.orEmpty()
        val records = tree.resolve("shared/programs/src/commonTest/resources/runs")
        assertTrue(examples.isNotEmpty())
        for (example in examples) {
            val report = folder.resolve("report.json")
            val callLog = folder.resolve("rom.txt")
            assertEquals(0, run(example.path, "--report", "$report", "--rom-log", "$callLog"), example.name)
            val name = example.nameWithoutExtension
            assertEquals(records.resolve("$name.report.json").readText(), report.readText(), name)
            val recordedLog = records.resolve("$name.rom-log.txt")
            if (recordedLog.exists()) assertEquals(recordedLog.readText(), callLog.readText(), name)
        }
    }

    @Test
    fun `two motors and nothing else are two calls, then the brick brakes and the summary says why`() {
        val file = javaProgram("Two", "Motor.A.forward();\nMotor.C.forward();")
        val calls = romLogOf(file)
        assertEquals(
            listOf("0x1a4e 0x2000 1 3 ; motor A forward 3 ; 5", "0x1a4e 0x2002 1 3 ; motor C forward 3 ; 6"),
            calls.filterNot { it.endsWith("; firmware") }.map { it.substringAfter(' ') },
        )
        val after = calls.dropWhile { !it.endsWith("; 6") }.drop(1)
        assertEquals(listOf("A", "B", "C").map { "motor $it brake 0" }, after.take(3).map { it.split(" ; ")[1] })
        assertContains(console.said.single(), "The program has come to its end, so the brick stopped the motors")
        assertContains(console.said.single(), "a loop that never ends")
    }

    @Test
    fun `with a loop that never ends the robot drives on until its time is up`() {
        val file = javaProgram("On", "Motor.A.forward();\nMotor.C.forward();\nwhile (true) {}")
        assertTrue(romLogOf(file, "--for", "2").none { "brake" in it })
        assertContains(console.said.single(), "The time was up after 2.0 s. The robot is at x 79.")
    }

    @Test
    fun `several files are one program and its ROM log names them`() {
        assertEquals(
            listOf("motor A forward 3 ; Robot.java:7", "motor A brake 7 ; Drive.java:5"),
            romLogOf(drive(), robot()).filterNot { it.endsWith("; firmware") }.map { it.substringAfter(" ; ") },
        )
    }

    @Test
    fun `a mistake names the file that it is in, and nothing runs`() {
        val robot = program(ROBOT.replace("forward", "forwrd"), "parts/Robot.java")
        assertEquals(2, run(drive(), robot))
        assertTrue(console.complaints.single().startsWith("$robot:7:14: "), console.complaints.single())
        assertEquals(emptyList(), console.said)
    }

    @Test
    fun `files in packages find each other`() {
        val robot =
            program("package parts;\n\npublic class Robot {\n    public void drive() {\n    }\n}\n", "parts/Robot.java")
        val main = program(
            "import parts.Robot;\n\npublic class Main {\n    public static void main(String[] args) {\n        new " +
                "Robot().drive();\n    }\n}\n",
            "Main.java",
        )
        assertEquals(0, run(robot, main), console.complaints.joinToString())
    }

    @Test
    fun `a class that is in no file, and a program that begins nowhere, are mistakes`() {
        assertEquals(2, run(drive()))
        assertContains(console.complaints.single(), "Drive.java:5:13: There is no class \"Robot\".")
        console.complaints.clear()
        assertEquals(2, run(robot()))
        assertContains(console.complaints.single(), "no class has a method \"main\"")
    }

    @Test
    fun `an exception that nobody catches fails with its line`() {
        val file = javaProgram("Fail", "int[] row = new int[3];\nint place = 5;\nrow[place] = 1;")
        assertEquals(1, run(file))
        assertContains(console.complaints.single(), "Line 7: ")
        assertContains(console.complaints.single(), "ArrayIndexOutOfBoundsException")
        assertContains(console.said.single(), "The program failed after")
    }

    @Test
    fun `where there are several files a failure names its own`() {
        val robot = program(ROBOT.replace("left.forward()", "((Motor) null).forward()"), "Robot.java")
        assertEquals(1, run(drive(), robot))
        assertContains(console.complaints.single(), "Robot.java, line 7: ")
        assertContains(console.complaints.single(), "NullPointerException")
    }

    @Test
    fun `a thread that fails is told though the program ends well`() {
        val file = program(
            "public class Beside extends Thread {\n    public static void main(String[] args) throws Exception {\n" +
                "        new Beside().start();\n        Thread.sleep(500);\n    }\n\n" +
                "    public void run() {\n        throw new RuntimeException();\n    }\n}\n",
            "Beside.java",
        )
        assertEquals(1, run(file))
        assertContains(console.complaints.single(), "Line 8: ")
    }

    @Test
    fun `a brick divides by sixteen bits and says so, a forgiving one as Java does`() {
        val file = javaProgram("Divide", "int divisor = 70000;\nLCD.showNumber(140000 / divisor);\nwhile (true) {}")
        assertContains(reportOf(file, "--for", "1"), "\"lcd\": \"0031 0\"")
        assertContains(console.complaints.single(), "Line 6: ")
        console.complaints.clear()
        assertContains(reportOf(file, "--for", "1", "--forgiving"), "\"lcd\": \"0002 0\"")
        assertContains(console.complaints.single(), "Line 6: ")
    }

    @Test
    fun `an unlimited brick computes much faster`() {
        val file = javaProgram("Compute", "int sum = 0;\nfor (int i = 0; i < 20000; i++) sum = sum + i;")
        val seconds = listOf(reportOf(file), reportOf(file, "--unlimited")).map { report ->
            Regex("\"seconds\": ([0-9.]+)").find(report)!!.groupValues[1].toDouble()
        }
        assertTrue(seconds[0] > 5 && seconds[1] < 1, "$seconds")
    }

    @Test
    fun `a program may use what the named version of leJOS has`() {
        val file =
            javaProgram(
                "Pile",
                "java.util.Stack pile = new java.util.Stack();\nLCD.showNumber(pile.size());\nThread.sleep(2000);",
            )
        assertContains(reportOf(file, "--for", "1"), "\"lcd\": \"0000 0\"")
        assertEquals(2, commandLine.execute(listOf("run", file, "--for", "1", "--lejos", "2.1")))
        assertContains(console.complaints.first(), "Vector")
        assertEquals(2, commandLine.execute(listOf("run", file, "--lejos", "1.0")))
    }

    private fun drive() = program(DRIVE, "Drive.java")

    private fun robot() = program(ROBOT, "Robot.java")

    private companion object {
        const val DRIVE =
            "import josx.platform.rcx.Motor;\n\npublic class Drive {\n    public static void main(String[] args) {\n" +
                "        new Robot().drive(); Motor.A.stop();\n    }\n}\n"
        const val ROBOT =
            "import josx.platform.rcx.Motor;\n\npublic class Robot {\n    private Motor left = Motor.A;\n\n" +
                "    void drive() {\n        left.forward();\n    }\n}\n"
    }
}
