package robotran.tinyvm

import robotran.brick.controls.BrickButton
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.CallFrame
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.StatementWatch
import robotran.brick.program.VariableView
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.programs.libraryClassFiles
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class DebuggingTest {
    private val source = """
        import josx.platform.rcx.*;
        class Program {
            static int total = 4;
            public static void main(String[] args) {
                int first = 1;
                String text = "hi";
                add(first);
                LCD.showNumber(total);
            }
            static void add(int more) {
                total += more;
            }
        }
    """.trimIndent()

    private fun pausedAt(line: Int): DebuggableRun {
        val run = linked(source).start(RecordingRom())
        run.watch = StatementWatch { it.sourceLine == line }
        assertIs<ProgramStatus.Paused>(run.resume(100))
        return run
    }

    @Test
    fun `a run pauses before a line and knows its call stack`() {
        val run = pausedAt(11)
        assertEquals(11, run.sourceLine)
        assertEquals(true, run.isBeforeStatement)
        assertEquals(listOf(CallFrame("Program.add", 11), CallFrame("Program.main", 7)), run.callStack)
        assertEquals("main", run.threads.single().name)
    }

    @Test
    fun `variables are seen by name`() {
        val run = pausedAt(7)
        assertEquals(
            listOf(VariableView("args", "null"), VariableView("first", "1"), VariableView("text", "\"hi\"")),
            run.variables.first { it.name == "Program.main" }.variables,
        )
        assertEquals(listOf(VariableView("total", "4")), run.variables.first { it.name == "Program" }.variables)
    }

    @Test
    fun `a paused run goes on with the statement it stands before`() {
        val run = pausedAt(8)
        assertEquals(6, run.statementsBegun)
        assertEquals(ProgramStatus.Ended, run.resume(100))
    }

    @Test
    fun `a program of several files tells the file of each line`() {
        val main = "public class Program {\npublic static void main(String[] arguments) {\nHelper.help();\n}\n}"
        val helper =
            "class Helper {\nstatic int none;\nstatic void help() {\njosx.platform.rcx.LCD.clear();\nnone = 1 / " +
                "none;\n}\n}"
        val classes = JavaCompiler.compile(mapOf("Program" to main, "Helper" to helper))
        val program = assertIs<TinyVmResult.Success>(
            linkTinyVm("Program", classes, libraryClassFiles, messages = TinyVmMessages.of(Language.ENGLISH)),
        ).program
        val brick = RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH))
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        val run = checkNotNull(brick.debuggableRun)
        run.watch = StatementWatch { it.sourceLine == 4 && it.sourceFile == "Helper.java" }
        while (!brick.isPaused) brick.tick()
        assertEquals(
            listOf(CallFrame("Helper.help", 4, "Helper.java"), CallFrame("Program.main", 3, "Program.java")),
            run.callStack,
        )
        assertEquals(RunState.Running(4, "Helper.java"), brick.state.run)
        repeat(50) { brick.tick() }
        assertEquals(
            listOf("0x27ac ; clear the LCD ; Helper.java:4"),
            brick.log.entries.filter { it.sourceLine > 0 }.map { it.text.substringAfter(' ') },
        )
        val failure = assertIs<RunState.Failed>(brick.state.run).failure
        assertEquals("Helper.java, line 5", failure.place(messages = PlaceMessages.of(Language.ENGLISH)))
    }

    @Test
    fun `decimal numbers look as the program itself would show them`() {
        val body = "int bits = 1;\nfor (int i = 0; i < 400; i++) {\nfloat number = Float.intBitsToFloat(bits);\n" +
            "String text = \"\" + number;\nbits = bits * 1103515245 + 12345;\n}"
        val run = linked(program(body), TinyVmMode.FORGIVING).start(RecordingRom())
        run.watch = StatementWatch { it.sourceLine == 8 }
        repeat(400) {
            while (run.resume(100) !is ProgramStatus.Paused) continue
            val values = run.variables.first().variables.associate { it.name to it.value }
            assertEquals(values["text"], "\"${values["number"]}\"")
        }
    }

    @Test
    fun `every line is met once`() {
        val met = mutableListOf<Pair<Int, Int>>()
        val run = linked(source).start(RecordingRom())
        run.watch = StatementWatch {
            met += it.sourceLine to it.depth
            false
        }
        assertEquals(ProgramStatus.Ended, run.resume(100))
        assertEquals(listOf(3 to 1, 5 to 0, 6 to 0, 7 to 0, 11 to 1, 12 to 1, 8 to 0, 9 to 0), met)
    }
}
